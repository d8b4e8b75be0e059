// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The same cameras as graphs.

#include <array>

#include "bench_case.hpp"

namespace balcony::bench {

namespace {

using expr::Expr;
using expr::Graph;
using Vector = std::array<Expr, 3>;

struct Parameters {
    Expr u, v;
};

std::array<Expr, 2> superellipse(Expr angle, double a, double b, double exponent) {
    const Expr r =
        pow(pow(abs(cos(angle)), exponent) + pow(abs(sin(angle)), exponent), -1.0 / exponent);
    return {a * r * cos(angle), b * r * sin(angle)};
}

Expr across(Expr x, double size, double limit) { return (2.0 * x / size - 1.0) * limit; }

Vector cross(const Vector& a, const Vector& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

std::vector<Expr> ray(const Vector& origin, const Vector& direction) {
    const Expr length = sqrt(direction[0] * direction[0] + direction[1] * direction[1] +
                             direction[2] * direction[2]);
    const Expr scale = 1.0 / length;
    return {origin[0],
            origin[1],
            origin[2],
            direction[0] * scale,
            direction[1] * scale,
            direction[2] * scale,
            0.0 < length && is_finite(length)};
}

Parameters superelliptic_map(Graph& graph, const Superelliptic& camera) {
    return {across(graph.picture_x(), picture_width, camera.longest_u),
            across(graph.picture_y(), picture_height, -camera.longest_v)};
}

// Rays along the normals of the superellipsoid, which are derived from its two curves.
program::Program superelliptic(Graph& graph, const Superelliptic& camera, Parameters at) {
    const Expr u = graph.fresh_variable();
    const Expr v = graph.fresh_variable();
    const auto g = superellipse(u, 1.0, camera.b / camera.a, camera.exponent);
    const auto h = superellipse(v, camera.a, camera.c, camera.exponent);
    const Vector point{g[0] * h[0], g[1] * h[0], h[1]};
    const std::vector<Expr> along_u = derive(point, u);
    const std::vector<Expr> along_v = derive(point, v);
    const Vector normal =
        cross({along_u[0], along_u[1], along_u[2]}, {along_v[0], along_v[1], along_v[2]});
    const std::array<expr::Substitution, 2> parameters{{{u, at.u}, {v, at.v}}};
    return program::Program(substitute(graph, ray(point, normal), parameters));
}

Parameters zoomed(Parameters at, const Zoom& zoom) {
    const Expr du = at.u - zoom.u;
    const Expr dv = at.v - zoom.v;
    const Expr q = (du * du + dv * dv) / (zoom.radius * zoom.radius);
    const Expr inside = 1.0 - (1.0 - 1.0 / zoom.strength) * pow(1.0 - q, 3.0);
    const Expr factor = select(q < 1.0, inside, at.u.graph().constant(1.0));
    return {zoom.u + du * factor, zoom.v + dv * factor};
}

program::Program pinhole(Graph& graph, const Pinhole& camera) {
    const Expr zero = graph.constant(0.0);
    const Expr right = across(graph.picture_x(), picture_width, camera.half_width);
    const Expr up = across(graph.picture_y(), picture_height, -camera.half_height);
    return program::Program(ray({zero, zero, zero}, {graph.constant(1.0), -right, up}));
}

}  // namespace

std::vector<Case> cases() {
    std::vector<Case> rows;
    Graph graph;
    const Superelliptic camera;
    const Parameters map = superelliptic_map(graph, camera);
    rows.push_back(
        {"superelliptic (plate 2)", superelliptic(graph, camera, map), plain_superelliptic});
    rows.push_back({"superelliptic, local zoom", superelliptic(graph, camera, zoomed(map, Zoom{})),
                    plain_zoomed_superelliptic});
    rows.push_back({"pinhole", pinhole(graph, Pinhole{}), plain_pinhole});
    return rows;
}

}  // namespace balcony::bench
