// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/temporary_folder.hpp"

#include <algorithm>
#include <string>
#include <utility>

#include <stdlib.h>

namespace balcony::bridge::povray {

namespace {

namespace fs = std::filesystem;

// POV-Ray splits options at blanks and quotes.
bool is_plain(const std::string& name) {
    return std::all_of(name.begin(), name.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '/' || c == '-' || c == '_' || c == '.';
    });
}

}  // namespace

std::optional<TemporaryFolder> TemporaryFolder::make() {
    std::error_code failed;
    fs::path parent = fs::absolute(fs::temp_directory_path(failed), failed);
    if (failed || !is_plain(parent.string())) {
        parent = "/tmp";
    }
    std::string name = (parent / "balcony-povray-XXXXXX").string();
    if (mkdtemp(name.data()) == nullptr) {
        return std::nullopt;
    }
    return TemporaryFolder(name);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept
    : path_(std::exchange(other.path_, {})) {}

TemporaryFolder::~TemporaryFolder() {
    if (!path_.empty()) {
        std::error_code ignored;
        fs::remove_all(path_, ignored);
    }
}

}  // namespace balcony::bridge::povray
