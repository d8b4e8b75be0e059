// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// 3DGRT: rays_ori and rays_dir of a Batch, of the shape [B, H, W, 3], in the axes of the camera,
// which are OpenCV's, and T_to_world, of the shape [B, 4, 4]: threedgrut/datasets/protocols.py of
// nv-tlabs/3dgrut.

#include <fmt/format.h>

#include "dataset/layouts/camera_arrays.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

std::vector<LayoutFile> threedgrt_files(const Plan& plan) {
    std::vector<LayoutFile> files;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (std::size_t i = 0; i < plan.scenes[scene].cameras.size(); ++i) {
            const PlannedCamera& camera = plan.scenes[scene].cameras[i];
            const std::string name =
                fmt::format("{}/3dgrt/{}", plan.scenes[scene].name, camera.name);
            const auto rays = rays_in_opencv(plan, camera);
            if (!rays) {  // As misfit() has said.
                continue;
            }
            const std::vector<std::size_t> shape{1, camera.size[1], camera.size[0], 3};
            files.push_back({name + ".rays_ori.npy", vectors_npy(shape, rays->origins)});
            files.push_back({name + ".rays_dir.npy", vectors_npy(shape, rays->directions)});
            files.push_back({name + ".T_to_world.npy", poses_npy(plan, scene, {})});
        }
    }
    return files;
}

}  // namespace

Layout threedgrt_layout() {
    return {.info = {"3dgrt", "rays_ori, rays_dir and T_to_world of 3DGRT and 3DGUT"},
            .misfit = misfit_of_rays,
            .files = threedgrt_files};
}

}  // namespace balcony::dataset
