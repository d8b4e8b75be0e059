// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/shared_text.hpp"

#include <fstream>
#include <iterator>
#include <utility>

#include "balcony/lang.hpp"
#include "balcony/output_file.hpp"

namespace balcony::studio {

namespace fs = std::filesystem;

namespace {

// Nothing if the file cannot be read.
std::optional<std::string> bytes_of(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    if (!stream) {
        return std::nullopt;
    }
    return std::string(std::istreambuf_iterator<char>(stream), {});
}

}  // namespace

Result<SharedText> SharedText::open(const fs::path& file, const std::string& otherwise) {
    SharedText made;
    std::error_code failure;
    made.file_ = fs::absolute(file, failure).lexically_normal();
    if (!fs::exists(made.file_, failure)) {
        made.text_ = otherwise;
        return made;
    }
    const auto read = lang::read_text(file);
    if (!read) {
        return read.diagnostics;
    }
    made.on_disk_ = bytes_of(made.file_);
    made.text_ = (*read)->text();
    made.saved_version_ = made.version_;
    return made;
}

bool SharedText::take(int version, std::string text) {
    if (version != version_ + 1) {
        return false;
    }
    version_ = version;
    text_ = std::move(text);
    return true;
}

bool SharedText::has_changed_on_disk() const {
    const std::optional<std::string> now = bytes_of(file_);
    // A file that was removed is written again.
    return now && now != on_disk_;
}

Diagnostics SharedText::save() {
    Diagnostics found = write_whole(file_, text_);
    if (!has_errors(found)) {
        on_disk_ = text_;
        saved_version_ = version_;
    }
    return found;
}

}  // namespace balcony::studio
