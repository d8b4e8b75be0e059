// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The page, embedded in the command.

#include <cstdint>
#include <span>
#include <string_view>

namespace balcony::studio {

struct PageFile {
    std::string_view path;  ///< "index.html"
    std::string_view type;  ///< "text/html; charset=utf-8"
    std::span<const std::uint8_t> bytes;
    bool is_gzip = false;  ///< The bytes are compressed.
};

/// Empty if it was built without the page.
[[nodiscard]] std::span<const PageFile> page_files();

}  // namespace balcony::studio
