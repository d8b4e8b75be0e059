// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace balcony {

/// Whether a byte of UTF-8 continues a code point instead of beginning one.
inline bool continues_code_point(char byte) {
    return (static_cast<unsigned char>(byte) & 0xc0U) == 0x80U;
}

}  // namespace balcony
