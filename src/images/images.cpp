// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/images.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include "images/image_library.hpp"
#include "images/png.hpp"

namespace balcony::images {

namespace {

constexpr std::string_view png_format = "png";
constexpr std::array encoders{png_format, std::string_view("jpeg"), std::string_view("webp"),
                              std::string_view("tiff")};

bool has_size(std::size_t width, std::size_t height) {
    constexpr std::size_t largest = std::numeric_limits<int>::max();
    return width > 0 && height > 0 && width <= largest && height <= largest;
}

bool holds_together(const Raster& raster) {
    const std::size_t values =
        std::visit([](auto samples) { return samples.size(); }, raster.samples);
    return has_size(raster.width, raster.height) &&
           (raster.channels == 3 || raster.channels == 4) &&
           values == raster.width * raster.height * raster.channels;
}

}  // namespace

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& file,
                                                   ImageChannels channels) {
    const auto& library = image_library();
    return library ? (*library)->open(file, channels) : library.diagnostics;
}

Result<std::unique_ptr<ImageFile>> ImageFile::open(const std::filesystem::path& name,
                                                   std::span<const std::uint8_t> bytes,
                                                   ImageChannels channels) {
    const auto& library = image_library();
    return library ? (*library)->open(name, bytes, channels) : library.diagnostics;
}

Result<std::vector<std::uint8_t>> encode(const Raster& raster, std::string_view format) {
    if (!holds_together(raster) ||
        std::find(encoders.begin(), encoders.end(), format) == encoders.end()) {
        return error(Kind::internal, "the samples, channels or format of an image cannot be");
    }
    if (format == png_format) {
        return encode_png(raster);
    }
    const auto& library = image_library();
    return library ? (*library)->encode(raster, format) : library.diagnostics;
}

Result<std::unique_ptr<FilteredImage>> FilteredImage::make(const LinearImage& image, bool closes) {
    if (!has_size(image.width, image.height) ||
        image.values.size() != 4 * image.width * image.height) {
        return error(Kind::internal, "an image to filter does not have four values a pixel");
    }
    const auto& library = image_library();
    if (!library) {
        return library.diagnostics;
    }
    return (*library)->filter(image, closes);
}

Diagnostics require_encoder(std::string_view format) {
    return format == png_format ? Diagnostics() : require();
}

Diagnostics require() { return image_library().diagnostics; }

}  // namespace balcony::images
