// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "balcony/film.hpp"
#include "balcony/output_file.hpp"

namespace balcony::render {

namespace {

std::string ending(const std::filesystem::path& file) {
    std::string text = file.extension().string();
    std::transform(text.begin(), text.end(), text.begin(),
                   [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return text;
}

}  // namespace

Diagnostics check_output(const std::filesystem::path& file) {
    const std::string format = ending(file);
    if (format != ".png" && format != ".exr") {
        return {
            error(fmt::format("the file extension of '{}' is not a picture format", file.string()),
                  {}, "use a file name that ends in .png or .exr")};
    }
    return OutputFile::check(file);
}

Diagnostics write(const Film& film, const std::filesystem::path& file, const PngOptions& options) {
    if (Diagnostics found = check_output(file); has_errors(found)) {
        return found;
    }
    return ending(file) == ".png" ? write_png(film, file, options) : write_exr(film, file);
}

}  // namespace balcony::render
