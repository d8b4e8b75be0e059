// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras as plain scalar C++: what the figures of the table are measured against. Written as
// a good programmer would for clarity, with analytic derivatives, one point after another.

#include <cmath>

#include "bench_case.hpp"

namespace balcony::bench {

namespace {

struct CurvePoint {
    double x, y;
    double dx, dy;
};

// A superellipse by the angle from its centre, with its derivative.
CurvePoint superellipse(double angle, double a, double b, double exponent) {
    const double cosine = std::cos(angle);
    const double sine = std::sin(angle);
    const double cosine_power = std::pow(std::fabs(cosine), exponent - 1.0);
    const double sine_power = std::pow(std::fabs(sine), exponent - 1.0);
    const double sum = cosine_power * std::fabs(cosine) + sine_power * std::fabs(sine);
    const double r = std::pow(sum, -1.0 / exponent);
    const double sum_slope = exponent * (std::copysign(sine_power, sine) * cosine -
                                         std::copysign(cosine_power, cosine) * sine);
    const double r_slope = -r * sum_slope / (exponent * sum);
    return {a * r * cosine, b * r * sine, a * (r_slope * cosine - r * sine),
            b * (r_slope * sine + r * cosine)};
}

struct Ray {
    double origin[3];
    double direction[3];
    bool valid;
};

Ray superelliptic_ray(double u, double v, const Superelliptic& camera) {
    const CurvePoint g = superellipse(u, 1.0, camera.b / camera.a, camera.exponent);
    const CurvePoint h = superellipse(v, camera.a, camera.c, camera.exponent);
    const double along_u[3]{g.dx * h.x, g.dy * h.x, 0.0};
    const double along_v[3]{g.x * h.dx, g.y * h.dx, h.dy};
    const double normal[3]{along_u[1] * along_v[2] - along_u[2] * along_v[1],
                           along_u[2] * along_v[0] - along_u[0] * along_v[2],
                           along_u[0] * along_v[1] - along_u[1] * along_v[0]};
    const double length =
        std::sqrt(normal[0] * normal[0] + normal[1] * normal[1] + normal[2] * normal[2]);
    const double scale = 1.0 / length;
    return {{g.x * h.x, g.y * h.x, h.y},
            {normal[0] * scale, normal[1] * scale, normal[2] * scale},
            0.0 < length && std::isfinite(length)};
}

template <class Camera>
void for_points(const program::Tile& tile, std::span<double* const> results, Camera camera) {
    for (std::size_t j = 0; j < tile.height; ++j) {
        for (std::size_t i = 0; i < tile.width; ++i) {
            const Ray ray = camera(tile.x + static_cast<double>(i) * tile.step,
                                   tile.y + static_cast<double>(j) * tile.step);
            const std::size_t point = j * tile.width + i;
            for (std::size_t k = 0; k < 3; ++k) {
                results[k][point] = ray.origin[k];
                results[3 + k][point] = ray.direction[k];
            }
            results[6][point] = ray.valid ? 1.0 : 0.0;
        }
    }
}

double across(double x, double size, double limit) { return (2.0 * x / size - 1.0) * limit; }

}  // namespace

void plain_superelliptic(const program::Tile& tile, std::span<double* const> results) {
    const Superelliptic camera;
    for_points(tile, results, [&](double x, double y) {
        return superelliptic_ray(across(x, picture_width, camera.max_u),
                                 across(y, picture_height, -camera.max_v), camera);
    });
}

void plain_zoomed_superelliptic(const program::Tile& tile, std::span<double* const> results) {
    const Superelliptic camera;
    const Zoom zoom;
    for_points(tile, results, [&](double x, double y) {
        const double du = across(x, picture_width, camera.max_u) - zoom.u;
        const double dv = across(y, picture_height, -camera.max_v) - zoom.v;
        const double q = (du * du + dv * dv) / (zoom.radius * zoom.radius);
        double factor = 1.0;
        if (q < 1.0) {
            const double rest = 1.0 - q;
            factor = 1.0 - (1.0 - 1.0 / zoom.strength) * rest * rest * rest;
        }
        return superelliptic_ray(zoom.u + du * factor, zoom.v + dv * factor, camera);
    });
}

void plain_pinhole(const program::Tile& tile, std::span<double* const> results) {
    const Pinhole camera;
    for_points(tile, results, [&](double x, double y) {
        const double right = across(x, picture_width, camera.half_width);
        const double up = across(y, picture_height, -camera.half_height);
        const double scale = 1.0 / std::sqrt(1.0 + right * right + up * up);
        return Ray{{0.0, 0.0, 0.0}, {scale, -right * scale, up * scale}, true};
    });
}

}  // namespace balcony::bench
