// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/animation/frame_file.hpp"

#include <algorithm>
#include <fstream>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/display_file.hpp"
#include "balcony/images.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

// How a file of a format ends; empty if formats of this kind have no mark there.
std::string_view end_mark(const fs::path& file) {
    const render::DisplayFormat* const format = render::display_format(file);
    const std::string_view encoder = format != nullptr ? format->encoder : "";
    return encoder == "png" ? "IEND\xae\x42\x60\x82" : encoder == "jpeg" ? "\xff\xd9" : "";
}

// Decoders take what there is of some files.
bool ends_with(const fs::path& file, std::string_view mark) {
    std::ifstream stream(file, std::ios::binary);
    std::string end(mark.size(), '\0');
    stream.seekg(-static_cast<std::streamoff>(mark.size()), std::ios::end);
    stream.read(end.data(), static_cast<std::streamsize>(end.size()));
    return stream && end == mark;
}

}  // namespace

std::optional<Diagnostic> why_damaged(const fs::path& frame, FramePart part) {
    const std::string_view mark = end_mark(frame);
    if (!mark.empty() && !ends_with(frame, mark)) {
        return error("it is truncated");
    }
    if (!mark.empty() && part == FramePart::end) {
        return std::nullopt;
    }
    const auto opened = images::ImageFile::open(frame, images::ImageChannels::all);
    if (!opened) {
        return opened.diagnostics.front();
    }
    images::ImageFile& image = **opened.value;
    constexpr std::size_t rows_at_once = 64;
    std::vector<float> values(rows_at_once * image.width() * image.channels());
    const std::size_t last = (image.height() - 1) / rows_at_once * rows_at_once;
    for (std::size_t row = part == FramePart::all ? 0 : last; row < image.height();
         row += rows_at_once) {
        const std::size_t end = std::min(row + rows_at_once, image.height());
        const std::size_t count = (end - row) * image.width() * image.channels();
        if (auto reason = image.read_rows(row, end, std::span(values).first(count))) {
            return reason;
        }
    }
    return std::nullopt;
}

}  // namespace balcony::app
