// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <complex>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using Complex = std::complex<double>;

constexpr int max_iterations = 450;
constexpr double bailout = 1e4;

struct Escape {
    bool inside = false;
    double smooth_count = 0.0;  // Iterations, without steps.
    Complex slope;              // Unit vector of the steepest ascent of the potential.
};

// The main cardioid, where the iteration never escapes and need not be tried.
bool in_cardioid(const Complex& c) {
    const double x = c.real() - 0.25;
    const double y2 = c.imag() * c.imag();
    const double q = x * x + y2;
    return q * (q + x) < 0.25 * y2;
}

// z -> z^2 + c with dz/dc, written out in reals.
Escape escape(const Complex& c) {
    if (in_cardioid(c)) {
        return {true, 0.0, {}};
    }
    double x = 0.0;
    double y = 0.0;
    double dx = 0.0;
    double dy = 0.0;
    for (int n = 0; n < max_iterations; ++n) {
        const double next_dx = 2.0 * (x * dx - y * dy) + 1.0;
        dy = 2.0 * (x * dy + y * dx);
        dx = next_dx;
        const double next_x = x * x - y * y + c.real();
        y = 2.0 * x * y + c.imag();
        x = next_x;
        const double size = x * x + y * y;
        if (size > bailout) {
            const Complex ascent = Complex(x, y) / Complex(dx, dy);
            return {false, n + 1 - std::log2(std::log(size) / std::log(bailout)),
                    ascent / std::abs(ascent)};
        }
    }
    return {true, 0.0, {}};
}

}  // namespace

Color mandelbrot(const Sample& sample) {
    static const Gradient palette(
        {0x0b1340, 0x1d4e89, 0x59a5b8, 0xf3ecd2, 0xf0b64a, 0xc8441f, 0x5a1233}, true);
    static const Color night = from_srgb(0x070b24);

    const Complex middle(-0.743030, 0.126433);
    constexpr double half_height = 0.0108;
    static const Complex turn = std::polar(half_height, 0.9);
    const Escape e = escape(middle + turn * Complex(sample.point.x, sample.point.y + 0.13));
    if (e.inside) {
        return night;
    }
    // Light falls from the upper left on the relief whose height is the potential.
    static const Complex towards_light = std::polar(1.0, -2.3);
    const double light = std::real(e.slope * towards_light);
    const double shade = std::clamp((light + 1.6) / 2.6, 0.0, 1.0);
    const Color color = palette(0.42 * std::log(std::max(e.smooth_count - 20.0, 1.0)) + 0.05);
    return color * (0.35 + 0.75 * shade);
}

}  // namespace balcony::plates
