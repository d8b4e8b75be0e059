// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec: the direction of a ray absolute (from the direction object alone), relative (from the
// eye point to the direction point), along a tangent of the eye object or along a fixed vector.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// The direction object alone: the vector from its own origin to its point.
class AbsoluteRule final : public DirectionRule {
public:
    bool needs_direction_object() const override { return true; }
    ObjectVector direction(const PathPoint&, const PathPoint* toward,
                           Emitter& emit) const override {
        emit.require(toward->has_center);
        return toward->point - toward->center;
    }
};

/// From the eye point to the direction point.
class RelativeRule final : public DirectionRule {
public:
    bool needs_direction_object() const override { return true; }
    ObjectVector direction(const PathPoint& eye, const PathPoint* toward, Emitter&) const override {
        return toward->point - eye.point;
    }
};

/// The direction in which the eye point moves when one of its parameters increases.
class TangentRule final : public DirectionRule {
public:
    enum class Parameter : std::uint8_t { u, v };
    TangentRule(Parameter along, bool backward) : along_(along), backward_(backward) {}
    int min_eye_dimension() const override { return along_ == Parameter::u ? 1 : 2; }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter&) const override {
        const ObjectVector tangent = along_ == Parameter::u ? eye.along_u : eye.along_v;
        return backward_ ? -tangent : tangent;
    }

private:
    Parameter along_;
    bool backward_;
};

/// One vector for all rays, independent of moves.
class FixedRule final : public DirectionRule {
public:
    explicit FixedRule(Triple direction) : direction_(std::move(direction)) {}
    ObjectVector direction(const PathPoint&, const PathPoint*, Emitter& emit) const override {
        return vector_of(direction_, emit);
    }

private:
    Triple direction_;
};

StageResult make_fixed_rule(const Arguments& a) {
    const Triple direction = a.triple("direction");
    if (direction[0].constant() == 0.0 && direction[1].constant() == 0.0 &&
        direction[2].constant() == 0.0) {
        return error("a direction must not be (0, 0, 0)", {},
                     "write x, y, z, or a vector such as (1, 0, -1)");
    }
    return made<FixedRule>(direction);
}

}  // namespace

std::vector<StageEntry> direction_rules() {
    return {
        {.name = "absolute",
         .meaning = "from the direction object's own origin to its point",
         .formula = R"(
d = q − q₀      q   the point of the direction object
q₀   the origin (0, 0, 0), moved like the direction object
)",
         .make = [](const Arguments&) { return made<AbsoluteRule>(); },
         .example = R"(
// The directions of a panorama from points along a street: each column from one step further.
camera walking_panorama {
    map    u = 120deg .. -120deg, v = -45deg .. 45deg
    eye    line(along = (0, 2, 0))
    toward sphere(1)
    look   absolute
}
)"},
        {.name = "relative",
         .meaning = "from the eye point to the point of the direction object",
         .formula = R"(
d = q − p      q   the point of the direction object,   p   the eye point
)",
         .make = [](const Arguments&) { return made<RelativeRule>(); },
         .example = R"(
// Perspective projection: all rays start at one point and pass through a plane.
camera perspective {
    map    u = 0.6 .. -0.6, v = square
    eye    point
    toward plane((1, 0, 0))
    look   relative
}
)"},
        {.name = "tangent",
         .meaning = "along a tangent of the eye object",
         .formula = R"(
d = ±∂p/∂u or ±∂p/∂v      + forward, − backward
)",
         .parameters = {choice_parameter("along", {"u", "v"},
                                         "the increasing parameter: u or, for a surface, v"),
                        choice_parameter(
                            "sense", {"forward", "backward"},
                            "in the direction of the point's motion, or opposite to it")},
         .make =
             [](const Arguments& a) {
                 using enum TangentRule::Parameter;
                 return made<TangentRule>(a.choice("along") == "u" ? u : v,
                                          a.choice("sense") == "backward");
             },
         .example = R"(
// Looks around a pillar: rays leave its wall sideways, all to the left.
camera round_the_pillar {
    map  u = 180deg .. -180deg, v = -1 .. 1
    eye  cylinder(1)
    look tangent(along = u)
}
)"},
        {.name = "along",
         .meaning = "along a fixed vector in the camera's axes, which moves do not rotate",
         .formula = R"(
d = direction
)",
         .parameters = {{.name = "direction",
                         .type = TripleParameter{.names_axes = true},
                         .meaning = "x, y, z, -z or a vector"}},
         .make = make_fixed_rule,
         .example = R"(
// An unrolled plan of a ring-shaped building: everything is seen from above.
camera unrolled_plan {
    map  u = 180deg .. -180deg, v = 0 .. 1
    eye  ring(inner = 8, outer = 14)
    look along(-z)
    move translate(0, 0, 20)
}
)"},
    };
}

}  // namespace balcony::camera
