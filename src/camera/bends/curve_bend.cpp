// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A bend by a formula: the points of a ray's path from 0 to 1.

#include <utility>

#include "camera/bends/straight_parts.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

constexpr FormulaShape point_shape{.parameters = 11,
                                   .min_results = 3,
                                   .max_results = 3,
                                   .functions = {},
                                   .names = "s, x, y, z, dx, dy, dz, u, v, px, py",
                                   .may_have_fewer = true};

class CurveBend final : public Bend {
public:
    CurveBend(Formula point, Division division) : point_(std::move(point)), division_(division) {}

    BentPath path(const CentralRay& ray, Emitter& emit) const override {
        const auto knots_of = [this](const CentralRay& central, std::size_t parts, Emitter& to) {
            std::vector<ObjectPoint> knots;
            for (std::size_t i = 0; i <= parts; ++i) {
                const Expr s = to(static_cast<double>(i) / static_cast<double>(parts));
                knots.push_back(point(central, s, to));
            }
            return knots;
        };
        return {knots_of(ray, straight_parts(division_, ray, knots_of, emit), emit),
                last_tangent(ray, emit)};
    }

private:
    [[nodiscard]] ObjectPoint point(const CentralRay& ray, Expr s, Emitter& emit) const {
        const auto& [o, d, p, picture] = ray;
        const std::array all{s,
                             o.x,
                             o.y,
                             o.z,
                             d.x,
                             d.y,
                             d.z,
                             p.u,
                             p.v,
                             picture.point.x / picture.size.width,
                             picture.point.y / picture.size.height};
        const std::vector<Expr> xyz =
            point_.emit(emit.graph(), std::span(all).first(point_.parameter_count()));
        return {xyz[0], xyz[1], xyz[2]};
    }

    [[nodiscard]] ObjectVector last_tangent(const CentralRay& ray, Emitter& emit) const {
        const Expr s = emit.graph().fresh_variable();
        const ObjectPoint p = point(ray, s, emit);
        const std::vector<Expr> slopes = expr::differentiate(std::array{p.x, p.y, p.z}, s);
        const std::vector<Expr> at_end =
            expr::substitute(emit.graph(), slopes, std::array{expr::Substitution{s, emit(1.0)}});
        return {at_end[0], at_end[1], at_end[2]};
    }

    Formula point_;
    Division division_;
};

}  // namespace

std::vector<StageEntry> curve_bend() {
    return {
        {.name = "curve",
         .meaning = "rays along curves: the point of a ray at s, from 0 at its start to 1",
         .formula = R"(
p(s) = point(s, ...),   0 ≤ s ≤ 1,   then straight on along p′(1)
(x, y, z), (dx, dy, dz)   the straight ray: its origin, its unit direction
(u, v)                    its parameters
(px, py)                  the point of the picture, in fractions from top left
knots   p(i/n), i = 0 .. n, so that |p − chords| ≤ tolerance
)",
         .parameters =
             std::vector<StageParameter>{
                 {.name = "point",
                  .type = FormulaParameter{.shape = point_shape},
                  .meaning = "point(s, x, y, z, dx, dy, dz, u, v, px, py) = [x, y, z], with as "
                             "many of these parameters as it needs"}} +
             division_parameters(),
         .make =
             [](const Arguments& a) { return made<CurveBend>(a.formula("point"), division_of(a)); },
         .example = R"(
// Rays fall like stones: what is far away stands higher.
camera stones {
    map    u = 0.8 .. -0.8, v = square
    eye    point
    toward plane((1, 0, 0))
    bend   curve(point(s, x, y, z, dx, dy, dz) =
               [x + 60*s*dx, y + 60*s*dy, z + 60*s*dz - 16*s^2], tolerance = 0.02)
}
)"},
    };
}

}  // namespace balcony::camera
