// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A leaf of the plant, on its stalk.

#include "balcony/scene.hpp"
#include "common/painting.hpp"

namespace balcony::plates {

/// Lengths are in scene units, angles in radians.
struct Leaf {
    double azimuth;  ///< Of the plane in which stalk and midrib bend.
    double pitch;    ///< Of the stalk above the horizon at the soil.
    double stalk_length;
    double length;  ///< Of the blade.
    double width;   ///< Of the blade where it is widest.
    double droop;   ///< By how much the blade bends down on its way to the tip.
    double roll;    ///< About the midrib.
    double wave;    ///< Height of the waves of the edge, in widths.
    double phase;   ///< Of the waves.
};

/// A leaf of a plant with so many leaves, of which the youngest (with the highest numbers) stand in
/// the middle, upright and small.
[[nodiscard]] Leaf leaf_of_plant(int number, int count);

[[nodiscard]] scene::Mesh leaf_blade(const Leaf& leaf);
[[nodiscard]] scene::Mesh leaf_stalk(const Leaf& leaf);

/// The colour of a blade: green with paler bands along the side veins; the tip is at the top.
[[nodiscard]] Color leaf_color(const Sample& sample);

}  // namespace balcony::plates
