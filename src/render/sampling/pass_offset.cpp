// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/sampling/pass_offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "balcony/render.hpp"
#include "render/sampling/digits.hpp"

namespace balcony::render {

namespace {

struct Row {
    PixelFilterInfo info;
    PixelFilter filter;
};

// The integral of the window's cosines (Harris 1978), as wide as in Blender's Cycles.
double blackman_harris(double offset) {
    constexpr double a0 = 0.35875;
    constexpr double a1 = 0.48829;
    constexpr double a2 = 0.14128;
    constexpr double a3 = 0.01168;
    const double t = offset / 3.0 + 0.5;
    const double angle = 2.0 * std::numbers::pi * t;
    const double waves =
        a1 * std::sin(angle) - a2 / 2.0 * std::sin(2.0 * angle) + a3 / 3.0 * std::sin(3.0 * angle);
    return t - waves / (2.0 * std::numbers::pi * a0);
}

double box(double offset) { return offset + 0.5; }

double tent(double offset) {
    const double rest = 1.0 - std::abs(offset);
    return offset < 0.0 ? 0.5 * rest * rest : 1.0 - 0.5 * rest * rest;
}

// Cut off at 3 standard deviations.
double gaussian(double offset) {
    constexpr double deviation = 0.5;
    const auto part = [](double x) { return std::erf(x / (deviation * std::numbers::sqrt2)); };
    return 0.5 + 0.5 * part(offset) / part(3.0 * deviation);
}

constexpr std::array rows{
    Row{{"blackman-harris", "sharp, without ringing"}, {1.5, blackman_harris}},
    Row{{"box", "the pixel's own square"}, {0.5, box}},
    Row{{"tent", "linear interpolation"}, {1.0, tent}},
    Row{{"gaussian", "softer"}, {1.5, gaussian}},
};

constexpr auto infos = [] {
    std::array<PixelFilterInfo, rows.size()> made;
    std::transform(rows.begin(), rows.end(), made.begin(), [](const Row& row) { return row.info; });
    return made;
}();

// The offset below which the given share of samples lies.
double quantile(const PixelFilter& filter, double share) {
    double below = -filter.radius;
    double above = filter.radius;
    // Halves a width of at most 3 to less than 2^-30.
    for (int halving = 0; halving < 34; ++halving) {
        const double middle = 0.5 * (below + above);
        (filter.distribution(middle) < share ? below : above) = middle;
    }
    return 0.5 * (below + above);
}

// The digits of two numbers from [0, 1), the first in the lowest bit.
struct NetPoint {
    std::uint32_t x = 0;
    std::uint32_t y = 0;
};

// Sobol's first two dimensions, scrambled by Owen's method: of any 2^k passes from a multiple of
// 2^k on, one lies in each elementary rectangle of area 2^-k.
NetPoint scrambled_net_point(std::uint32_t pass) {
    constexpr std::uint32_t x_seed = 0x2f1b3c5dU;
    constexpr std::uint32_t y_seed = 0x9d6e8a47U;
    return {scrambled(pass, x_seed), scrambled(in_powers_of_z_plus_1(pass), y_seed)};
}

// Shifted digit by digit, which preserves that, so that the first point is (1/2, 1/2).
NetPoint net_point(std::uint32_t pass) {
    constexpr std::uint32_t half = 1;
    const NetPoint first = scrambled_net_point(0);
    const NetPoint point = scrambled_net_point(pass);
    return {point.x ^ first.x ^ half, point.y ^ first.y ^ half};
}

}  // namespace

std::span<const PixelFilterInfo> pixel_filters() { return infos; }

const PixelFilter* find_pixel_filter(std::string_view name) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& one) { return one.info.name == name; });
    return row != rows.end() ? &row->filter : nullptr;
}

Imath::V2d pass_offset(const PixelFilter& filter, std::size_t pass) {
    const NetPoint net = net_point(static_cast<std::uint32_t>(pass));
    const auto at = [&](std::uint32_t digits) {
        const double share = static_cast<double>(reversed(digits)) * 0x1p-32;
        return std::nearbyint(quantile(filter, share) * 0x1p30) * 0x1p-30;
    };
    return {at(net.x), at(net.y)};
}

double pass_moment(std::size_t pass) {
    constexpr double golden = 0.61803398874989484820;
    const double value = 0.5 + static_cast<double>(pass) * golden;
    return value - std::floor(value);
}

}  // namespace balcony::render
