// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/povray/light_file.hpp"

#include <cmath>
#include <utility>
#include <vector>

#include <fmt/format.h>

namespace balcony::bridge::povray {

namespace {

// IEC 61966-2-1.
float linear_of_srgb(float value) {
    return value <= 0.04045F
               ? value / 12.92F
               : static_cast<float>(std::pow((static_cast<double>(value) + 0.055) / 1.055, 2.4));
}

Diagnostic unreadable(const std::string& reason) {
    return error(Kind::environment,
                 fmt::format("the picture that POV-Ray has written cannot be read: {}", reason));
}

}  // namespace

Result<LightFile> LightFile::open(const std::filesystem::path& file, std::size_t width,
                                  std::size_t height) {
    Result<std::unique_ptr<images::ImageFile>> opened = images::ImageFile::open(file);
    if (!opened) {
        return unreadable(opened.diagnostics.front().message);
    }
    const images::ImageFile& image = **opened;
    if (image.width() != width || image.height() != height || image.channels() < 3) {
        return error(fmt::format("POV-Ray has rendered {} x {} pixels with {} channels in place of "
                                 "{} x {} in colour",
                                 image.width(), image.height(), image.channels(), width, height),
                     {}, "omit POV-Ray's options for size and file type");
    }
    return LightFile(std::move(*opened));
}

Diagnostics LightFile::read_rows(std::size_t begin, std::span<Imath::Color4f> light) {
    const std::size_t channels = image_->channels();
    std::vector<float> values(light.size() * channels);
    if (const auto failed =
            image_->read_rows(begin, begin + light.size() / image_->width(), values)) {
        return {unreadable(failed->message)};
    }
    const bool straight = image_->unassociated_alpha().has_value();
    for (std::size_t i = 0; i < light.size(); ++i) {
        const float* const pixel = &values[i * channels];
        const float alpha = channels > 3 ? pixel[3] : 1.0F;
        const auto channel = [&](std::size_t c) {
            const float linear = image_->is_float() ? pixel[c] : linear_of_srgb(pixel[c]);
            const float known = std::isfinite(linear) ? linear : 0.0F;
            return straight ? known * alpha : known;
        };
        light[i] = {channel(0), channel(1), channel(2), alpha};
    }
    return {};
}

}  // namespace balcony::bridge::povray
