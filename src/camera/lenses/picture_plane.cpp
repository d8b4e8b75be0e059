// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/lenses/picture_plane.hpp"

#include <array>
#include <vector>

#include "camera/catalogue/stage_parameters.hpp"
#include "camera/machine/ray_expressions.hpp"

namespace balcony::camera {

namespace {

/// For a direction d = w/|w| with w linear in x, this is the derivative of w divided by |w|.
ObjectVector in_picture_plane(const ObjectVector& d, Expr leaf) {
    const auto differentiated = [leaf](const ObjectVector& a) {
        const std::vector<Expr> slopes = expr::differentiate(std::array{a.x, a.y, a.z}, leaf);
        return ObjectVector{slopes[0], slopes[1], slopes[2]};
    };
    const ObjectVector first = differentiated(d);
    const ObjectVector second = differentiated(first);
    return first + -(0.5 * dot(second, first) / dot(first, first)) * d;
}

/// Vectors that depend on the point of the picture, at the same fraction of its width and height.
template <std::size_t count>
std::array<ObjectVector, count> at_point(const PicturePoint& picture,
                                         const std::array<ObjectVector, count>& vectors,
                                         double fraction) {
    std::vector<Expr> values;
    for (const ObjectVector& vector : vectors) {
        values.insert(values.end(), {vector.x, vector.y, vector.z});
    }
    const auto& [point, size] = picture;
    const std::array put{expr::Substitution{point.x, fraction * size.width},
                         expr::Substitution{point.y, fraction * size.height}};
    const std::vector<Expr> made = expr::substitute(size.width.graph(), values, put);
    std::array<ObjectVector, count> there;
    for (std::size_t i = 0; i < count; ++i) {
        there[i] = {made[3 * i], made[3 * i + 1], made[3 * i + 2]};
    }
    return there;
}

/// Just beside the middle: in the middle itself, the formulas of some fisheyes have no derivatives.
constexpr double beside_middle = 0.5 + 0x1p-17;

}  // namespace

PicturePlane picture_plane(const CentralRay& ray, const Emitter& emit) {
    Graph& graph = emit.graph();
    const ObjectVector& d = ray.direction;
    const auto [middle, right, down, across] = at_point(
        ray.picture,
        std::array{d, in_picture_plane(d, graph.picture_x()),
                   in_picture_plane(d, graph.picture_y()), right_across(ray, std::nullopt, emit)},
        beside_middle);
    const ObjectVector normal = cross(right, down);
    const Expr square = dot(normal, normal);
    // Parallel rays have no such plane.
    const Expr flat = smallest_square * smallest_square < square && is_finite(square);
    const Expr towards = select(dot(normal, middle) < 0.0, emit(-1.0), emit(1.0));
    const auto either = [&](const ObjectVector& a, const ObjectVector& b) {
        return ObjectVector{select(flat, a.x, b.x), select(flat, a.y, b.y), select(flat, a.z, b.z)};
    };
    return {either(to_unit_length(right), across),
            either((towards / sqrt(square)) * normal, middle)};
}

}  // namespace balcony::camera
