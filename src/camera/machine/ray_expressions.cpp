// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/machine/ray_expressions.hpp"

#include <algorithm>
#include <array>
#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include <Imath/ImathVec.h>

namespace balcony::camera {

namespace {

ObjectVector select(Expr condition, const ObjectVector& a, const ObjectVector& b) {
    return {expr::select(condition, a.x, b.x), expr::select(condition, a.y, b.y),
            expr::select(condition, a.z, b.z)};
}

ObjectVector without_part_along(const ObjectVector& unit, const ObjectVector& a) {
    return a + -(dot(a, unit) * unit);
}

ObjectVector by_x(const std::array<Expr, 3>& values, Graph& graph) {
    const std::vector<Expr> slopes = expr::differentiate(values, graph.picture_x());
    return {slopes[0], slopes[1], slopes[2]};
}

std::vector<Expr> values_of(const RayExpressions& ray) {
    std::vector<Expr> values{ray.origin.x,    ray.origin.y,     ray.origin.z,
                             ray.direction.x, ray.direction.y,  ray.direction.z,
                             ray.valid,       ray.parameters.u, ray.parameters.v};
    if (ray.lens) {
        const auto& [o, d, inverse_length, valid, blocked] = ray.lens->ray;
        values.insert(values.end(), {o.x, o.y, o.z, d.x, d.y, d.z, inverse_length, valid});
        if (blocked) {
            values.push_back(*blocked);
        }
        for (const expr::Substitution& one : ray.lens->fixed) {
            values.push_back(one.replacement);
        }
    }
    if (ray.time) {
        values.push_back(*ray.time);
    }
    if (ray.bend) {
        const ObjectVector& d = ray.bend->direction;
        values.insert(values.end(), {d.x, d.y, d.z});
        for (const ObjectPoint& p : ray.bend->knots) {
            values.insert(values.end(), {p.x, p.y, p.z});
        }
    }
    return values;
}

/// Takes values out of a list in its order.
class ValueReader {
public:
    explicit ValueReader(std::span<const Expr> values) : values_(values) {}

    Expr number() {
        const Expr first = values_.front();
        values_ = values_.subspan(1);
        return first;
    }
    /// A point or a vector.
    template <class Vector>
    void read(Vector& into) {
        into = {values_[0], values_[1], values_[2]};
        values_ = values_.subspan(3);
    }

private:
    std::span<const Expr> values_;
};

}  // namespace

std::string distance_input(std::string_view object) {
    return fmt::format("distance of \"{}\"", object);
}

CentralRay::Values CentralRay::values() const {
    const auto& [o, d, p, at] = *this;
    return {o.x, o.y, o.z,        d.x,        d.y,           d.z,
            p.u, p.v, at.point.x, at.point.y, at.size.width, at.size.height};
}

CentralRay CentralRay::of(std::span<const Expr> v) {
    return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}, {v[6], v[7]}, {{v[8], v[9]}, {v[10], v[11]}}};
}

CentralRay middle_of(const CentralRay& ray) {
    const PicturePoint& picture = ray.picture;
    const std::array put{expr::Substitution{picture.point.x, 0.5 * picture.size.width},
                         expr::Substitution{picture.point.y, 0.5 * picture.size.height}};
    return CentralRay::of(expr::substitute(picture.size.width.graph(), ray.values(), put));
}

