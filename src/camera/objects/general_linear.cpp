// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generator, PCS → OCS: general linear cameras. Yu and McMillan, "General Linear Cameras"
// (ECCV 2004).

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "camera/catalogue/families.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

namespace {

/// Three rays by the points where they meet two parallel planes, in (y, z).
struct ThreeRays {
    std::array<Pair, 3> near;
    std::array<Pair, 3> far;
    Scalar distance;  ///< Between the planes.
};

/// The affine combinations of three rays: a ray starts in the plane x = 0 and is the normal there.
class GeneralLinear final : public ObjectGenerator {
public:
    explicit GeneralLinear(ThreeRays rays) : rays_(std::move(rays)) {}

    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint at = between(rays_.near, p, emit);
        return {emit(0.0), at.u, at.v};
    }
    std::optional<ObjectVector> normal(const ParameterPoint& p, Emitter& emit) const override {
        const ParameterPoint from = between(rays_.near, p, emit);
        const ParameterPoint to = between(rays_.far, p, emit);
        return ObjectVector{emit(rays_.distance), to.u - from.u, to.v - from.v};
    }

private:
    static ParameterPoint between(const std::array<Pair, 3>& points, const ParameterPoint& p,
                                  const Emitter& emit) {
        const auto coordinate = [&](std::size_t k) {
            const Expr first = emit(points[0][k]);
            return first + p.u * (emit(points[1][k]) - first) + p.v * (emit(points[2][k]) - first);
        };
        return {coordinate(0), coordinate(1)};
    }

    ThreeRays rays_;
};

// The change from the first ray to another one, if it is known.
std::optional<std::array<double, 4>> change(const ThreeRays& rays, std::size_t other) {
    std::array<double, 4> made{};
    for (std::size_t k = 0; k < made.size(); ++k) {
        const std::array<Pair, 3>& points = k < 2 ? rays.near : rays.far;
        const auto first = points[0][k % 2].constant();
        const auto last = points[other][k % 2].constant();
        if (!first || !last) {
            return std::nullopt;
        }
        made[k] = *last - *first;
    }
    return made;
}

// Whether all combinations of the rays are those of two of them.
bool are_in_line(const ThreeRays& rays) {
    const auto a = change(rays, 1);
    const auto b = change(rays, 2);
    if (!a || !b) {
        return false;
    }
    double largest = 0.0;
    double squares_a = 0.0;
    double squares_b = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        squares_a += (*a)[i] * (*a)[i];
        squares_b += (*b)[i] * (*b)[i];
        for (std::size_t k = 0; k < i; ++k) {
            largest = std::max(largest, std::abs((*a)[i] * (*b)[k] - (*a)[k] * (*b)[i]));
        }
    }
    constexpr double rounding = 1e-12;
    return largest <= rounding * std::sqrt(squares_a * squares_b);
}

StageResult make_general_linear(const Arguments& a) {
    const ThreeRays rays{{a.pair("a"), a.pair("b"), a.pair("c")},
                         {a.pair("to_a"), a.pair("to_b"), a.pair("to_c")},
                         a.number("distance")};
    if (are_in_line(rays)) {
        return error("one of the three rays is between the others, so they make no picture", {},
                     "move one of them out of the line of the two others, in one of the planes");
    }
    return made<GeneralLinear>(rays);
}

StageParameter point_parameter(std::string_view name, std::array<double, 2> value,
                               std::string_view meaning) {
    return {.name = name, .type = PairParameter{.default_value = value}, .meaning = meaning};
}

}  // namespace

std::vector<StageEntry> general_linear() {
    return {
        {.name = "general_linear",
         .meaning = "the general linear camera of three rays: all their affine combinations, along "
                    "x from the plane x = 0",
         .formula = R"(
p = (0, from)               from = a + u (b − a) + v (c − a)
n = (distance, to − from)   to = a′ + u (b′ − a′) + v (c′ − a′)
a, b, c and a′, b′, c′ (to_a, to_b, to_c) are points (y, z) in the planes x = 0
and x = distance; the normals n are the directions of the rays.
The triangle of the three rays at x = s distance has twice the area
F(s) = (1 − s)² A + s (1 − s) M + s² A′
A = det(b − a, c − a),   A′ = det(b′ − a′, c′ − a′),
M = det(b − a, c′ − a′) + det(b′ − a′, c − a)
The roots of F tell what the rays have in common:
two roots       cross-slit: all meet two lines
a double root   pencil: all meet a line; pinhole: all meet a point
one, F linear   pushbroom: all meet a line and are parallel to a plane
no root         bilinear: no two rays meet
F constant      orthographic: all are parallel; otherwise twisted orthographic
)",
         .parameters =
             {point_parameter("a", {1.0, -1.0}, "where the ray of u = 0, v = 0 starts"),
              point_parameter("b", {-1.0, -1.0}, "where the ray of u = 1, v = 0 starts"),
              point_parameter("c", {1.0, 1.0}, "where the ray of u = 0, v = 1 starts"),
              point_parameter("to_a", {2.0, -2.0}, "where the ray of a meets the other plane"),
              point_parameter("to_b", {-2.0, -2.0}, "where the ray of b meets the other plane"),
              point_parameter("to_c", {2.0, 2.0}, "where the ray of c meets the other plane"),
              positive_parameter("distance", 1.0, "of the other plane")},
         .make = make_general_linear,
         .dimension = 2,
         .example = R"(
// A cross-slit camera: lines upwards meet in a slit near to the eye, those across in one far behind.
// So the sides are seen at wide angles, but floor and ceiling as through a long lens.
camera cross_slit(near = 4, far = 16) {
    let grow(slit) = 1 + 10/slit
    map  u = 0 .. 1, v = 0 .. 1
    eye  general_linear((4, -3), (-4, -3), (4, 3),
                        to_a = (4*grow(near), -3*grow(far)), to_b = (-4*grow(near), -3*grow(far)),
                        to_c = (4*grow(near), 3*grow(far)), distance = 10)
}
)"},
    };
}

}  // namespace balcony::camera
