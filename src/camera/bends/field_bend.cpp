// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Bends by a field in space: an index of refraction or an acceleration; E. Gröller, "Nonlinear Ray
// Tracing: Visualizing Strange Worlds" (1995).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>

#include "camera/bends/straight_parts.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// A point of a path, with its motion: the unit direction times the index, or a velocity.
struct PathState {
    ObjectPoint point;
    ObjectVector motion;
};

/// The derivative of both by the parameter of the path.
struct PathSlope {
    ObjectVector point;
    ObjectVector motion;
};

PathState moved(const PathState& from, double step, const PathSlope& slope, const Emitter& emit) {
    const Expr h = emit(step);
    return {from.point + h * slope.point, from.motion + h * slope.motion};
}

class FieldBend : public Bend {
public:
    FieldBend(Scalar length, Division division) : length_(std::move(length)), division_(division) {}

    BentPath path(const CentralRay& ray, Emitter& emit) const final {
        const auto knots_of = [this](const CentralRay& central, std::size_t parts, Emitter& to) {
            return integrated(central, parts, to).path.knots;
        };
        const std::size_t parts = straight_parts(division_, ray, knots_of, emit);
        if (division_.parts > 0) {
            report_unsteady_paths(parts, ray, knots_of, emit);
        }
        Flight flight = integrated(ray, parts, emit);
        judge(flight, ray, emit);
        return std::move(flight.path);
    }

private:
    [[nodiscard]] virtual ObjectVector first_motion(const CentralRay& ray, Emitter& emit) const = 0;
    [[nodiscard]] virtual PathSlope slope(const PathState& at, Emitter& emit) const = 0;
    /// Whether there can be a path at this point.
    [[nodiscard]] virtual Expr is_passable(const PathState&, const Emitter& emit) const {
        return emit(1.0);
    }

protected:
    struct Flight {
        BentPath path;
        Expr is_passable;  ///< At the end of all steps.
    };

private:
    /// Requires or reports what follows from the whole path.
    virtual void judge(const Flight&, const CentralRay&, Emitter&) const {}

    // Steps of the classical Runge-Kutta method of order 4, over s from 0 to 1. A step may have
    // several straight parts: between its ends, the path is the cubic with the same points and
    // tangents, whose error is of the same order.
    [[nodiscard]] Flight integrated(const CentralRay& ray, std::size_t parts, Emitter& emit) const {
        const std::size_t parts_of_step = parts % 4 == 0 ? 4 : parts % 2 == 0 ? 2 : 1;
        const std::size_t steps = parts / parts_of_step;
        const double step = 1.0 / static_cast<double>(steps);
        PathState at{ray.origin, first_motion(ray, emit)};
        PathSlope here = scaled_slope(at, emit);
        std::vector<ObjectPoint> knots{at.point};
        Expr passable = emit(1.0);
        for (std::size_t i = 0; i < steps; ++i) {
            const PathState next = stepped(at, here, step, emit);
            const PathSlope there = scaled_slope(next, emit);
            passable = passable && is_passable(next, emit);
            for (std::size_t k = 1; k < parts_of_step; ++k) {
                const double part = static_cast<double>(k) / static_cast<double>(parts_of_step);
                knots.push_back(
                    between(at.point, here.point, next.point, there.point, step, part, emit));
            }
            knots.push_back(next.point);
            at = next;
            here = there;
        }
        return {{std::move(knots), here.point}, passable};
    }

    [[nodiscard]] PathState stepped(const PathState& at, const PathSlope& first, double step,
                                    Emitter& emit) const {
        const PathSlope second = scaled_slope(moved(at, 0.5 * step, first, emit), emit);
        const PathSlope third = scaled_slope(moved(at, 0.5 * step, second, emit), emit);
        const PathSlope fourth = scaled_slope(moved(at, step, third, emit), emit);
        const auto mean = [&](ObjectVector PathSlope::*part) {
            return emit(1.0 / 6.0) *
                   (first.*part + emit(2.0) * (second.*part + third.*part) + fourth.*part);
        };
        return moved(at, step, {mean(&PathSlope::point), mean(&PathSlope::motion)}, emit);
    }

