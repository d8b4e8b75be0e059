// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/input_file.hpp"

#include <algorithm>
#include <cctype>
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
    if (file.string().find("://") != std::string::npos) {
        return error(fmt::format("{} is an address, not a file", name), {},
                     "download it first, for example with curl -O, and name the file");
    }
    return error(fmt::format("there is no file {}", name), {}, "check its name and its folder");
}

std::optional<Diagnostic> begin_text(std::string_view& text, std::string_view name) {
    // With a byte order mark, or as its first character, which is one of ASCII, shows.
    const bool is_utf16 = text.starts_with("\xfe\xff") || text.starts_with("\xff\xfe") ||
                          (text.size() > 1 && (text[0] == '\0') != (text[1] == '\0'));
    if (is_utf16) {
        return error(fmt::format("the text of {} is UTF-16, which is not supported", name), {},
                     "save it as UTF-8: iconv -f UTF-16 -t UTF-8");
    }
    if (text.starts_with("\xef\xbb\xbf")) {
        text.remove_prefix(3);
    }
    return std::nullopt;
}

std::string extension_of(const fs::path& file) {
    std::string extension = file.extension().string();
    std::transform(extension.begin(), extension.end(), extension.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return extension;
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
