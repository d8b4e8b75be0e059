// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One pass over one tile, and its addition to the film.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
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
    std::uint32_t object = 0;    ///< Index into Scene::objects plus 1.
    std::uint32_t material = 0;  ///< Index into Scene::materials plus 1.
    std::uint32_t instance = 0;  ///< Index into Scene::instances.
    std::uint32_t triangle = 0;  ///< Index into Mesh::triangles.
    float u = 0.0F;              ///< The point (1 - u - v) p0 + u p1 + v p2 of the triangle.
    float v = 0.0F;
};

/// The objects and materials that a ray sees, each by its part of the ray.
struct Coverage {
    Matte objects;
    Matte materials;

    void add(const VisibleSurface& surface, float part) {
        objects.add(surface.object, part);
        materials.add(surface.material, part);
    }
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
    double length = 0.0;  ///< From the origin to the visible surface, along the ray.
    /// The visible surface, on the ray, as its position is rounded; without one, a point of the ray
    /// so far away that only its last direction matters.
    Imath::V3d end;
    V2f parameters;
    float magnification = 0.0F;  ///< 0 if unknown.
    double time = 0.0;           ///< When the ray meets the scene, in seconds.
    VisibleSurface visible;
    V4f motion{0.0F};  ///< As DataLayers::motion.
};

/// What a camera layer contributes to a point, for the layers that are means over the passes.
struct Contribution {
    float weight = 0.0F;  ///< Of the camera layer at the point, from 0 to 1.
    LightParts parts;
    VisibleSurface shown;  ///< As in Seen.
    Coverage coverage;
};

/// A list of contributions for each pixel.
class Contributions {
public:
    [[nodiscard]] bool empty() const { return ends_.empty(); }
    void add(const Contribution& one) { all_.push_back(one); }
    /// The following ones are of the next pixel.
    void end_pixel() { ends_.push_back(all_.size()); }
    [[nodiscard]] std::span<const Contribution> operator[](std::size_t i) const {
        const std::size_t begin = i == 0 ? 0 : ends_[i - 1];
        return std::span(all_).subspan(begin, ends_[i] - begin);
    }

private:
    std::vector<Contribution> all_;
    std::vector<std::size_t> ends_;
};

/// A sample of each pixel of a region, row by row.
struct TileImage {
    Region region;
    std::vector<Color4f> light;
    std::vector<PointData> data{};       ///< Empty if not requested.
    std::vector<Color4f> display{};      ///< Empty if not requested.
    std::vector<Color4f> mirrored{};     ///< Empty if not requested.
    Contributions contributions{};       ///< Empty if not requested.
    std::vector<std::uint8_t> active{};  ///< Whether a pixel has a sample; empty if all have.
};

/// Calls visit(i, x, y, width) for each row of a region, as far as it is in a window, too: its
/// first pixel (x, y), whose number in the region, row by row, is i, and its number of pixels.
template <class Visit>
void for_each_row_within(const Region& region, const Region& window, const Visit& visit) {
    const Region shared = region.intersection(window);
    for (std::size_t y = shared.y; y < shared.y + shared.height && shared.width > 0; ++y) {
        visit((y - region.y) * region.width + shared.x - region.x, shared.x, y, shared.width);
    }
}

/// Calls visit(i, x, y) for each pixel (x, y) of a region that is in a window, too; i is its number
/// in the region, row by row.
template <class Visit>
void for_each_pixel_within(const Region& region, const Region& window, const Visit& visit) {
    for_each_row_within(region, window,
                        [&](std::size_t first, std::size_t left, std::size_t y, std::size_t width) {
                            for (std::size_t k = 0; k < width; ++k) {
                                visit(first + k, left + k, y);
                            }
                        });
}

/// The same for all pixels of a region.
template <class Visit>
void for_each_pixel(const Region& region, const Visit& visit) {
    for_each_pixel_within(region, region, visit);
}

/// Adds the samples of a tile's next pass that are in the film's window. Two tiles may be added at
/// the same time.
void add_pass(Film& film, std::size_t tile, const TileImage& image);

}  // namespace balcony::render
