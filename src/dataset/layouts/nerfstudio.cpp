// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// nerfstudio: https://docs.nerf.studio/quickstart/data_conventions.html. Cameras have OpenGL's
// axes, the world has z up, and the middle of the first pixel is (0.5, 0.5), as here.

#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dataset/files.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

using nlohmann::json;

// What nerfstudio calls a model, and its names of the distortion; null if it has none.
struct NerfstudioModel {
    std::string_view lens;
    const char* name;
};
constexpr std::array nerfstudio_models{NerfstudioModel{"pinhole", "OPENCV"},
                                       NerfstudioModel{"opencv", "OPENCV"},
                                       NerfstudioModel{"opencv_fisheye", "OPENCV_FISHEYE"}};

const char* nerfstudio_model(const PlannedCamera& camera) {
    for (const NerfstudioModel& one : nerfstudio_models) {
        if (camera.lens && camera.lens->model == one.lens) {
            return one.name;
        }
    }
    return nullptr;
}

std::string nerfstudio_misfit(const PlannedCamera& camera) {
    return nerfstudio_model(camera) != nullptr
               ? ""
               : "pinholes and lenses of OpenCV's models, fisheye among them";
}

json transforms_of(const Plan& plan, std::size_t scene, std::size_t camera) {
    const PlannedCamera& planned = plan.scenes[scene].cameras[camera];
    json made = {{"camera_model", nerfstudio_model(planned)},
                 {"fl_x", planned.lens->number("fx")},
                 {"fl_y", planned.lens->number("fy")},
                 {"cx", planned.lens->number("cx")},
                 {"cy", planned.lens->number("cy")},
                 {"w", planned.size[0]},
                 {"h", planned.size[1]},
                 {"frames", json::array()}};
    for (const char* name : {"k1", "k2", "k3", "k4", "p1", "p2"}) {
        made[name] = planned.lens->number(name);
    }
    for (const Frame& frame : plan.frames) {
        if (frame.scene != scene || frame.camera != camera) {
            continue;
        }
        json one = {
            {"file_path", layer_file_in_scene(frame, "rgb")},
            {"transform_matrix", matrix_json(lens_pose(plan, frame), "opengl", Axes::z_up)}};
        for (const std::string& layer : plan.recipe.layers) {
            if (layer == "depth") {
                one["depth_file_path"] = layer_file_in_scene(frame, layer);
            }
        }
        made["frames"].push_back(std::move(one));
    }
    return made;
}

// A file has one model, so each camera has a file.
std::vector<LayoutFile> nerfstudio_files(const Plan& plan) {
    std::vector<LayoutFile> files;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const PlannedScene& planned = plan.scenes[scene];
        for (std::size_t camera = 0; camera < planned.cameras.size(); ++camera) {
            const std::string name =
                planned.cameras.size() == 1
                    ? "transforms.json"
                    : fmt::format("transforms-{}.json", planned.cameras[camera].name);
            files.push_back({fmt::format("{}/{}", planned.name, name),
                             dumped(transforms_of(plan, scene, camera))});
        }
    }
    return files;
}

}  // namespace

Layout nerfstudio_layout() {
    return {.info = {"nerfstudio", "transforms.json of nerfstudio"},
            .layers = {"rgb"},
            .misfit = nerfstudio_misfit,
            .files = nerfstudio_files};
}

}  // namespace balcony::dataset
