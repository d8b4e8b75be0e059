// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformers, OCS → OCS: rigid motions that place a camera, which looks along x, somewhere
// in the scene: at a point, or on its way along a path.

#include <cmath>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/curves/path_frame.hpp"

namespace balcony::camera {

namespace {

/// Three orthonormal vectors: left = up x forward.
struct Axes3 {
    ObjectVector forward, left, up;
};

/// The frame that looks along a direction, upright: its left is perpendicular to `up`. No ray if
/// the direction is 0 or parallel to `up`.
Axes3 upright(const ObjectVector& direction, const ObjectVector& up, Emitter& emit) {
    constexpr double parallel = 1e-24;  // The squared sine of the angle between the two.
    const ObjectVector across = cross(up, direction);
    emit.require(parallel * (dot(up, up) * dot(direction, direction)) < dot(across, across));
    const ObjectVector forward = to_unit_length(direction);
    const ObjectVector left = to_unit_length(across);
    return {forward, left, cross(forward, left)};
}

/// Moves the camera's own frame, which looks along x, to another, and rolls it clockwise as seen
/// along its line of sight.
ObjectPoint placed(const ObjectPoint& p, const Axes3& own, const ObjectPoint& at, const Axes3& axes,
                   Expr roll, const Emitter& emit) {
    const ObjectVector d = p - ObjectPoint{emit(0.0), emit(0.0), emit(0.0)};
    const Expr left = dot(d, own.left);
    const Expr up = dot(d, own.up);
    return at + (d.x * axes.forward + (cos(roll) * left - sin(roll) * up) * axes.left +
                 (sin(roll) * left + cos(roll) * up) * axes.up);
}

Axes3 own_axes(const ObjectVector& up, Emitter& emit) {
    return upright({emit(1.0), emit(0.0), emit(0.0)}, up, emit);
}

class LookAt final : public ObjectTransformer {
public:
    LookAt(Triple from, Triple target, Triple up, Scalar roll)
        : from_(std::move(from)),
          target_(std::move(target)),
          up_(std::move(up)),
          roll_(std::move(roll)) {}

    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectPoint from = point_of(from_, emit);
        const ObjectVector up = vector_of(up_, emit);
        const Axes3 axes = upright(point_of(target_, emit) - from, up, emit);
        return placed(p, own_axes(up, emit), from, axes, emit(roll_), emit);
    }

private:
    Triple from_, target_, up_;
    Scalar roll_;
};

class Follow final : public ObjectTransformer {
public:
    enum class Look : std::uint8_t { along, backward, fixed, target };
    struct Parts {
        ObjectGeneratorPointer path;
        double from, to;
        bool closed;
        Scalar at;
        Look look;
        Triple target;    ///< For Look::target.
        PathFrame frame;  ///< Without a position: upright.
        Triple up;
        Scalar roll, bank;
    };
    explicit Follow(Parts parts) : parts_(std::move(parts)) {}

    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const Expr at = emit(parts_.at);
        const Expr way = parts_.closed ? at - floor(at) : min(max(at, emit(0.0)), emit(1.0));
        const PathPlace place =
            place_on(*parts_.path, parts_.from * (1.0 - way) + parts_.to * way, emit);
        const ObjectVector up = vector_of(parts_.up, emit);
        const Axes3 axes = upright(direction(place, emit), up_at(way, up, emit), emit);
        return placed(p, own_axes(up, emit), place.point, axes, roll(place, up, emit), emit);
    }

private:
    ObjectVector direction(const PathPlace& place, Emitter& emit) const {
        const ObjectVector along = parts_.from < parts_.to ? place.along : -place.along;
        switch (parts_.look) {
            case Look::along: break;
            case Look::backward: return -along;
            case Look::fixed: return {emit(1.0), emit(0.0), emit(0.0)};
            case Look::target: return point_of(parts_.target, emit) - place.point;
        }
        return along;
    }

    ObjectVector up_at(Expr way, const ObjectVector& up, Emitter& emit) const {
        if (!parts_.frame.position) {
            return up;
        }
        const Expr position = (*parts_.frame.position)(way, emit);
        const auto value = [&](std::size_t k) {
            return emit.graph().lookup(parts_.frame.up[k], position);
        };
        return {value(0), value(1), value(2)};
    }

