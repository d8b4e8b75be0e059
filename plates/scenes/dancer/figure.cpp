// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/dancer/figure.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "common/implicit_surface.hpp"
#include "common/painting.hpp"

namespace balcony::plates {

namespace {

using scene::Mesh;

// An ellipse of the body at a height: its middle, its half axes across and along the line of sight.
struct Section {
    double z, x, y, across, along;
};

constexpr std::array sections{
    Section{-0.05, 0.000, 0.075, 0.400, 0.420}, Section{0.00, 0.000, 0.065, 0.350, 0.370},
    Section{0.06, 0.000, 0.050, 0.285, 0.300},  Section{0.16, -0.004, 0.032, 0.224, 0.234},
    Section{0.32, -0.012, 0.012, 0.178, 0.180}, Section{0.52, -0.020, -0.006, 0.162, 0.156},
    Section{0.74, -0.024, 0.000, 0.182, 0.158}, Section{0.88, -0.020, 0.008, 0.186, 0.156},
    Section{1.00, -0.008, 0.004, 0.150, 0.118}, Section{1.10, 0.002, -0.004, 0.118, 0.092},
    Section{1.20, 0.008, -0.006, 0.134, 0.104}, Section{1.30, 0.010, -0.002, 0.146, 0.106},
    Section{1.38, 0.008, 0.004, 0.142, 0.084},  Section{1.44, 0.006, 0.006, 0.096, 0.064},
    Section{1.49, 0.006, 0.004, 0.050, 0.050},  Section{1.56, 0.010, -0.004, 0.043, 0.045},
    Section{1.62, 0.012, -0.008, 0.043, 0.046},
};

double catmull_rom(double a, double b, double c, double d, double t) {
    return b + 0.5 * t * (c - a + t * (2 * a - 5 * b + 4 * c - d + t * (3 * (b - c) + d - a)));
}

Section section_at(double z) {
    const auto last = sections.size() - 1;
    std::size_t i = 0;
    while (i + 2 < sections.size() && sections[i + 1].z < z) {
        ++i;
    }
    const Section& b = sections[i];
    const Section& c = sections[i + 1];
    const Section& a = sections[i > 0 ? i - 1 : 0];
    const Section& d = sections[std::min(i + 2, last)];
    const double t = std::clamp((z - b.z) / (c.z - b.z), 0.0, 1.0);
    return {z, catmull_rom(a.x, b.x, c.x, d.x, t), catmull_rom(a.y, b.y, c.y, d.y, t),
            catmull_rom(a.across, b.across, c.across, d.across, t),
            catmull_rom(a.along, b.along, c.along, d.along, t)};
}

// Pleats that begin at the hips and deepen towards the hem, and finer ones above the waist.
double pleats(double angle, double z) {
    constexpr int folds = 22;
    const double skirt = smooth_step(0.98, 0.25, z);
    const double wave = std::sin(folds * angle + 0.5 * std::sin(3.0 * angle));
    return (0.004 + 0.026 * skirt * skirt) * wave * smooth_step(1.09, 0.98, z) +
           0.003 * std::sin(36.0 * angle) * smooth_step(1.10, 1.16, z) * smooth_step(1.36, 1.28, z);
}

// The dress goes on a little below z = 0, inside the ground that the dancer stands on.
constexpr double lowest = -0.02;

double body(const V3d& p) {
    const Section s = section_at(p.z);
    const double x = (p.x - s.x) / s.across;
    const double y = (p.y - s.y) / s.along;
    const double r = std::sqrt(x * x + y * y);
    const double size = std::min(s.across, s.along);
    const double round = (r - 1.0 - pleats(std::atan2(y, x), p.z) * std::min(r, 1.5)) * size;
    return std::max({round, lowest - p.z, p.z - sections.back().z});
}

double ellipsoid(const V3d& p, const V3d& center, const V3d& radii) {
    const V3d q = (p - center) / radii;
    return (q.length() - 1.0) * std::min({radii.x, radii.y, radii.z});
}

// A rod between two balls of different sizes.
double limb(const V3d& p, const V3d& from, const V3d& to, double from_radius, double to_radius) {
    const V3d along = to - from;
    const double t = std::clamp((p - from).dot(along) / along.length2(), 0.0, 1.0);
    return (p - from - t * along).length() - (from_radius + t * (to_radius - from_radius));
}

// A point of an arm, from the shoulder (0) to the fingertips (1): a Bezier curve that rounds the
// space above the head. `side` is -1 or 1.
V3d arm_at(double side, double t) {
    const std::array<V3d, 4> control{V3d(0.118, 0.006, 1.385), V3d(0.385, -0.010, 1.520),
                                     V3d(0.345, -0.070, 1.960), V3d(0.035, -0.075, 2.020)};
    const double u = 1.0 - t;
    const V3d p = u * u * u * control[0] + 3 * u * u * t * control[1] + 3 * u * t * t * control[2] +
                  t * t * t * control[3];
    return {0.008 + side * p.x, p.y, p.z + 0.02 * side * t};
}

double arm(const V3d& p, double side) {
    constexpr int parts = 14;
    const auto radius = [](double t) {
        const double slim = 0.042 - 0.024 * smooth_step(0.1, 0.8, t);
        return slim + 0.004 * std::sin(std::numbers::pi * std::min(2.0 * t, 1.0)) -
               0.011 * smooth_step(0.88, 1.0, t);
    };
    double d = 1.0;
    for (int i = 0; i < parts; ++i) {
        const double from = static_cast<double>(i) / parts;
        const double to = static_cast<double>(i + 1) / parts;
        d = std::min(d, limb(p, arm_at(side, from), arm_at(side, to), radius(from), radius(to)));
    }
    return d;
}

double head(const V3d& p) {
    const V3d middle(0.018, -0.016, 1.685);
    // The face is narrower towards the chin.
    const double skull = ellipsoid(p, middle + V3d(0, 0.006, 0.012), V3d(0.080, 0.096, 0.102));
    const double chin = ellipsoid(p, middle + V3d(0.0, -0.030, -0.048), V3d(0.049, 0.056, 0.072));
    // A knot of hair.
    const double knot = ellipsoid(p, middle + V3d(0.0, 0.096, 0.050), V3d(0.050, 0.046, 0.048));
    return smooth_min(smooth_min(skull, chin, 0.05), knot, 0.015);
}

double figure(const V3d& p) {
    if (p.z > 2.3) {
        return p.z - 2.2;
    }
    double d = body(p);
    for (const double side : {-1.0, 1.0}) {
        d = smooth_min(
            d, ellipsoid(p, V3d(0.010 + 0.060 * side, -0.082, 1.285), V3d(0.056, 0.050, 0.056)),
            0.06);
    }
    // The knee of the leg in front.
    d = smooth_min(d, limb(p, V3d(0.075, -0.075, 0.80), V3d(0.065, -0.135, 0.50), 0.080, 0.062),
                   0.09);
    d = smooth_min(d, head(p), 0.03);
    if (p.z > 1.25) {
        d = smooth_min(smooth_min(d, arm(p, -1.0), 0.06), arm(p, 1.0), 0.06);
    }
    return d;
}

}  // namespace

Mesh dancer_figure(double cell) {
    const Imath::Box3d box(V3d(-0.5, -0.5, -0.05), V3d(0.5, 0.62, 2.12));
    return implicit_surface(figure, box, cell, 1.8);
}

namespace {

// The veils: sheets that hang from the arms, in folds. A place on one is (s, t): s from the body
// (0) to its edge (1), t from the hem (0) to the hand (1).
struct Reach {
    double z, inner, outer;
};
constexpr std::array reaches{
    Reach{0.07, 0.05, 0.19}, Reach{0.30, 0.05, 0.41},   Reach{0.60, 0.05, 0.50},
    Reach{0.90, 0.05, 0.55}, Reach{1.20, 0.05, 0.565},  Reach{1.45, 0.16, 0.54},
    Reach{1.65, 0.27, 0.47}, Reach{1.85, 0.245, 0.345}, Reach{2.00, 0.09, 0.12},
};

V3d veil_at(double side, double s, double t) {
    const double place = t * static_cast<double>(reaches.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(place), reaches.size() - 2);
    const auto at = [&](std::size_t k) -> const Reach& {
        return reaches[std::min(k, reaches.size() - 1)];
    };
    const double f = place - static_cast<double>(i);
    const Reach& a = at(i > 0 ? i - 1 : 0);
    const Reach& b = at(i);
    const Reach& c = at(i + 1);
    const Reach& d = at(i + 2);
    const double inner = catmull_rom(a.inner, b.inner, c.inner, d.inner, f);
    const double outer = catmull_rom(a.outer, b.outer, c.outer, d.outer, f);
    const double z = catmull_rom(a.z, b.z, c.z, d.z, f);
    const double x = inner + (outer - inner) * s;
    const double fold = 0.030 * std::sin(15.0 * s * (1.0 + 0.15 * side) - 2.2 * t + side) *
                        smooth_step(0.0, 0.4, s) * smooth_step(1.0, 0.7, t);
    const double back = 0.03 + 0.10 * s * s * smooth_step(1.0, 0.5, t) - 0.10 * t * t * t;
    return {0.008 + side * x, back + fold, z + 0.02 * side * t};
}

void add_normals(Mesh& mesh) {
    mesh.normals.assign(mesh.positions.size(), scene::V3f(0.0F));
    for (const auto& [a, b, c] : mesh.triangles) {
        const auto& p = mesh.positions;
        const scene::V3f across = (p[b] - p[a]).cross(p[c] - p[a]);
        for (const std::uint32_t corner : {a, b, c}) {
            mesh.normals[corner] += across;
        }
    }
    for (scene::V3f& normal : mesh.normals) {
        normal.normalize();
    }
}

}  // namespace

Mesh dancer_veil(double side) {
    constexpr std::uint32_t columns = 72;
    constexpr std::uint32_t rows = 120;
    Mesh mesh;
    for (std::uint32_t j = 0; j <= rows; ++j) {
        for (std::uint32_t i = 0; i <= columns; ++i) {
            mesh.positions.emplace_back(
                veil_at(side, static_cast<double>(i) / columns, static_cast<double>(j) / rows));
        }
    }
    for (std::uint32_t j = 0; j < rows; ++j) {
        for (std::uint32_t i = 0; i < columns; ++i) {
            const std::uint32_t a = j * (columns + 1) + i;
            const std::uint32_t b = a + columns + 1;
            mesh.triangles.push_back({a, a + 1, b + 1});
            mesh.triangles.push_back({a, b + 1, b});
        }
    }
    add_normals(mesh);
    return mesh;
}

std::vector<V3d> dancer_veil_edge(double side) {
    constexpr int steps = 160;
    std::vector<V3d> path;
    for (int i = 0; i <= steps / 4; ++i) {
        path.push_back(veil_at(side, 4.0 * i / steps, 0.0));
    }
    for (int i = 1; i <= steps; ++i) {
        path.push_back(veil_at(side, 1.0, static_cast<double>(i) / steps));
    }
    return path;
}

}  // namespace balcony::plates