    [[nodiscard]] PathSlope scaled_slope(const PathState& at, Emitter& emit) const {
        const auto [point, motion] = slope(at, emit);
        const Expr length = emit(length_);
        return {length * point, length * motion};
    }

    // Hermite's cubic.
    static ObjectPoint between(const ObjectPoint& a, const ObjectVector& slope_a,
                               const ObjectPoint& b, const ObjectVector& slope_b, double step,
                               double t, const Emitter& emit) {
        const double of_way = t * t * (3.0 - 2.0 * t);
        const double of_a = t * (1.0 - t) * (1.0 - t) * step;
        const double of_b = t * t * (t - 1.0) * step;
        return a + emit(of_way) * (b - a) + emit(of_a) * slope_a + emit(of_b) * slope_b;
    }

    Scalar length_;
    Division division_;
};

std::array<Expr, 3> coordinates(const ObjectPoint& p) { return {p.x, p.y, p.z}; }

/// The index with its gradient.
Formula with_gradient(const Formula& index) {
    auto graph = std::make_shared<Graph>();
    const std::array at{graph->fresh_variable(), graph->fresh_variable(), graph->fresh_variable()};
    std::vector<Expr> results = index.emit(*graph, at);
    for (const Expr& axis : at) {
        results.push_back(
            expr::differentiate(std::span<const Expr>(results).first(1), axis).front());
    }
    return {std::move(graph), {at.begin(), at.end()}, std::move(results)};
}

/// d/ds (n dp/ds) = ∇n, with m = n dp/ds: |m| is n.
class RefractiveField final : public FieldBend {
public:
    RefractiveField(const Formula& index, Scalar length, Division division)
        : FieldBend(std::move(length), division), index_(with_gradient(index)) {}

private:
    ObjectVector first_motion(const CentralRay& ray, Emitter& emit) const override {
        const Expr n = index_.emit(emit.graph(), coordinates(ray.origin)).front();
        emit.require_somewhere(
            0.0 < n, error("the refractive index of this bend is not positive where rays start", {},
                           "write an index above 0, such as 1 of the void"));
        return n * ray.direction;
    }
    PathSlope slope(const PathState& at, Emitter& emit) const override {
        const std::vector<Expr> n = index_.emit(emit.graph(), coordinates(at.point));
        return {to_unit_length(at.motion), {n[1], n[2], n[3]}};
    }
    Expr is_passable(const PathState& at, const Emitter& emit) const override {
        return 0.0 < index_.emit(emit.graph(), coordinates(at.point)).front();
    }
    void judge(const Flight& flight, const CentralRay& ray, Emitter& emit) const override {
        const ObjectPoint& start = flight.path.knots.front();
        const Expr first = index_.emit(emit.graph(), coordinates(start)).front();
        emit.require_somewhere(
            !(0.0 < first) || flight.is_passable,
            error("the refractive index of this bend is not positive along any ray", {},
                  "write an index above 0, such as 1 of the void"));
        report_jumps(flight.path.knots, ray, emit);
    }

    // A jump of the index has no gradient, so it bends no ray: the gradients along the path do not
    // add up to the change of the index.
    void report_jumps(std::span<const ObjectPoint> knots, const CentralRay& ray,
                      Emitter& emit) const {
        constexpr double noticeable = 0.05;
        const std::vector<Expr> along = indices_along(knots, emit);
        const auto jumps = [&](const Imath::V2d& point) {
            const std::vector<double> n = emit.trial(along, point.x, point.y);
            double by_gradient = 0.0;
            for (std::size_t i = 2; i < n.size(); i += 2) {
                by_gradient += 0.5 * (n[i - 1] + n[i + 1]);
                const double change = n[i] - n[0];
                if (std::abs(change) > noticeable * n[0] &&
                    std::abs(by_gradient - change) > 0.5 * std::abs(change)) {
                    return true;
                }
            }
            return false;
        };
        const std::vector<Imath::V2d> points = trial_points(ray, emit);
        const auto wrong = std::count_if(points.begin(), points.end(), jumps);
        if (wrong > 0) {
            emit.report(warning(
                fmt::format("on {} of {} rays over the picture, the refractive index of this bend "
                            "changes by more than {:.0f} % without bending them",
                            wrong, points.size(), 100.0 * noticeable),
                {}, "let it change without a jump, over a length of several straight parts"));
        }
    }

