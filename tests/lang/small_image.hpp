// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace balcony::lang::test {

/// A TGA file, from the top, of the grey values 0 and 1 above 0.2 and 0.6.
inline std::string four_greys() {
    std::string file(18, '\0');
    file[2] = 3;
    file[12] = file[14] = 2;
    file[16] = 8;
    file[17] = 32;
    for (const int grey : {0, 255, 51, 153}) {
        file += static_cast<char>(grey);
    }
    return file;
}

}  // namespace balcony::lang::test
