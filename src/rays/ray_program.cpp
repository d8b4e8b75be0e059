// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

#include <algorithm>
#include <string_view>

#include "base/precondition.hpp"
#include "rays/results.hpp"

namespace balcony::rays {

namespace {

bool declares(const CompileOptions& options, std::string_view name) {
    return std::any_of(options.inputs.begin(), options.inputs.end(),
                       [name](const Input& input) { return input.name == name; });
}

}  // namespace

Result<RayProgram> RayProgram::make(const camera::RayExpressions& ray, Axes axes_of_ray,
                                    const CompileOptions& options) {
    if (!options.tiles && !options.points) {
        return error(Kind::internal, "rays are compiled for tiles or for points");
    }
    if (ray.bend && !options.bends) {
        return bent_rays_error();
    }
    const bool lens = ray.lens && declares(options, camera::lens_input_x) &&
                      declares(options, camera::lens_input_y);
    std::vector<expr::Expr> roots =
        ray_roots(ray, lens, options.footprints, axes_of_ray, options.axes.value_or(axes_of_ray));
    if (const auto blocked = lens ? camera::through_lens(ray).blocked : std::nullopt) {
        expr::Expr& valid = roots[RayRoots::valid];
        valid = select(*blocked, valid.graph().constant(RayRoots::is_blocked), valid);
    }
    if (ray.time) {
        roots.push_back(*ray.time);
    }
    if (options.parameters) {
        roots.insert(roots.end(), {ray.parameters.u, ray.parameters.v});
    }
    if (ray.bend) {
        const auto rest =
            bend_roots(ray, options.footprints, axes_of_ray, options.axes.value_or(axes_of_ray));
        roots.insert(roots.end(), rest.begin(), rest.end());
    }
    RayProgram made({options.footprints, ray.time.has_value(), options.parameters,
                     ray.bend ? ray.bend->knots.size() : 0},
                    lens);
    Diagnostics found;
    if (options.tiles) {
        made.for_tiles_ =
            take(program::Program::make(roots, {program::Sampling::grid, options.inputs}), found);
    }
    if (options.points) {
        made.for_points_ =
            take(program::Program::make(roots, {program::Sampling::points, options.inputs}), found);
    }
    if (has_errors(found)) {
        return found;
    }
    return {std::move(made), std::move(found)};
}

std::size_t RayProgram::instruction_count() const {
    const program::Program& program = for_points_ ? *for_points_ : *for_tiles_;
    std::size_t count = 0;
    for (const program::Rate rate : {program::Rate::uniform, program::Rate::column,
                                     program::Rate::row, program::Rate::pixel}) {
        count += program.instruction_count(rate);
    }
    return count;
}

void RayProgram::run(const Tile& tile, Scratch& scratch, RayBatch& rays) const {
    precondition(for_tiles_.has_value(), "the rays are compiled for tiles");
    program::run(*for_tiles_, tile, scratch, rays.reserve(tile.width * tile.height, roots_));
}

void RayProgram::run(const Points& points, Scratch& scratch, RayBatch& rays) const {
    precondition(for_points_.has_value(), "the rays are compiled for points");
    program::run(*for_points_, points, scratch, rays.reserve(points.x.size(), roots_));
}

Result<RayProgram> compile(const camera::Camera& camera, double width, double height,
                           const CompileOptions& options, const std::stop_token& stop) {
    if (camera.parts().bend && !options.bends) {
        return bent_rays_error(camera.name(), camera.parts().bend_span);
    }
    return within_limits<RayProgram>("camera", camera.name(), {width, height}, stop,
                                     [&](auto& graph) {
                                         return RayProgram::make(camera.emit(graph, width, height),
                                                                 camera.parts().axes, options);
                                     });
}

}  // namespace balcony::rays
