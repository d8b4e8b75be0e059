// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/environment.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <numbers>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "balcony/images.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"
#include "base/parallel_for.hpp"
#include "shading/lights/atmosphere.hpp"
#include "shading/lights/environment_state.hpp"
#include "shading/textures/texture_reader.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;

// What infinity becomes: the largest value of half floats, which overflow in pictures of the sun.
constexpr float brightest = 65504.0F;

/// Reads colours, and repairs those that are no light.
class PixelReader {
public:
    explicit PixelReader(const images::ImageFile& image)
        : channels_(image.channels()), linear_(image.is_float()) {}

    [[nodiscard]] Color3f read(std::span<const float> pixel) {
        bool repaired = false;
        const auto channel = [&](std::size_t i) {
            const float value = linear_ ? pixel[i] : linear_from_srgb(pixel[i]);
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

// The sky with the sun above x, over a ground that is lit by both.
EnvironmentMap sky_map(const Atmosphere& air) {
    constexpr std::size_t width = 256;
    constexpr std::size_t half = width / 2;
    constexpr std::size_t rows = 128;  // Above the horizon.
    using std::numbers::pi;
    std::vector<Color3f> texels(width * 2 * rows);
    parallel_for(rows, [&](std::size_t row) {
        const double angle = 0.5 * pi * (static_cast<double>(row) + 0.5) / rows;
        for (std::size_t i = 0; i < half; ++i) {
            const double turn = pi * (static_cast<double>(i) + 0.5) / half;
            const Color3f color = air.sky({std::sin(angle) * std::cos(turn),
                                           std::sin(angle) * std::sin(turn), std::cos(angle)})
                                      .to_color();
            texels[row * width + half + i] = color;
            texels[row * width + half - 1 - i] = color;
        }
    });
    Color3f irradiance = std::max(0.0F, static_cast<float>(air.to_sun().z)) * air.sun().to_color();
    for (std::size_t row = 0; row < rows; ++row) {
        const double angle = 0.5 * pi * (static_cast<double>(row) + 0.5) / rows;
        const double solid_angle = std::sin(angle) * (0.5 * pi / rows) * (2.0 * pi / width);
        for (std::size_t x = 0; x < width; ++x) {
            irradiance +=
                static_cast<float>(solid_angle * std::cos(angle)) * texels[row * width + x];
        }
    }
    constexpr float ground_albedo = 0.2F;
    std::fill(texels.begin() + static_cast<std::ptrdiff_t>(rows * width), texels.end(),
              ground_albedo / std::numbers::pi_v<float> * irradiance);
    return {width, 2 * rows, std::move(texels)};
}

Diagnostic unusable(const std::filesystem::path& file, const Diagnostic& reason) {
    return error(reason.kind,
                 fmt::format("environment '{}' cannot be used: {}", file.string(), reason.message),
                 reason.remedy);
}

}  // namespace

Result<Environment> Environment::load(const std::filesystem::path& file,
                                      const std::stop_token& stop) {
    Result<std::unique_ptr<images::ImageFile>> opened = images::ImageFile::open(file);
    if (!opened) {
        return unusable(file, opened.diagnostics.front());
    }
    try {
        images::ImageFile& image = **opened;
        image.turn_upright();
        const std::size_t width = image.width();
        const std::size_t height = image.height();
        std::vector<Color3f> texels;
        texels.reserve(width * height);
        std::vector<float> row(width * image.channels());
        PixelReader pixels(image);
        for (std::size_t y = 0; y < height; ++y) {
            if (stop.stop_requested()) {
                return stopped();
            }
            if (const auto failure = image.read_rows(y, y + 1, row)) {
                return unusable(file, *failure);
            }
            for (std::size_t x = 0; x < width; ++x) {
                texels.push_back(
                    pixels.read(std::span(row).subspan(x * image.channels(), image.channels())));
            }
        }
        Diagnostics warnings;
        if (pixels.repaired() > 0) {
            warnings.push_back(warning(fmt::format(
                "environment '{}' has values that are negative, infinite or not a number in {} {}; "
                "they are replaced by 0, or by {} if positive",
                file.string(), pixels.repaired(), pixels.repaired() == 1 ? "pixel" : "pixels",
                brightest)));
        }
        auto map = std::make_shared<const EnvironmentMap>(width, height, std::move(texels), stop);
        if (stop.stop_requested()) {
            return stopped();
        }
        if (map->is_black()) {
            warnings.push_back(warning(
                fmt::format("environment '{}' is black and gives no light", file.string())));
        }
        return {Environment(std::make_shared<const State>(State{
                    std::move(map), {}, fmt::format("environment {}", file.filename().string())})),
                std::move(warnings)};
    } catch (const std::bad_alloc&) {
        return unusable(file, error("it needs more memory than available"));
    }
}

Environment Environment::constant(const Color3f& radiance) {
    auto map = std::make_shared<const EnvironmentMap>(1, 1, std::vector{radiance});
    return Environment(
        std::make_shared<const State>(State{std::move(map), {}, "a constant environment"}));
}

const std::string& Environment::description() const { return state_->description; }

// Like the overcast sky of the CIE (Moon and Spencer, 1942), brighter towards the zenith, but less
// so, and bluish.
Environment Environment::dome() {
    constexpr std::size_t rows = 64;
    const Color3f horizon(0.94F, 0.97F, 1.0F);
    const Color3f zenith(0.80F, 0.93F, 1.15F);
    const Color3f ground(0.33F, 0.32F, 0.31F);
    std::vector<Color3f> texels;
    for (std::size_t row = 0; row < rows; ++row) {
        const double angle = std::numbers::pi * (static_cast<double>(row) + 0.5) / rows;
        const auto height = static_cast<float>(std::cos(angle));
        const Color3f sky = (0.75F + 0.375F * height) * (horizon + height * (zenith - horizon));
        texels.push_back(height > 0.0F ? sky : ground);
    }
    auto map = std::make_shared<const EnvironmentMap>(1, rows, std::move(texels));
    return Environment(std::make_shared<const State>(
        State{std::move(map), {}, "a sky without sun, as the scene has no light"}));
}

Result<Environment> Environment::sky(const Sky& sky) {
    constexpr double right = 0.5 * std::numbers::pi;
    const bool sensible = sky.elevation >= -0.35 && sky.elevation <= right &&
                          sky.turbidity >= 1.0 && sky.turbidity <= 10.0 &&
                          std::isfinite(sky.azimuth);
    if (!sensible) {
        return error("the sky is out of range", {},
                     "give an elevation from -20 to 90 degrees, and a turbidity from 1 to 10");
    }
    const Atmosphere air(sky.turbidity, sky.elevation);
    const std::vector<Sun> suns{
        Sun(Imath::V3f(air.to_sun()), air.sun().to_color(), double{scene::sun_angle})};
    auto map = std::make_shared<const EnvironmentMap>(sky_map(air));
    constexpr double degree = right / 90.0;
    // From clockwise and north (y) to counterclockwise and x.
    return Environment(std::make_shared<const State>(State{
        std::move(map), suns,
        fmt::format("a sky with the sun at an elevation of {:.3g} degrees", sky.elevation / degree),
        right - sky.azimuth}));
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
