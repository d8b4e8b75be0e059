// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/lights/distant_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/shading/frame.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;
using Imath::V3f;

constexpr float pi = std::numbers::pi_v<float>;

Imath::M33f environment_from_world(Axes axes, double rotation) {
    const auto turned_axis = [&](const Imath::V3d& axis) {
        const Imath::V3d v = turned(axis, axes, Axes::z_up);
        const double c = std::cos(rotation);
        const double s = std::sin(rotation);
        return V3f(Imath::V3d(c * v.x + s * v.y, c * v.y - s * v.x, v.z));
    };
    const V3f x = turned_axis({1.0, 0.0, 0.0});
    const V3f y = turned_axis({0.0, 1.0, 0.0});
    const V3f z = turned_axis({0.0, 0.0, 1.0});
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

}  // namespace

DistantLights::DistantLights(const scene::Scene& scene,
                             const std::optional<Environment>& environment) {
    for (const scene::Light& light : scene.lights) {
        if (light.kind == scene::LightKind::directional) {
            suns_.push_back({V3f(-light.direction), light.intensity});
        }
    }
    if (environment && !environment->state().map->is_black() &&
        environment->state().strength > 0.0F) {
        environment_ = environment->state();
        environment_from_world_ = environment_from_world(scene.axes, environment_->rotation);
    }
}

std::optional<DistantLights::Sample> DistantLights::sample(const V3f& normal,
                                                           const V3f& random) const {
    const std::size_t count = suns_.size() + (environment_ ? 1 : 0);
    const auto chosen = static_cast<std::size_t>(random.x * static_cast<float>(count));
    const float probability = 1.0F / static_cast<float>(count);
    if (chosen < suns_.size()) {
        return Sample{suns_[chosen].to_light, suns_[chosen].irradiance, probability, true};
    }
    V3f direction;
    if (environment_->map->is_constant() && normal != V3f(0.0F)) {
        direction = Frame(normal).to_world(sample_cosine(random.y, random.z));
    } else {
        const EnvironmentMap::Sample found = environment_->map->sample({random.y, random.z});
        direction = found.direction * environment_from_world_.transposed();
    }
    direction.normalize();
    const float density = pdf(normal, direction);
    return density > 0.0F ? std::optional(Sample{direction, radiance(direction), density})
                          : std::nullopt;
}

float DistantLights::pdf(const V3f& normal, const V3f& direction) const {
    if (!environment_) {
        return 0.0F;
    }
    const float density = environment_->map->is_constant() && normal != V3f(0.0F)
                              ? std::max(0.0F, normal.dot(direction)) / pi
                              : environment_->map->pdf(direction * environment_from_world_);
    return density / static_cast<float>(suns_.size() + 1);
}

Color3f DistantLights::radiance(const V3f& direction) const {
    return environment_ ? environment_->strength *
                              environment_->map->radiance(direction * environment_from_world_)
                        : Color3f(0.0F);
}

}  // namespace balcony::render
