// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Marble, and what wind and sand did to it.

#include "balcony/scene.hpp"
#include "common/painting.hpp"

namespace balcony::plates::temple {

/// Smooth noise in space in [-1, 1] with features of size 1.
[[nodiscard]] double noise(const V3d& point, std::uint32_t seed);

/// Sum of octaves of noise that repeats with period 1 in x and y; features of the first octave have
/// the size 1/cells.
[[nodiscard]] double tile_noise(const V2d& point, int cells, int octaves, std::uint32_t seed);

/// A tile of veined marble: warm white, with honey-coloured patina where iron has come out.
[[nodiscard]] Color marble(const Sample& sample);

/// The floor: rings of slabs in three marbles about a star of 14 rays.
[[nodiscard]] Color floor_slabs(const Sample& sample);

/// A grey level of about 1 for a block of stone; another number, another level.
[[nodiscard]] Color block_tint(int number, double variation = 0.12);

/// Moves positions by noise, so that edges are no longer straight; the same position, the same way.
void weather(scene::Mesh& mesh, double amount, double size);

}  // namespace balcony::plates::temple
