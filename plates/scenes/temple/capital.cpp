// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The Corinthian capital: a bell with two rows of acanthus leaves, volutes under the corners of a
// hollow-sided abacus.

#include <cmath>
#include <numbers>

#include "common/meshes.hpp"
#include "common/mouldings.hpp"
#include "scenes/temple/column.hpp"
#include "scenes/temple/dimensions.hpp"

namespace balcony::plates::temple {

namespace {

using scene::M44d;
using scene::Mesh;
using std::numbers::pi;

constexpr double abacus_z = 0.86;

double bell(double z) { return 0.405 + 0.17 * std::pow(z / abacus_z, 3.0); }

Mesh turned(const Mesh& mesh, double angle) {
    return moved(mesh, M44d().setAxisAngle(V3d(0, 0, 1), angle));
}

// A leaf on the +x side, which rises along the bell and curls over at its tip.
Mesh leaf(double height, double width) {
    constexpr std::uint32_t across = 9;
    constexpr int along = 18;
    const double curl = 0.16 * height + 0.015;  // Radius of the curl.
    std::vector<V3d> points;
    for (int k = 0; k <= along; ++k) {
        const double t = static_cast<double>(k) / along;
        // The middle line: up to the curl, then three eighths of a circle outwards and down.
        constexpr double turn_at = 0.68;
        double r = bell(height * t) + 0.02 + 0.02 * t;
        double z = (height - curl) * t / turn_at;
        if (t > turn_at) {
            const double angle = (t - turn_at) / (1.0 - turn_at) * 0.8 * pi;
            r = bell(height * turn_at) + 0.034 + curl * (1.0 - std::cos(angle));
            z = height - curl + curl * std::sin(angle);
        }
        const double lobes = 0.8 + 0.2 * std::abs(std::sin(4.5 * pi * t));
        const double half = width * lobes * (0.72 + 0.6 * t - 0.95 * t * t * t);
        for (std::uint32_t i = 0; i < across; ++i) {
            const double s = 2.0 * i / (across - 1.0) - 1.0;
            // The rib stands out, and so do the fingers beside it.
            const double relief = 0.03 * (1.0 - std::abs(s)) + 0.008 * std::cos(3.0 * pi * s);
            const double angle = s * half / r;
            points.emplace_back((r + relief) * std::cos(angle), (r + relief) * std::sin(angle), z);
        }
    }
    return grid(across, points, marble_size);
}

// A band that rises from the leaves towards a corner of the abacus and coils up below it.
Mesh volute() {
    constexpr int along = 44;
    constexpr double coil_r = 0.69;
    constexpr double coil_z = 0.735;
    std::vector<V2d> middle;
    for (int k = 0; k <= along; ++k) {
        const double t = static_cast<double>(k) / along;
        if (t < 0.4) {
            const double s = t / 0.4;
            middle.emplace_back(std::lerp(0.47, coil_r, s * s), std::lerp(0.42, coil_z + 0.105, s));
        } else {
            const double s = (t - 0.4) / 0.6;
            const double angle = pi / 2 - s * 3.4 * pi;
            const double radius = std::lerp(0.105, 0.02, s);
            middle.emplace_back(coil_r + radius * std::cos(angle),
                                coil_z + radius * std::sin(angle));
        }
    }
    constexpr std::uint32_t around = 5;
    std::vector<V3d> points;
    for (std::size_t k = 0; k < middle.size(); ++k) {
        const V2d& before = middle[k > 0 ? k - 1 : 0];
        const V2d along_it = (middle[std::min(k + 1, middle.size() - 1)] - before).normalized();
        const V2d out(-along_it.y, along_it.x);
        const double width = std::lerp(0.05, 0.075, static_cast<double>(k) / along);
        for (const V2d& corner : {V2d(-1, 1), V2d(-1, -1), V2d(1, -1), V2d(1, 1), V2d(-1, 1)}) {
            const V2d at = middle[k] + out * (corner.x * 0.016);
            points.emplace_back(at.x, corner.y * width, at.y);
        }
    }
    return grid(around, points, marble_size);
}

// A slab whose sides are hollow and whose corners are cut off.
Mesh abacus() {
    constexpr int pieces = 12;
    std::vector<V2d> outline;
    for (int side = 0; side < 4; ++side) {
        for (int k = 0; k <= pieces; ++k) {
            const double s = 2.0 * k / pieces - 1.0;
            const V2d at(0.56 + 0.13 * s * s, 0.62 * s);
            const double c = std::cos(side * pi / 2);
            const double d = std::sin(side * pi / 2);
            outline.emplace_back(c * at.x - d * at.y, d * at.x + c * at.y);
        }
    }
    outline.push_back(outline.front());
    const auto columns = static_cast<std::uint32_t>(outline.size());
    Mesh mesh;
    const auto band = [&](double low_scale, double low, double high_scale, double high) {
        std::vector<V3d> points;
        for (const auto& [scale, z] : {V2d(low_scale, low), V2d(high_scale, high)}) {
            for (const V2d& at : outline) {
                points.emplace_back(at.x * scale, at.y * scale, z);
            }
        }
        append(mesh, grid(columns, points, marble_size));
    };
    band(0.5, abacus_z, 0.92, abacus_z);
    band(0.92, abacus_z, 0.92, abacus_z + 0.05);
    band(0.92, abacus_z + 0.05, 1.0, abacus_z + 0.075);
    band(1.0, abacus_z + 0.075, 1.0, 1.0);
    band(1.0, 1.0, 0.5, 1.0);
    return mesh;
}

}  // namespace

Mesh capital() {
    Profile profile(V2d(0.0, -0.03));
    profile.line({0.4, -0.03});
    profile.arc({0.4, 0.035}, 0.5, 6);
    for (int k = 0; k < 5; ++k) {
        const double z = abacus_z * (k + 1) / 5.0;
        profile.line({bell(z), z});
    }
    Mesh mesh = revolve(profile, 40, {}, marble_size);
    const Mesh low = leaf(0.36, 0.15);
    const Mesh high = leaf(0.62, 0.145);
    for (int k = 0; k < 8; ++k) {
        append(mesh, turned(low, k * pi / 4 + pi / 8));
        append(mesh, turned(high, k * pi / 4));
    }
    const Mesh coil = volute();
    Profile boss(V2d(0.075, -0.03));
    boss.arc({0.0, 0.05}, 0.25, 5);
    const Mesh flower = moved(revolve(boss, 12, {}, marble_size),
                              M44d().setAxisAngle(V3d(0, 1, 0), pi / 2) *
                                  M44d().setTranslation(V3d(0.55, 0, abacus_z + 0.06)));
    for (int side = 0; side < 4; ++side) {
        append(mesh, turned(coil, side * pi / 2 + pi / 4));
        append(mesh, turned(flower, side * pi / 2));
    }
    append(mesh, abacus());
    return mesh;
}

}  // namespace balcony::plates::temple
