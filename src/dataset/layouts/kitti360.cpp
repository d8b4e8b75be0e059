// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// KITTI-360: https://www.cvlibs.net/datasets/kitti-360/documentation.php, and the scripts of
// autonomousvision/kitti360Scripts, which read the files. Cameras have OpenCV's axes, the system
// that carries them has x ahead, y to the right and z down, and the world has z up. The middle of
// the first pixel is (0, 0).

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "dataset/frames/frame_layers.hpp"
#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

constexpr double half_pixel = 0.5;

bool is_of(const PlannedCamera& camera, std::string_view model) {
    return camera.lens && camera.lens->model == model;
}

std::string kitti360_misfit(const PlannedCamera& camera) {
    return is_of(camera, "pinhole") || is_of(camera, "omnidirectional")
               ? ""
               : "pinholes and fisheyes of the omnidirectional model of Mei";
}

// The number of a camera among image_00 to image_03: 0 and 1 are pinholes, 2 and 3 fisheyes. From 4
// on, there is no place for it.
std::size_t number_of_image(const PlannedScene& scene, std::size_t camera) {
    const std::string_view model = scene.cameras[camera].lens->model;
    std::size_t before = 0;
    for (std::size_t i = 0; i < camera; ++i) {
        before += is_of(scene.cameras[i], model) ? 1 : 0;
    }
    constexpr std::size_t places = 2;
    constexpr std::size_t none = 4;
    const std::size_t first = model == "pinhole" ? 0 : places;
    return before < places ? first + before : none;
}

Diagnostics too_many_cameras(const Plan& plan) {
    for (const PlannedScene& scene : plan.scenes) {
        for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
            if (number_of_image(scene, i) > 3) {
                return {error(Kind::usage,
                              "the layout kitti360 has two pinholes and two fisheyes at most",
                              "make a data set for each few of the cameras")};
            }
        }
    }
    return {};
}

// 12 numbers, row by row.
std::string row_text(const app::PoseMatrix& matrix) {
    std::string text;
    for (const auto& row : matrix) {
        text += fmt::format(" {}", fmt::join(row, " "));
    }
    return text;
}

// From axes with x ahead, y to the left and z up to those with y to the right and z down.
app::PoseMatrix in_system(app::PoseMatrix matrix) {
    for (std::size_t i : {1U, 2U}) {
        for (double& number : matrix[i]) {
            number = 0.0 - number;
        }
    }
    return matrix;
}

std::string camera_to_pose(const PlannedScene& scene) {
    constexpr app::PoseMatrix looks_ahead{{{0, 0, 1, 0}, {1, 0, 0, 0}, {0, 1, 0, 0}}};
    std::array<app::PoseMatrix, 4> matrices{looks_ahead, looks_ahead, looks_ahead, looks_ahead};
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const auto matrix = app::matrix_of(scene.cameras[i].lens->in_camera, "opencv", Axes::z_up);
        matrices[number_of_image(scene, i)] = in_system(*matrix);
    }
    std::string text;
    for (std::size_t i = 0; i < matrices.size(); ++i) {
        text += fmt::format("image_{:02}:{}\n", i, row_text(matrices[i]));
    }
    return text;
}

// A place without a camera has that of the first pinhole, since readers want both.
std::string perspective_text(const PlannedScene& scene) {
    std::array<const PlannedCamera*, 2> pinholes{};
    for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
        const std::size_t number = number_of_image(scene, i);
        if (number < pinholes.size()) {
            pinholes[number] = &scene.cameras[i];
        }
    }
    std::string text;
    for (std::size_t i = 0; pinholes[0] != nullptr && i < pinholes.size(); ++i) {
        const PlannedCamera& camera = pinholes[i] != nullptr ? *pinholes[i] : *pinholes[0];
        const Lens& lens = *camera.lens;
        text += fmt::format(
            "S_rect_{0:02}: {1} {2}\nR_rect_{0:02}: 1 0 0 0 1 0 0 0 1\n"
            "P_rect_{0:02}: {3} 0 {4} 0 0 {5} {6} 0 0 0 1 0\n",
            i, camera.size[0], camera.size[1], lens.number("fx"), lens.number("cx") - half_pixel,
            lens.number("fy"), lens.number("cy") - half_pixel);
    }
    return text;
}

