// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/families.hpp"

namespace balcony::camera {

namespace {

using Pair = std::array<Scalar, 2>;

ParameterPoint parameter_point(const Pair& pair, Emitter& emit) {
    return {emit(pair[0]), emit(pair[1])};
}

class Translate final : public ParameterTransformer {
public:
    explicit Translate(Pair by) : by_(std::move(by)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint by = parameter_point(by_, emit);
        return {p.u + by.u, p.v + by.v};
    }

private:
    Pair by_;
};

class Scale final : public ParameterTransformer {
public:
    Scale(Pair factor, Pair at) : factor_(std::move(factor)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint factor = parameter_point(factor_, emit);
        const ParameterPoint at = parameter_point(at_, emit);
        return {at.u + factor.u * (p.u - at.u), at.v + factor.v * (p.v - at.v)};
    }

private:
    Pair factor_, at_;
};

class Rotate final : public ParameterTransformer {
public:
    Rotate(Scalar angle, Pair at) : angle_(std::move(angle)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Expr c = cos(emit(angle_));
        const Expr s = sin(emit(angle_));
        const ParameterPoint at = parameter_point(at_, emit);
        const Expr du = p.u - at.u;
        const Expr dv = p.v - at.v;
        return {at.u + c * du - s * dv, at.v + s * du + c * dv};
    }

private:
    Scalar angle_;
    Pair at_;
};

class Shear final : public ParameterTransformer {
public:
    explicit Shear(Pair factor) : factor_(std::move(factor)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint factor = parameter_point(factor_, emit);
        return {p.u + factor.u * p.v, p.v + factor.v * p.u};
    }

private:
    Pair factor_;
};

class Affine final : public ParameterTransformer {
public:
    Affine(Pair u, Pair v, Pair at) : u_(std::move(u)), v_(std::move(v)), at_(std::move(at)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint u = parameter_point(u_, emit);
        const ParameterPoint v = parameter_point(v_, emit);
        const ParameterPoint at = parameter_point(at_, emit);
        return {at.u + p.u * u.u + p.v * v.u, at.v + p.u * u.v + p.v * v.v};
    }

private:
    Pair u_, v_, at_;
};

StageParameter center() {
    return {.name = "at",
            .type = ParameterType::pair,
            .unit = Unit::parameter,
            .default_value = {0.0, 0.0},
            .meaning = "the point that stays"};
}

StageParameter number(std::string_view name, Unit unit, double value, std::string_view meaning) {
    return {.name = name, .unit = unit, .default_value = {value}, .meaning = meaning};
}

StageParameter image(std::string_view name, std::vector<double> value, std::string_view meaning) {
    return {.name = name,
            .type = ParameterType::pair,
            .unit = Unit::parameter,
            .default_value = std::move(value),
            .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> parameter_affine() {
    const StageKind kind = StageKind::parameter_transformer;
    return {
        {kind,
         "translate",
         "(u + a, v + b)",
         {number("u", Unit::parameter, 0.0, "added to u"),
          number("v", Unit::parameter, 0.0, "added to v")},
         [](const Arguments& a) {
             return made<Translate>(Pair{a.number("u"), a.number("v")});
         }},
        {kind,
         "scale",
         "scales about a point; a factor above 1 shows more of the object",
         {{.name = "factor", .type = ParameterType::size, .meaning = "for u and v"}, center()},
         [](const Arguments& a) { return made<Scale>(a.pair("factor"), a.pair("at")); }},
        {kind,
         "rotate",
         "turns parameter space counter-clockwise about a point",
         {{.name = "angle", .unit = Unit::angle, .meaning = "how far"}, center()},
         [](const Arguments& a) { return made<Rotate>(a.number("angle"), a.pair("at")); }},
        {kind,
         "shear",
         "(u + a v, v + b u)",
         {number("u", Unit::number, 0.0, "how much of v is added to u"),
          number("v", Unit::number, 0.0, "how much of u is added to v")},
         [](const Arguments& a) {
             return made<Shear>(Pair{a.number("u"), a.number("v")});
         }},
        {kind,
         "affine",
         "at + u (image of u) + v (image of v)",
         {image("u", {1.0, 0.0}, "where (1, 0) goes, before at is added"),
          image("v", {0.0, 1.0}, "where (0, 1) goes, before at is added"),
          image("at", {0.0, 0.0}, "where (0, 0) goes")},
         [](const Arguments& a) { return made<Affine>(a.pair("u"), a.pair("v"), a.pair("at")); }},
    };
}

}  // namespace balcony::camera
