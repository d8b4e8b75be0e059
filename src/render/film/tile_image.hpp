// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One pass over one tile, and its addition to the film.

#include <cstddef>
#include <cstdint>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/film.hpp"

namespace balcony::render {

/// The first surface on a ray that is not fully transparent.
struct VisibleSurface {
    bool any = false;
    V3f position{0.0F};
    V3f normal{0.0F};
    Color3f albedo{0.0F};
    std::uint32_t object = 0;  ///< Index into Scene::objects plus 1.
};

/// Parts of the radiance by how often their light was scattered, that is, reflected or refracted by
/// surfaces, on its way to the camera. The rest, light scattered more than once, is indirect.
/// Premultiplied like the radiance. To pass a surface because of its opacity is no scattering.
struct LightParts {
    Color3f emission{0.0F};  ///< Never: surfaces that emit, and the environment, seen directly.
    Color3f direct{0.0F};    ///< Once: light of lamps, emitting surfaces and the environment.
};

/// The data layers of a point.
struct PointData {
    bool valid = false;  ///< Whether there is a ray; otherwise all other values are undefined.
    std::uint16_t layer = 0;
    Imath::V3d origin;
    Imath::V3d direction;
    V2f parameters;
    VisibleSurface visible;
};

/// A sample of each pixel of a region, row by row.
struct TileImage {
    Region region;
    std::vector<Color4f> light;
    std::vector<PointData> data{};    ///< Empty if not requested.
    std::vector<Color4f> display{};   ///< Empty if not requested.
    std::vector<Color4f> mirrored{};  ///< Empty if not requested.
};

/// Calls visit(i, x, y) for each pixel (x, y) of a region, which is number i row by row.
template <class Visit>
void for_each_pixel(const Region& region, const Visit& visit) {
    std::size_t i = 0;
    for (std::size_t y = region.y; y < region.y + region.height; ++y) {
        for (std::size_t x = region.x; x < region.x + region.width; ++x) {
            visit(i++, x, y);
        }
    }
}

/// Adds the samples of a tile's next pass that are in the film's window. Two tiles may be added at
/// the same time.
void add_pass(Film& film, std::size_t tile, const TileImage& image);

}  // namespace balcony::render
