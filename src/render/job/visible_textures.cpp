// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/visible_textures.hpp"

#include <set>
#include <vector>

#include "render/job/coarse_rays.hpp"

namespace balcony::render {

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
