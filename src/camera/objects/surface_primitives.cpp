// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: disc, ring, cone, paraboloids and the Möbius band.

#include <numbers>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Flat in the plane z = 0; the front faces up in every parametrisation, even at the centre.
class FlatSurface : public ObjectGenerator {
public:
    int dimension() const final { return 2; }
    std::optional<ObjectVector> normal(const ParameterPoint&, Emitter& emit) const final {
        return ObjectVector{emit(0.0), emit(0.0), emit(1.0)};
    }
};

/// By the angle u and the position v between the circles, 0 at the inner and 1 at the outer one.
class Ring final : public FlatSurface {
public:
    Ring(Scalar inner, Scalar outer) : inner_(std::move(inner)), outer_(std::move(outer)) {}
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        emit.require(0.0 <= p.v && p.v <= emit(1.0));
        const Expr r = emit(inner_) + (emit(outer_) - emit(inner_)) * p.v;
        return {r * cos(p.u), r * sin(p.u), emit(0.0)};
    }

private:
    Scalar inner_, outer_;
};

/// Maps the square |u|, |v| <= 1 to the disc, and concentric squares to circles: the concentric map
/// of Shirley and Chiu (1997), which preserves relative areas.
class ConcentricDisc final : public FlatSurface {
public:
    explicit ConcentricDisc(Scalar radius) : radius_(std::move(radius)) {}
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        emit.require(abs(p.u) <= emit(1.0) && abs(p.v) <= emit(1.0));
        const Expr beside = abs(p.v) < abs(p.u);  // rather than above or below the centre
        const Expr r = select(beside, p.u, p.v);
        const Expr across = select(beside, p.v, p.u);
        const Expr angle =
            0.25 * std::numbers::pi * across / select(equal(r, emit(0.0)), emit(1.0), r);
        const Expr main = emit(radius_) * r * cos(angle);
        const Expr side = emit(radius_) * r * sin(angle);
        return {select(beside, main, side), select(beside, side, main), emit(0.0)};
    }

private:
    Scalar radius_;
};

/// By angle u and height v; ends at its apex.
class Cone final : public ObjectGenerator {
public:
    Cone(Scalar radius, Scalar top, Scalar height)
        : radius_(std::move(radius)), top_(std::move(top)), height_(std::move(height)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr r = emit(radius_) + (emit(top_) - emit(radius_)) / emit(height_) * p.v;
        emit.require(0.0 <= r);
        return {r * cos(p.u), r * sin(p.u), p.v};
    }

private:
    Scalar radius_, top_, height_;
};

/// z = x^2/a^2 + y^2/b^2 by the angle u and the distance v from the axis before a and b are
/// applied. Its normals are those of the cross product without a factor v, so that there is one at
/// the apex too and the front is outside for v < 0 as well.
class PolarParaboloid final : public ObjectGenerator {
public:
    explicit PolarParaboloid(Pair axes) : axes_(std::move(axes)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return {emit(axes_[0]) * p.v * cos(p.u), emit(axes_[1]) * p.v * sin(p.u), p.v * p.v};
    }
    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        const Expr a = emit(axes_[0]);
        const Expr b = emit(axes_[1]);
        return ObjectVector{2.0 * b * p.v * cos(p.u), 2.0 * a * p.v * sin(p.u), -(a * b)};
    }

private:
    Pair axes_;
};

/// z = x^2/a^2 + sign y^2/b^2 by u = x/a and v = y/b.
class CartesianParaboloid final : public ObjectGenerator {
public:
    CartesianParaboloid(Pair axes, double sign) : axes_(std::move(axes)), sign_(sign) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        return {emit(axes_[0]) * p.u, emit(axes_[1]) * p.v, p.u * p.u + sign_ * (p.v * p.v)};
    }

private:
    Pair axes_;
    double sign_;
};

/// A segment that rotates by half_turns/2 turns about the tangent of a circle along it: by the
/// angle u around the z axis and the distance v from the circle.
class MobiusBand final : public ObjectGenerator {
public:
    MobiusBand(Scalar radius, std::size_t half_turns)
        : radius_(std::move(radius)), turns_(0.5 * static_cast<double>(half_turns)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const Expr twist = turns_ * p.u;
        const Expr r = emit(radius_) + p.v * cos(twist);
        return {r * cos(p.u), r * sin(p.u), p.v * sin(twist)};
    }

private:
    Scalar radius_;
    double turns_;
};

Pair axes_of(const Arguments& a) { return {a.number("a"), a.number("b")}; }

std::vector<StageParameter> half_widths() {
    return {positive_parameter("a", 1.0, "half its width along x at z = 1"),
            positive_parameter("b", 1.0, "half its width along y at z = 1")};
}

}  // namespace

