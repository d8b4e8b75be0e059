// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object transformers, OCS → OCS: the affine maps.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

class Translate final : public ObjectTransformer {
public:
    explicit Translate(Triple by) : by_(std::move(by)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        return p + vector_of(by_, emit);
    }

private:
    Triple by_;
};

/// Rodrigues' formula: d cos + (axis x d) sin + axis (axis . d) (1 - cos).
class Rotate final : public ObjectTransformer {
public:
    Rotate(Triple axis, Scalar angle, Triple at)
        : axis_(std::move(axis)), angle_(std::move(angle)), at_(std::move(at)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectVector axis = to_unit_length(vector_of(axis_, emit));
        const ObjectPoint at = point_of(at_, emit);
        const ObjectVector d = p - at;
        const Expr c = cos(emit(angle_));
        const Expr s = sin(emit(angle_));
        return at + (c * d + s * cross(axis, d) + ((1.0 - c) * dot(axis, d)) * axis);
    }

private:
    Triple axis_;
    Scalar angle_;
    Triple at_;
};

class Stretch final : public ObjectTransformer {
public:
    Stretch(Triple factors, Triple at) : factors_(std::move(factors)), at_(std::move(at)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectPoint at = point_of(at_, emit);
        const ObjectVector f = vector_of(factors_, emit);
        const ObjectVector d = p - at;
        return at + ObjectVector{f.x * d.x, f.y * d.y, f.z * d.z};
    }

private:
    Triple factors_, at_;
};

/// Reflection in the plane through a point and perpendicular to an axis: d - 2 axis (axis . d).
class Mirror final : public ObjectTransformer {
public:
    Mirror(Triple axis, Triple at) : axis_(std::move(axis)), at_(std::move(at)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const ObjectVector axis = to_unit_length(vector_of(axis_, emit));
        const ObjectVector d = p - point_of(at_, emit);
        return p + (-2.0 * dot(axis, d)) * axis;
    }

private:
    Triple axis_, at_;
};

class Affine final : public ObjectTransformer {
public:
    Affine(Triple x, Triple y, Triple z, Triple at)
        : x_(std::move(x)), y_(std::move(y)), z_(std::move(z)), at_(std::move(at)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        return point_of(at_, emit) + p.x * vector_of(x_, emit) + p.y * vector_of(y_, emit) +
               p.z * vector_of(z_, emit);
    }

private:
    Triple x_, y_, z_, at_;
};

StageParameter center() { return triple_parameter("at", {0.0, 0.0, 0.0}, "the fixed point"); }

StageParameter axis(std::string_view meaning) {
    return {.name = "axis", .type = TripleParameter{.names_axes = true}, .meaning = meaning};
}

bool is_null(const Triple& t) {
    return t[0].constant() == 0.0 && t[1].constant() == 0.0 && t[2].constant() == 0.0;
}

Diagnostic null_axis() {
    return error("the axis is (0, 0, 0), which is not a direction", {},
                 "write x, y, z or a vector such as (1, 1, 0)");
}

}  // namespace