RayExpressions substitute(Graph& target, const RayExpressions& ray,
                          std::span<const expr::Substitution> put) {
    std::vector<expr::Substitution> all(put.begin(), put.end());
    std::vector<expr::Substitution> fixed;
    if (ray.lens) {
        for (const expr::Substitution& one : ray.lens->fixed) {
            fixed.push_back({target.fresh_variable(), {}});
            all.push_back({one.leaf, fixed.back().leaf});
        }
    }
    const std::vector<Expr> values = expr::substitute(target, values_of(ray), all);
    ValueReader next(values);
    RayExpressions made = ray;
    next.read(made.origin);
    next.read(made.direction);
    made.valid = next.number();
    made.parameters = {next.number(), next.number()};
    if (made.lens) {
        LensRay& through = made.lens->ray;
        next.read(through.origin);
        next.read(through.direction);
        through.inverse_length = next.number();
        through.valid = next.number();
        if (through.blocked) {
            through.blocked = next.number();
        }
        for (expr::Substitution& one : fixed) {
            one.replacement = next.number();
        }
        made.lens->fixed = std::move(fixed);
    }
    if (made.time) {
        made.time = next.number();
    }
    if (made.bend) {
        next.read(made.bend->direction);
        for (ObjectPoint& knot : made.bend->knots) {
            next.read(knot);
        }
    }
    return made;
}

std::vector<StageValues> substitute(Graph& target, std::span<const StageValues> stages,
                                    std::span<const expr::Substitution> put) {
    // All at once, because each stage contains those before it.
    std::vector<Expr> values;
    for (const StageValues& stage : stages) {
        values.insert(values.end(), stage.values.begin(), stage.values.end());
    }
    values = expr::substitute(target, values, put);
    std::vector<StageValues> made(stages.begin(), stages.end());
    auto value = values.begin();
    for (StageValues& stage : made) {
        for (Expr& one : stage.values) {
            one = *value++;
        }
    }
    return made;
}

namespace {

using Values = std::span<const Expr>;

struct Slopes {
    std::vector<Expr> by_x;
    std::vector<Expr> by_y;
};

Slopes slopes_of(Values values, Graph& graph) {
    return {expr::differentiate(values, graph.picture_x()),
            expr::differentiate(values, graph.picture_y())};
}

// By the chain rule, if the values depend on the picture through two values alone that each change
// along x and y, as the parameters behind a warp do: their derivatives by these are then shared by
// the derivatives by x and by y. Otherwise nothing.
std::optional<Slopes> slopes_through(const std::array<Expr, 2>& parameters, Values values,
                                     Graph& graph) {
    const auto is_pixel = [](const Expr& e) { return e.rate() == expr::Rate::pixel; };
    if (!std::all_of(parameters.begin(), parameters.end(), is_pixel)) {
        return std::nullopt;
    }
    const Expr u = graph.fresh_variable();
    const Expr v = graph.fresh_variable();
    const std::vector<Expr> of_uv = expr::substitute(
        graph, values,
        std::array{expr::Substitution{parameters[0], u}, expr::Substitution{parameters[1], v}});
    const expr::Dependence on_picture =
        expr::Dependence::on(expr::inputs::x) | expr::Dependence::on(expr::inputs::y);
    if (std::any_of(of_uv.begin(), of_uv.end(),
                    [&](const Expr& e) { return e.dependence().intersects(on_picture); })) {
        return std::nullopt;
    }
    const auto by = [&](const Expr& variable) {
        return expr::substitute(
            graph, expr::differentiate(of_uv, variable),
            std::array{expr::Substitution{u, parameters[0]}, expr::Substitution{v, parameters[1]}});
    };
    const std::vector<Expr> by_u = by(u);
    const std::vector<Expr> by_v = by(v);
    const Slopes inner = slopes_of(parameters, graph);
    Slopes made;
    for (std::size_t i = 0; i < values.size(); ++i) {
        made.by_x.push_back(by_u[i] * inner.by_x[0] + by_v[i] * inner.by_x[1]);
        made.by_y.push_back(by_u[i] * inner.by_y[0] + by_v[i] * inner.by_y[1]);
    }
    return made;
}

Slopes slopes_by_picture(const std::array<Expr, 2>& parameters, Values values, Graph& graph) {
    const auto shared = slopes_through(parameters, values, graph);
    return shared ? *shared : slopes_of(values, graph);
}

Slopes slopes_of_ray(const RayExpressions& ray, Values values) {
    Graph& graph = ray.origin.x.graph();
    return slopes_by_picture({ray.parameters.u, ray.parameters.v}, values, graph);
}

}  // namespace

