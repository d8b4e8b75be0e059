// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/read_source.hpp"

#include <fstream>

#include <fmt/format.h>

#include "balcony/lang.hpp"

namespace balcony::lang {

namespace fs = std::filesystem;

Result<std::shared_ptr<const SourceText>> read_text(const fs::path& file) {
    return read_source(file, file.string(), {});
}

Result<std::shared_ptr<const SourceText>> read_source(const fs::path& file, const std::string& name,
                                                      const SourceSpan& asked) {
    std::error_code failure;
    const fs::file_status status = fs::status(file, failure);
    if (!fs::exists(status)) {
        return error(fmt::format("there is no file '{}'", name), asked,
                     "check its name and its folder");
    }
    if (fs::is_directory(status)) {
        return error(fmt::format("'{}' is a folder, not a file", name), asked,
                     "name a .cam file in the folder");
    }
    // Opening a pipe waits for a writer, perhaps forever.
    if (fs::is_fifo(status) || fs::is_socket(status)) {
        return error(fmt::format("'{}' is a pipe, not a file", name), asked,
                     "save its output to a .cam file");
    }
    const auto too_large = [&] {
        return error(fmt::format("'{}' is larger than 1 MB, the maximum for camera files", name),
                     asked, "check that it is a camera file");
    };
    if (fs::is_regular_file(status) && fs::file_size(file, failure) > max_file && !failure) {
        return too_large();
    }
    std::ifstream stream(file, std::ios::binary);
    std::string text(max_file + 1, '\0');
    stream.read(text.data(), static_cast<std::streamsize>(text.size()));
    if (!stream.is_open() || stream.bad()) {
        return error(fmt::format("'{}' cannot be read", name), asked, "check its read permission");
    }
    text.resize(static_cast<std::size_t>(stream.gcount()));
    if (text.size() > max_file) {
        return too_large();
    }
    return std::make_shared<const SourceText>(name, std::move(text));
}

}  // namespace balcony::lang
