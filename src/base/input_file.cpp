// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/input_file.hpp"

#include <algorithm>
#include <system_error>

#include <fmt/format.h>

namespace balcony {

namespace fs = std::filesystem;

std::optional<Diagnostic> not_a_file(const fs::path& file, std::string_view name) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::is_regular_file(status)) {
        return std::nullopt;
    }
    if (fs::is_directory(status)) {
        return error(fmt::format("{} is a folder, not a file", name), {}, "name a file in it");
    }
    if (fs::exists(status)) {
        return error(fmt::format("{} is a pipe or a device, not a file", name), {},
                     "save its output to a file");
    }
    if (fs::is_symlink(fs::symlink_status(file, ignored))) {
        return error(fmt::format("{} is a link that leads to no file", name), {},
                     "repair the link, or name the file itself");
    }
    return error(fmt::format("there is no file {}", name), {}, "check its name and its folder");
}

std::vector<std::string> names_in(const fs::path& folder) {
    std::vector<std::string> names;
    std::error_code failed;
    for (fs::directory_iterator entry(folder.empty() ? "." : folder, failed), end;
         !failed && entry != end; entry.increment(failed)) {
        names.push_back(entry->path().filename().string());
    }
    std::sort(names.begin(), names.end());
    return names;
}

}  // namespace balcony