RayFootprint footprint(const RayExpressions& ray) {
    const std::array values{ray.origin.x,    ray.origin.y,    ray.origin.z,
                            ray.direction.x, ray.direction.y, ray.direction.z};
    const auto [by_x, by_y] = slopes_of_ray(ray, values);
    return {{by_x[0], by_x[1], by_x[2]},
            {by_y[0], by_y[1], by_y[2]},
            {by_x[3], by_x[4], by_x[5]},
            {by_y[3], by_y[4], by_y[5]}};
}

BendFootprint footprint_of_bend(const RayExpressions& ray) {
    const auto& [knots, direction] = *ray.bend;
    std::vector<Expr> values{direction.x, direction.y, direction.z};
    for (const ObjectPoint& knot : knots) {
        values.insert(values.end(), {knot.x, knot.y, knot.z});
    }
    const auto [by_x, by_y] = slopes_of_ray(ray, values);
    BendFootprint made{{}, {}, {by_x[0], by_x[1], by_x[2]}, {by_y[0], by_y[1], by_y[2]}};
    for (std::size_t i = 3; i < values.size(); i += 3) {
        made.knots_by_x.push_back({by_x[i], by_x[i + 1], by_x[i + 2]});
        made.knots_by_y.push_back({by_y[i], by_y[i + 1], by_y[i + 2]});
    }
    return made;
}

// -------------------------------------------------------------------------------------- stereo

ObjectVector right_across(const CentralRay& ray, std::optional<Expr> vergence,
                          const Emitter& emit) {
    constexpr double smallest_square = 1e-24;
    Graph& graph = emit.graph();
    const auto& [o, d, parameters, picture] = ray;
    const ObjectVector origin_by_x = by_x({o.x, o.y, o.z}, graph);
    const ObjectVector direction_by_x = by_x({d.x, d.y, d.z}, graph);
    const ObjectVector first =
        without_part_along(d, vergence ? direction_by_x + *vergence * origin_by_x : origin_by_x);
    const ObjectVector second = without_part_along(d, vergence ? origin_by_x : direction_by_x);
    const ObjectVector z{emit(0.0), emit(0.0), emit(1.0)};
    const ObjectVector x{emit(1.0), emit(0.0), emit(0.0)};
    const ObjectVector of_viewer = cross(d, select(abs(d.z) < 0.9, z, x));
    const ObjectVector right =
        select(smallest_square < dot(first, first), first,
               select(smallest_square < dot(second, second), second, of_viewer));
    return (1.0 / sqrt(dot(right, right))) * right;
}

RayExpressions seen_by_eye(const RayExpressions& ray, const StereoView& stereo,
                           const ObjectVector& up, const PicturePoint& picture, Emitter& emit) {
    const EyeRay eye = stereo.eye({ray.origin, ray.direction, ray.parameters, picture}, up, emit);
    const Expr squared_length = dot(eye.direction, eye.direction);
    const ObjectVector offset = eye.origin - ray.origin;
    emit.require(0.0 < squared_length && is_finite(squared_length + dot(offset, offset)));
    RayExpressions made = ray;
    made.origin = eye.origin;
    made.direction = (1.0 / sqrt(squared_length)) * eye.direction;
    made.valid = ray.valid && emit.valid();
    return made;
}

// ---------------------------------------------------------------------------------------- lens

namespace {

ObjectVector unit_direction(const LensRay& ray) { return ray.inverse_length * ray.direction; }

}  // namespace

RayExpressions with_lens(const RayExpressions& ray, const Lens& lens, const PicturePoint& picture,
                         Emitter& emit) {
    Graph& graph = emit.graph();
    const LensRays rays = lens.rays({ray.origin, ray.direction, ray.parameters, picture},
                                    {graph.input(lens_input_x), graph.input(lens_input_y)}, emit);
    RayExpressions made = ray;
    if (!lens.is_pinhole()) {
        made.lens = LensExpressions{rays.ray, rays.fixed};
        const Expr there = ray.valid && emit.valid();
        made.lens->ray.valid = there && rays.ray.valid;
        if (rays.ray.blocked) {
            made.lens->ray.blocked = there && *rays.ray.blocked;
        }
    }
    if (rays.middle) {
        made.origin = rays.middle->origin;
        made.direction = unit_direction(*rays.middle);
        made.valid = ray.valid && emit.valid() && rays.middle->valid;
    }
    return made;
}