    // The path's curvature to the left, as seen from above, is c″·left/|c′|².
    Expr roll(const PathPlace& place, const ObjectVector& up, Emitter& emit) const {
        const Expr roll = emit(parts_.roll);
        if (parts_.bank.constant() == 0.0) {
            return roll;
        }
        const ObjectVector along = parts_.from < parts_.to ? place.along : -place.along;
        const ObjectVector left = upright(along, up, emit).left;
        const Expr curvature = dot(place.along_by_parameter, left) / dot(along, along);
        const Expr lean = atan(emit(parts_.bank) * curvature);
        return parts_.look == Look::backward ? roll + lean : roll - lean;
    }

    Parts parts_;
};

// ---------------------------------------------------------------------------------- making them

std::optional<Vector3> constant(const Triple& t) {
    const auto [x, y, z] = t;
    return x.constant() && y.constant() && z.constant()
               ? std::optional(Vector3{*x.constant(), *y.constant(), *z.constant()})
               : std::nullopt;
}

bool are_parallel(const Vector3& a, const Vector3& b) {
    const Vector3 across{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                         a[0] * b[1] - a[1] * b[0]};
    return norm(across) <= 1e-12 * norm(a) * norm(b);
}

std::optional<Diagnostic> fault_of_up(const Triple& up) {
    const auto known = constant(up);
    if (known && norm(*known) == 0.0) {
        return error("up has no direction", {}, "make one of its coordinates differ from 0");
    }
    if (known && are_parallel(*known, {1.0, 0.0, 0.0})) {
        return error("up is parallel to x, along which the camera looks", {},
                     "use z, or y in a camera with axes y_up");
    }
    return std::nullopt;
}

StageResult make_look_at(const Arguments& a) {
    const Triple up = a.triple("up");
    if (auto fault = fault_of_up(up)) {
        return std::move(*fault);
    }
    const auto from = constant(a.triple("from"));
    const auto target = constant(a.triple("target"));
    if (from && target && *from == *target) {
        return error("from and target are the same point", {},
                     "put the target where the camera is to look");
    }
    if (from && target && constant(up)) {
        const Vector3 way{(*target)[0] - (*from)[0], (*target)[1] - (*from)[1],
                          (*target)[2] - (*from)[2]};
        if (are_parallel(way, *constant(up))) {
            return error("the target is straight along up, so nothing says what is upright", {},
                         "choose another up, such as the direction that is upwards in the picture");
        }
    }
    return made<LookAt>(a.triple("from"), a.triple("target"), up, a.number("roll"));
}

StageResult make_follow(const Arguments& a) {
    using Look = Follow::Look;
    const std::string& look = a.choice("look");
    Follow::Parts parts{a.curve("path"),
                        a.constant("from"),
                        a.constant("to"),
                        false,
                        a.number("at"),
                        a.has("target")      ? Look::target
                        : look == "along"    ? Look::along
                        : look == "backward" ? Look::backward
                                             : Look::fixed,
                        a.has("target") ? a.triple("target") : Triple(),
                        {},
                        a.triple("up"),
                        a.number("roll"),
                        a.number("bank")};
    if (parts.from == parts.to) {
        return error("from and to are equal, so the path is empty", {},
                     "use two different parameters of the path");
    }
    if (auto fault = fault_of_up(parts.up)) {
        return std::move(*fault);
    }
    const Result<CurveSampler> sampler =
        CurveSampler::make(*parts.path, CurveSampler::Derivatives::first);
    if (!sampler) {
        return sampler.diagnostics;
    }
    const std::vector<CurveSample> ends = (*sampler)(std::array{parts.from, parts.to});
    parts.closed = at_same_point(ends[0], ends[1]);
    if (a.choice("frame") == "rotation_minimising") {
        Result<PathFrame> frame =
            rotation_minimising_frame(*parts.path, parts.from, parts.to, *constant(parts.up));
        if (!frame) {
            return frame.diagnostics;
        }
        parts.frame = std::move(*frame);
    }
    return made<Follow>(std::move(parts));
}

