// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A tracer of prescriptions from the textbook, which knows nothing of the one in the library.
// Points are (distance behind the first surface, y, z), and light runs towards the sensor.

#include <cmath>
#include <optional>
#include <string>

#include <gtest/gtest.h>

#include "balcony/data.hpp"
#include "balcony/prescription.hpp"
#include "support.hpp"

namespace balcony::rays::test {

/// A prescription among the built-in files.
inline camera::Prescription read_lens(const std::string& name) {
    const auto file = data::find_file(name, std::nullopt);
    EXPECT_TRUE(file) << to_text(file.diagnostics);
    const auto lens = data::read_prescription(*file);
    EXPECT_TRUE(lens) << to_text(lens.diagnostics);
    return **lens;
}

struct Line {
    V3d point, direction;
};

/// Where a line crosses a sphere next to its vertex, by its centre; a plane has radius 0.
inline std::optional<V3d> crossing(const Line& line, double vertex, double radius) {
    if (radius == 0.0) {
        return line.point + (vertex - line.point.x) / line.direction.x * line.direction;
    }
    const V3d from_center = line.point - V3d(vertex + radius, 0.0, 0.0);
    const double b = from_center.dot(line.direction);
    const double square = b * b - from_center.dot(from_center) + radius * radius;
    if (square < 0.0) {
        return std::nullopt;
    }
    std::optional<V3d> nearest;
    for (const double root : {-std::sqrt(square), std::sqrt(square)}) {
        const V3d at = line.point + (root - b) * line.direction;
        if (!nearest || std::abs(at.x - vertex) < std::abs(nearest->x - vertex)) {
            nearest = at;
        }
    }
    return nearest;
}

/// How far a toroidal surface is behind its vertex: at the distance 1/curvature_x less the sag of
/// the upright circle from the line that it is turned about.
inline double toroid_sag(const camera::LensSurface& s, double y, double z) {
    const double up = s.curvature * z * z / (1.0 + std::sqrt(1.0 - std::pow(s.curvature * z, 2)));
    if (*s.curvature_x == 0.0) {
        return up;
    }
    const double to_line = 1.0 / *s.curvature_x;
    return to_line - std::copysign(std::sqrt(std::pow(to_line - up, 2) - y * y), to_line);
}

/// From where it crosses the plane of the vertex, along the line to the sag of where it is.
inline V3d toroid_crossing(const camera::LensSurface& s, const Line& line, double vertex) {
    V3d at = *crossing(line, vertex, 0.0);
    double off = 1.0;
    for (int i = 0; i < 200 && std::abs(off) > 1e-14; ++i) {
        off = vertex + toroid_sag(s, at.y, at.z) - at.x;
        at += off / line.direction.x * line.direction;
    }
    return at;
}

/// From a point to the centre of the upright circle there, or to its upright line's axis.
inline V3d toroid_normal(const camera::LensSurface& s, const V3d& at, double vertex) {
    if (*s.curvature_x == 0.0) {
        return (V3d(vertex + 1.0 / s.curvature, at.y, 0.0) - at).normalized();
    }
    const V3d line(vertex + 1.0 / *s.curvature_x, 0.0, 0.0);
    if (s.curvature == 0.0) {
        return (V3d(line.x, 0.0, at.z) - at).normalized();
    }
    const V3d from_line =
        std::copysign(1.0, -*s.curvature_x) * V3d(at.x - line.x, at.y, 0.0).normalized();
    return (line + (1.0 / s.curvature - 1.0 / *s.curvature_x) * from_line - at).normalized();
}

/// Snell's law by angles, in the plane of the ray and the normal.
inline std::optional<V3d> bent(const V3d& d, V3d normal, double n, double n_after) {
    if (normal.dot(d) < 0.0) {
        normal = -normal;
    }
    const V3d across = d - d.dot(normal) * normal;
    const double sine = across.length();
    const double sine_after = sine * n / n_after;
    if (sine_after >= 1.0) {
        return std::nullopt;
    }
    const V3d side = sine > 0.0 ? across / sine : V3d(0.0);
    return std::cos(std::asin(sine_after)) * normal + sine_after * side;
}

/// Light of the scene through all surfaces; none if it does not get through.
inline std::optional<Line> through(const camera::Prescription& lens, Line line, double wavelength,
                                   double stop_scale = 1.0) {
    double vertex = 0.0;
    double n = 1.0;
    for (const camera::LensSurface& s : lens.surfaces) {
        const double radius = s.curvature == 0.0 ? 0.0 : 1.0 / s.curvature;
        const auto at =
            s.curvature_x ? toroid_crossing(s, line, vertex) : crossing(line, vertex, radius);
        if (!at || !(std::hypot(at->y, at->z) <= s.radius * (s.stop ? stop_scale : 1.0))) {
            return std::nullopt;
        }
        const V3d normal = s.curvature_x   ? toroid_normal(s, *at, vertex)
                           : radius == 0.0 ? V3d(1.0, 0.0, 0.0)
                                           : (*at - V3d(vertex + radius, 0.0, 0.0)) / radius;
        const double n_after = s.behind.index(wavelength);
        const auto direction = bent(line.direction, normal, n, n_after);
        if (!direction) {
            return std::nullopt;
        }
        line = {*at, *direction};
        n = n_after;
        vertex += s.gap;
    }
    return line;
}

inline double length_of(const camera::Prescription& lens) {
    double sum = 0.0;
    for (std::size_t i = 0; i + 1 < lens.surfaces.size(); ++i) {
        sum += lens.surfaces[i].gap;
    }
    return sum;
}

}  // namespace balcony::rays::test
