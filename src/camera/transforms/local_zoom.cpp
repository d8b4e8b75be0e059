// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformer, PCS → PCS: the local zoom as an analytic function.

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Enlarges the picture around a point of parameter space and keeps the rest visible: with d the
/// offset from the point in units of the radius and q = |d|^2 < 1, d becomes d (1 - k (1 - q)^3)
/// with k = 1 - 1/strength. Twice continuously differentiable at the rim. It never folds for
/// strengths of 1 and more; below 32/81 it does (the slope along d, 1 - k (1 - q)^2 (1 - 7 q), has
/// its minimum at q = 3/7).
class LocalZoom final : public ParameterTransformer {
public:
    LocalZoom(std::array<Scalar, 2> at, std::array<Scalar, 2> radius, Scalar strength)
        : at_(std::move(at)), radius_(std::move(radius)), strength_(std::move(strength)) {}

    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const Expr du = p.u - emit(at_[0]);
        const Expr dv = p.v - emit(at_[1]);
        const Expr nu = du / emit(radius_[0]);
        const Expr nv = dv / emit(radius_[1]);
        const Expr k = 1.0 - 1.0 / emit(strength_);
        const Expr inside = max(1.0 - (nu * nu + nv * nv), emit(0.0));
        const Expr pull = k * (inside * inside * inside);
        return {p.u - pull * du, p.v - pull * dv};
    }

private:
    std::array<Scalar, 2> at_, radius_;
    Scalar strength_;
};

}  // namespace

std::vector<StageEntry> local_zoom() {
    return {
        {.name = "zoom",
         .meaning =
             "local zoom: magnifies around a point of parameter space and keeps the rest visible",
         .formula = R"(
(u′, v′) = at + s (u − at₁, v − at₂)
s = 1 − (1 − 1/strength) (1 − q)³ where q < 1, otherwise 1
q = ((u − at₁)/radius₁)² + ((v − at₂)/radius₂)²
It folds over for strength < 32/81, where the slope along a radius,
1 − (1 − 1/strength) (1 − q)² (1 − 7q), is negative around q = 3/7.
)",
         .parameters = {{.name = "at",
                         .type = PairParameter{.unit = Unit::either},
                         .meaning = "the point (u, v)"},
                        {.name = "radius",
                         .type = PairParameter{.unit = Unit::either,
                                               .range = {.minimum = 0.0, .excludes_minimum = true},
                                               .one_for_both = true},
                         .meaning = "radius of the affected region, in u and v"},
                        number_parameter(
                            "strength", 2.0,
                            "magnification at the centre; the picture folds over below 32/81",
                            {.minimum = 0.0, .excludes_minimum = true})},
         .make = maker<LocalZoom>("at", "radius", "strength"),
         .example = R"(
// Enlarges the centre by a factor of 2.5 and keeps the rest visible.
camera overview_and_detail {
    map    u = 40deg .. -40deg, v = square
    warp   zoom(at = (0, 0), radius = 20deg, strength = 2.5)
    eye    point
    toward sphere(1)
}
)"},
    };
}

}  // namespace balcony::camera