StageParameter up_parameter(bool constant) {
    return {.name = "up",
            .type = TripleParameter{.default_value = std::array{0.0, 0.0, 1.0},
                                    .constant = constant,
                                    .names_axes = true},
            .meaning = "the direction that is upright; y in a camera with axes y_up"};
}

StageParameter roll_parameter() {
    return angle_parameter("roll", 0.0,
                           "rotation about the line of sight, clockwise as seen along it");
}

}  // namespace

std::vector<StageEntry> camera_placements() {
    return {
        {.name = "look_at",
         .meaning = "puts the camera at a point, facing another: its x axis points to the target, "
                    "upright",
         .formula = R"(
p′ = from + a F + (b cos ρ − c sin ρ) L + (b sin ρ + c cos ρ) U
F = target − from, at unit length;   L = up × F, at unit length;   U = F × L
(a, b, c)   p along x and along the L and U that F = x has;   ρ = roll
no ray where F is parallel to up
)",
         .parameters = {triple_parameter("from", {0.0, 0.0, 0.0},
                                         "the image of (0, 0, 0), where the camera stands"),
                        {.name = "target",
                         .type = TripleParameter{},
                         .meaning = "the point that it faces"},
                        up_parameter(false),
                        roll_parameter()},
         .make = make_look_at,
         .example = R"(
// Looks at the origin from behind it, on the left and above.
camera watching {
    map    u = 0.6 .. -0.6, v = square
    eye    point
    toward plane((1, 0, 0))
    move   look_at((-4, 3, 2), (0, 0, 0))
}
)"},
        {.name = "follow",
         .meaning = "moves the camera along a path: to a point of it, with its x axis along the "
                    "path or to a target",
         .formula = R"(
p′ = c(w) + a F + (b cos ρ − c sin ρ) L + (b sin ρ + c cos ρ) U
w = from + s (to − from);   s = at, held from 0 to 1; modulo 1 if c is closed
F, L, U, a, b, c   as for look_at, with F along the path, along x, or
                   to the target
ρ = roll − arctan(bank κ),   κ = c″·left/|c′|², positive where c turns left
frame = rotation_minimising   L is perpendicular to the frame's up, as for
                              sweep, instead of `up`
)",
         .parameters =
             {curve_parameter("path",
                              "the path; it cannot change with time. arc_length(curve) has "
                              "constant speed"),
              {.name = "at",
               .type = NumberParameter{},
               .meaning = "the part of the way that lies behind, from 0 to 1: t/10 takes ten "
                          "seconds. A path that is open ends at both; a closed one goes on"},
              choice_parameter(
                  "look", {"along", "backward", "fixed"},
                  "where the x axis points: along the path, back along it, or where it "
                  "did before"),
              {.name = "target",
               .type = TripleParameter{},
               .optional = true,
               .meaning = "a point that the x axis points to instead"},
              up_parameter(true),
              roll_parameter(),
              number_parameter("bank", 0.0,
                               "how much the camera leans into bends: it leans by 45 degrees where "
                               "the radius of curvature is this length"),
              choice_parameter(
                  "frame", {"upright", "rotation_minimising"},
                  "orientation about the line of sight: upright, or without rotation about "
                  "the path, for one that goes straight up or loops"),
              {.name = "from",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 0.0, .constant = true},
               .meaning = "the path's parameter at the start"},
              {.name = "to",
               .type =
                   NumberParameter{.unit = Unit::either, .default_value = 1.0, .constant = true},
               .meaning = "the path's parameter at the end"}},
         .make = make_follow,
         .example = R"(
// A walk around a corner in ten seconds, at constant speed, seen after three of them.
camera walking {
    map    u = 0.6 .. -0.6, v = square
    eye    point
    toward plane((1, 0, 0))
    move   follow(arc_length(catmull_rom([(-4, 0, 1.6), (0, 0.5, 1.6), (2, 2, 1.7), (2, 6, 1.6)])),
                  at = 0.3 + t/10)
}
)"},
    };
}

}  // namespace balcony::camera
