// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Random numbers, and cells of the sphere in which directions are counted.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <numbers>
#include <random>
#include <vector>

#include <Imath/ImathVec.h>

namespace balcony::render::test {

/// From a fixed seed.
class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}

    float number() { return static_cast<float>(generator_() >> 8U) * 0x1p-24F; }
    Imath::V2f pair() { return {number(), number()}; }
    Imath::V3f numbers() { return {number(), number(), number()}; }
    /// In a cube around the origin.
    Imath::V3f point(float half) { return half * (2.0F * numbers() - Imath::V3f(1.0F)); }
    Imath::V3f direction() {
        for (;;) {
            const Imath::V3f found = point(1.0F);
            if (found.length2() > 0.01F && found.length2() < 1.0F) {
                return found.normalized();
            }
        }
    }

private:
    std::mt19937 generator_;
};

/// Cells of the sphere of equal solid angle.
struct SphereCells {
    static constexpr std::size_t rows = 24;
    static constexpr std::size_t columns = 48;

    [[nodiscard]] static std::size_t cell_of(const Imath::V3f& direction);
    /// The integral of a density over each cell, by steps² points.
    [[nodiscard]] static std::vector<double> integrals(
        const std::function<double(const Imath::V3f&)>& density, int steps);
};

[[nodiscard]] double sum(const std::vector<double>& values);

}  // namespace balcony::render::test
