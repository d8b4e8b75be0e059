// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/placement.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace balcony::scene {

namespace {

// Whether a matrix is not singular: relative to the lengths of its rows, so that units do not
// matter.
bool invertible(const M44d& matrix) {
    const V3d x(matrix[0][0], matrix[0][1], matrix[0][2]);
    const V3d y(matrix[1][0], matrix[1][1], matrix[1][2]);
    const V3d z(matrix[2][0], matrix[2][1], matrix[2][2]);
    constexpr double flattest = 1e-12;
    return std::abs(x.cross(y).dot(z)) > flattest * x.length() * y.length() * z.length();
}

// Whether the linear part of an affine matrix is within max_scale.
bool scale_fits(const M44d& matrix) {
    for (int row = 0; row < 3; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (!(std::abs(matrix[row][column]) <= max_scale)) {
                return false;
            }
        }
    }
    return true;
}

bool is_within_range(const V3d& point) {
    const auto fits = [](double value) { return std::abs(value) <= max_coordinate; };
    return fits(point.x) && fits(point.y) && fits(point.z);
}

std::string too_far() {
    return fmt::format("it is further than {:g} from the origin", max_coordinate);
}

V3d turned_by(const M44d& world_from_node, const V3d& axis) {
    V3d direction;
    world_from_node.multDirMatrix(axis, direction);
    return direction;
}

constexpr const char* no_direction = "its node's transform gives it no direction";

}  // namespace

bool is_finite(const M44d& matrix) {
    const double* numbers = matrix.getValue();
    return std::all_of(numbers, numbers + 16, [](double number) { return std::isfinite(number); });
}

PlacementFault fault_of_placement(const Box3f& box, const M44d& world_from_mesh) {
    if (!is_finite(world_from_mesh)) {
        return "its transform is not finite";
    }
    if (!invertible(world_from_mesh)) {
        return "its transform is singular";
    }
    if (!scale_fits(world_from_mesh) || !scale_fits(world_from_mesh.inverse())) {
        return fmt::format("its transform scales beyond {:g} .. {:g}", 1.0 / max_scale, max_scale);
    }
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto side = [&](unsigned axis) {
            const V3f& end = (corner >> axis & 1U) != 0 ? box.max : box.min;
            return double{end[static_cast<int>(axis)]};
        };
        if (!is_within_range(V3d(side(0), side(1), side(2)) * world_from_mesh)) {
            return fmt::format("it reaches further than {:g} from the origin", max_coordinate);
        }
    }
    return std::nullopt;
}

PlacementFault place(Light& light, const M44d& world_from_node) {
    const V3d direction = turned_by(world_from_node, V3d(0.0, 0.0, -1.0));
    if (!(direction.length() > 0.0 && std::isfinite(direction.length()))) {
        return no_direction;
    }
    const V3d position = V3d(0.0) * world_from_node;
    if (!is_within_range(position)) {
        return too_far();
    }
    light.position = position;
    light.direction = direction.normalized();
    return std::nullopt;
}

PlacementFault place(Camera& camera, const M44d& world_from_node) {
    Camera placed = camera;
    placed.position = V3d(0.0) * world_from_node;
    placed.forward = turned_by(world_from_node, V3d(0.0, 0.0, -1.0)).normalized();
    const V3d up = turned_by(world_from_node, V3d(0.0, 1.0, 0.0));
    placed.up = (up - up.dot(placed.forward) * placed.forward).normalized();
    placed.right = placed.forward.cross(placed.up);
    if (!(placed.right.length() > 0.5)) {
        return no_direction;
    }
    if (world_from_node.determinant() < 0.0) {
        placed.right = -placed.right;
    }
    if (!is_within_range(placed.position)) {
        return too_far();
    }
    camera = std::move(placed);
    return std::nullopt;
}

Box3f box_of(std::span<const V3f> points, const M44d& world_from_points) {
    Box3f box;
    for (const V3f& point : points) {
        box.extendBy(V3f(V3d(point) * world_from_points));
    }
    return box;
}

}  // namespace balcony::scene
