// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/poses.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::app {

namespace {

using Imath::V3d;

constexpr double tolerance = 1e-4;  // Of matrices of floats, whose digits a file has shortened.

// The columns of a rotation, made exactly orthonormal; nothing if they are no rotation.
std::optional<std::array<V3d, 3>> orthonormal(const std::array<V3d, 3>& columns) {
    const auto& [x, y, z] = columns;
    const V3d across = x.cross(y);
    const bool is_rotation = std::abs(x.length() - 1.0) < tolerance &&
                             std::abs(y.length() - 1.0) < tolerance &&
                             std::abs(x.dot(y)) < tolerance && (across - z).length() < tolerance;
    if (!is_rotation) {  // As with NaN.
        return std::nullopt;
    }
    const V3d first = x.normalized();
    const V3d third = across.normalized();
    return std::array{first, third.cross(first), third};
}

Diagnostic no_axes(std::string_view axes) {
    std::vector<std::string> names;
    for (const CameraAxes& one : camera_axes()) {
        names.emplace_back(one.name);
    }
    return error(Kind::usage, fmt::format("there are no axes '{}' of cameras", axes),
                 suggestion(axes, names, "the axes are"));
}

// Null if the name is not known.
const CameraAxes* find_axes(std::string_view name) {
    const auto all = camera_axes();
    const auto row = std::find_if(all.begin(), all.end(),
                                  [&](const CameraAxes& one) { return one.name == name; });
    return row != all.end() ? &*row : nullptr;
}

V3d rotated(const camera::Pose& pose, const V3d& v) {
    V3d made;
    for (int i = 0; i < 3; ++i) {
        const auto& [x, y, z] = pose.rotation[static_cast<std::size_t>(i)];
        made[i] = x * v.x + y * v.y + z * v.z;
    }
    return made;
}

}  // namespace

std::span<const CameraAxes> camera_axes() {
    static const std::array rows{
        CameraAxes{
            "balcony", "x ahead, y to the left, z up", {V3d(1, 0, 0), V3d(0, 1, 0), V3d(0, 0, 1)}},
        CameraAxes{"opencv",
                   "x to the right, y down, z ahead: OpenCV, COLMAP, ROS's optical frames",
                   {V3d(0, -1, 0), V3d(0, 0, -1), V3d(1, 0, 0)}},
        CameraAxes{"opengl",
                   "x to the right, y up, z to the back: OpenGL, Blender, glTF, nerfstudio",
                   {V3d(0, -1, 0), V3d(0, 0, 1), V3d(-1, 0, 0)}},
    };
    return rows;
}

Result<camera::Pose> pose_of(const PoseMatrix& matrix, std::string_view axes, Axes world) {
    const CameraAxes* const row = find_axes(axes);
    if (row == nullptr) {
        return no_axes(axes);
    }
    const auto column = [&](std::size_t i) {
        return V3d(matrix[0][i], matrix[1][i], matrix[2][i]);
    };
    const V3d position = column(3);
    const auto rotation = orthonormal({column(0), column(1), column(2)});
    if (!rotation || !std::isfinite(position.length2())) {
        return error(Kind::usage, "the matrix of a pose is not a rotation with a finite place",
                     "give the matrix from the camera to the world, without a scale");
    }
    const V3d place = turned(position, world, Axes::z_up);
    camera::Pose pose{.rotation = {}, .position = {place.x, place.y, place.z}};
    // `axes` are the vectors of the program's axes: their coordinates i are those of Balcony's axis
    // i.
    for (int i = 0; i < 3; ++i) {
        V3d image(0.0);
        for (std::size_t k = 0; k < 3; ++k) {
            image += row->axes[k][i] * (*rotation)[k];
        }
        image = turned(image, world, Axes::z_up);
        for (int j = 0; j < 3; ++j) {
            pose.rotation[static_cast<std::size_t>(j)][static_cast<std::size_t>(i)] = image[j];
        }
    }
    return pose;
}

Result<PoseMatrix> matrix_of(const camera::Pose& pose, std::string_view axes, Axes world) {
    const CameraAxes* const row = find_axes(axes);
    if (row == nullptr) {
        return no_axes(axes);
    }
    const auto& [px, py, pz] = pose.position;
    const std::array columns{rotated(pose, row->axes[0]), rotated(pose, row->axes[1]),
                             rotated(pose, row->axes[2]), V3d(px, py, pz)};
    PoseMatrix matrix{};
    for (std::size_t k = 0; k < columns.size(); ++k) {
        const V3d column = turned(columns[k], Axes::z_up, world);
        for (int i = 0; i < 3; ++i) {
            matrix[static_cast<std::size_t>(i)][k] = column[i];
        }
    }
    return matrix;
}

V3d place_of(const camera::Pose& pose, const V3d& point) {
    const auto& [x, y, z] = pose.position;
    return V3d(x, y, z) + rotated(pose, point);
}

V3d point_at(const camera::Pose& pose, const V3d& place) {
    const auto& [x, y, z] = pose.position;
    const V3d from = place - V3d(x, y, z);
    V3d made;
    for (std::size_t i = 0; i < 3; ++i) {
        made[static_cast<int>(i)] = pose.rotation[0][i] * from.x + pose.rotation[1][i] * from.y +
                                    pose.rotation[2][i] * from.z;
    }
    return made;
}

camera::Pose combined(const camera::Pose& outer, const camera::Pose& inner) {
    const auto& [x, y, z] = inner.position;
    const V3d position = place_of(outer, V3d(x, y, z));
    camera::Pose made{.rotation = {}, .position = {position.x, position.y, position.z}};
    for (std::size_t j = 0; j < 3; ++j) {
        const V3d column =
            rotated(outer, V3d(inner.rotation[0][j], inner.rotation[1][j], inner.rotation[2][j]));
        for (std::size_t i = 0; i < 3; ++i) {
            made.rotation[i][j] = column[static_cast<int>(i)];
        }
    }
    return made;
}

}  // namespace balcony::app
