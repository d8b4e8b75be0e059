// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using Complex = std::complex<double>;

// Five zeros on a circle, a double one in the middle, five poles further out, turned a little.
Complex function(const Complex& z) {
    const Complex z5 = std::pow(z, 5);
    const Complex poles = std::polar(3.4, 1.0);
    return z * z * (z5 - 0.32) / (z5 * z5 * 0.12 + z5 - poles);
}

// A sawtooth in [0, 1) whose jump is drawn as a soft dark line.
double relief(double t) {
    const double saw = t - std::floor(t);
    return 0.72 + 0.28 * saw - 0.25 * smooth_step(0.965, 1.0, saw);
}

}  // namespace

Color rational_function(const Sample& sample) {
    static const Gradient wheel({0xd6402b, 0xf2a541, 0xf6e7b4, 0x6fb98f, 0x1f7a8c, 0x1b2a6b,
                                 0x7b2d6d}, true);
    const Complex z = 1.72 * Complex(sample.point.x, sample.point.y);
    const Complex w = function(z);
    const double turns = std::arg(w) / (2.0 * std::numbers::pi);
    const double octaves = std::log2(std::max(std::abs(w), 1e-9));

    Color color = wheel(turns) * relief(octaves) * relief(12.0 * turns);
    color = mix(color, from_srgb(0x0a0c24), smooth_step(-3.0, -7.5, octaves));
    return mix(color, from_srgb(0xfff8e7), smooth_step(3.5, 7.0, octaves));
}

}  // namespace balcony::plates
