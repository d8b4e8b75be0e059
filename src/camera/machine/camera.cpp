// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getRay: picture arrangers, then getEyePnt, getDirPnt and getDirVec.

#include "balcony/camera.hpp"

#include <cmath>

#include <fmt/format.h>

#include "balcony/progress.hpp"
#include "camera/machine/arrange.hpp"
#include "camera/machine/misfits.hpp"
#include "camera/machine/ray_expressions.hpp"
#include "camera/machine/size_limit.hpp"

namespace balcony::camera {

ObjectVector operator-(const ObjectPoint& a, const ObjectPoint& b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

ObjectPoint operator+(const ObjectPoint& a, const ObjectVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

ObjectVector operator+(const ObjectVector& a, const ObjectVector& b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

ObjectVector operator-(const ObjectVector& a) { return {-a.x, -a.y, -a.z}; }

ObjectVector operator*(Expr factor, const ObjectVector& a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

Expr dot(const ObjectVector& a, const ObjectVector& b) { return a.x * b.x + a.y * b.y + a.z * b.z; }

ObjectVector cross(const ObjectVector& a, const ObjectVector& b) {
    return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

namespace {

std::string_view name_of_dimension(int dimension) {
    return dimension == 2 ? "surface" : dimension == 1 ? "curve" : "point";
}

void check_path(const Path& path, std::string_view object, const std::string& camera,
                Diagnostics& diagnostics) {
    if (!path.mapper) {
        diagnostics.push_back(error(
            fmt::format("camera '{}' has no picture mapper for its {} object", camera, object), {},
            "add: map u = ... .. ..., v = ... .. ..."));
    }
    if (!path.generator) {
        diagnostics.push_back(error(fmt::format("camera '{}' has no {} object", camera, object)));
    }
}

void add_misfits_of_moves(const Path& path, Misfit::Of of, std::vector<Misfit>& found) {
    for (std::size_t i = 0; path.generator && i < path.object_transformers.size(); ++i) {
        const ObjectTransformerPointer& transformer = path.object_transformers[i];
        if (transformer && path.generator->dimension() < transformer->min_dimension()) {
            found.push_back(
                {of, i,
                 error(fmt::format("this stage needs a surface, but the '{}' object is a {}",
                                   of == Misfit::Of::eye_move ? "eye" : "toward",
                                   name_of_dimension(path.generator->dimension())),
                       {},
                       "write it in the block of an object that is a surface, for example eye { "
                       "object sphere(1)  move offset(1) }")});
        }
    }
}

}  // namespace

std::vector<double> Emitter::trial(std::span<const Expr> expressions, double x, double y) const {
    std::vector<expr::InputValue> inputs;
    for (const KnownInput& input : trial_.inputs) {
        inputs.push_back({input.name, input.value});
    }
    return expr::evaluate(expressions, {x, y, 0.0, trial_.variables, inputs});
}

Expr ClipShape::coverage(const PicturePoint& picture, Expr softness, Emitter& emit) const {
    const Expr depth = -distance(picture, emit);
    const Expr sharp = select(0.0 <= depth, emit(1.0), emit(0.0));
    const Expr ramp = min(max(0.5 + depth / softness, emit(0.0)), emit(1.0));
    return select(0.0 < softness, ramp * ramp * (3.0 - 2.0 * ramp), sharp);
}

std::vector<Misfit> misfits(const Camera::Parts& parts) {
    std::vector<Misfit> found;
    add_misfits_of_moves(parts.eye, Misfit::Of::eye_move, found);
    if (parts.toward) {
        add_misfits_of_moves(*parts.toward, Misfit::Of::toward_move, found);
    }
    if (!parts.look) {
        return found;
    }
    const auto add = [&found](Misfit::Of of, std::string message, std::string remedy) {
        found.push_back({of, 0, error(std::move(message), {}, std::move(remedy))});
    };
    if (parts.look->needs_direction_object() && !parts.toward) {
        add(Misfit::Of::missing_toward, "this direction rule needs a direction object",
            "add one with toward, for example toward sphere(10)");
    }
    if (parts.toward && parts.toward->generator &&
        parts.toward->generator->dimension() < parts.look->min_direction_dimension()) {
        add(Misfit::Of::look,
            fmt::format("this direction rule needs a surface, but the direction object is a {}",
                        name_of_dimension(parts.toward->generator->dimension())),
            "write a surface after toward");
    }
    const int minimum = parts.look->min_eye_dimension();
    if (parts.eye.generator && parts.eye.generator->dimension() < minimum) {
        add(Misfit::Of::look,
            fmt::format("this direction rule needs a {}, but the eye object is a {}",
                        minimum == 2 ? "surface" : "curve or a surface",
                        name_of_dimension(parts.eye.generator->dimension())),
            "add a direction object with toward, or use another eye object");
    }
    return found;
}

Result<Camera> Camera::make(Parts parts, const std::stop_token& stop) {
    const std::string name = parts.name;
    Diagnostics diagnostics;
    check_path(parts.eye, "eye", parts.name, diagnostics);
    if (parts.toward) {
        check_path(*parts.toward, "direction", parts.name, diagnostics);
    }
    if (!parts.look) {
        diagnostics.push_back(error(fmt::format("camera '{}' has no direction rule", parts.name)));
    }
    for (Misfit& misfit : misfits(parts)) {
        misfit.diagnostic.message =
            fmt::format("camera '{}': {}", parts.name, misfit.diagnostic.message);
        diagnostics.push_back(std::move(misfit.diagnostic));
    }
    if (parts.toward && parts.look && !parts.look->needs_direction_object()) {
        diagnostics.push_back(warning(
            fmt::format("camera '{}' has a direction object that its direction rule does not use",
                        parts.name),
            {}, "remove toward, or use: look relative"));
        parts.toward.reset();
    }
    if (!(parts.aspect > 0.0 && std::isfinite(parts.aspect))) {
        diagnostics.push_back(
            error(fmt::format("camera '{}' has the aspect {}, which is not a positive number",
                              parts.name, parts.aspect),
                  {}, "write the width of the picture divided by its height, such as 16/9"));
    }
    if (parts.bend && parts.lens) {
        diagnostics.push_back(error(
            fmt::format("camera '{}' has a lens, but its rays are bent", parts.name),
            parts.bend_span, "remove the lens or the bend: rays through a lens are straight"));
    }
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    std::shared_ptr<const Emitted> emitted;
    try {
        emitted =
            std::make_shared<const Emitted>(std::move(parts), stop, max_operations_of_camera + 1);
    } catch (const expr::GraphStopped&) {
        return stopped();
    } catch (const expr::GraphTooLarge&) {
        // The error follows.
    }
    if (!emitted || emitted->graph.size() > max_operations_of_camera) {
        diagnostics.push_back(too_large("camera", name, max_operations_of_camera));
        return diagnostics;
    }
    diagnostics.insert(diagnostics.end(), emitted->problems.begin(), emitted->problems.end());
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    return {Camera(std::move(emitted)), std::move(diagnostics)};
}

namespace {

// The ray at picture x and y of the camera's own picture. A sum of squares is finite only if every
// term is, so that one speaks for all six values. Directions so short that their squares lose
// digits cannot be brought to unit length.
RayExpressions ray_in_own_picture(const Camera::Parts& parts, const PicturePoint& picture,
                                  Emitter& emit) {
    const PathPoint eye = parts.eye.emit(picture, emit, parts.look->needs_second_derivative());
    std::optional<PathPoint> toward;
    if (parts.toward) {
        const std::size_t of_eye = emit.stages().size();
        toward = parts.toward->emit(picture, emit);
        for (StageValues& stage : std::span(emit.stages()).subspan(of_eye)) {
            stage.owner = StageValues::Owner::toward;
        }
    }
    const ObjectVector direction = parts.look->direction(eye, toward ? &*toward : nullptr, emit);
    emit.record(
        {parts.look.get(), StageValues::Owner::look, {direction.x, direction.y, direction.z}});

    constexpr double min_squared_length = 0x1p-960;
    const Expr squared_length = dot(direction, direction);
    const Expr origin_size =
        eye.point.x * eye.point.x + eye.point.y * eye.point.y + eye.point.z * eye.point.z;
    emit.require(min_squared_length < squared_length);
    emit.require(is_finite(squared_length + origin_size));
    return {
        eye.point, (1.0 / sqrt(squared_length)) * direction, emit.valid(), eye.parameters, {}, {},
        {}};
}

// Where the camera's moves turn the upward direction of its axes, at the place to which they move
// the origin. Moves that need a surface do not turn it.
ObjectVector up_of(const Camera::Parts& parts, Graph& graph) {
    const Expr zero = graph.constant(0.0);
    const Expr height = graph.fresh_variable();
    const bool y_up = parts.axes == Axes::y_up;
    ObjectPoint p = y_up ? ObjectPoint{zero, height, zero} : ObjectPoint{zero, zero, height};
    Emitter unused(graph);
    for (const ObjectTransformerPointer& transformer : parts.eye.object_transformers) {
        if (transformer->min_dimension() == 0) {
            p = transformer->transform(p, unused);
        }
    }
    const std::array coordinates{p.x, p.y, p.z};
    const std::vector<Expr> slopes = expr::differentiate(coordinates, height);
    const std::array put{expr::Substitution{height, zero}};
    const std::vector<Expr> at_origin = expr::substitute(graph, slopes, put);
    const ObjectVector up{at_origin[0], at_origin[1], at_origin[2]};
    const Expr square = dot(up, up);
    const Expr known = 0.0 < square && is_finite(square);
    const auto unit = [&](Expr part, bool is_up) {
        return select(known, part / sqrt(square), graph.constant(is_up ? 1.0 : 0.0));
    };
    return {unit(up.x, false), unit(up.y, y_up), unit(up.z, !y_up)};
}

/// The errors of conditions that hold at no point of a fine grid over the picture, at time 0. Most
/// hold at one of the first points, those of a coarse grid.
Diagnostics unmet_needs(const PicturePoint& picture, const Emitter& emit) {
    std::vector<Emitter::Need> unmet = emit.needs();
    if (unmet.empty()) {
        return {};
    }
    const std::array extent{picture.size.width, picture.size.height};
    const std::vector<double> size = emit.trial(extent, 0.0, 0.0);
    for (const int cells : {4, 16, 64}) {
        for (int i = 0; i < cells * cells && !unmet.empty(); ++i) {
            const double x = (i % cells + 0.5) / cells * size[0];
            const double y = (i / cells + 0.5) / cells * size[1];
            std::erase_if(unmet, [&](const Emitter::Need& need) {
                return emit.trial(std::array{need.condition}, x, y)[0] != 0.0;
            });
        }
    }
    Diagnostics errors;
    for (Emitter::Need& need : unmet) {
        errors.push_back(std::move(need.otherwise));
    }
    return errors;
}

}  // namespace

Camera::Emitted::Emitted(Parts made_of, const std::stop_token& stop, std::size_t most_operations)
    : parts(std::move(made_of)),
      graph(stop, most_operations),
      picture{{graph.picture_x(), graph.picture_y()},
              {graph.fresh_variable(), graph.fresh_variable()}} {
    constexpr double height = 1000.0;
    const std::array<double, 2> own =
        arranged_size(parts.arrangers, height * parts.aspect, height, 0.0);
    const Emitter::Trial trial{{own[0], own[1]}, parts.inputs};
    Emitter emit(graph, trial);
    ray = ray_in_own_picture(parts, picture, emit);
    stages = std::move(emit.stages());
    problems = emit.problems();
    const Diagnostics unmet = unmet_needs(picture, emit);
    problems.insert(problems.end(), unmet.begin(), unmet.end());
    if (parts.stereo) {
        Emitter stereo_emit(graph, trial);
        ray = seen_by_eye(ray, *parts.stereo, up_of(parts, graph), picture, stereo_emit);
        problems.insert(problems.end(), stereo_emit.problems().begin(),
                        stereo_emit.problems().end());
    }
    if (parts.lens) {
        Emitter lens_emit(graph, trial);
        ray = with_lens(ray, *parts.lens, picture, lens_emit);
        problems.insert(problems.end(), lens_emit.problems().begin(), lens_emit.problems().end());
    }
    if (parts.bend) {
        Emitter bend_emit(graph, trial);
        ray = bent(ray, *parts.bend, picture, bend_emit);
        Diagnostics of_bend = bend_emit.problems();
        const Diagnostics nowhere = unmet_needs(picture, bend_emit);
        of_bend.insert(of_bend.end(), nowhere.begin(), nowhere.end());
        if (has_errors(of_bend)) {  // What else is doubtful follows from these.
            std::erase_if(of_bend,
                          [](const Diagnostic& one) { return one.severity == Severity::warning; });
        }
        for (Diagnostic& problem : of_bend) {
            problem.span = parts.bend_span;
            problems.push_back(std::move(problem));
        }
    }
    if (parts.pose) {
        ray = posed(ray, *parts.pose, parts.axes, Emitter(graph));
    }
    if (parts.turn) {
        ray = turned(ray, *parts.turn, parts.axes, Emitter(graph));
    }
    if (parts.time) {
        const std::array fractions{picture.point.x / picture.size.width,
                                   picture.point.y / picture.size.height};
        const Expr time = parts.time->emit(graph, fractions).front();
        ray = at_time(ray, time);
        stages = substitute(graph, stages, std::array{expr::Substitution{graph.time(), time}});
    }
}

Camera Camera::with_pose(const Pose& pose) const {
    Parts posed = parts();
    posed.pose = pose;
    return Camera(
        std::make_shared<const Emitted>(std::move(posed), std::stop_token(), expr::max_nodes));
}

Camera Camera::with_turn(const Turn& turn) const {
    Parts turned = parts();
    turned.turn = turn;
    return Camera(
        std::make_shared<const Emitted>(std::move(turned), std::stop_token(), expr::max_nodes));
}

std::optional<double> Camera::fixed_aspect() const {
    const Parts& made_of = parts();
    const auto adapts = [](const Path& path) {
        return path.generator->dimension() == 0 || path.mapper->adapts_to_aspect();
    };
    return adapts(made_of.eye) && (!made_of.toward || adapts(*made_of.toward))
               ? std::nullopt
               : std::optional(made_of.aspect);
}

RayExpressions Camera::emit(Graph& graph, double width, double height) const {
    return emit(whole_picture(graph, width, height));
}

// The point of the camera's own picture.
PicturePoint Camera::own_point(const PicturePoint& whole, Emitter& emit) const {
    const PicturePoint picture = arranged(whole, parts().arrangers, emit);
    // In a layer with a soft edge, the camera extends beyond its image where it is defined.
    if (!parts().arrangers.empty()) {
        emit.require(inside(arranged(clamped(whole), parts().arrangers, emit)));
    }
    return picture;
}

std::array<expr::Substitution, 4> Camera::put(const PicturePoint& picture) const {
    const PicturePoint& own = emitted_->picture;
    return {expr::Substitution{own.point.x, picture.point.x},
            expr::Substitution{own.point.y, picture.point.y},
            expr::Substitution{own.size.width, picture.size.width},
            expr::Substitution{own.size.height, picture.size.height}};
}

RayExpressions Camera::emit(const PicturePoint& whole) const {
    Graph& graph = whole.size.width.graph();
    Emitter emit(graph);
    RayExpressions ray = substitute(graph, emitted_->ray, put(own_point(whole, emit)));
    emit.require(ray.valid);
    ray.valid = emit.valid();
    return ray;
}

std::vector<StageValues> Camera::emit_stages(const PicturePoint& whole) const {
    Graph& graph = whole.size.width.graph();
    Emitter unused(graph);
    return substitute(graph, emitted_->stages, put(own_point(whole, unused)));
}

Expr Camera::emit_arranged(const PicturePoint& whole) const {
    Emitter emit(whole.size.width.graph());
    (void)own_point(whole, emit);
    return emit.valid();
}

}  // namespace balcony::camera
