// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS: quadrics and superquadrics as spherical products of conics and
// superconics (the paper, section 3.2).

#include "camera/catalogue/families.hpp"
#include "camera/objects/spherical_product.hpp"
#include "camera/objects/superconics.hpp"

namespace balcony::camera {

namespace {

using Curve = Result<ObjectGeneratorPointer>;
StageResult product(const Curve& g, const Curve& h) {
    if (!g) {
        return g.diagnostics;
    }
    if (!h) {
        return h.diagnostics;
    }
    return {spherical_product_of(*g, *h)};
}

Scalar quotient(const Scalar& numerator, const Scalar& denominator) {
    const auto graph = std::make_shared<Graph>();
    return Formula(graph, {}, {numerator.emit(*graph) / denominator.emit(*graph)});
}

/// A curve moved along x.
class OffsetCurve final : public ObjectGenerator {
public:
    OffsetCurve(Scalar offset, ObjectGeneratorPointer curve)
        : offset_(std::move(offset)), curve_(std::move(curve)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ObjectPoint point = curve_->generate(p, emit);
        return {emit(offset_) + point.x, point.y, point.z};
    }

private:
    Scalar offset_;
    ObjectGeneratorPointer curve_;
};

// Common parameters: half axes, and the parameters and parametrisations of the two curves.
// The defaults are those of conics.
struct Shape {
    Scalar a, b, c;
    Scalar gamma_u = 1.0, gamma_v = 1.0;
    std::string by_u, by_v;
};

Shape shape_of(const Arguments& arguments) {
    const auto choice = [&](std::string_view own) {
        return arguments.choice(arguments.has(own) ? own : "by");
    };
    const auto gamma = [&](std::string_view name) {
        return arguments.has(name) ? arguments.number(name) : Scalar(1.0);
    };
    return {arguments.number("a"), arguments.number("b"), arguments.number("c"), gamma("gamma_u"),
            gamma("gamma_v"),      choice("by_u"),        choice("by_v")};
}

StageResult make_ellipsoid(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    return product(superellipse(1.0, quotient(s.b, s.a), s.gamma_u, s.by_u),
                   superellipse(s.a, s.c, s.gamma_v, s.by_v));
}

StageResult make_hyperboloid_one(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    return product(superellipse(1.0, quotient(s.b, s.a), s.gamma_u, s.by_u),
                   superhyperbola(s.a, s.c, s.gamma_v, s.by_v));
}

StageResult make_hyperboloid_two(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    return product(superhyperbola(1.0, quotient(s.b, s.a), s.gamma_u, s.by_u),
                   superhyperbola(s.a, s.c, s.gamma_v, s.by_v));
}

StageResult make_toroid(const Arguments& arguments) {
    const Shape s = shape_of(arguments);
    const Curve tube = superellipse(arguments.number("tube"), s.c, s.gamma_v, s.by_v);
    if (!tube) {
        return tube.diagnostics;
    }
    return product(superellipse(1.0, quotient(s.b, s.a), s.gamma_u, s.by_u),
                   Curve(std::make_shared<const OffsetCurve>(s.a, *tube)));
}

// ---------------------------------------------------------------------------------- parameters

using Parameters = std::vector<StageParameter>;

Parameters half_axes() {
    return {positive_parameter("a", 1.0, "half axis along x"),
            positive_parameter("b", 1.0, "half axis along y"),
            positive_parameter("c", 1.0, "half axis along z")};
}

Parameters torus_measures() {
    return {positive_parameter("a", 2.0, "half axis of the tube's centre line along x"),
            positive_parameter("b", 2.0, "half axis of the tube's centre line along y"),
            positive_parameter("tube", 1.0, "half the tube's width on the x axis"),
            positive_parameter("c", 1.0, "half the tube's height")};
}

Parameters gammas() {
    return {gamma_parameter("gamma_u",
                            "superconic parameter around z: 1 is the conic, less is more "
                            "square"),
            gamma_parameter("gamma_v", "superconic parameter in the vertical direction")};
}

StageParameter parametrisation(std::string_view name, std::vector<std::string_view> choices,
                               std::string_view meaning) {
    return choice_parameter(name, std::move(choices), meaning);
}

Parameters by_ellipses() {
    return {parametrisation("by", superellipse_parametrisations(),
                            "the parametrisation of both curves, as in superellipse")};
}

Parameters by_ellipses_of_quadrics() {
    return {parametrisation("by", {"trigonometric", "arc_length"},
                            "the parametrisation of both curves, as in ellipse")};
}

Parameters by_hyperbolas(std::string_view name) {
    return {parametrisation(name, superhyperbola_parametrisations(),
                            "the parametrisation of its hyperbolas, as in superhyperbola")};
}

Parameters by_ellipse_and_hyperbola() {
    return Parameters{parametrisation("by_u", superellipse_parametrisations(),
                                      "the parametrisation of its superellipses")} +
           by_hyperbolas("by_v");
}

}  // namespace

std::vector<StageEntry> quadrics() {
    return {
        {.name = "ellipsoid",
         .meaning =
             "x^2/a^2 + y^2/b^2 + z^2/c^2 = 1, u around the z axis and v upwards from the equator",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = ellipse(1, b/a, by),   h = ellipse(a, c, by)
trigonometric   p = (a cos u cos v, b sin u cos v, c sin v)
)",
         .parameters = half_axes() + by_ellipses_of_quadrics(),
         .make = make_ellipsoid,
         .dimension = 2,
         .example = R"(
// All round from a flattened dome: the ground and the sky in one picture.
camera dome {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  ellipsoid(3, 2, 1)
    look normal
}
)"},
        {.name = "superellipsoid",
         .meaning = "product of two superellipses, (|x/a|^e + |y/b|^e)^(f/e) + |z/c|^f = 1 with e "
                    "= 2/gamma_u and f = 2/gamma_v",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = superellipse(1, b/a, gamma_u, by),   h = superellipse(a, c, gamma_v, by)
)",
         .parameters = half_axes() + gammas() + by_ellipses(),
         .make = make_ellipsoid,
         .dimension = 2,
         .example = R"(
// Nearly a box: each side sees a wall of the surrounding room at right angles.
camera long_room {
    aspect 4
    map  u = 180deg .. -180deg, v = -60deg .. 60deg
    eye  superellipsoid(45, 25, 25, gamma_u = 1/4, gamma_v = 1/4, by = arc_length)
    look normal
}
)"},
        {.name = "hyperboloid_one",
         .meaning = "the hyperboloid of one sheet, x^2/a^2 + y^2/b^2 - z^2/c^2 = 1, u around the z "
                    "axis and v along it",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = ellipse(1, b/a, trigonometric),   h = superhyperbola(a, c, 1, by)
cartesian   p = (a √(1 + v²) cos u, b √(1 + v²) sin u, c v)
)",
         .parameters = half_axes() + by_hyperbolas("by"),
         .make =
             [](const Arguments& arguments) {
                 Arguments both = arguments;
                 both.set("by_u", std::string("trigonometric"));
                 return make_hyperboloid_one(both);
             },
         .dimension = 2,
         .example = R"(
// From the waist of a cooling tower: downwards at its top, upwards at its base.
camera cooling_tower {
    map  u = 180deg .. -180deg, v = -1.5 .. 1.5
    eye  hyperboloid_one(1, 1, 2)
    look normal
}
)"},
        {.name = "superhyperboloid_one",
         .meaning = "product of a superellipse and a superhyperbola, (|x/a|^e + |y/b|^e)^(f/e) - "
                    "|z/c|^f = 1 with e = 2/gamma_u and f = 2/gamma_v",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = superellipse(1, b/a, gamma_u, by_u)
h = superhyperbola(a, c, gamma_v, by_v)
)",
         .parameters = half_axes() + gammas() + by_ellipse_and_hyperbola(),
         .make = make_hyperboloid_one,
         .dimension = 2,
         .example = R"(