std::vector<StageEntry> object_affine() {
    return {
        {.name = "translate",
         .meaning = "translates by a vector",
         .formula = R"(
p′ = p + (X, Y, Z)      X, Y, Z   the parameters x, y and z
)",
         .parameters = {number_parameter("x", 0.0, "along x"),
                        number_parameter("y", 0.0, "along y"),
                        number_parameter("z", 0.0, "along z")},
         .make = [](const Arguments& a) { return made<Translate>(xyz_of(a)); },
         .example = R"(
// The same parallel rays from a position two units forward and one up.
camera moved {
    map  u = 3 .. -3, v = square
    eye  plane
    look normal
    move translate(2, 0, 1)
}
)"},
        {.name = "rotate",
         .meaning = "rotates about an axis, counter-clockwise as seen from its tip",
         .formula = R"(
p′ = at + d cos θ + (n × d) sin θ + (n·d) (1 − cos θ) n
d = p − at,   n = axis/|axis|,   θ = angle
)",
         .parameters = {axis("x, y, z or a vector"),
                        {.name = "angle",
                         .type = NumberParameter{.unit = Unit::angle},
                         .meaning = "angle of rotation"},
                        center()},
         .make = [](const Arguments& a) -> StageResult {
             if (is_null(a.triple("axis"))) {
                 return null_axis();
             }
             return made<Rotate>(a.triple("axis"), a.number("angle"), a.triple("at"));
         },
         .example = R"(
// A plan seen from above on the left: the plane is tilted down, then rotated to the right.
camera from_above {
    map  u = 3 .. -3, v = square
    eye  plane
    look normal
    move rotate(y, 35deg), rotate(z, -30deg)
}
)"},
        {.name = "scale",
         .meaning = "scales about a point",
         .formula = R"(
p′ = at + factor (p − at)
)",
         .parameters = {{.name = "factor",
                         .type = NumberParameter{},
                         .meaning = "factor for all three axes"},
                        center()},
         .make =
             [](const Arguments& a) {
                 const Scalar factor = a.number("factor");
                 return made<Stretch>(Triple{factor, factor, factor}, a.triple("at"));
             },
         .example = R"(
// A sphere of half the size: rays start nearer to its centre, with the same directions.
camera smaller {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  sphere(4)
    look normal
    move scale(1/2)
}
)"},
        {.name = "stretch",
         .meaning = "scales along each axis about a point",
         .formula = R"(
p′ = at + (X d₁, Y d₂, Z d₃)      d = p − at
X, Y, Z   the parameters x, y and z
)",
         .parameters = {number_parameter("x", 1.0, "factor along x"),
                        number_parameter("y", 1.0, "factor along y"),
                        number_parameter("z", 1.0, "factor along z"), center()},
         .make = [](const Arguments& a) { return made<Stretch>(xyz_of(a), a.triple("at")); },
         .example = R"(
// A sphere stretched vertically, whose normals concentrate towards the horizon.
camera egg {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  sphere(1)
    look normal
    move stretch(z = 2)
}
)"},
        {.name = "mirror",
         .meaning = "reflects in the plane through a point and perpendicular to an axis; a "
                    "surface's front becomes its back",
         .formula = R"(
p′ = p − 2 (n·(p − at)) n      n = axis/|axis|
)",
         .parameters = {axis("the plane's normal: x, y, z or a vector"), center()},
         .make = [](const Arguments& a) -> StageResult {
             if (is_null(a.triple("axis"))) {
                 return null_axis();
             }
             return made<Mirror>(a.triple("axis"), a.triple("at"));
         },
         .example = R"(
// The view in a flat mirror in the plane y = 0, from its left side.
camera mirrored {
    map    u = 0.6 .. -0.6, v = square
    eye    point(0, 1, 0)
    toward plane((1, 0.2, 0))
    move   mirror(y)
}
)"},
        {.name = "affine",
         .meaning = "at + x (image of x) + y (image of y) + z (image of z)",
         .formula = R"(
p′ = at + x X + y Y + z Z      p = (x, y, z)
X, Y, Z   the parameters x, y and z
)",
         .parameters =
             {triple_parameter("x", {1.0, 0.0, 0.0}, "the image of (1, 0, 0), before adding `at`"),
              triple_parameter("y", {0.0, 1.0, 0.0}, "the image of (0, 1, 0), before adding `at`"),
              triple_parameter("z", {0.0, 0.0, 1.0}, "the image of (0, 0, 1), before adding `at`"),
              triple_parameter("at", {0.0, 0.0, 0.0}, "the image of (0, 0, 0)")},
         .make = maker<Affine>("x", "y", "z", "at"),
         .example = R"(
// Parallel rays from a picture plane that leans forwards and to the left, perpendicular to it.
camera sheared {
    map  u = 3 .. -3, v = square
    eye  plane
    look normal
    move affine(z = (0.5, 0.3, 1), at = (0, 0, 1))
}
)"},
    };
}

}  // namespace balcony::camera
