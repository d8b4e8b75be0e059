// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera as numbers: over a grid of picture points, along a line, or at one point.

#include <cstddef>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/camera.hpp"
#include "balcony/program.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

/// A ray with its exact derivatives by picture x and y, all a pixel.
struct Ray {
    V3d origin;
    V3d direction;  ///< Unit length where valid.
    bool valid = false;
    V2d parameters;  ///< (u, v) of the eye object.
    V3d origin_by_x{0.0}, origin_by_y{0.0};
    V3d direction_by_x{0.0}, direction_by_y{0.0};
};

/// Equally spaced points of a picture, one in the middle of each of its cells.
struct SampleGrid {
    double picture_width = 0.0;  ///< In pixels, as are all lengths here.
    double picture_height = 0.0;
    double step = 1.0;  ///< From sample to sample in both directions.
    std::size_t columns = 0;
    std::size_t rows = 0;

    /// As many samples, at least one, as cells of the given size fit into the picture; what is left
    /// over is at its borders.
    [[nodiscard]] static SampleGrid over(double picture_width, double picture_height, double step);

    [[nodiscard]] std::size_t size() const { return columns * rows; }
    [[nodiscard]] V2d first() const;
    /// Where the sample of an index (row by row) lies.
    [[nodiscard]] V2d at(std::size_t index) const;
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
    /// `count` points from `first` on, `step` apart, along x or along y; count is at most 64.
    [[nodiscard]] std::vector<Ray> along(const V2d& first, double step, std::size_t count,
                                         bool along_x);

private:
    void run(const program::Tile& tile);
    [[nodiscard]] Ray result(std::size_t index) const;

    program::Program program_;
    double time_;
    program::Scratch scratch_;
    std::vector<std::vector<double>> values_;  ///< By root, for one tile.
    std::vector<double*> results_;
};

}  // namespace balcony::analyse