// A square tower with a waist: four walls side by side, with a larger view above and below.
camera square_tower {
    map  u = 180deg .. -180deg, v = -1.5 .. 1.5
    eye  superhyperboloid_one(1, 1, 2, gamma_u = 1/3, gamma_v = 1/2, by_u = arc_length)
    look normal
}
)"},
        {.name = "hyperboloid_two",
         .meaning =
             "the sheet x > 0 of the hyperboloid of two sheets, x^2/a^2 - y^2/b^2 - z^2/c^2 = 1",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = superhyperbola(1, b/a, 1, by),   h = superhyperbola(a, c, 1, by)
hyperbolic   p = (a cosh u cosh v, b sinh u cosh v, c sinh v)
)",
         .parameters = half_axes() + by_hyperbolas("by"),
         .make = make_hyperboloid_two,
         .dimension = 2,
         .example = R"(
// The view in a convex mirror: wide, and undistorted in the middle.
camera wide_view {
    map  u = -1.5 .. 1.5, v = -1 .. 1
    eye  hyperboloid_two(1, 1, 1, by = hyperbolic)
    look normal(side = back)
    move rotate(z, 180deg)
}
)"},
        {.name = "superhyperboloid_two",
         .meaning = "product of two superhyperbolas, one sheet: (|x/a|^e - |y/b|^e)^(f/e) - "
                    "|z/c|^f = 1 with e = 2/gamma_u and f = 2/gamma_v",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = superhyperbola(1, b/a, gamma_u, by)
h = superhyperbola(a, c, gamma_v, by)
)",
         .parameters = half_axes() + gammas() + by_hyperbolas("by"),
         .make = make_hyperboloid_two,
         .dimension = 2,
         .example = R"(
