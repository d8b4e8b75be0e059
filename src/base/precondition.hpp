// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stdexcept>

namespace balcony {

/// Checks a precondition of a public function that returns no diagnostics, in all builds: throws
/// std::logic_error if it does not hold. Others return an error of Kind::internal.
inline void precondition(bool holds, const char* what) {
    if (!holds) {
        throw std::logic_error(what);
    }
}

}  // namespace balcony
