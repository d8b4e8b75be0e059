// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/input_rays.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "balcony/ray_roots.hpp"
#include "rays/results.hpp"
#include "solve/shapes.hpp"

namespace balcony::solve {

namespace {

using expr::Expr;
using rays::RayRoots;

constexpr std::size_t change_size = 6;  // Numbers of an origin and a direction.

V3d vector_at(const program::ResultArrays& values, std::size_t first, std::size_t i) {
    return {values[first][i], values[first + 1][i], values[first + 2][i]};
}

void append_derivatives(std::vector<Expr>& roots, std::span<const Expr> of, Expr leaf) {
    const std::vector<Expr> derivatives = expr::differentiate(of, leaf);
    roots.insert(roots.end(), derivatives.begin(), derivatives.end());
}

program::Interface interface_of(const std::vector<std::string>& inputs, bool is_simplified) {
    program::Interface made{program::Sampling::points, {}, is_simplified};
    for (const std::string& name : inputs) {
        made.inputs.push_back({name});
    }
    return made;
}

// One value for each input, as Points wants them.
std::vector<std::span<const double>> input_values(std::span<const double> values) {
    std::vector<std::span<const double>> made;
    for (const double& value : values) {
        made.emplace_back(&value, 1);
    }
    return made;
}

void run_at(const program::Program& program, std::span<const V2d> points, double time,
            std::span<const double> values, program::ResultArrays& results) {
    std::vector<double> x(points.size());
    std::vector<double> y(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        x[i] = points[i].x;
        y[i] = points[i].y;
    }
    const std::vector<std::span<const double>> inputs = input_values(values);
    program::Scratch scratch;
    program::run(program, program::Points{x, y, time, inputs}, scratch,
                 results.reserve(program.root_count(), points.size()));
}

}  // namespace

Result<InputRays> InputRays::make(const camera::Camera& camera, const V2d& size,
                                  bool is_one_of_many, const std::vector<std::string>& inputs,
                                  const std::vector<const Constraint*>& shapes,
                                  const std::stop_token& stop) {
    if (camera.parts().bend) {
        return rays::bent_rays_error(camera.name(), camera.parts().bend_span);
    }
    return make({.emit = [&](expr::Graph& graph) { return camera.emit(graph, size.x, size.y); },
                 .axes = camera.parts().axes,
                 .name = camera.name(),
                 .size = size,
                 .is_one_of_many = is_one_of_many},
                inputs, shapes, stop);
}

Result<InputRays> InputRays::make(const RaySource& source, const std::vector<std::string>& inputs,
                                  const std::vector<const Constraint*>& shapes,
                                  const std::stop_token& stop) {
    const auto make = [&](expr::Graph& graph) -> Result<InputRays> {
        const camera::RayExpressions ray = source.emit(graph);
        if (ray.bend) {
            return rays::bent_rays_error(source.name, {});
        }
        std::vector<Expr> roots = rays::ray_roots(ray, false, true, source.axes, source.axes);
        const std::vector<Expr> of(roots.begin(), roots.begin() + change_size);
        const program::Interface interface = interface_of(inputs, !source.is_one_of_many);

        InputRays made;
        made.inputs_ = inputs.size();
        made.time_ = source.time;
        Diagnostics found;
        made.rays_ = rays::take(program::Program::make(roots, interface), found);
        for (const std::string& name : inputs) {
            append_derivatives(roots, of, graph.input(name));
        }
        made.by_input_ = inputs.empty()
                             ? made.rays_
                             : rays::take(program::Program::make(roots, interface), found);
        for (auto place = shapes.begin(); place != shapes.end(); ++place) {
            const Constraint* const shape = *place;
            const auto alike = std::find_if(shapes.begin(), place, [&](const Constraint* other) {
                return have_same_formulas(*other, *shape);
            });
            if (alike != place) {
                Shape known = made.shapes_[static_cast<std::size_t>(alike - shapes.begin())];
                known.position = shape->position;
                made.shapes_.push_back(std::move(known));
                continue;
            }
            const std::vector<Expr> misses = shape_misses(*shape, ray);
            std::vector<Expr> shape_roots{ray.valid};
            shape_roots.insert(shape_roots.end(), misses.begin(), misses.end());
            for (const std::string& name : inputs) {
                append_derivatives(shape_roots, misses, graph.input(name));
            }
            auto program = rays::take(program::Program::make(shape_roots, interface), found);
            if (!program) {
                return found;
            }
            made.shapes_.push_back({std::move(*program), shape->position, misses.size()});
        }
        if (has_errors(found)) {
            return found;
        }
        return made;
    };
    return rays::within_limits<InputRays>("camera", source.name, {source.size.x, source.size.y},
                                          stop, make);
}

std::vector<InputRay> InputRays::at(std::span<const V2d> points, std::span<const double> values,
                                    bool by_input) const {
    program::ResultArrays results;
    run_at(by_input ? *by_input_ : *rays_, points, time_, values, results);
    std::vector<InputRay> made(points.size());
    for (std::size_t i = 0; i < points.size(); ++i) {
        const auto vector = [&](std::size_t first) { return vector_at(results, first, i); };
        rays::Ray& ray = made[i].ray;
        ray.origin = vector(RayRoots::origin);
        ray.direction = vector(RayRoots::direction);
        ray.origin_by_x = vector(RayRoots::origin_by_x);
        ray.origin_by_y = vector(RayRoots::origin_by_y);
        ray.direction_by_x = vector(RayRoots::direction_by_x);
        ray.direction_by_y = vector(RayRoots::direction_by_y);
        double size = ray.origin_by_x.length2() + ray.origin_by_y.length2() +
                      ray.direction_by_x.length2() + ray.direction_by_y.length2();
        for (std::size_t k = 0; by_input && k < inputs_; ++k) {
            const std::size_t first = RayRoots::end_of_footprints + k * change_size;
            made[i].by_input.push_back({vector(first), vector(first + 3)});
            size += made[i].by_input[k].origin.length2() + made[i].by_input[k].direction.length2();
        }
        ray.valid = results[RayRoots::valid][i] == 1.0 && std::isfinite(size);
    }
    return made;
}

std::vector<ShapeValues> InputRays::shapes(std::span<const double> values) const {
    std::vector<ShapeValues> made;
    program::ResultArrays results;
    for (const Shape& shape : shapes_) {
        run_at(shape.program, std::span(&shape.position, 1), time_, values, results);
        ShapeValues one{results[0][0] == 1.0, {}, {}};
        for (std::size_t r = 0; r < shape.count; ++r) {
            one.values.push_back(results[1 + r][0]);
            one.valid = one.valid && std::isfinite(one.values.back());
            one.by_input.emplace_back(inputs_);
            for (std::size_t k = 0; k < inputs_; ++k) {
                one.by_input[r][k] = results[1 + (k + 1) * shape.count + r][0];
                one.valid = one.valid && std::isfinite(one.by_input[r][k]);
            }
        }
        made.push_back(std::move(one));
    }
    return made;
}

}  // namespace balcony::solve
