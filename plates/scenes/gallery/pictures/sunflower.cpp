// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

using std::numbers::pi;
const double golden_angle = pi * (3.0 - std::sqrt(5.0));

constexpr int seed_count = 900;
constexpr double head_radius = 0.60;
const double spacing = head_radius / std::sqrt(double(seed_count));

double square(double x) { return x * x; }

struct Seed {
    int number = -1;
    V2d offset;  // From the seed's middle, in units of the spacing.
};

std::vector<V2d> seed_places() {
    std::vector<V2d> places;
    for (int n = 0; n < seed_count; ++n) {
        const double radius = spacing * std::sqrt(n + 0.5);
        const double angle = n * golden_angle;
        places.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
    }
    return places;
}

// The nearest seed: its radius cannot differ from the point's by more than 1.5 spacings.
Seed nearest_seed(const V2d& point) {
    static const std::vector<V2d> places = seed_places();
    const double radius = point.length() / spacing;
    const double reach = 1.5;
    const int first = std::max(0, int(square(std::max(radius - reach, 0.0))) - 1);
    const int last = std::min(seed_count - 1, int(square(radius + reach)) + 1);
    Seed nearest;
    double minimum = 1e9;
    for (int n = first; n <= last; ++n) {
        const V2d offset = point - places[static_cast<std::size_t>(n)];
        if (offset.length2() < minimum) {
            minimum = offset.length2();
            nearest = {n, offset / spacing};
        }
    }
    return nearest;
}

// A seed is a little dome, lit from the upper left; families of 21 and 34 spirals tint it.
Color seed_color(const Seed& seed) {
    static const Gradient ripening(
        {0x7d9a3c, 0x4d5a1f, 0x2b1b12, 0x4a2413, 0x8f3f14, 0xe08a1e, 0xf7c948});
    static const Color gap = from_srgb(0x150a0c);
    const double ripeness = std::sqrt(double(seed.number) / seed_count);
    const double radius = 0.92;
    const double distance = seed.offset.length() / radius;
    if (distance >= 1.0) {
        return gap;
    }
    const double height = std::sqrt(1.0 - distance * distance);
    const V3d normal(seed.offset.x / radius, seed.offset.y / radius, height);
    const V3d light = V3d(-0.5, 0.6, 0.65).normalized();
    const double diffuse = std::max(0.0, normal.dot(light));
    const double gloss =
        std::pow(std::max(0.0, normal.dot((light + V3d(0, 0, 1)).normalized())), 40);
    const double tint = 0.82 + 0.18 * std::cos(2.0 * pi * (seed.number % 21) / 21.0) +
                        0.10 * std::cos(2.0 * pi * (seed.number % 34) / 34.0);
    return ripening(ripeness) * (tint * (0.25 + 0.95 * diffuse)) + Color(0.35) * gloss;
}

struct Petals {
    int count;
    double turn;           // Radians by which the ring is turned.
    double length;         // Radius of the tips.
    double width;          // Half the width at the widest, radians.
    const Gradient& tint;  // From the head to the tips.
};

// The petals or sepals of one ring that reach over a point, on top of what is there.
Color over(const Petals& ring, const V2d& point, Color below, std::uint32_t seed) {
    const double radius = point.length();
    constexpr double longest = 1.01;  // Tip of a petal over the ring's length, below.
    constexpr double widest = 2.0;    // Half a petal with its shadow over the ring's width.
    if (radius >= longest * ring.length) {
        return below;
    }
    const double angle = std::atan2(point.y, point.x) - ring.turn;
    const double step = 2.0 * pi / ring.count;
    const int middle = int(std::lround(angle / step));
    for (const int side : {-1, 1, 0}) {
        const int n = (middle + side + ring.count) % ring.count;
        const double lean = 0.10 * (lattice_noise(n, 1, seed) - 0.5);
        const double tip = ring.length * (longest - 0.14 * lattice_noise(n, 2, seed));
        const double along = (radius - 0.5) / (tip - 0.5);
        if (along <= 0.0 || along >= 1.0) {
            continue;
        }
        const double away = angle - (middle + side) * step - lean * along * 1.5;
        if (std::abs(away) > widest * ring.width) {
            continue;
        }
        const double half =
            ring.width * std::pow(1.0 - std::pow(along, 2.6), 0.75) * (0.55 + 0.9 * along);
        const double across = away / half;
        const double edge = std::abs(across);
        if (edge < 1.0) {
            const double vein = 0.93 + 0.07 * std::cos(across * 11.0);
            const double fold =
                0.80 + 0.28 * across * (std::sin(angle + ring.turn - 0.7) > 0 ? -1 : 1);
            const double rim = 1.0 - 0.55 * smooth_step(0.86, 1.0, edge);
            below = ring.tint(0.18 + 0.8 * along) * (vein * fold * rim);
        } else if (edge < 1.35) {
            below *= 0.55 + 0.45 * (edge - 1.0) / 0.35;
        }
    }
    return below;
}

}  // namespace

Color sunflower(const Sample& sample) {
    const V2d point = sample.point * 1.05;
    const double radius = point.length();
    if (radius < head_radius) {
        const Seed seed = nearest_seed(point);
        const double rim = 1.0 - 0.35 * smooth_step(head_radius - 0.05, head_radius, radius);
        return seed_color(seed) * rim;
    }
    static const Gradient green({0x1c3a1e, 0x3c6b2c, 0x6f9a3f});
    static const Gradient deep_yellow({0x6b2106, 0xc25c0a, 0xe8900f, 0xf2b02c});
    static const Gradient yellow({0x7a2c08, 0xd9730d, 0xf4a71d, 0xfbd04a, 0xfce58a});
    static const Gradient ground({0x2a6f7f, 0x174a66, 0x0e2447});
    const double weave = 0.04 * fractal_noise(point * 9.0, 4, 77);
    Color color = ground(radius / 1.45 + weave);
    color = over({21, 0.20, 1.02, 0.11, green}, point, color, 4);
    color = over({34, 0.05, 0.985, 0.095, deep_yellow}, point, color, 5);
    color = over({21, 0.12, 0.93, 0.14, yellow}, point, color, 6);
    return color * (0.45 + 0.55 * smooth_step(head_radius - 0.01, head_radius + 0.10, radius));
}

}  // namespace balcony::plates
