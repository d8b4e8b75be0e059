// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/command_rows.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace balcony::cli {

std::string scene_files_text() {
    return fmt::format("scene file ({})", fmt::join(scene::file_extensions(), ", "));
}

std::optional<std::vector<std::string>> open_names(std::string_view words) {
    if (words == "all") {
        return std::nullopt;
    }
    std::vector<std::string> names;
    while (!words.empty() && words != "none") {
        const std::size_t comma = std::min(words.find(','), words.size());
        names.emplace_back(words.substr(0, comma));
        words.remove_prefix(std::min(comma + 1, words.size()));
    }
    return names;
}

}  // namespace balcony::cli
