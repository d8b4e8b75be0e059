// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/environment.hpp"

#include <algorithm>
#include <cmath>
#include <new>
#include <vector>

#include <fmt/format.h>

#include "balcony/image_file.hpp"
#include "render/lights/environment_state.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;

// What infinity becomes: the largest value of half floats, which overflow in pictures of the sun.
constexpr float brightest = 65504.0F;

float from_srgb(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

/// Reads colours, and repairs those that are no light.
class PixelReader {
public:
    explicit PixelReader(const scene::ImageFile& image)
        : channels_(image.channels()), linear_(image.is_float()) {}

    [[nodiscard]] Color3f read(std::span<const float> pixel) {
        bool repaired = false;
        const auto channel = [&](std::size_t i) {
            const float value = linear_ ? pixel[i] : from_srgb(pixel[i]);
            if (value >= 0.0F && value <= std::numeric_limits<float>::max()) {
                return value;
            }
            repaired = true;
            return value > 0.0F ? brightest : 0.0F;
        };
        const Color3f color =
            channels_ < 3 ? Color3f(channel(0)) : Color3f(channel(0), channel(1), channel(2));
        repaired_ += repaired ? 1 : 0;
        return color;
    }

    [[nodiscard]] std::size_t repaired() const { return repaired_; }

private:
    std::size_t channels_;
    bool linear_;
    std::size_t repaired_ = 0;
};

Diagnostic unusable(const std::filesystem::path& file, const Diagnostic& reason) {
    return error(fmt::format("environment '{}' cannot be used: {}", file.string(), reason.message),
                 {}, reason.remedy);
}

}  // namespace

Result<Environment> Environment::load(const std::filesystem::path& file) {
    Result<scene::ImageFile> image = scene::ImageFile::open(file);
    if (!image) {
        return unusable(file, image.diagnostics.front());
    }
    try {
        const std::size_t width = image->width();
        const std::size_t height = image->height();
        std::vector<Color3f> texels;
        texels.reserve(width * height);
        std::vector<float> row(width * image->channels());
        PixelReader pixels(*image);
        for (std::size_t y = 0; y < height; ++y) {
            if (const auto failure = image->read_rows(y, y + 1, row)) {
                return unusable(file, *failure);
            }
            for (std::size_t x = 0; x < width; ++x) {
                texels.push_back(
                    pixels.read(std::span(row).subspan(x * image->channels(), image->channels())));
            }
        }
        Diagnostics warnings;
        if (pixels.repaired() > 0) {
            warnings.push_back(warning(fmt::format(
                "environment '{}' has {} pixels that are negative, infinite or not a number; "
                "they are replaced by 0, or by {} if positive",
                file.string(), pixels.repaired(), brightest)));
        }
        auto map = std::make_shared<const EnvironmentMap>(width, height, std::move(texels));
        if (map->is_black()) {
            warnings.push_back(warning(
                fmt::format("environment '{}' is black and gives no light", file.string())));
        }
        return {Environment(std::make_shared<const State>(State{std::move(map)})),
                std::move(warnings)};
    } catch (const std::bad_alloc&) {
        return unusable(file, error("it needs more memory than available"));
    }
}

Environment Environment::constant(const Color3f& radiance) {
    auto map = std::make_shared<const EnvironmentMap>(1, 1, std::vector{radiance});
    return Environment(std::make_shared<const State>(State{std::move(map)}));
}

Environment Environment::rotated(double angle) const {
    State state = *state_;
    state.rotation += angle;
    return Environment(std::make_shared<const State>(std::move(state)));
}

Environment Environment::scaled(float factor) const {
    State state = *state_;
    state.strength *= factor;
    return Environment(std::make_shared<const State>(std::move(state)));
}

}  // namespace balcony::render
