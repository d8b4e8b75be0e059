// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Measures what a picture shows, from its data layers alone.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::plates {

/// A rectangle that hangs in the world: corner + s*right + t*up, s and t from 0 to 1.
struct Rectangle {
    scene::V3d corner, right, up;
};

/// The rectangle that a flat, rectangular object of a scene fills; it must have one instance.
[[nodiscard]] Rectangle rectangle_of(const scene::Scene& scene, const std::string& object);

/// How a picture shows a rectangle.
struct View {
    std::size_t pixels = 0;
    std::size_t regions = 0;         ///< Connected parts (by edges) of the object's pixels.
    double share_seen = 0.0;         ///< Of cells x cells equal cells of the rectangle, those hit.
    std::vector<double> anisotropy;  ///< A pixel each: ratio of the singular values of the map from
                                     ///< pixels to the rectangle's plane.
    double bend = 0.0;               ///< The farthest that a pixel lies from where the affine map
                                     ///< that fits best would put it, in diagonals.
    static constexpr std::size_t cells = 12;
};

[[nodiscard]] View view_of(const render::Film& film, const std::string& object,
                           const Rectangle& rectangle);

/// Of the objects whose names begin alike, how many a picture shows.
struct Sightings {
    std::size_t objects = 0;
    std::size_t seen = 0;
    std::size_t connected = 0;  ///< Shown as one region.
    std::size_t pixels = 0;     ///< Of all of them.
};

[[nodiscard]] Sightings sightings_of(const render::Film& film, const std::string& begin);

/// The pixels of an object, and its connected regions; none if it is not seen. Throws
/// std::runtime_error if no object of the scene has that name.
struct ObjectPixels {
    std::size_t pixels = 0;
    std::size_t regions = 0;
    std::size_t min_x = 0, max_x = 0, min_y = 0, max_y = 0;  ///< Of its pixels.
};
[[nodiscard]] ObjectPixels object_pixels(const render::Film& film, const std::string& object);

/// The largest number of separate runs of an object's pixels in a row of the picture. Throws as
/// object_pixels does.
[[nodiscard]] std::size_t max_runs_in_row(const render::Film& film, const std::string& object);

/// The ratio of the singular values of the matrix [[a, b], [c, d]], the larger one by the smaller.
[[nodiscard]] double singular_ratio(double a, double b, double c, double d);

/// The longest steps from a pixel's ray to its right and lower neighbours'.
struct RayStep {
    double origin = 0.0;     ///< Scene units.
    double direction = 0.0;  ///< Radians, for small angles.
};
[[nodiscard]] RayStep max_step(const render::Film& film);

}  // namespace balcony::plates
