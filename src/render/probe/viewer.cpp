// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/probe/viewer.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::render {

using Imath::V3d;
using Imath::V3f;

std::size_t Sight::objects() const {
    return rays_by_object.size() -
           static_cast<std::size_t>(std::count(rays_by_object.begin(), rays_by_object.end(), 0U));
}

double Sight::interest() const {
    double sum = 0.0;
    for (const std::size_t count : rays_by_object) {
        sum += std::sqrt(static_cast<double>(count));
    }
    return sum * std::sqrt(distance_sum);
}

Sight Viewer::look(const scene::Camera& camera) const {
    constexpr int columns = 20;
    constexpr int rows = 12;
    Sight sight = empty_sight();
    for (int row = 0; row < rows; ++row) {
        for (int column = 0; column < columns; ++column) {
            const double x = (2.0 * (column + 0.5) / columns - 1.0) * camera.half_height;
            const double y = (2.0 * (row + 0.5) / rows - 1.0) * camera.half_height;
            add(camera.position,
                (camera.forward + default_view_aspect * x * camera.right + y * camera.up)
                    .normalized(),
                sight);
        }
    }
    return sight;
}

Sight Viewer::look_round(const V3d& from) const {
    constexpr int directions = 256;
    Sight sight = empty_sight();
    for (int i = 0; i < directions; ++i) {
        const double z = 1.0 - (2.0 * i + 1.0) / directions;
        const double radius = std::sqrt(1.0 - z * z);
        const double angle = 2.0 * std::numbers::pi * i / std::numbers::phi;
        add(from, {radius * std::cos(angle), radius * std::sin(angle), z}, sight);
    }
    return sight;
}

double Viewer::distance(const V3d& from, const V3d& direction) const {
    const embree::Hit hit = scene_.nearest(scene_.ray(V3f(from), V3f(direction)));
    return hit.any() ? (V3d(scene_.place(hit)) - from).length()
                     : std::numeric_limits<double>::infinity();
}

bool Viewer::is_lit(const V3d& point) const {
    const std::vector<scene::Light>& lights = scene_.scene().lights;
    return std::any_of(lights.begin(), lights.end(), [&](const scene::Light& light) {
        const V3d way = light.position - point;
        embree::Ray ray = scene_.ray(V3f(point), V3f(way));
        ray.farthest = 1.0F;
        return light.kind != scene::LightKind::directional && !scene_.nearest(ray).any();
    });
}

Sight Viewer::empty_sight() const {
    Sight sight;
    sight.rays_by_object.resize(scene_.scene().objects.size());
    return sight;
}

void Viewer::add(const V3d& from, const V3d& direction, Sight& sight) const {
    const embree::Ray ray = scene_.ray(V3f(from), V3f(direction));
    const embree::Hit hit = scene_.nearest(ray);
    ++sight.rays;
    if (!hit.any()) {
        return;
    }
    const double distance = (V3d(scene_.place(hit)) - from).length();
    ++sight.hits;
    ++sight.rays_by_object[scene_.object(hit)];
    sight.fronts += scene_.from_behind(hit, ray.direction) ? 0 : 1;
    sight.distance_sum += distance;
    sight.nearest = std::min(sight.nearest, distance);
}

}  // namespace balcony::render
