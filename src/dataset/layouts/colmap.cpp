// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// COLMAP: https://colmap.github.io/format.html and https://colmap.github.io/cameras.html. Cameras
// have OpenCV's axes, poses lead from the world to the camera, and the middle of the first pixel is
// (0.5, 0.5), as here.

#include <array>
#include <cmath>

#include <fmt/format.h>

#include "dataset/layouts/layout.hpp"

namespace balcony::dataset {

namespace {

struct ColmapModel {
    std::string_view lens;
    std::string_view name;
    std::array<std::string_view, 12> parameters;  // Behind the last one, empty.
};
constexpr std::array colmap_models{
    ColmapModel{"pinhole", "PINHOLE", {"fx", "fy", "cx", "cy"}},
    ColmapModel{"opencv",
                "FULL_OPENCV",
                {"fx", "fy", "cx", "cy", "k1", "k2", "p1", "p2", "k3", "k4", "k5", "k6"}},
    ColmapModel{
        "opencv_fisheye", "OPENCV_FISHEYE", {"fx", "fy", "cx", "cy", "k1", "k2", "k3", "k4"}}};

const ColmapModel* colmap_model(const PlannedCamera& camera) {
    for (const ColmapModel& one : colmap_models) {
        if (camera.lens && camera.lens->model == one.lens) {
            return &one;
        }
    }
    return nullptr;
}

std::string colmap_misfit(const PlannedCamera& camera) {
    return colmap_model(camera) != nullptr
               ? ""
               : "PINHOLE, FULL_OPENCV and OPENCV_FISHEYE: pinholes and lenses of OpenCV's models";
}

// w, x, y, z of a rotation, by the largest of them.
std::array<double, 4> quaternion_of(const std::array<std::array<double, 3>, 3>& m) {
    const std::array squares{1.0 + m[0][0] + m[1][1] + m[2][2], 1.0 + m[0][0] - m[1][1] - m[2][2],
                             1.0 - m[0][0] + m[1][1] - m[2][2], 1.0 - m[0][0] - m[1][1] + m[2][2]};
    std::size_t largest = 0;
    for (std::size_t i = 1; i < squares.size(); ++i) {
        largest = squares[i] > squares[largest] ? i : largest;
    }
    const double twice = std::sqrt(squares[largest]);
    const double wx = m[2][1] - m[1][2];
    const double wy = m[0][2] - m[2][0];
    const double wz = m[1][0] - m[0][1];
    const double xy = m[0][1] + m[1][0];
    const double xz = m[0][2] + m[2][0];
    const double yz = m[1][2] + m[2][1];
    std::array<double, 4> q{};
    switch (largest) {
        case 0: q = {squares[0], wx, wy, wz}; break;
        case 1: q = {wx, squares[1], xy, xz}; break;
        case 2: q = {wy, xy, squares[2], yz}; break;
        default: q = {wz, xz, yz, squares[3]}; break;
    }
    for (double& part : q) {
        part /= 2.0 * twice;
    }
    return q;
}

std::string image_lines(const Plan& plan, const Frame& frame) {
    const auto matrix =
        app::matrix_of(lens_pose(plan, frame), "opencv", plan.scenes[frame.scene].axes);
    std::array<std::array<double, 3>, 3> rotation{};
    std::array<double, 3> translation{};
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 3; ++j) {
            rotation[i][j] = (*matrix)[j][i];
            translation[i] -= (*matrix)[j][i] * (*matrix)[j][3];
        }
    }
    const auto [w, x, y, z] = quaternion_of(rotation);
    return fmt::format("{} {} {} {} {} {} {} {} {} {}.png\n\n", frame.index + 1, w, x, y, z,
                       translation[0], translation[1], translation[2], frame.camera + 1,
                       frame.name);
}

std::vector<LayoutFile> colmap_files(const Plan& plan) {
    std::vector<LayoutFile> files;
    for (std::size_t scene = 0; scene < plan.scenes.size(); ++scene) {
        const PlannedScene& planned = plan.scenes[scene];
        std::string cameras = "# CAMERA_ID, MODEL, WIDTH, HEIGHT, PARAMS[]\n";
        for (std::size_t i = 0; i < planned.cameras.size(); ++i) {
            const PlannedCamera& camera = planned.cameras[i];
            const ColmapModel& model = *colmap_model(camera);
            cameras +=
                fmt::format("{} {} {} {}", i + 1, model.name, camera.size[0], camera.size[1]);
            for (const std::string_view name : model.parameters) {
                cameras += name.empty() ? "" : fmt::format(" {}", camera.lens->number(name));
            }
            cameras += '\n';
        }
        std::string images =
            "# IMAGE_ID, QW, QX, QY, QZ, TX, TY, TZ, CAMERA_ID, NAME\n# POINTS2D[] as (X, Y, "
            "POINT3D_ID)\n";
        for (const Frame& frame : plan.frames) {
            images += frame.scene == scene ? image_lines(plan, frame) : "";
        }
        const std::string folder = planned.name + "/sparse/0/";
        files.push_back({folder + "cameras.txt", cameras});
        files.push_back({folder + "images.txt", images});
        files.push_back(
            {folder + "points3D.txt", "# POINT3D_ID, X, Y, Z, R, G, B, ERROR, TRACK[]\n"});
    }
    return files;
}

}  // namespace

Layout colmap_layout() {
    return {.info = {"colmap", "cameras.txt, images.txt and points3D.txt of COLMAP"},
            .layers = {"rgb"},
            .misfit = colmap_misfit,
            .files = colmap_files};
}

}  // namespace balcony::dataset
