// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <string>

#include <fmt/format.h>

#include "balcony/display_file.hpp"
#include "balcony/film.hpp"
#include "balcony/images.hpp"
#include "balcony/output_file.hpp"
#include "film/files/extension.hpp"

namespace balcony::render {

Diagnostic not_a_picture_format(const std::filesystem::path& file) {
    std::string known;
    for (const DisplayFormat& format : display_formats()) {
        known += fmt::format("{}, ", format.extension);
    }
    return error(Kind::usage,
                 fmt::format("the file extension of '{}' is not a picture format", file.string()),
                 fmt::format("use a file name that ends in {}or .exr", known));
}

Diagnostics check_output(const std::filesystem::path& file) {
    if (ending_of(file) == ".exr") {
        return OutputFile::check(file);
    }
    const DisplayFormat* const format = display_format(file);
    if (format == nullptr) {
        return {not_a_picture_format(file)};
    }
    Diagnostics found = images::require_encoder(format->encoder);
    return found.empty() ? OutputFile::check(file) : found;
}

Diagnostics write(const Film& film, const std::filesystem::path& file,
                  const DisplayOptions& options) {
    if (Diagnostics found = check_output(file); has_errors(found)) {
        return found;
    }
    const DisplayFormat* const format = display_format(file);
    if (format == nullptr) {
        return write_exr(film, file);
    }
    const auto bytes = encode(film, *format, options);
    return bytes ? write_whole(file, *bytes) : bytes.diagnostics;
}

}  // namespace balcony::render
