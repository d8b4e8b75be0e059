// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// MapAnything: the entries ray_directions, depth_z and camera_poses of a view, in OpenCV's axes
// with poses from the camera to the world: the page of facebookresearch/map-anything.

#include <cmath>

#include <fmt/format.h>

#include "dataset/layouts/camera_arrays.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

camera::Pose at_viewpoint(const PlannedCamera& camera) {
    const V3d place = camera.viewpoint.value_or(V3d(0.0));
    camera::Pose pose;
    pose.position = {place.x, place.y, place.z};
    return pose;
}

std::string mapanything_misfit(const PlannedCamera& camera) {
    return camera.viewpoint ? "" : "cameras whose rays start at one point";
}

std::vector<LayoutFile> mapanything_files(const Plan& plan) {
    std::vector<LayoutFile> files;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        for (std::size_t i = 0; i < plan.scenes[scene].cameras.size(); ++i) {
            const PlannedCamera& camera = plan.scenes[scene].cameras[i];
            const std::string name =
                fmt::format("{}/mapanything/{}", plan.scenes[scene].name, camera.name);
            const auto rays = rays_in_opencv(plan, camera);
            if (!rays) {  // As misfit() has said.
                continue;
            }
            files.push_back({name + ".ray_directions.npy",
                             vectors_npy({camera.size[1], camera.size[0], 3}, rays->directions)});
            files.push_back(
                {name + ".camera_poses.npy", poses_npy(plan, scene, at_viewpoint(camera))});
        }
    }
    return files;
}

std::vector<std::string> mapanything_frame_files(const Plan& plan, const Frame& frame) {
    return {
        fmt::format("{}/mapanything/{}.depth_z.npy", plan.scenes[frame.scene].name, frame.name)};
}

// How far what a ray meets is ahead of the camera; 0 where it meets nothing.
Result<std::vector<std::string>> mapanything_frame_bytes(const FrameData& data) {
    const auto& rotation = data.plan.pose_of(data.frame).pose.rotation;
    const Imath::V3f ahead(
        turned(V3d(rotation[0][0], rotation[1][0], rotation[2][0]), Axes::z_up, data.scene().axes));
    const render::DataLayers& layers = *data.film->layers;
    std::vector<float> depths(data.pixels(), 0.0F);
    for (std::size_t i = 0; i < depths.size(); ++i) {
        if (layers.valid[i] == 1 && std::isfinite(layers.ray_length[i])) {
            depths[i] = layers.ray_length[i] * layers.direction[i].dot(ahead);
        }
    }
    return std::vector{
        npy_bytes({data.film->height, data.film->width}, std::span<const float>(depths))};
}

}  // namespace

Layout mapanything_layout() {
    return {.info = {"mapanything", "ray_directions, depth_z and camera_poses of MapAnything"},
            .layers = {"rgb", "depth", "rays"},
            .misfit = mapanything_misfit,
            .files = mapanything_files,
            .frame_files = mapanything_frame_files,
            .frame_bytes = mapanything_frame_bytes};
}

}  // namespace balcony::dataset
