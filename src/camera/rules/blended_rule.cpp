// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// getDirVec from two rules: directions between those of both, by a formula of the parameters.

#include <algorithm>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"
#include "camera/rules/great_circle.hpp"

namespace balcony::camera {

namespace {

/// Weight 0 is the first rule, 1 the second; other weights extrapolate.
class BlendedRule : public DirectionRule {
public:
    BlendedRule(DirectionRulePointer first, DirectionRulePointer second, Formula weight)
        : first_(std::move(first)), second_(std::move(second)), weight_(std::move(weight)) {}
    int min_eye_dimension() const final {
        return std::max(first_->min_eye_dimension(), second_->min_eye_dimension());
    }
    bool needs_direction_object() const final {
        return first_->needs_direction_object() || second_->needs_direction_object();
    }
    int min_direction_dimension() const final {
        return std::max(first_->min_direction_dimension(), second_->min_direction_dimension());
    }
    bool needs_second_derivative() const final {
        return first_->needs_second_derivative() || second_->needs_second_derivative();
    }
    ObjectVector direction(const PathPoint& eye, const PathPoint* toward,
                           Emitter& emit) const final {
        const std::array uv{eye.parameters.u, eye.parameters.v};
        return between(to_unit_length(first_->direction(eye, toward, emit)),
                       to_unit_length(second_->direction(eye, toward, emit)),
                       weight_.emit(emit.graph(), uv).front(), emit);
    }

private:
    /// Of two unit vectors.
    virtual ObjectVector between(const ObjectVector& a, const ObjectVector& b, Expr weight,
                                 Emitter& emit) const = 0;

    DirectionRulePointer first_, second_;
    Formula weight_;
};

class LinearlyBlendedRule final : public BlendedRule {
    using BlendedRule::BlendedRule;
    ObjectVector between(const ObjectVector& a, const ObjectVector& b, Expr weight,
                         Emitter&) const override {
        return (1.0 - weight) * a + weight * b;
    }
};

class SphericallyBlendedRule final : public BlendedRule {
    using BlendedRule::BlendedRule;
    ObjectVector between(const ObjectVector& a, const ObjectVector& b, Expr weight,
                         Emitter& emit) const override {
        return on_great_circle(a, b, weight, emit);
    }
};

}  // namespace

ObjectVector on_great_circle(const ObjectVector& a, const ObjectVector& b, Expr weight,
                             Emitter& emit) {
    const Expr cosine = dot(a, b);
    const ObjectVector across = b + -(cosine * a);
    const Expr squared_sine = dot(across, across);
    constexpr double rounding = 1e-24;
    emit.require(0.0 < cosine || rounding < squared_sine);
    // If a equals b, both the sine and the angle are nearly 0.
    constexpr double tiny = 1e-300;
    const Expr sine = sqrt(max(squared_sine, emit(tiny)));
    const Expr angle = weight * atan2(sine, cosine);
    return cos(angle) * a + sin(angle) / sine * across;
}

std::vector<StageEntry> blended_rule() {
    const auto rule = [](std::string_view name, std::string_view meaning) {
        return StageParameter{.name = name,
                              .type = NestedStageParameter{.kind = StageKind::direction_rule},
                              .meaning = meaning};
    };
    return {
        {.name = "blend",
         .meaning = "interpolates two rules by a formula of the eye object's parameters",
         .formula = R"(
mixing   d = (1 − w) a + w b
angle    d = a cos(w θ) + c sin(w θ),   θ = ∠(a, b)
         c   the unit vector perpendicular to a on the side of b
a, b   the unit directions of first and second;   w = weight(u, v)
)",
         .parameters =
             {rule("first", "the rule where the weight is 0"),
              rule("second", "the rule where the weight is 1"),
              {.name = "weight",
               .type = FormulaParameter{.shape = {2, 1, 1}},
               .meaning =
                   "weight(u, v) = [w]; below 0 and above 1 the directions are extrapolated"},
              choice_parameter(
                  "by", {"mixing", "angle"},
                  "the sum (1 - w) first + w second of unit vectors, or a rotation from the first "
                  "to the second by w times the angle between them (no ray where they are "
                  "opposite)")},
         .make =
             [](const Arguments& a) {
                 const auto first = a.stage<DirectionRule>("first");
                 const auto second = a.stage<DirectionRule>("second");
                 return a.choice("by") == "mixing"
                            ? made<LinearlyBlendedRule>(first, second, a.formula("weight"))
                            : made<SphericallyBlendedRule>(first, second, a.formula("weight"));
             },
         .example = R"(
// Perspective in the middle, and the walls at right angles at both sides.
camera half_perspective {
    map    u = 2 .. -2, v = square
    eye    surface(u, v) = [-cosh(u), sinh(u), v]
    toward sphere(1)
    look   blend(normal, absolute, weight(u, v) = [1/(1 + u^4)])
}
)"},
    };
}

}  // namespace balcony::camera
