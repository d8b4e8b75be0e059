// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "solve/shapes.hpp"

#include <cmath>

namespace balcony::solve {

namespace {

using camera::Expr;
using camera::ObjectVector;

/// By which steps perpendicular to the ray the point that it shows at a distance moves, from pixel
/// to pixel: a and b of docs/analysis.md; at infinity, the change of the unit direction.
struct Steps {
    ObjectVector a, b;
    ObjectVector direction;

    Steps(const Constraint& constraint, const camera::RayExpressions& ray)
        : direction(ray.direction) {
        const camera::RayFootprint slopes = camera::footprint(ray);
        const Expr distance = ray.valid.graph().constant(constraint.distance.value_or(0.0));
        const auto step = [&](const ObjectVector& origin, const ObjectVector& slope) {
            if (!constraint.distance) {
                return slope;
            }
            const ObjectVector moved = origin + distance * slope;
            return moved + -(dot(moved, ray.direction) * ray.direction);
        };
        a = step(slopes.origin_by_x, slopes.direction_by_x);
        b = step(slopes.origin_by_y, slopes.direction_by_y);
    }

    /// The area of a pixel, negative where the picture is mirrored: x to the right and y downwards
    /// turn clockwise seen along the ray.
    [[nodiscard]] Expr area() const { return dot(cross(a, b), direction); }
};

}  // namespace

std::vector<Expr> shape_misses(const Constraint& constraint, const camera::RayExpressions& ray) {
    const Steps steps(constraint, ray);
    const Expr aa = dot(steps.a, steps.a);
    const Expr bb = dot(steps.b, steps.b);
    switch (constraint.kind) {
        case ConstraintKind::magnification:
            // log of (1 / sqrt(area)) / value.
            return {-0.5 * log(abs(steps.area())) - std::log(constraint.value)};
        case ConstraintKind::isotropic:
            return {(aa - bb) / (aa + bb), 2.0 * dot(steps.a, steps.b) / (aa + bb)};
        default: {
            // The sine of the angle between the steps, which folds and mirrored parts have not.
            const Expr sine = steps.area() / sqrt(aa * bb);
            return {max(constraint.value - sine, sine.graph().constant(0.0))};
        }
    }
}

}  // namespace balcony::solve
