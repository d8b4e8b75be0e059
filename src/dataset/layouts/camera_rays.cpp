// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/layouts/camera_rays.hpp"

#include <cmath>

#include "balcony/ray_arrays.hpp"

namespace balcony::dataset {

Result<CameraRays> camera_rays(const camera::Picture& picture,
                               const std::array<std::size_t, 2>& size, Axes axes, double time) {
    const auto grid = bridge::RayGrid::make(picture, {.width = size[0],
                                                      .height = size[1],
                                                      .layer = {},
                                                      .axes = axes,
                                                      .time = time,
                                                      .footprints = true});
    if (!grid) {
        return grid.diagnostics;
    }
    CameraRays made;
    made.origins.resize(grid->size());
    made.directions.resize(grid->size());
    made.spreads.resize(grid->size());
    std::vector<std::array<V3d, 4>> footprints(grid->size());
    bridge::RayArrays arrays;
    arrays.origins = &made.origins.data()->x;
    arrays.directions = &made.directions.data()->x;
    arrays.footprints = &footprints.data()->data()->x;
    static_cast<void>(bridge::fill(*grid, arrays));
    for (std::size_t i = 0; i < footprints.size(); ++i) {
        made.spreads[i] = std::sqrt(footprints[i][2].cross(footprints[i][3]).length());
    }
    return made;
}

Result<CameraRays> rays_in_opencv(const Plan& plan, const PlannedCamera& camera) {
    auto made =
        camera_rays(camera.picture, camera.size, Axes::z_up, plan.recipe.picture.settings.time);
    if (made) {
        for (auto* const all : {&made->origins, &made->directions}) {
            for (V3d& v : *all) {
                v = {0.0 - v.y, 0.0 - v.z, v.x};
            }
        }
    }
    return made;
}

std::string misfit_of_rays(const PlannedCamera& camera) {
    constexpr std::array<std::size_t, 2> small{2, 2};
    return camera_rays(camera.picture, small, Axes::z_up, 0.0) ? "" : "pictures of one camera";
}

}  // namespace balcony::dataset
