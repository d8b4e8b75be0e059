// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformers, PCS → PCS: the affine maps.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

class ParameterTranslation final : public ParameterTransformer {
public:
    explicit ParameterTranslation(Pair by) : by_(std::move(by)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint by = parameter_point_of(by_, emit);
        return {p.u + by.u, p.v + by.v};
    }

private:
    Pair by_;
};

class ParameterScaling final : public ParameterTransformer {
public:
    ParameterScaling(Pair factor, Pair at) : factor_(std::move(factor)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint factor = parameter_point_of(factor_, emit);
        const ParameterPoint at = parameter_point_of(at_, emit);
        return {at.u + factor.u * (p.u - at.u), at.v + factor.v * (p.v - at.v)};
    }

private:
    Pair factor_, at_;
};

class ParameterRotation final : public ParameterTransformer {
public:
    ParameterRotation(Scalar angle, Pair at) : angle_(std::move(angle)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Expr c = cos(emit(angle_));
        const Expr s = sin(emit(angle_));
        const ParameterPoint at = parameter_point_of(at_, emit);
        const Expr du = p.u - at.u;
        const Expr dv = p.v - at.v;
        return {at.u + c * du - s * dv, at.v + s * du + c * dv};
    }

private:
    Scalar angle_;
    Pair at_;
};

class ParameterShear final : public ParameterTransformer {
public:
    explicit ParameterShear(Pair factor) : factor_(std::move(factor)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint factor = parameter_point_of(factor_, emit);
        return {p.u + factor.u * p.v, p.v + factor.v * p.u};
    }

private:
    Pair factor_;
};

class ParameterAffineMap final : public ParameterTransformer {
public:
    ParameterAffineMap(Pair u, Pair v, Pair at)
        : u_(std::move(u)), v_(std::move(v)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint u = parameter_point_of(u_, emit);
        const ParameterPoint v = parameter_point_of(v_, emit);
        const ParameterPoint at = parameter_point_of(at_, emit);
        return {at.u + p.u * u.u + p.v * v.u, at.v + p.u * u.v + p.v * v.v};
    }

private:
    Pair u_, v_, at_;
};

StageParameter fixed_parameters() { return pair_parameter("at", {0.0, 0.0}, "the fixed point"); }

StageParameter addend(std::string_view name, std::string_view meaning) {
    return {.name = name,
            .type = NumberParameter{.unit = Unit::either, .default_value = 0.0},
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> parameter_affine() {
    return {
        {.name = "translate",
         .meaning = "(u + a, v + b)",
         .formula = R"(
(u′, v′) = (u + a, v + b)      a, b   the parameters u and v
)",
         .parameters = {addend("u", "added to u"), addend("v", "added to v")},
         .make =
             [](const Arguments& a) {
                 return made<ParameterTranslation>(Pair{a.number("u"), a.number("v")});
             },
         .example = R"(
// Looks 30 degrees further to the left and 10 degrees up, with the same field of view.
camera aside {
    map    u = 40deg .. -40deg, v = square
    warp   translate(30deg, 10deg)
    eye    point
    toward sphere(1)
}
)"},
        {.name = "scale",
         .meaning = "scales about a point; a factor above 1 shows more of the object",
         .formula = R"(
u′ = at₁ + factor₁ (u − at₁)
v′ = at₂ + factor₂ (v − at₂)
The range that the picture shows grows by the factors, also the one that
`square` chose before: its pixels stay square if factor₁ = ±factor₂.
)",
         .parameters = {{.name = "factor",
                         .type = PairParameter{.one_for_both = true},
                         .meaning = "factors for u and v"},
                        fixed_parameters()},
         .make = maker<ParameterScaling>("factor", "at"),
         .example = R"(
// Shows 1.5 times as much in width and the same in height.
camera wider {
    map    u = 40deg .. -40deg, v = square
    warp   scale((1.5, 1))
    eye    point
    toward sphere(1)
}
)"},
        {.name = "rotate",
         .meaning = "rotates (u, v) about a point, from u towards v",
         .formula = R"(
u′ = at₁ + (u − at₁) cos angle − (v − at₂) sin angle
v′ = at₂ + (u − at₁) sin angle + (v − at₂) cos angle
)",
         .parameters = {{.name = "angle",
                         .type = NumberParameter{.unit = Unit::angle},
                         .meaning = "angle of rotation"},
                        fixed_parameters()},
         .make = maker<ParameterRotation>("angle", "at"),
         .example = R"(
// The picture is tilted, like that of a tilted camera.
camera askew {
    map    u = 40deg .. -40deg, v = square
    warp   rotate(20deg)
    eye    point
    toward sphere(1)
}
)"},
        {.name = "shear",
         .meaning = "(u + a v, v + b u)",
         .formula = R"(
(u′, v′) = (u + a v, v + b u)      a, b   the parameters u and v
)",
         .parameters = {number_parameter("u", 0.0, "the multiple of v added to u"),
                        number_parameter("v", 0.0, "the multiple of u added to v")},
         .make =
             [](const Arguments& a) {
                 return made<ParameterShear>(Pair{a.number("u"), a.number("v")});
             },
         .example = R"(
// Vertical lines lean like italic letters.
camera leaning {
    map    u = 40deg .. -40deg, v = square
    warp   shear(u = 0.3)
    eye    point
    toward sphere(1)
}
)"},
        {.name = "affine",
         .meaning = "at + u (image of u) + v (image of v)",
         .formula = R"(
(u′, v′) = at + u U + v V      U, V   the parameters u and v
)",
         .parameters = {pair_parameter("u", {1.0, 0.0}, "the image of (1, 0), before adding `at`"),
                        pair_parameter("v", {0.0, 1.0}, "the image of (0, 1), before adding `at`"),
                        pair_parameter("at", {0.0, 0.0}, "the image of (0, 0)")},
         .make = maker<ParameterAffineMap>("u", "v", "at"),
         .example = R"(
// Any affine map of the angles: here rotation, scaling and translation at once.
camera any_affine {
    map    u = 40deg .. -40deg, v = square
    warp   affine(u = (0.8, 0.3), v = (-0.2, 0.6), at = (10deg, 0))
    eye    point
    toward sphere(1)
}
)"},
    };
}

}  // namespace balcony::camera