    // At places along the straight parts, the index and how much its gradient changes it up to the
    // next place.
    [[nodiscard]] std::vector<Expr> indices_along(std::span<const ObjectPoint> knots,
                                                  Emitter& emit) const {
        constexpr std::size_t fewest = 64;
        const std::size_t parts = knots.size() - 1;
        const std::size_t of_part = std::max<std::size_t>(2, (fewest + parts - 1) / parts);
        const double step = 1.0 / static_cast<double>(of_part);
        std::vector<Expr> made;
        const auto add = [&](const ObjectPoint& at, const ObjectVector& way) {
            const std::vector<Expr> n = index_.emit(emit.graph(), coordinates(at));
            made.insert(made.end(), {n[0], dot(ObjectVector{n[1], n[2], n[3]}, way)});
        };
        for (std::size_t i = 0; i < parts; ++i) {
            const ObjectVector way = emit(step) * (knots[i + 1] - knots[i]);
            for (std::size_t k = 0; k < of_part; ++k) {
                add(knots[i] + emit(static_cast<double>(k)) * way, way);
            }
            if (i + 1 == parts) {
                add(knots[i + 1], way);
            }
        }
        return made;
    }

    Formula index_;
};

/// d²p/ds² = a.
class AcceleratingField final : public FieldBend {
public:
    AcceleratingField(Formula acceleration, Scalar length, Division division)
        : FieldBend(std::move(length), division), acceleration_(std::move(acceleration)) {}

private:
    ObjectVector first_motion(const CentralRay& ray, Emitter&) const override {
        return ray.direction;
    }
    PathSlope slope(const PathState& at, Emitter& emit) const override {
        const std::vector<Expr> a = acceleration_.emit(emit.graph(), coordinates(at.point));
        return {at.motion, {a[0], a[1], a[2]}};
    }

    Formula acceleration_;
};

StageResult make_field(const Arguments& a) {
    const Formula& field = a.formula("at");
    switch (field.result_count()) {
        case 1: return made<RefractiveField>(field, a.number("length"), division_of(a));
        case 3: return made<AcceleratingField>(field, a.number("length"), division_of(a));
        default:
            return error(
                "a field has 1 result, a refractive index, or 3, an acceleration, but this "
                "one has 2",
                {}, "write at(x, y, z) = [n], or at(x, y, z) = [ax, ay, az]");
    }
}

}  // namespace

std::vector<StageEntry> field_bend() {
    return {
        {.name = "field",
         .meaning = "rays in a field: a refractive index, or an acceleration such as gravity",
         .formula = R"(
index n          d/ds (n dp/ds) = ∇n      s   the length of the path
acceleration a   d²p/ds² = a              s   the time of a flight
p(0) = o,   p′(0) = d,   0 ≤ s ≤ length,   then straight on
o, d   the straight ray, |d| = 1
)",
         .parameters =
             std::vector<StageParameter>{
                 {.name = "at",
                  .type = FormulaParameter{.shape = {3, 1, 3}},
                  .meaning = "at(x, y, z) = [n], the refractive index there, or [ax, ay, az], the "
                             "acceleration"},
                 {.name = "length",
                  .type = NumberParameter{.range = {.minimum = 0.0, .excludes_minimum = true}},
                  .meaning = "of the path in the field; rays are straight behind it"}} +
             division_parameters(),
         .make = make_field,
         .example = R"(
// A ball of denser air hangs in the room.
camera ball_of_air {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    bend   field(at(x, y, z) = [1 + 0.2*exp(-((x - 25)^2 + y^2 + z^2)/60)], length = 60,
                 tolerance = 0.02)
}
)"},
    };
}

}  // namespace balcony::camera