// The offset a is perpendicular to the unit direction d, so that |d - q a|² = 1 + q² |a|², which
// is exactly 1 in the middle of the lens.
LensRays ThinLens::rays(const CentralRay& central, const AperturePoint& square,
                        Emitter& emit) const {
    const ObjectVector& d = central.direction;
    const Expr power = focus().vergence(central, emit);
    const Expr vergence = select(0.0 < power && is_finite(power), power, emit(0.0));
    const AperturePoint at = aperture(square, emit);
    const ObjectVector right = right_across(central, vergence, emit);
    const ObjectVector up = cross(right, d);
    const Expr radius = emit(this->radius());
    const ObjectVector offset = radius * (at.x * right + at.y * up);
    Graph& graph = emit.graph();
    const ObjectVector a{graph.fresh_variable(), graph.fresh_variable(), graph.fresh_variable()};
    const ObjectVector turn = vergence * a;
    return {{central.origin + a, d + -turn, 1.0 / sqrt(1.0 + dot(turn, turn)),
             is_finite(dot(offset, offset) + vergence)},
            {{a.x, offset.x}, {a.y, offset.y}, {a.z, offset.z}}};
}

namespace {

ObjectVector vector_at(std::span<const Expr> values, std::size_t first) {
    return {values[first], values[first + 1], values[first + 2]};
}

}  // namespace

RayExpressions through_lens(const RayExpressions& ray) {
    const auto& [o, d, inverse_length, valid, blocked] = ray.lens->ray;
    const std::vector<Expr> values = expr::substitute(
        o.x.graph(),
        std::array{o.x, o.y, o.z, d.x, d.y, d.z, inverse_length, valid, blocked.value_or(valid)},
        ray.lens->fixed);
    RayExpressions made = ray;
    made.origin = {values[0], values[1], values[2]};
    made.direction = values[6] * vector_at(values, 3);
    made.valid = values[7];
    if (blocked) {
        made.blocked = values[8];
    }
    made.lens.reset();
    return made;
}

// Of w/|w|: the part across of the derivative of w, divided by |w|.
RayFootprint footprint_through_lens(const RayExpressions& ray) {
    const auto& [o, d, inverse_length, valid, blocked] = ray.lens->ray;
    Graph& graph = o.x.graph();
    const Slopes slopes = slopes_by_picture({ray.parameters.u, ray.parameters.v},
                                            std::array{o.x, o.y, o.z, d.x, d.y, d.z}, graph);
    std::vector<Expr> values{inverse_length, d.x, d.y, d.z};
    values.insert(values.end(), slopes.by_x.begin(), slopes.by_x.end());
    values.insert(values.end(), slopes.by_y.begin(), slopes.by_y.end());
    values = expr::substitute(graph, values, ray.lens->fixed);
    const Expr scale = values[0];
    const ObjectVector unit = scale * vector_at(values, 1);
    const auto turned = [&](const ObjectVector& by) {
        return scale * without_part_along(unit, by);
    };
    return {vector_at(values, 4), vector_at(values, 10), turned(vector_at(values, 7)),
            turned(vector_at(values, 13))};
}

// ---------------------------------------------------------------------------------------- bend

