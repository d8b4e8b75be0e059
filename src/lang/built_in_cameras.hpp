// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <span>
#include <string_view>

namespace balcony::lang {

/// A file of cameras/, compiled into the library.
struct BuiltInCamera {
    std::string_view name;    ///< Without .cam.
    std::string_view family;  ///< Its folder.
    std::string_view text;
};

/// The family of the map projections, which are many.
inline constexpr std::string_view map_family = "maps";

/// All built-in cameras, by family and name; CMake generates the definition.
[[nodiscard]] std::span<const BuiltInCamera> built_in_camera_files();
/// A built-in camera by its name, with or without .cam; null if there is none.
[[nodiscard]] const BuiltInCamera* find_built_in_camera(std::string_view name);

}  // namespace balcony::lang
