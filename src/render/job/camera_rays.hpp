// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A camera as a program that fills tiles with rays in the scene's axes.

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/camera.hpp"
#include "balcony/program.hpp"
#include "render/shading/surface.hpp"

namespace balcony::render {

using Imath::V2f;
using Imath::V3d;

/// The rays of a grid of picture points, row by row.
class RayGrid {
public:
    /// The values of a ray, in the order of the program's roots. A program has those from
    /// origin_by_x on only if it is asked for footprints; they are vectors too.
    enum Root : std::size_t {
        origin_x,
        origin_y,
        origin_z,
        direction_x,
        direction_y,
        direction_z,
        valid,
        parameter_u,
        parameter_v,
        origin_by_x,
        origin_by_y = origin_by_x + 3,
        direction_by_x = origin_by_y + 3,
        direction_by_y = direction_by_x + 3,
        root_count = direction_by_y + 3
    };

    /// Room for so many points, and for footprints if there are to be any.
    void resize(std::size_t points, bool footprints);
    /// Where a program with so many roots writes them.
    [[nodiscard]] std::span<double* const> roots(std::size_t count);

    /// There is a ray, and it can be traced in floats.
    [[nodiscard]] bool traceable(std::size_t i) const;
    [[nodiscard]] V3d origin(std::size_t i) const { return vector(origin_x, i); }
    [[nodiscard]] V3d direction(std::size_t i) const { return vector(direction_x, i); }
    [[nodiscard]] V2f parameters(std::size_t i) const;
    /// The ray's change over a part of a pixel; 0 along x or y where it is not finite.
    [[nodiscard]] RayDifferentials differentials(std::size_t i, double part) const;

private:
    [[nodiscard]] V3d vector(std::size_t root, std::size_t i) const {
        return {values_[root][i], values_[root + 1][i], values_[root + 2][i]};
    }

    std::array<std::vector<double>, root_count> values_;
    std::array<double*, root_count> roots_{};
};

/// Whether floats can hold it.
[[nodiscard]] bool fits_float(const V3d& v);

/// A vector in other axes: z_up (x, y, z) is y_up (x, z, -y).
template <class T>
[[nodiscard]] std::array<T, 3> turned(const std::array<T, 3>& v, Axes from, Axes to) {
    if (from == to) {
        return v;
    }
    return to == Axes::y_up ? std::array{v[0], v[2], -v[1]} : std::array{v[0], -v[2], v[1]};
}

/// The program of a ray, turned from the camera's axes into the scene's.
[[nodiscard]] program::Program compile_rays(const camera::RayExpressions& ray, Axes camera_axes,
                                            Axes scene_axes, bool footprints);
/// The same of a camera by itself, in a picture of the given size, without footprints.
[[nodiscard]] program::Program compile_camera(const camera::Camera& camera, Axes scene_axes,
                                              std::size_t width, std::size_t height);

}  // namespace balcony::render
