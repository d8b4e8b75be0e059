// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera as numbers: over a grid of picture points, or at points anywhere.

#include <cstddef>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/camera.hpp"
#include "balcony/diagnose.hpp"
#include "balcony/program.hpp"

namespace balcony::analyse {

/// A ray with its exact derivatives by picture x and y, all a pixel.
struct Ray {
    V3d origin;
    V3d direction;  ///< Unit length where valid.
    bool valid = false;
    V2d parameters;  ///< (u, v) of the eye object.
    V3d origin_by_x{0.0}, origin_by_y{0.0};
    V3d direction_by_x{0.0}, direction_by_y{0.0};
};

/// A camera compiled for a picture of one size. Belongs to one thread.
class RayProgram {
public:
    enum class Derivatives : bool { without, with };

    RayProgram(const camera::Camera& camera, double picture_width, double picture_height,
               double time, Derivatives derivatives);

    /// Row by row. Without derivatives those of the rays are 0.
    [[nodiscard]] std::vector<Ray> run(const SampleGrid& grid);
    [[nodiscard]] Ray at(const V2d& point);
    /// Much faster than one by one; at most program::max_points.
    [[nodiscard]] std::vector<Ray> at(std::span<const V2d> points);

private:
    struct Roots;
    RayProgram(const Roots& roots, double time);
    [[nodiscard]] Ray result(std::size_t index) const;

    program::Program for_grid_;
    program::Program for_points_;
    double time_;
    program::Scratch scratch_;
    std::vector<std::vector<double>> values_;  ///< By root, for one tile or list.
    std::vector<double*> results_;
};

}  // namespace balcony::analyse
