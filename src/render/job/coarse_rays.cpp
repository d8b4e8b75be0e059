// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/coarse_rays.hpp"

#include "render/job/coarse_grid.hpp"

namespace balcony::render {

void for_each_coarse_ray(const TracedScene& traced, PictureRays& all, const Film& film, double time,
                         const std::function<void(const DifferentialRay&)>& visit) {
    const rays::Tile grid = coarse_grid(film, time);
    TileRays found;
    for (std::size_t layer = 0; layer < all.layer_count(); ++layer) {
        all.find_rays(layer, grid, found);
        for (std::size_t i = 0; i < found.all.size(); ++i) {
            if (!traceable(found.all, i)) {
                continue;
            }
            DifferentialRay ray{
                V3f(found.all.origin(i)), V3f(found.all.direction(i)), {}, found.time_of(i)};
            if (traced.materials.has_textures()) {
                ray.differentials = differentials(found.all, i, grid.step);
            }
            visit(ray);
        }
    }
}

}  // namespace balcony::render
