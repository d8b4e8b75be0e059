// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/ray_field.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::analyse {

namespace {

// The order of the program's roots: what is not a vector, then the vectors by component.
enum Root : std::size_t { valid, parameter_u, parameter_v, origin, direction = origin + 3 };
enum DerivativeRoot : std::size_t {
    origin_by_x = direction + 3,
    origin_by_y = origin_by_x + 3,
    direction_by_x = origin_by_y + 3,
    direction_by_y = direction_by_x + 3
};

program::Program compile(const camera::Camera& camera, double width, double height,
                         RayProgram::Derivatives derivatives) {
    expr::Graph graph;
    const camera::RayExpressions ray = camera.emit(graph, width, height);
    std::vector<expr::Expr> roots = {ray.valid, ray.parameters.u, ray.parameters.v};
    const auto add = [&roots](const auto& vector) {
        roots.insert(roots.end(), {vector.x, vector.y, vector.z});
    };
    add(ray.origin);
    add(ray.direction);
    if (derivatives == RayProgram::Derivatives::with) {
        const camera::RayFootprint footprint = camera::footprint(ray);
        add(footprint.origin_by_x);
        add(footprint.origin_by_y);
        add(footprint.direction_by_x);
        add(footprint.direction_by_y);
    }
    return program::Program(roots);
}

}  // namespace

SampleGrid SampleGrid::over(double picture_width, double picture_height, double step) {
    const auto count = [step](double length) {
        return static_cast<std::size_t>(std::max(std::floor(length / step + 1e-9), 1.0));
    };
    return {picture_width, picture_height, step, count(picture_width), count(picture_height)};
}

V2d SampleGrid::first() const {
    return {0.5 * (picture_width - step * static_cast<double>(columns - 1)),
            0.5 * (picture_height - step * static_cast<double>(rows - 1))};
}

V2d SampleGrid::at(std::size_t index) const {
    return first() +
           step * V2d(static_cast<double>(index % columns), static_cast<double>(index / columns));
}

RayProgram::RayProgram(const camera::Camera& camera, double picture_width, double picture_height,
                       double time, Derivatives derivatives)
    : program_(compile(camera, picture_width, picture_height, derivatives)),
      time_(time),
      values_(program_.root_count(),
              std::vector<double>(program::max_tile_width * program::max_tile_height)) {
    for (std::vector<double>& values : values_) {
        results_.push_back(values.data());
    }
}

std::vector<Ray> RayProgram::run(const SampleGrid& grid) {
    std::vector<Ray> rays(grid.size());
    for (std::size_t top = 0; top < grid.rows; top += program::max_tile_height) {
        for (std::size_t left = 0; left < grid.columns; left += program::max_tile_width) {
            const V2d corner = grid.at(top * grid.columns + left);
            const program::Tile tile{corner.x,
                                     corner.y,
                                     grid.step,
                                     std::min(program::max_tile_width, grid.columns - left),
                                     std::min(program::max_tile_height, grid.rows - top),
                                     time_};
            run(tile);
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                rays[(top + i / tile.width) * grid.columns + left + i % tile.width] = result(i);
            }
        }
    }
    return rays;
}

Ray RayProgram::at(const V2d& point) {
    run({point.x, point.y, 1.0, 1, 1, time_});
    return result(0);
}

std::vector<Ray> RayProgram::along(const V2d& first, double step, std::size_t count, bool along_x) {
    run({first.x, first.y, step, along_x ? count : 1, along_x ? 1 : count, time_});
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back(result(i));
    }
    return rays;
}

void RayProgram::run(const program::Tile& tile) {
    program::run(program_, tile, scratch_, results_);
}

Ray RayProgram::result(std::size_t index) const {
    const auto vector = [&](std::size_t root) {
        return V3d(values_[root][index], values_[root + 1][index], values_[root + 2][index]);
    };
    Ray ray;
    ray.valid = values_[valid][index] == 1.0;
    ray.parameters = {values_[parameter_u][index], values_[parameter_v][index]};
    ray.origin = vector(origin);
    ray.direction = vector(direction);
    if (values_.size() > origin_by_x) {
        ray.origin_by_x = vector(origin_by_x);
        ray.origin_by_y = vector(origin_by_y);
        ray.direction_by_x = vector(direction_by_x);
        ray.direction_by_y = vector(direction_by_y);
    }
    return ray;
}

}  // namespace balcony::analyse
