// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/draw/color_scale.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace balcony::analyse {

namespace {

// Ten equally spaced colours of matplotlib's map "viridis" by Nathaniel Smith, Stéfan van der Walt
// and Eric Firing, which is dedicated to the public domain (CC0).
constexpr std::array<Color, 10> viridis = {{{0x44, 0x01, 0x54},
                                            {0x48, 0x28, 0x78},
                                            {0x3e, 0x4a, 0x89},
                                            {0x31, 0x68, 0x8e},
                                            {0x26, 0x82, 0x8e},
                                            {0x1f, 0x9e, 0x89},
                                            {0x35, 0xb7, 0x79},
                                            {0x6d, 0xcd, 0x59},
                                            {0xb4, 0xde, 0x2c},
                                            {0xfd, 0xe7, 0x25}}};

// The smallest number of the form 1, 2 or 5 times a power of ten that is not below.
double round_up(double step) {
    const double decade = std::pow(10.0, std::floor(std::log10(step)));
    for (const double digit : {1.0, 2.0, 5.0}) {
        if (digit * decade >= step * (1.0 - 1e-9)) {
            return digit * decade;
        }
    }
    return 10.0 * decade;
}

}  // namespace

Color sequential_color(double s) {
    const double at = std::clamp(s, 0.0, 1.0) * static_cast<double>(viridis.size() - 1);
    const auto below = std::min(static_cast<std::size_t>(at), viridis.size() - 2);
    const double share = at - static_cast<double>(below);
    Color color{};
    for (std::size_t i = 0; i < color.size(); ++i) {
        color[i] = static_cast<std::uint8_t>(
            std::lround((1.0 - share) * viridis[below][i] + share * viridis[below + 1][i]));
    }
    return color;
}

ColorScale::ColorScale(double minimum, double maximum, Spacing spacing)
    : min_(minimum), max_(maximum), spacing_(spacing) {}

double ColorScale::position(double value) const {
    const double s = spacing_ == Spacing::linear ? (value - min_) / (max_ - min_)
                                                 : std::log(value / min_) / std::log(max_ / min_);
    return std::clamp(s, 0.0, 1.0);
}

double ColorScale::value(double position) const {
    return spacing_ == Spacing::linear ? min_ + position * (max_ - min_)
                                       : min_ * std::pow(max_ / min_, position);
}

std::vector<ColorScale::Tick> ColorScale::ticks(double wanted) const {
    constexpr double slack = 1e-9;
    std::vector<Tick> ticks;
    // A decade or more: powers of ten, with two and five times these if there is room.
    if (spacing_ == Spacing::logarithmic && max_ / min_ >= 10.0) {
        const double decades = std::log10(max_ / min_);
        const double skip = std::ceil(decades / wanted);
        for (double power = std::floor(std::log10(min_)); power <= std::log10(max_);
             power += skip) {
            for (const double digit : {1.0, 2.0, 5.0}) {
                const double value = digit * std::pow(10.0, power);
                const bool has_room = digit == 1.0 || decades < 3.0;
                if (has_room && value >= min_ && value <= max_) {
                    ticks.push_back({value, fmt::format("{:.6g}", value)});
                }
            }
        }
        return ticks;
    }
    const double step = round_up((max_ - min_) / wanted);
    for (double i = std::ceil(min_ / step - slack) + 0.0; i * step <= max_ + slack * step; ++i) {
        ticks.push_back({i * step, fmt::format("{:.6g}", i * step)});
    }
    return ticks;
}

}  // namespace balcony::analyse
