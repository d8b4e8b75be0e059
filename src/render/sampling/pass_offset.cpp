// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/sampling/pass_offset.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "balcony/render.hpp"

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

}  // namespace

std::span<const PixelFilterInfo> pixel_filters() { return infos; }

const PixelFilter* find_pixel_filter(std::string_view name) {
    const auto row = std::find_if(rows.begin(), rows.end(),
                                  [&](const Row& one) { return one.info.name == name; });
    return row != rows.end() ? &row->filter : nullptr;
}

Imath::V2d pass_offset(const PixelFilter& filter, std::size_t pass) {
    if (pass == 0) {
        return {0.0, 0.0};
    }
    // Roberts' R2 sequence: steps by the powers of the plastic number's inverse.
    constexpr double plastic = 1.32471795724474602596;
    const auto at = [&](double step) {
        const double value = 0.5 + static_cast<double>(pass) * step;
        return std::nearbyint(quantile(filter, value - std::floor(value)) * 0x1p30) * 0x1p-30;
    };
    return {at(1.0 / plastic), at(1.0 / (plastic * plastic))};
}

double pass_moment(std::size_t pass) {
    constexpr double golden = 0.61803398874989484820;
    const double value = 0.5 + static_cast<double>(pass) * golden;
    return value - std::floor(value);
}

}  // namespace balcony::render
