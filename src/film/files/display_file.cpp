// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/display_file.hpp"

#include <algorithm>
#include <array>
#include <string>

#include <fmt/format.h>

#include "balcony/images.hpp"
#include "balcony/output_file.hpp"
#include "film/files/extension.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t any_side = 0x7fffffff;

constexpr std::array formats{
    DisplayFormat{".png", "png", true, 8, 16, any_side},
    DisplayFormat{".jpg", "jpeg", false, 8, 8, 65535},
    DisplayFormat{".jpeg", "jpeg", false, 8, 8, 65535},
    DisplayFormat{".webp", "webp", true, 8, 8, 16383, false},
    DisplayFormat{".tif", "tiff", true, 16, 16, any_side},
    DisplayFormat{".tiff", "tiff", true, 16, 16, any_side},
};

Result<std::vector<std::uint8_t>> encode(const images::Samples& samples, const DisplaySize& size,
                                         const DisplayFormat& format) {
    if (Diagnostics found = check_size(format, size.width, size.height); has_errors(found)) {
        return found;
    }
    return images::encode({size.width, size.height, size.channels, samples, size.dpi},
                          format.encoder);
}

}  // namespace

std::span<const DisplayFormat> display_formats() { return formats; }

const DisplayFormat* display_format(const std::filesystem::path& file) {
    const std::string extension = ending_of(file);
    const auto* const format = std::find_if(
        formats.begin(), formats.end(),
        [&](const DisplayFormat& candidate) { return candidate.extension == extension; });
    return format == formats.end() ? nullptr : format;
}

Diagnostics check_size(const DisplayFormat& format, std::size_t width, std::size_t height) {
    if (std::max(width, height) <= format.max_side) {
        return {};
    }
    return {
        error(Kind::usage,
              fmt::format("a {} file has at most {} pixels per side, but the picture has {} x {}",
                          format.extension, format.max_side, width, height),
              "write a .png or .tif file")};
}

Result<std::vector<std::uint8_t>> encode(const std::vector<std::uint8_t>& samples,
                                         const DisplaySize& size, const DisplayFormat& format) {
    return encode(images::Samples(std::span(samples)), size, format);
}

Result<std::vector<std::uint8_t>> encode(const std::vector<std::uint16_t>& samples,
                                         const DisplaySize& size, const DisplayFormat& format) {
    return encode(images::Samples(std::span(samples)), size, format);
}

Diagnostics write_samples(const std::vector<std::uint8_t>& samples, const DisplaySize& size,
                          const std::filesystem::path& file) {
    const DisplayFormat* const format = display_format(file);
    if (format == nullptr) {
        return {not_a_picture_format(file)};
    }
    // Encoded in memory first, so that only one call can fail to write.
    const auto bytes = encode(samples, size, *format);
    return bytes ? write_whole(file, *bytes) : bytes.diagnostics;
}

}  // namespace balcony::render