std::vector<StageEntry> surface_primitives() {
    std::vector<StageParameter> paraboloid_parameters = half_widths();
    paraboloid_parameters.push_back(choice_parameter(
        "by", {"polar", "cartesian"},
        "the parametrisation: u is the angle and v the root of z, front outside; or u "
        "is x/a and v is y/b, front inside"));
    return {
        {.name = "disc",
         .meaning = "a disc around the z axis in the plane z = 0, whose front faces up",
         .formula = R"(
polar        p = radius v (cos u, sin u, 0)      0 ≤ v ≤ 1
concentric   p = radius u (cos φ, sin φ, 0),  φ = (π/4) v/u   where |v| < |u|
             p = radius v (sin φ, cos φ, 0),  φ = (π/4) u/v   elsewhere
             |u| ≤ 1, |v| ≤ 1      (P. Shirley and K. Chiu, 1997)
)",
         .parameters =
             {positive_parameter("radius", 1.0, "the radius"),
              choice_parameter(
                  "by", {"polar", "concentric"},
                  "the parametrisation: u is the angle and v the distance from the centre, 1 "
                  "at the rim; or the square of u and v from -1 to 1, with relative areas "
                  "preserved")},
         .make =
             [](const Arguments& a) {
                 return a.choice("by") == "polar" ? made<Ring>(0.0, a.number("radius"))
                                                  : made<ConcentricDisc>(a.number("radius"));
             },
         .dimension = 2,
         .example = R"(
// The view down through a round window, from its centre at the lower edge to its rim at the upper.
camera round_window(radius = 2) {
    map  u = 180deg .. -180deg, v = 0 .. 1
    eye  disc(radius)
    look normal(side = back)
}
)"},
        {.name = "ring",
         .meaning =
             "the part of the plane z = 0 between two circles around the z axis, whose front faces "
             "up; u is the angle, v runs from 0 at the inner to 1 at the outer circle",
         .formula = R"(
p = r (cos u, sin u, 0)      r = inner + v (outer − inner),   0 ≤ v ≤ 1
)",
         .parameters = {number_parameter("inner", 0.5, "radius of the inner circle",
                                         {.minimum = 0.0}),
                        positive_parameter("outer", 1.0, "radius of the outer circle")},
         .make = maker<Ring>("inner", "outer"),
         .dimension = 2,
         .example = R"(
// A ring of seats, unrolled and seen from above: the stage is at the bottom, the last row on top.
camera arena {
    aspect 4
    map  u = 180deg .. -180deg, v = 0 .. 1
    eye  ring(inner = 2, outer = 5)
    look normal(side = back)
    move translate(0, 0, 3)
}
)"},
        {.name = "cone",
         .meaning =
             "a cone or a frustum around the z axis, by angle u and height v; ends at its apex",
         .formula = R"(
p = (r cos u, r sin u, v)      r = radius + v (top − radius)/height ≥ 0
)",
         .parameters = {number_parameter("radius", 1.0, "radius at height 0", {.minimum = 0.0}),
                        number_parameter("top", 0.0, "radius at `height`", {.minimum = 0.0}),
                        positive_parameter("height", 1.0,
                                           "the height at which the radius is `top`")},
         .make = maker<Cone>("radius", "top", "height"),
         .dimension = 2,
         .example = R"(
// Looks out of a pointed roof all round, upwards according to the slope of its sides.
camera roof {
    map  u = 180deg .. -180deg, v = 0 .. 1.8
    eye  cone(radius = 2, height = 2)
    look normal
}
)"},
        {.name = "paraboloid",
         .meaning = "the elliptic paraboloid z = x^2/a^2 + y^2/b^2",
         .formula = R"(
polar       p = (a v cos u, b v sin u, v²)
cartesian   p = (a u, b v, u² + v²)
)",
         .parameters = std::move(paraboloid_parameters),
         .make =
             [](const Arguments& a) {
                 return a.choice("by") == "polar" ? made<PolarParaboloid>(axes_of(a))
                                                  : made<CartesianParaboloid>(axes_of(a), 1.0);
             },
         .dimension = 2,
         .example = R"(
// The outside of a headlight's reflector: undistorted in the middle, compressed at the border.
camera headlight {
    map  u = -2 .. 2, v = square
    eye  paraboloid(by = cartesian)
    look normal(side = back)
    move rotate(z, -90deg), rotate(y, -90deg)
}
)"},
        {.name = "hyperbolic_paraboloid",
         .meaning = "the saddle z = x^2/a^2 - y^2/b^2 by u = x/a and v = y/b, whose front faces up",
         .formula = R"(
p = (a u, b v, u² − v²)
)",
         .parameters = half_widths(),
         .make = [](const Arguments& a) { return made<CartesianParaboloid>(axes_of(a), -1.0); },
         .dimension = 2,
         .example = R"(
// The normals of a saddle converge in one direction and diverge in the other. Where rays have
// crossed, the picture is mirrored in one direction.
camera saddle {
    map  u = 0.8 .. -0.8, v = square
    eye  hyperbolic_paraboloid
    look normal
}
)"},
        {.name = "mobius_band",
         .meaning = "a twisted band around the z axis, by the angle u and the distance v "
                    "from its centre circle",
         .formula = R"(
p = (r cos u, r sin u, v sin φ)      r = radius + v cos φ,   φ = half_turns u/2
)",
         .parameters = {positive_parameter("radius", 1.0, "radius of its centre circle"),
                        {.name = "half_turns",
                         .type = CountParameter{.default_value = 1.0,
                                                .range = {.minimum = 0.0, .maximum = 1000.0}},
                         .meaning = "number of half turns per revolution: with an odd number, the "
                                    "band is one-sided"}},
         .make = maker<MobiusBand>("radius", "half_turns"),
         .dimension = 2,
         .example = R"(
// Twice around a one-sided band: the second half of the picture looks in the opposite directions
// of the first half.
camera both_sides {
    aspect 4
    map  u = 720deg .. 0deg, v = -0.8 .. 0.8
    eye  mobius_band(radius = 2)
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
