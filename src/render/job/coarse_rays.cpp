// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/coarse_rays.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

#include "render/job/bent_rays.hpp"

namespace balcony::render {

rays::Tile coarse_grid(std::size_t pixels_wide, std::size_t pixels_high, double points,
                       double time) {
    const auto width = static_cast<double>(pixels_wide);
    const auto height = static_cast<double>(pixels_high);
    const double step = std::max(1.0, std::sqrt(width * height / points));
    const auto count = [step](double extent) {
        return static_cast<std::size_t>(std::max(1.0, std::round(extent / step)));
    };
    return {0.5 * step,         0.5 * step,         step, count(width), count(height), time,
            {0.5, width - 0.5}, {0.5, height - 0.5}};
}

rays::Tile coarse_grid(const Film& film, double time) {
    return coarse_grid(film.width, film.height, 2048.0, time);
}

DifferentialRay coarse_ray(const TracedScene& traced, const rays::Tile& grid, const TileRays& rays,
                           std::size_t i) {
    const embree::Accelerator& objects =
        rays.shown != nullptr ? rays.shown->in(traced) : traced.accelerator;
    const std::size_t seen =
        rays.all.part_count() == 1 ? 0 : first_hit(objects, rays.all, i, rays.time_of(i)).part;
    const rays::RayBatch::Part part = rays.all.part(i, seen);
    DifferentialRay ray{V3f(part.origin), V3f(part.direction), {}, rays.time_of(i)};
    if (traced.materials.has_textures()) {
        ray.differentials = differentials(rays.all, i, seen, grid.step);
    }
    return ray;
}

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
            visit(coarse_ray(traced, grid, found, i));
        }
    }
}

void read_visible_textures(const TracedScene& traced, PictureRays& rays, const Film& film,
                           double time, const std::stop_token& stop) {
    if (traced.textures->all_fit()) {
        return;
    }
    const SceneTracer tracer(traced);
    std::set<std::size_t> seen;
    for_each_coarse_ray(traced, rays, film, time, [&](const DifferentialRay& ray) {
        if (const embree::Hit hit = tracer.nearest(ray); hit.any()) {
            seen.insert(traced.surfaces.mesh_point(hit).mesh->material.value());
        }
    });
    std::vector<const scene::Material*> materials;
    for (const std::size_t material : seen) {
        materials.push_back(&traced.scene->materials[material]);
    }
    traced.textures->read(materials, stop);
}

}  // namespace balcony::render
