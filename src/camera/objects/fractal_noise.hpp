// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "balcony/spaces.hpp"

namespace balcony::camera {

/// Fractional Brownian motion in space (Musgrave, Kolb, Mace: "The Synthesis and Rendering of
/// Eroded Fractal Terrains", 1989): a sum of octaves of one smooth random function, each finer than
/// the one before by the lacunarity and lower by lacunarity^-hurst. The random function is a cubic
/// B-spline over a lattice of random numbers, twice continuously differentiable. Octaves are
/// rotated and shifted relative to each other, to hide the lattice and its period of 8.
///
/// The same seed gives the same values on every machine, up to rounding.
class FractalNoise {
public:
    FractalNoise(std::uint64_t seed, std::size_t octaves);

    /// Has mean 0 and variance 1 over all of space; the largest features have a size of 1 to 2.
    [[nodiscard]] Expr emit(const ObjectPoint& p, Expr lacunarity, Expr hurst) const;

private:
    struct Octave {
        std::array<std::array<double, 3>, 3> turn;
        std::array<double, 3> offset;
    };

    std::shared_ptr<const expr::Table> noise_;
    std::vector<Octave> octaves_;
};

}  // namespace balcony::camera