std::string fisheye_text(const PlannedCamera& camera, std::size_t number) {
    const Lens& lens = *camera.lens;
    return fmt::format(
        "%YAML:1.0\n---\nmodel_type: MEI\ncamera_name: image_{:02}\nimage_width: {}\n"
        "image_height: {}\nmirror_parameters:\n   xi: {}\ndistortion_parameters:\n   k1: {}\n"
        "   k2: {}\n   p1: {}\n   p2: {}\nprojection_parameters:\n   gamma1: {}\n   gamma2: {}\n"
        "   u0: {}\n   v0: {}\n",
        number, camera.size[0], camera.size[1], lens.number("xi"), lens.number("k1"),
        lens.number("k2"), lens.number("p1"), lens.number("p2"), lens.number("fx"),
        lens.number("fy"), lens.number("cx") - half_pixel, lens.number("cy") - half_pixel);
}

std::string poses_text(const PlannedScene& scene) {
    constexpr std::array<std::array<double, 3>, 3> system_axes{{{1, 0, 0}, {0, -1, 0}, {0, 0, -1}}};
    std::string text;
    for (std::size_t i = 0; i < scene.poses.size(); ++i) {
        const camera::Pose system =
            app::combined(scene.poses[i].pose, {.rotation = system_axes, .position = {}});
        text += fmt::format("{}{}\n", i, row_text(*app::matrix_of(system, "balcony", Axes::z_up)));
    }
    return text;
}

std::vector<LayoutFile> kitti360_files(const Plan& plan) {
    std::vector<LayoutFile> files;
    for (const PlannedScene& scene : plan.scenes) {
        const std::string folder = scene.name + "/kitti360/";
        files.push_back({folder + "calibration/calib_cam_to_pose.txt", camera_to_pose(scene)});
        if (const std::string text = perspective_text(scene); !text.empty()) {
            files.push_back({folder + "calibration/perspective.txt", text});
        }
        for (std::size_t i = 0; i < scene.cameras.size(); ++i) {
            if (is_of(scene.cameras[i], "omnidirectional")) {
                const std::size_t number = number_of_image(scene, i);
                files.push_back({fmt::format("{}calibration/image_{:02}.yaml", folder, number),
                                 fisheye_text(scene.cameras[i], number)});
            }
        }
        files.push_back(
            {fmt::format("{}data_poses/{}/poses.txt", folder, scene.name), poses_text(scene)});
    }
    return files;
}

std::vector<std::string> kitti360_frame_files(const Plan& plan, const Frame& frame) {
    const PlannedScene& scene = plan.scenes[frame.scene];
    const std::size_t number = number_of_image(scene, frame.camera);
    return {fmt::format("{0}/kitti360/data_2d_raw/{0}/image_{1:02}/{2}/{3:010}.png", scene.name,
                        number, number < 2 ? "data_rect" : "data_rgb", frame.pose)};
}

Result<std::vector<std::string>> kitti360_frame_bytes(const FrameData& data) {
    auto bytes = frame_layer("rgb").bytes(data);
    return bytes ? Result<std::vector<std::string>>(std::vector{std::move(*bytes)})
                 : Result<std::vector<std::string>>(std::move(bytes.diagnostics));
}

}  // namespace

Layout kitti360_layout() {
    return {.info = {"kitti360", "calibration, poses and pictures of KITTI-360"},
            .layers = {"rgb"},
            .misfit = kitti360_misfit,
            .check = too_many_cameras,
            .files = kitti360_files,
            .frame_files = kitti360_frame_files,
            .frame_bytes = kitti360_frame_bytes};
}

}  // namespace balcony::dataset
