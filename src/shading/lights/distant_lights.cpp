// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/distant_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "images/luminance.hpp"
#include "shading/geometry/frame.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;
using Imath::V2f;
using Imath::V3f;

using std::numbers::pi_v;

// A rotation about the vertical axis that moves the centre of the picture to x.
Imath::M33f environment_from_world(Axes axes, double rotation) {
    const auto seen_from_environment = [&](const Imath::V3d& axis) {
        const Imath::V3d v = turned(axis, axes, Axes::z_up);
        const double c = std::cos(rotation);
        const double s = std::sin(rotation);
        return V3f(Imath::V3d(c * v.x + s * v.y, c * v.y - s * v.x, v.z));
    };
    const V3f x = seen_from_environment({1.0, 0.0, 0.0});
    const V3f y = seen_from_environment({0.0, 1.0, 0.0});
    const V3f z = seen_from_environment({0.0, 0.0, 1.0});
    return {x.x, x.y, x.z, y.x, y.y, y.z, z.x, z.y, z.z};
}

}  // namespace

DistantLights::DistantLights(const scene::Scene& scene,
                             const std::optional<Environment>& environment,
                             const std::optional<double>& sun_angle) {
    for (const scene::Light& light : scene.lights) {
        if (light.kind == scene::LightKind::directional) {
            suns_.emplace_back(V3f(-light.direction), light.intensity,
                               sun_angle.value_or(double{light.angle}));
        }
    }
    if (environment && !environment->state().map->is_black() &&
        environment->state().strength > 0.0F) {
        environment_ = environment->state();
        environment_from_world_ = environment_from_world(scene.axes, environment_->rotation);
        environment_illuminance_ =
            pi_v<float> * environment_->strength * luminance(environment_->map->mean());
        for (const Sun& sun : environment_->suns) {
            suns_.push_back(
                sun.seen_from(environment_from_world_.transposed(), environment_->strength));
        }
    }
    std::erase_if(suns_, [](const Sun& sun) { return !(sun.illuminance(V3f(0.0F)) > 0.0F); });
    has_radiance_ = environment_ || std::any_of(suns_.begin(), suns_.end(),
                                                [](const Sun& sun) { return !sun.is_point(); });
}

float DistantLights::illuminance(const V3f& normal) const {
    float total = environment_illuminance_;
    for (const Sun& sun : suns_) {
        total += sun.illuminance(normal);
    }
    return total;
}

DistantLights::Shares::Shares(const DistantLights& lights, const V3f& normal) {
    float total = lights.environment_illuminance_;
    int count = total > 0.0F ? 1 : 0;
    for (const Sun& sun : lights.suns_) {
        const float one = sun.illuminance(normal);
        total += one;
        count += one > 0.0F ? 1 : 0;
    }
    even_ = 0.5F / static_cast<float>(count);
    by_illuminance_ = 0.5F / total;
}

std::optional<DistantLights::Sample> DistantLights::sample(const V3f& normal,
                                                           const V3f& random) const {
    const Shares share(*this, normal);
    const V2f numbers(random.y, random.z);
    float rest = random.x;
    V3f direction(0.0F);
    for (const Sun& sun : suns_) {
        const float probability = share(sun.illuminance(normal));
        if (rest < probability) {
            if (sun.is_point()) {
                return Sample{sun.to_light(), sun.irradiance(), probability, true};
            }
            direction = sun.sample(numbers);
            break;
        }
        rest -= probability;
    }
    if (direction == V3f(0.0F)) {
        if (!environment_) {
            return std::nullopt;
        }
        direction = sample_environment(normal, numbers);
    }
    const float density = pdf(share, normal, direction);
    return density > 0.0F ? std::optional(Sample{direction, radiance(direction), density})
                          : std::nullopt;
}

float DistantLights::pdf(const V3f& normal, const V3f& direction) const {
    return pdf(Shares(*this, normal), normal, direction);
}

float DistantLights::pdf(const Shares& share, const V3f& normal, const V3f& direction) const {
    float density = 0.0F;
    for (const Sun& sun : suns_) {
        if (!sun.is_point() && sun.covers(direction)) {
            density += share(sun.illuminance(normal)) * sun.pdf();
        }
    }
    if (environment_) {
        density += share(environment_illuminance_) * pdf_of_environment(normal, direction);
    }
    return density;
}

// All directions of a constant environment are equal but for the cosine.
V3f DistantLights::sample_environment(const V3f& normal, const V2f& random) const {
    if (environment_->map->is_constant() && normal != V3f(0.0F)) {
        return Frame(normal).to_world(sample_cosine(random.x, random.y)).normalized();
    }
    return (environment_->map->sample(random).direction * environment_from_world_.transposed())
        .normalized();
}

float DistantLights::pdf_of_environment(const V3f& normal, const V3f& direction) const {
    if (environment_->map->is_constant() && normal != V3f(0.0F)) {
        return std::max(0.0F, normal.dot(direction)) / pi_v<float>;
    }
    return environment_->map->pdf(direction * environment_from_world_);
}

Color3f DistantLights::radiance(const V3f& direction) const {
    Color3f total(0.0F);
    if (environment_) {
        total = environment_->strength *
                environment_->map->radiance(direction * environment_from_world_);
    }
    for (const Sun& sun : suns_) {
        if (!sun.is_point() && sun.covers(direction)) {
            total += sun.radiance();
        }
    }
    return total;
}

}  // namespace balcony::render
