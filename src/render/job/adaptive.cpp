// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/adaptive.hpp"

#include <algorithm>
#include <bit>

#include "balcony/median.hpp"
#include "film/sums/tile_image.hpp"
#include "images/luminance.hpp"

namespace balcony::render {

namespace {

// What is known of a pixel: its luminance, and the square of the difference between all samples
// and their first half, in colour and in alpha.
struct Estimate {
    double luminance = 0.0;
    double color = 0.0;
    double alpha = 0.0;
};

Estimate estimate(const Film& film, std::size_t at) {
    const double count = film.pixel_passes[at];
    const Color4d mean = film.sum[at] / count;
    const Color4d difference = mean - film.first_half[at] * (2.0 / count);
    const auto square = [](double value) { return value * value; };
    return {luminance(Color3f(static_cast<float>(mean.r), static_cast<float>(mean.g),
                              static_cast<float>(mean.b))),
            (square(difference.r) + square(difference.g) + square(difference.b)) / 3.0,
            square(difference.a)};
}

// The estimates of a tile's part in the window, and their means around a pixel.
class Estimates {
public:
    Estimates(const Film& film, const Region& region) : region_(region) {
        estimates_.reserve(region.size());
        for_each_pixel(region, [&](std::size_t, std::size_t x, std::size_t y) {
            estimates_.push_back(estimate(film, film.index(x, y)));
        });
    }

    [[nodiscard]] Estimate around(std::size_t x, std::size_t y) const {
        constexpr std::size_t reach = 2;
        Estimate mean;
        double count = 0.0;
        for (std::size_t j = std::max(y, region_.y + reach) - reach;
             j <= std::min(y + reach, region_.y + region_.height - 1); ++j) {
            for (std::size_t i = std::max(x, region_.x + reach) - reach;
                 i <= std::min(x + reach, region_.x + region_.width - 1); ++i) {
                const Estimate& one = estimates_[(j - region_.y) * region_.width + i - region_.x];
                mean.luminance += one.luminance;
                mean.color += one.color;
                mean.alpha += one.alpha;
                count += 1.0;
            }
        }
        return {mean.luminance / count, mean.color / count, mean.alpha / count};
    }

private:
    Region region_;
    std::vector<Estimate> estimates_;
};

}  // namespace

std::uint32_t first_judgement(const SamplingSettings& settings) {
    return std::bit_ceil(std::max<std::uint32_t>(settings.min_samples, 2));
}

double white_of(const Film& film) {
    constexpr double middle_grey = 0.18;
    std::vector<double> lit;
    for (std::size_t y = film.window.y; y < film.window.y + film.window.height; ++y) {
        for (std::size_t x = film.window.x; x < film.window.x + film.window.width; ++x) {
            const Color4f light = film.light(x, y);
            const double found = luminance(Color3f(light.r, light.g, light.b));
            if (found > 0.0) {
                lit.push_back(found);
            }
        }
    }
    return median(std::move(lit)).value_or(middle_grey) / middle_grey;
}

bool find_active(const Film& film, std::size_t tile, const Region& region,
                 const SamplingSettings& settings, std::vector<std::uint8_t>& active) {
    const std::uint32_t count = film.passes[tile];
    const Region inside = region.intersection(film.window);
    active.assign(region.size(), 1);
    bool any = false;
    const auto judge = [&](const auto& needs_more) {
        for_each_pixel(region, [&](std::size_t i, std::size_t x, std::size_t y) {
            if (film.window.contains(x, y)) {
                active[i] = film.pixel_passes[film.index(x, y)] == count && needs_more(x, y);
                any = any || active[i] != 0;
            }
        });
    };
    if (count < first_judgement(settings) || !std::has_single_bit(count)) {
        judge([](std::size_t, std::size_t) { return true; });
        return any;
    }
    const Estimates estimates(film, inside);
    const double level = settings.noise * settings.noise;
    judge([&](std::size_t x, std::size_t y) {
        // A thousandth of white is black.
        constexpr double black = 1e-3;
        const Estimate mean = estimates.around(x, y);
        const double reference = film.white * std::max(mean.luminance, black * film.white);
        return mean.color > level * reference || mean.alpha > level;
    });
    return any;
}

}  // namespace balcony::render
