// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace balcony::data {

/// A file of cameras/data/, compiled into the library.
struct BuiltInFile {
    std::string_view name;
    std::span<const std::uint8_t> bytes;
};

/// All built-in files, sorted by name; CMake generates the definition.
[[nodiscard]] std::span<const BuiltInFile> embedded_files();

}  // namespace balcony::data
