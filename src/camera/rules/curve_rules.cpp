// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec from the frame of a curve: sideways from it, along its binormal or its principal
// normal. do Carmo, "Differential Geometry of Curves and Surfaces", section 1-5.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Perpendicular to the curve and to an upward vector, which moves do not rotate.
class SidewaysRule final : public DirectionRule {
public:
    SidewaysRule(bool to_the_right, Triple up) : right_(to_the_right), up_(std::move(up)) {}
    int min_eye_dimension() const override { return 1; }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter& emit) const override {
        const ObjectVector up = vector_of(up_, emit);
        const ObjectVector left = cross(up, eye.along_u);
        // Where the curve is parallel to the upward vector, rounding alone decides.
        constexpr double rounding = 1e-24;
        emit.require(rounding * (dot(up, up) * dot(eye.along_u, eye.along_u)) < dot(left, left));
        return right_ ? -left : left;
    }

private:
    bool right_;
    Triple up_;
};

/// Frenet's frame: the binormal c' x c'', and the principal normal (c' x c'') x c', towards the
/// centre of curvature. A straight piece has neither.
class FrenetRule final : public DirectionRule {
public:
    enum class FrameVector : std::uint8_t { binormal, principal_normal };
    FrenetRule(FrameVector vector, bool backward) : vector_(vector), backward_(backward) {}
    int min_eye_dimension() const override { return 1; }
    bool needs_second_derivative() const override { return true; }
    ObjectVector direction(const PathPoint& eye, const PathPoint*, Emitter& emit) const override {
        const ObjectVector& first = eye.along_u;
        const ObjectVector& second = *eye.along_u_by_u;
        const ObjectVector binormal = cross(first, second);
        constexpr double rounding = 1e-24;
        emit.require(rounding * (dot(first, first) * dot(second, second)) <
                     dot(binormal, binormal));
        const ObjectVector vector =
            vector_ == FrameVector::binormal ? binormal : cross(binormal, first);
        return backward_ ? -vector : vector;
    }

private:
    FrameVector vector_;
    bool backward_;
};

StageParameter sense_parameter(std::string_view meaning) {
    return choice_parameter("sense", {"forward", "backward"}, meaning);
}

StageResult make_sideways_rule(const Arguments& a) {
    const Triple up = a.triple("up");
    if (up[0].constant() == 0.0 && up[1].constant() == 0.0 && up[2].constant() == 0.0) {
        return error("up has no direction", {}, "write z, or a vector such as (0, 1, 1)");
    }
    return made<SidewaysRule>(a.choice("side") == "right", up);
}

template <FrenetRule::FrameVector vector>
StageResult make_frenet_rule(const Arguments& a) {
    return made<FrenetRule>(vector, a.choice("sense") == "backward");
}

}  // namespace

std::vector<StageEntry> curve_rules() {
    return {
        {.name = "sideways",
         .meaning = "at right angles to an upward vector and to a curve, or to the curves along u "
                    "of a surface",
         .formula = R"(
left   d = up × c′(u)        right   d = c′(u) × up
no ray where c′(u) is 0 or parallel to up
)",
         .parameters = {choice_parameter("side", {"left", "right"},
                                         "of the way on which u increases, with `up` upwards"),
                        {.name = "up",
                         .type = TripleParameter{.default_value = std::array{0.0, 0.0, 1.0},
                                                 .names_axes = true},
                         .meaning = "in the camera's axes, which moves do not rotate"}},
         .make = make_sideways_rule,
         .example = R"(
// A strip of all house fronts along a bent street, as from the window of a bus.
camera street_fronts {
    map  u = 0 .. 1, v = -1.5 .. 1.5
    eye  product(bezier([(0, 0), (4, 0), (5, 2), (9, 2)]), curve(v) = [1, v])
    look sideways(left)
}
)"},
        {.name = "binormal",
         .meaning = "along the binormal of a curve, perpendicular to the plane in which it bends; "
                    "of a surface, of its curves along u",
         .formula = R"(
forward   d = c′(u) × c″(u)        backward   d = c″(u) × c′(u)
With the tangent T = c′/|c′| and the principal normal N, B = d/|d| = T × N.
no ray where the curve is straight: c′ × c″ = 0
)",
         .parameters = {sense_parameter("on the side from which the curve turns to the left, or "
                                        "on the opposite side")},
         .make = make_frenet_rule<FrenetRule::FrameVector::binormal>,
         .example = R"(
// A spiral ramp unrolled, seen from above: downwards at right angles to the ramp's own slope.
camera ramp {
    map  u = 0deg .. 540deg, v = 1 .. -1
    eye  surface(u, v) = [(3 + v)*cos(u), (3 + v)*sin(u), 0.4*u + 2]
    look binormal(backward)
}
)"},
        {.name = "principal_normal",
         .meaning = "along the principal normal of a curve, towards its centre of curvature; of a "
                    "surface, of its curves along u",
         .formula = R"(
forward   d = (c′(u) × c″(u)) × c′(u)        backward   the opposite
The centre of curvature is c + N/κ with N = d/|d| and κ = |c′ × c″| / |c′|³.
no ray where the curve is straight: c′ × c″ = 0
)",
         .parameters = {sense_parameter("towards the centre of curvature, or away from it")},
         .make = make_frenet_rule<FrenetRule::FrameVector::principal_normal>,
         .example = R"(
// A statue from all sides, from a path around it: each column looks straight across the path.
camera around {
    map  u = 0deg .. 360deg, v = -1 .. 1
    eye  surface(u, v) = [4*cos(u), 3*sin(u), v]
    look principal_normal
}
)"},
    };
}

}  // namespace balcony::camera
