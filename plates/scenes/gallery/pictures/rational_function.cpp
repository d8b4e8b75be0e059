// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using Complex = std::complex<double>;

// A double zero in the middle, five zeros round it, ten poles further out in two circles.
Complex function(const Complex& z) {
    const Complex z2 = z * z;
    const Complex z5 = z2 * z2 * z;
    static const Complex poles = std::polar(3.4, 1.0);
    return z2 * (z5 - 0.32) / (z5 * z5 * 0.12 + z5 - poles);
}

// A sawtooth in [0, 1) whose jump is drawn as a soft dark line.
double relief(double t) {
    const double saw = t - std::floor(t);
    return 0.84 + 0.24 * saw - 0.30 * smooth_step(0.95, 1.0, saw);
}

}  // namespace

Color rational_function(const Sample& sample) {
    static const Gradient wheel(
        {0xd6402b, 0xf2a541, 0xf6e7b4, 0x6fb98f, 0x1f7a8c, 0x1b2a6b, 0x7b2d6d}, true);
    const Complex z = 1.80 * Complex(sample.point.x, sample.point.y);
    const Complex w = function(z);
    const double turns = std::arg(w) / (2.0 * std::numbers::pi);
    const double octaves = std::log2(std::max(std::abs(w), 1e-9));

    Color color = wheel(turns) * relief(2.0 * octaves) * relief(14.0 * turns);
    static const Color zero = from_srgb(0x0a0c24);
    static const Color pole = from_srgb(0xfff8e7);
    color = mix(color, zero, smooth_step(-4.5, -9.5, octaves));
    return mix(color, pole, smooth_step(3.0, 6.5, octaves));
}

}  // namespace balcony::plates
