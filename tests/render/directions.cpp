// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "directions.hpp"

namespace balcony::render::test {

using Imath::V3f;

namespace {

using std::numbers::pi;

}  // namespace

std::size_t SphereCells::cell_of(const V3f& direction) {
    const double z = 0.5 * (1.0 - double{direction.z});
    const double turn = std::atan2(double{direction.y}, double{direction.x}) / (2.0 * pi) + 0.5;
    const auto row = std::min(static_cast<std::size_t>(z * rows), rows - 1);
    const auto column = std::min(static_cast<std::size_t>(turn * columns), columns - 1);
    return row * columns + column;
}

std::vector<double> SphereCells::integrals(const std::function<double(const V3f&)>& density,
                                           int steps) {
    std::vector<double> found(rows * columns);
    const double weight = 4.0 * pi / (rows * columns) / (steps * steps);
    for (std::size_t cell = 0; cell < found.size(); ++cell) {
        for (int i = 0; i < steps * steps; ++i) {
            const double z =
                1.0 -
                2.0 * (static_cast<double>(cell / columns) + (i / steps + 0.5) / steps) / rows;
            const double turn =
                2.0 * pi *
                ((static_cast<double>(cell % columns) + (i % steps + 0.5) / steps) / columns - 0.5);
            const double across = std::sqrt(1.0 - z * z);
            found[cell] +=
                weight *
                density(V3f(Imath::V3d(across * std::cos(turn), across * std::sin(turn), z)));
        }
    }
    return found;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

}  // namespace balcony::render::test