// A sum of squares is finite only if every coordinate is.
RayExpressions bent(const RayExpressions& ray, const Bend& bend, const PicturePoint& picture,
                    Emitter& emit) {
    const BentPath path = bend.path({ray.origin, ray.direction, ray.parameters, picture}, emit);
    constexpr double min_squared_length = 0x1p-960;
    const Expr squared_length = dot(path.direction, path.direction);
    Expr size = squared_length;
    for (const ObjectPoint& p : path.knots) {
        size = size + p.x * p.x + p.y * p.y + p.z * p.z;
    }
    emit.require_somewhere(
        !ray.valid || (min_squared_length < squared_length && is_finite(size)),
        error("this bend has no path for any ray of the picture: its numbers are not finite, or it "
              "ends without a direction",
              {}, "write smaller numbers, or let its formula be defined along the rays"));
    const ObjectVector first = path.knots[1] - path.knots[0];
    const Expr square = dot(first, first);
    RayExpressions made = ray;
    made.origin = path.knots.front();
    made.direction = select(0.0 < square, (1.0 / sqrt(square)) * first, ray.direction);
    made.bend = BendExpressions{{path.knots.begin() + 1, path.knots.end()},
                                (1.0 / sqrt(squared_length)) * path.direction};
    made.valid = ray.valid && emit.valid();
    return made;
}

// ---------------------------------------------------------------------------------------- motion

namespace {

// A ray that is moved with its lens and its bend: a point becomes to + rotate(point - from).
template <class Rotate>
RayExpressions moved(const RayExpressions& ray, const ObjectPoint& from, const ObjectPoint& to,
                     const Rotate& rotate) {
    const auto move = [&](ObjectPoint& point) { point = to + rotate(point - from); };
    RayExpressions made = ray;
    move(made.origin);
    made.direction = rotate(ray.direction);
    if (ray.lens) {
        move(made.lens->ray.origin);
        made.lens->ray.direction = rotate(ray.lens->ray.direction);
    }
    if (ray.bend) {
        std::for_each(made.bend->knots.begin(), made.bend->knots.end(), move);
        made.bend->direction = rotate(ray.bend->direction);
    }
    return made;
}

ObjectPoint point_in(const std::array<double, 3>& place, Axes from, Axes to, const Emitter& emit) {
    const auto& [x, y, z] = place;
    const Imath::V3d made = balcony::turned(Imath::V3d(x, y, z), from, to);
    return {emit(made.x), emit(made.y), emit(made.z)};
}

}  // namespace

RayExpressions posed(const RayExpressions& ray, const Pose& pose, Axes axes, const Emitter& emit) {
    const auto rotate = [&](const ObjectVector& vector) {
        const ObjectVector v = balcony::turned(vector, axes, Axes::z_up);
        const auto along = [&](const std::array<double, 3>& row) {
            return emit(row[0]) * v.x + emit(row[1]) * v.y + emit(row[2]) * v.z;
        };
        const auto& [x, y, z] = pose.rotation;
        return balcony::turned(ObjectVector{along(x), along(y), along(z)}, Axes::z_up, axes);
    };
    return moved(ray, {emit(0.0), emit(0.0), emit(0.0)},
                 point_in(pose.position, Axes::z_up, axes, emit), rotate);
}

RayExpressions turned(const RayExpressions& ray, const Turn& turn, Axes axes, const Emitter& emit) {
    const Expr angle = emit(turn.angle);
    const Expr c = cos(angle);
    const Expr s = sin(angle);
    const auto about_vertical = [&](const ObjectVector& v) {
        return axes == Axes::z_up ? ObjectVector{c * v.x - s * v.y, s * v.x + c * v.y, v.z}
                                  : ObjectVector{c * v.x + s * v.z, v.y, c * v.z - s * v.x};
    };
    const ObjectPoint center = point_in(turn.center, turn.axes, axes, emit);
    return moved(ray, center, center, about_vertical);
}

// ---------------------------------------------------------------------------------------- time

RayExpressions at_time(const RayExpressions& ray, Expr time) {
    Graph& graph = time.graph();
    const std::array put{expr::Substitution{graph.time(), time}};
    RayExpressions made = substitute(graph, ray, put);
    made.valid = made.valid && is_finite(time);
    made.time = time;
    return made;
}

}  // namespace balcony::camera
