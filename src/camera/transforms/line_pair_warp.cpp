// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformer, PCS → PCS: warping by pairs of lines after T. Beier and S. Neely,
// "Feature-Based Image Metamorphosis" (SIGGRAPH 1992).

#include <cmath>

#include <fmt/format.h>

#include "camera/catalogue/families.hpp"
#include "camera/transforms/offset_stages.hpp"

namespace balcony::camera {

namespace {

constexpr std::size_t max_lines = 1000;

struct Vector2 {
    double u = 0.0;
    double v = 0.0;
};

Vector2 operator-(const Vector2& a, const Vector2& b) { return {a.u - b.u, a.v - b.v}; }
double length(const Vector2& a) { return std::hypot(a.u, a.v); }
/// The vector rotated by a quarter turn counter-clockwise.
Vector2 perpendicular(const Vector2& a) { return {-a.v, a.u}; }

/// The line P Q in the picture and the corresponding line P' Q'.
struct LinePair {
    Vector2 from, to, from_new, to_new;
};

/// A point X keeps its position along each line, in units of its length, and its distance from it:
///     along = (X - P) . (Q - P) / |Q - P|^2,  aside = (X - P) . perp(Q - P) / |Q - P|,
///     X' = P' + along (Q' - P') + aside perp(Q' - P') / |Q' - P'|.
/// Its offset is the mean of X' - X with the weights (|Q - P|^p / (a + distance))^b, the distance
/// being that from the segment.
struct LineField {
    std::vector<LinePair> lines;
    double a = 0.1;
    double b = 2.0;
    double p = 0.5;

    [[nodiscard]] std::vector<Expr> operator()(std::span<const Expr> x, const Emitter& emit) const {
        Expr weights = emit(0.0);
        std::vector<Expr> offset(2, emit(0.0));
        for (const LinePair& line : lines) {
            const Vector2 pq = line.to - line.from;
            const Vector2 pq_new = line.to_new - line.from_new;
            const Vector2 across = perpendicular(pq);
            const Vector2 across_new = perpendicular(pq_new);
            const double size = length(pq);
            const double size_new = length(pq_new);
            const Expr du = x[0] - line.from.u;
            const Expr dv = x[1] - line.from.v;
            const Expr along = (pq.u / (size * size)) * du + (pq.v / (size * size)) * dv;
            const Expr aside = (across.u / size) * du + (across.v / size) * dv;

            const Expr beyond = along - min(max(along, emit(0.0)), emit(1.0));
            const Expr squared = aside * aside + (size * size) * (beyond * beyond);
            // The slope of the square root is infinite at 0, hence the lower bound of its argument.
            const Expr distance = sqrt(max(squared, emit(1e-24 * size * size)));
            const Expr weight = pow(std::pow(size, p) / (a + distance), b);

            weights = weights + weight;
            const Vector2 shift = line.from_new - line.from;
            const Vector2 stretch = pq_new - pq;
            const Vector2 turn{across_new.u / size_new - across.u / size,
                               across_new.v / size_new - across.v / size};
            offset[0] = offset[0] + weight * (shift.u + stretch.u * along + turn.u * aside);
            offset[1] = offset[1] + weight * (shift.v + stretch.v * along + turn.v * aside);
        }
        return {offset[0] / weights, offset[1] / weights};
    }
};

StageResult line_pairs(const Arguments& arguments) {
    const PointList& points = arguments.points("lines");
    if (points.size() > max_lines) {
        return error(fmt::format("{} pairs of lines are too many", points.size()), {},
                     fmt::format("give at most {}", max_lines));
    }
    LineField field{{}, arguments.constant("a"), arguments.constant("b"), arguments.constant("p")};
    for (std::size_t i = 0; i < points.size(); ++i) {
        const std::span<const double> c = points[i];
        const LinePair line{{c[0], c[1]}, {c[2], c[3]}, {c[4], c[5]}, {c[6], c[7]}};
        if (length(line.to - line.from) == 0.0 || length(line.to_new - line.from_new) == 0.0) {
            return error(fmt::format("a line of pair {} has equal ends", i + 1), {},
                         "give a line two different ends");
        }
        field.lines.push_back(line);
    }
    return made<ParameterOffset<LineField>>(std::move(field), arguments.number("amount"));
}

}  // namespace

std::vector<StageEntry> line_pair_warp() {
    return {
        {.name = "line_pairs",
         .meaning = "field warping: lines in the picture move their surroundings (Beier and Neely)",
         .formula = R"(
X′ = X + amount Σ w (Y − X) / Σ w      sums over the line pairs
Y = P′ + s (Q′ − P′) + h n′,   n′ = (Q′ − P′)⊥/|Q′ − P′|
s = (X − P)·(Q − P)/|Q − P|²,   h = (X − P)·(Q − P)⊥/|Q − P|
w = (|Q − P|^p/(a + d))^b,   d = the distance of X from the segment P Q
(x, y)⊥ = (−y, x)      (T. Beier and S. Neely, SIGGRAPH 1992)
)",
         .parameters =
             {{.name = "lines",
               .type = PointsParameter{.unit = Unit::either, .coordinates = {8}},
               .meaning = "(P, Q, P', Q') as 8 numbers: the line P Q of the picture shows what was "
                          "along P' Q'"},
              {.name = "a",
               .type = NumberParameter{.default_value = 0.1,
                                       .range = {.minimum = 0.0, .excludes_minimum = true},
                                       .constant = true},
               .meaning = "a distance; smaller values move the lines more exactly"},
              {.name = "b",
               .type = NumberParameter{.default_value = 2.0,
                                       .range = {.minimum = 0.0, .maximum = 16.0},
                                       .constant = true},
               .meaning = "falloff of a line's influence with distance; 0 is none"},
              {.name = "p",
               .type = NumberParameter{.default_value = 0.5,
                                       .range = {.minimum = 0.0, .maximum = 4.0},
                                       .constant = true},
               .meaning = "additional influence of long lines; 0 is none"},
              amount_parameter()},
         .make = line_pairs,
         .example = R"(camera line_pairs {
    map    u = 1.2 .. -1.2, v = square
    warp   line_pairs([(-1, -0.6, 1, -0.6, -1, -0.6, 1, -0.6), (-1, 0.6, 1, 0.6, -1, 0.6, 1, 0.6),
                       (0, -0.3, 0, 0.3, -0.2, -0.2, 0.2, 0.2)])
    eye    point
    toward plane((1, 0, 0))
})"},
    };
}

}  // namespace balcony::camera
