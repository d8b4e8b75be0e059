// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "scenes/gallery/paintings.hpp"

namespace balcony::plates {

namespace {

struct Ball {
    V3d middle;  // z up, the floor is z = 0.
    double radius;
    Color tint;
    double mirror;  // Reflectance seen straight on; 0 is matt.
};

constexpr double chrome = 0.9;
constexpr double lacquer = 0.05;

const std::array<Ball, 9> balls{{
    {{-0.55, 0.6, 1.25}, 1.25, from_srgb(0xeef2f6), chrome},
    {{1.55, 0.55, 0.78}, 0.78, from_srgb(0xd6402b), lacquer},
    {{0.85, -0.85, 0.45}, 0.45, from_srgb(0xf2c14e), chrome},
    {{-1.95, -0.75, 0.5}, 0.5, from_srgb(0x1f7a8c), lacquer},
    {{-0.65, -1.35, 0.3}, 0.3, from_srgb(0xf6efe0), lacquer},
    {{2.25, -0.75, 0.34}, 0.34, from_srgb(0x2b3a8c), lacquer},
    {{0.1, -1.75, 0.17}, 0.17, from_srgb(0xd6402b), lacquer},
    {{-2.75, 1.6, 0.85}, 0.85, from_srgb(0xe58e26), lacquer},
    {{3.1, 2.1, 1.05}, 1.05, from_srgb(0xeef2f6), chrome},
}};

struct Hit {
    double distance;
    V3d point;
    V3d normal;
    const Ball* ball;  // Null for the floor.
};

std::optional<double> distance_to(const Ball& ball, const V3d& origin, const V3d& direction) {
    constexpr double nearest = 1e-6;
    const V3d to = ball.middle - origin;
    const double along = to.dot(direction);
    const double below = along * along - to.length2() + ball.radius * ball.radius;
    if (below <= 0.0) {
        return std::nullopt;
    }
    const double distance = along - std::sqrt(below);
    return distance > nearest ? std::optional(distance) : std::nullopt;
}

std::optional<Hit> first_hit(const V3d& origin, const V3d& direction) {
    std::optional<Hit> hit;
    if (direction.z < -1e-6) {
        const double distance = -origin.z / direction.z;
        if (distance > 1e-6) {
            hit = Hit{distance, origin + direction * distance, V3d(0, 0, 1), nullptr};
        }
    }
    for (const Ball& ball : balls) {
        const auto distance = distance_to(ball, origin, direction);
        if (distance && (!hit || *distance < hit->distance)) {
            const V3d point = origin + direction * *distance;
            hit = Hit{*distance, point, (point - ball.middle) / ball.radius, &ball};
        }
    }
    return hit;
}

const V3d sun = V3d(-0.62, -0.45, 0.64).normalized();

// An evening: a pale horizon, deep blue above, a few long clouds and a glow about the sun.
Color sky(const V3d& direction) {
    static const Gradient air(
        {0xfbe3b8, 0xf5b98a, 0xb98fae, 0x5f79b8, 0x2f559f, 0x1b3a80, 0x12265f, 0x0d1b4a});
    const double up = std::max(direction.z, 0.0);
    Color color = air(1.15 * std::sqrt(up) - 0.02);
    const V2d ceiling(direction.x / (up + 0.12), direction.y / (up + 0.12));
    const double cloud = fractal_noise(V2d(ceiling.x * 0.9, ceiling.y * 2.1), 5, 41);
    static const Color white = from_srgb(0xfff0dc);
    color = mix(color, white, 0.6 * smooth_step(0.02, 0.5, cloud) * smooth_step(0.015, 0.12, up));
    return color + Color(1.0, 0.8, 0.5) * (2.5 * std::pow(std::max(0.0, direction.dot(sun)), 220));
}

// The share of the sun's disc that a point sees, from a few places on the disc, others for each
// sub-sample.
double sunlight(const V3d& point, int index) {
    constexpr double disc = 0.055;
    constexpr int places_per_sample = 2;
    constexpr int places = places_per_sample * samples_per_pixel;
    const V3d side = sun.cross(V3d(0, 0, 1)).normalized();
    const V3d up = side.cross(sun);
    double seen = 0.0;
    for (int k = 0; k < places_per_sample; ++k) {
        const int place = (index * places_per_sample + k) * 5 % places;
        const double radius = disc * std::sqrt((place + 0.5) / places);
        const double angle = 2.399963 * place;
        const V3d towards =
            (sun + side * (radius * std::cos(angle)) + up * (radius * std::sin(angle)))
                .normalized();
        const bool hidden = std::any_of(balls.begin(), balls.end(), [&](const Ball& ball) {
            return distance_to(ball, point, towards).has_value();
        });
        seen += hidden ? 0.0 : 1.0 / places_per_sample;
    }
    return seen;
}

// How much of the sky the balls leave open: each hides a share by its solid angle.
double openness(const V3d& point, const V3d& normal, const Ball* own) {
    double open = 1.0;
    for (const Ball& ball : balls) {
        if (&ball != own) {
            const V3d to = ball.middle - point;
            const double distance = std::max(to.length(), ball.radius);
            const double facing = std::max(0.0, 0.15 + 0.85 * normal.dot(to) / distance);
            const double share = ball.radius / distance;
            open *= 1.0 - facing * share * share;
        }
    }
    return open;
}

Color floor_color(const V3d& point) {
    const int parity = (int(std::floor(point.x * 1.25)) + int(std::floor(point.y * 1.25))) & 1;
    const double veins = 0.94 + 0.12 * fractal_noise(V2d(point.x, point.y) * 3.0, 4, 9);
    static const Color ivory = from_srgb(0xf6ead2);
    static const Color wine = from_srgb(0x76192b);
    return (parity != 0 ? ivory : wine) * veins;
}

double fifth_power(double x) { return x * x * x * x * x; }

// Follows a ray through its mirror images; what is matt adds its light on the way.
Color radiance(V3d origin, V3d direction, int index) {
    Color sum(0.0);
    Color weight(1.0);
    constexpr int max_bounces = 6;
    for (int bounce = 0; bounce < max_bounces; ++bounce) {
        const std::optional<Hit> hit = first_hit(origin, direction);
        if (!hit) {
            return sum + weight * sky(direction);
        }
        const Ball* ball = hit->ball;
        const Color tint = ball ? ball->tint : floor_color(hit->point);
        const double straight = ball ? ball->mirror : 0.04;
        const double facing = std::clamp(-hit->normal.dot(direction), 0.0, 1.0);
        const double fresnel = straight + (1.0 - straight) * fifth_power(1.0 - facing);
        const bool metal = straight > 0.5;

        // The floor fades into the evening air, so that far squares do not flicker.
        const double haze = ball ? 0.0 : 1.0 - std::exp(-std::pow(hit->distance / 26.0, 2));
        if (!metal) {
            const V3d above = hit->point + hit->normal * 1e-4;
            const double lit = std::max(0.0, hit->normal.dot(sun));
            const double direct = lit > 0.0 ? lit * sunlight(above, index) : 0.0;
            const double open = openness(hit->point, hit->normal, ball);
            const Color light = Color(1.42, 1.20, 0.90) * direct +
                                Color(0.24, 0.26, 0.36) * (open * (0.65 + 0.35 * hit->normal.z)) +
                                Color(0.10, 0.06, 0.05) * (0.5 - 0.5 * hit->normal.z);
            const Color matt = tint * light * (1.0 - fresnel);
            sum += weight * mix(matt, sky(V3d(direction.x, direction.y, 0.0).normalized()), haze);
        }
        weight *= metal ? mix(tint, Color(1.0), (fresnel - straight) / (1.0 - straight)) * fresnel
                        : Color(fresnel * (ball ? 1.0 : 0.6) * (1.0 - haze));
        if (std::max({weight.x, weight.y, weight.z}) < 0.01) {
            return sum;
        }
        direction = direction - hit->normal * (2.0 * direction.dot(hit->normal));
        origin = hit->point + hit->normal * 1e-4;
    }
    return sum;
}

}  // namespace

Color spheres(const Sample& sample) {
    const V3d eye(0.35, -7.2, 2.15);
    const V3d forward = (V3d(0.1, 0.0, 0.92) - eye).normalized();
    const V3d right = forward.cross(V3d(0, 0, 1)).normalized();
    const V3d up = right.cross(forward);
    const double half_field = 0.33;
    const V3d direction =
        forward + right * (half_field * sample.point.x) + up * (half_field * sample.point.y);
    const Color color = radiance(eye, direction.normalized(), sample.index);
    // Highlights roll off gently instead of clipping.
    const auto develop = [](double x) {
        return x < 0.6 ? x : 1.0 - 0.4 * std::exp(-(x - 0.6) / 0.4);
    };
    return {develop(color.x), develop(color.y), develop(color.z)};
}

}  // namespace balcony::plates
