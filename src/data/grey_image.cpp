// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "balcony/images.hpp"
#include "data/files.hpp"

namespace balcony::data {

namespace {

using camera::GreyImage;
using images::ImageFile;

Diagnostic no_image(const File& file, const Diagnostic& reason) {
    return error(reason.kind,
                 fmt::format("'{}' cannot be read as an image: {}", file.name, reason.message),
                 reason.remedy);
}

/// Rec. 709 luma, or the first channel, times straight alpha. Written so
/// that a NaN becomes 0.
float grey(std::span<const float> pixel, const std::optional<std::size_t>& alpha) {
    const float luma =
        pixel.size() >= 3 ? 0.2126F * pixel[0] + 0.7152F * pixel[1] + 0.0722F * pixel[2] : pixel[0];
    const float value = alpha ? luma * pixel[*alpha] : luma;
    return value > 0.0F ? std::min(value, 1.0F) : 0.0F;
}

Result<std::shared_ptr<const GreyImage>> read_pixels(ImageFile& input, const File& file) {
    const std::size_t width = input.width();
    const std::size_t height = input.height();
    if (width > max_pixels / height) {
        return error(
            fmt::format("'{}' has {} x {} pixels, more than 16 million", file.name, width, height),
            {}, "scale it down: a mask needs no more pixels than the picture");
    }
    const std::size_t channels = input.channels();
    const auto alpha = input.unassociated_alpha();
    constexpr std::size_t rows_at_once = 64;
    std::vector<float> values;
    GreyImage image{width, height, {}};
    image.values.reserve(width * height);
    for (std::size_t row = 0; row < height; row += rows_at_once) {
        const std::size_t end = std::min(row + rows_at_once, height);
        values.resize((end - row) * width * channels);
        if (const auto failure = input.read_rows(row, end, values)) {
            return no_image(file, *failure);
        }
        for (std::size_t i = 0; i < values.size(); i += channels) {
            image.values.push_back(grey(std::span(values).subspan(i, channels), alpha));
        }
    }
    return std::make_shared<const GreyImage>(std::move(image));
}

}  // namespace

Result<std::shared_ptr<const GreyImage>> read_grey_image(const File& file) {
    Result<std::unique_ptr<ImageFile>> input =
        file.bytes ? ImageFile::open(file.path, *file.bytes) : ImageFile::open(file.path);
    if (!input) {
        return no_image(file, input.diagnostics.front());
    }
    (*input)->turn_upright();
    return read_pixels(**input, file);
}

}  // namespace balcony::data
