// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/ray_field.hpp"

#include <algorithm>
#include <array>
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

}  // namespace

struct RayProgram::Roots {
    Roots(const camera::Camera& camera, double width, double height, Derivatives derivatives) {
        const camera::RayExpressions ray = camera.emit(graph, width, height);
        all = {ray.valid, ray.parameters.u, ray.parameters.v};
        const auto add = [this](const auto& vector) {
            all.insert(all.end(), {vector.x, vector.y, vector.z});
        };
        add(ray.origin);
        add(ray.direction);
        if (derivatives == Derivatives::with) {
            const camera::RayFootprint footprint = camera::footprint(ray);
            add(footprint.origin_by_x);
            add(footprint.origin_by_y);
            add(footprint.direction_by_x);
            add(footprint.direction_by_y);
        }
    }

    expr::Graph graph;
    std::vector<expr::Expr> all;
};

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
    : RayProgram(Roots(camera, picture_width, picture_height, derivatives), time) {}

RayProgram::RayProgram(const Roots& roots, double time)
    : for_grid_(roots.all),
      for_points_(roots.all, program::Sampling::points),
      time_(time),
      values_(roots.all.size(),
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
            program::run(for_grid_, tile, scratch_, results_);
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                rays[(top + i / tile.width) * grid.columns + left + i % tile.width] = result(i);
            }
        }
    }
    return rays;
}

Ray RayProgram::at(const V2d& point) { return at(std::span(&point, 1)).front(); }

std::vector<Ray> RayProgram::at(std::span<const V2d> points) {
    std::array<double, program::max_points> x{};
    std::array<double, program::max_points> y{};
    for (std::size_t i = 0; i < points.size(); ++i) {
        x[i] = points[i].x;
        y[i] = points[i].y;
    }
    const std::size_t count = points.size();
    program::run(for_points_, {std::span(x).first(count), std::span(y).first(count), time_},
                 scratch_, results_);
    std::vector<Ray> rays;
    for (std::size_t i = 0; i < count; ++i) {
        rays.push_back(result(i));
    }
    return rays;
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