// Enlarges the middle of a wall and keeps its borders in the picture.
camera wall_of_pictures {
    map  u = -2 .. 2, v = -2 .. 2
    eye  superhyperboloid_two(45, 25, 25, gamma_u = 1/4, gamma_v = 1/4)
    look normal(side = back)
    move rotate(z, 180deg)
}
)"},
        {.name = "toroid",
         .meaning = "a torus whose centre line and tube are ellipses, u around the z axis and v "
                    "around the tube",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = ellipse(1, b/a, by),   h = (a, 0) + ellipse(tube, c, by)
trigonometric   p = (r cos u, (b/a) r sin u, c sin v),   r = a + tube cos v
)",
         .parameters = torus_measures() + by_ellipses_of_quadrics(),
         .make = make_toroid,
         .dimension = 2,
         .example = R"(
// All sides of an oval tube: outwards in the middle of the picture, towards the hole at its edges.
camera oval_ring {
    map  u = 180deg .. -180deg, v = -180deg .. 180deg
    eye  toroid(4, 3, 0.6, 1)
    look normal
}
)"},
        {.name = "supertoroid",
         .meaning = "a torus whose centre line and tube are superellipses",
         .formula = R"(
p = (g₁(u) h₁(v), g₂(u) h₁(v), h₂(v))
g = superellipse(1, b/a, gamma_u, by)
h = (a, 0) + superellipse(tube, c, gamma_v, by)
)",
         .parameters = torus_measures() + gammas() + by_ellipses(),
         .make = make_toroid,
         .dimension = 2,
         .example = R"(
// A corridor around a square court, seen from inside and unrolled: outer wall, ceiling, inner
// wall and floor.
camera corridor {
    map  u = 180deg .. -180deg, v = -180deg .. 180deg
    eye  supertoroid(6, 6, 1, 1, gamma_u = 1/4, gamma_v = 1/4, by = arc_length)
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
