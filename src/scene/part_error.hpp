// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace balcony::scene {

/// The reason why a part of a file (a mesh, a texture, a light) cannot be used. The reader of the
/// part converts it into a warning that names the part, and continues without it.
struct PartError {
    std::string reason;
    std::string remedy{};
};

}  // namespace balcony::scene
