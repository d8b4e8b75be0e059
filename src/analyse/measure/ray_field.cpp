// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/ray_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "rays/results.hpp"

namespace balcony::analyse {

Result<RayField> RayField::make(const camera::Camera& camera, double picture_width,
                                double picture_height, double time, Derivatives derivatives,
                                Work work, Parts parts) {
    work.go_on();
    const rays::CompileOptions options{
        .footprints = derivatives == Derivatives::with, .points = true, .bends = true};
    Result<rays::RayProgram> program = rays::within_limits<rays::RayProgram>(
        "camera", camera.name(), {picture_width, picture_height}, work.stop(),
        [&](expr::Graph& graph) {
            camera::RayExpressions ray = camera.emit(graph, picture_width, picture_height);
            if (parts == Parts::first) {
                ray.bend.reset();
            }
            return rays::RayProgram::make(ray, camera.parts().axes, options);
        });
    if (!program) {
        return program.diagnostics;
    }
    return RayField(std::move(*program), time, std::move(work));
}

std::vector<Ray> RayField::run(const SampleGrid& grid) {
    std::vector<Ray> rays(grid.size());
    for (std::size_t top = 0; top < grid.rows; top += program::max_tile_height) {
        for (std::size_t left = 0; left < grid.columns; left += program::max_tile_width) {
            work_.go_on();
            const V2d corner = grid.at(top * grid.columns + left);
            const rays::Tile tile{corner.x,
                                  corner.y,
                                  grid.step,
                                  std::min(program::max_tile_width, grid.columns - left),
                                  std::min(program::max_tile_height, grid.rows - top),
                                  time_};
            program_.run(tile, scratch_, batch_);
            for (std::size_t i = 0; i < batch_.size(); ++i) {
                rays[(top + i / tile.width) * grid.columns + left + i % tile.width] = batch_[i];
            }
        }
    }
    return rays;
}

Ray RayField::at(const V2d& point) { return at(std::span(&point, 1)).front(); }

std::vector<rays::RayBatch::Part> RayField::path_at(const V2d& point) {
    std::vector<rays::RayBatch::Part> path;
    if (!at(point).valid) {
        return path;
    }
    for (std::size_t number = 0; number < batch_.part_count(); ++number) {
        const rays::RayBatch::Part part = batch_.part(0, number);
        if (part.length > 0.0) {
            path.push_back(part);
        }
    }
    return path;
}

std::vector<Ray> RayField::at(std::span<const V2d> points) {
    work_.go_on();
    std::array<double, program::max_points> x{};
    std::array<double, program::max_points> y{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        x[i] = points[i].x;
        y[i] = points[i].y;
    }
    const std::size_t count = points.size();
    program_.run({std::span(x).first(count), std::span(y).first(count), time_}, scratch_, batch_);
    std::vector<Ray> rays;
    rays.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back(batch_[i]);
    }
    return rays;
}

}  // namespace balcony::analyse
