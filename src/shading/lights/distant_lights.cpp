// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/distant_lights.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "images/luminance.hpp"
#include "shading/geometry/frame.hpp"
#include "shading/lights/choice.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;
using Imath::V2f;
using Imath::V3f;

using std::numbers::pi_v;

// What no probe has seen may still shine through a gap.
constexpr float unseen = 0.02F;

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

float DistantLights::of_environment(const DistantReceiver& at) const {
    return environment_illuminance_ *
           (at.place != nullptr ? std::max(at.place->environment, unseen) : 1.0F);
}

float DistantLights::of_sun(std::size_t sun, const DistantReceiver& at) const {
    return suns_[sun].illuminance(at.normal) *
           (at.place != nullptr ? std::max(at.place->suns[sun], unseen) : 1.0F);
}

float DistantLights::illuminance(const DistantReceiver& at) const {
    float total = of_environment(at);
    for (std::size_t sun = 0; sun < suns_.size(); ++sun) {
        total += of_sun(sun, at);
    }
    return total;
}

DistantLights::Shares::Shares(const DistantLights& lights, const DistantReceiver& at) {
    float total = lights.of_environment(at);
    int count = total > 0.0F ? 1 : 0;
    for (std::size_t sun = 0; sun < lights.suns_.size(); ++sun) {
        const float one = lights.of_sun(sun, at);
        total += one;
        count += one > 0.0F ? 1 : 0;
    }
    const float even = at.place != nullptr ? 0.1F : 0.5F;
    even_ = even / static_cast<float>(count);
    by_illuminance_ = (1.0F - even) / total;
}

std::optional<DistantLights::Sample> DistantLights::sample(const DistantReceiver& at,
                                                           const V3f& random) const {
    const Shares share(*this, at);
    const V2f numbers(random.y, random.z);
    float rest = random.x;
    V3f direction(0.0F);
    for (std::size_t i = 0; i < suns_.size(); ++i) {
        const Sun& sun = suns_[i];
        const float probability = share(of_sun(i, at));
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
        direction = sample_environment(at, numbers);
    }
    const float density = pdf(share, at, direction);
    return density > 0.0F ? std::optional(Sample{direction, radiance(direction), density})
                          : std::nullopt;
}

float DistantLights::pdf(const DistantReceiver& at, const V3f& direction) const {
    return pdf(Shares(*this, at), at, direction);
}

float DistantLights::pdf(const Shares& share, const DistantReceiver& at,
                         const V3f& direction) const {
    float density = 0.0F;
    for (std::size_t sun = 0; sun < suns_.size(); ++sun) {
        if (!suns_[sun].is_point() && suns_[sun].covers(direction)) {
            density += share(of_sun(sun, at)) * suns_[sun].pdf();
        }
    }
    if (environment_) {
        density += share(of_environment(at)) * pdf_of_environment(at, direction);
    }
    return density;
}

// By the sectors from which light is known to arrive, or by what arrives without shadows. All
// directions of a constant environment are equal but for the cosine.
V3f DistantLights::sample_environment(const DistantReceiver& at, const V2f& random) const {
    const EnvironmentMap& map = *environment_->map;
    V2f numbers = random;
    if (at.place != nullptr) {
        const float known = at.place->known;
        if (random.x < known) {
            const ChosenCell sector = choose_cell(at.place->sectors, rest_below(random.x, known));
            const V3f in_map = map.sample(sector.cell, {sector.within, random.y}).direction;
            return (in_map * environment_from_world_.transposed()).normalized();
        }
        numbers.x = rest_above(random.x, known);
    }
    if (map.is_constant() && at.normal != V3f(0.0F)) {
        return Frame(at.normal).to_world(sample_cosine(numbers.x, numbers.y)).normalized();
    }
    return (map.sample(numbers).direction * environment_from_world_.transposed()).normalized();
}

float DistantLights::pdf_of_environment(const DistantReceiver& at, const V3f& direction) const {
    const EnvironmentMap& map = *environment_->map;
    const V3f in_map = direction * environment_from_world_;
    const float without_shadows = map.is_constant() && at.normal != V3f(0.0F)
                                      ? std::max(0.0F, at.normal.dot(direction)) / pi_v<float>
                                      : map.pdf(in_map);
    if (at.place == nullptr) {
        return without_shadows;
    }
    const std::size_t sector = EnvironmentMap::sector_of(in_map);
    const float all = map.probability(sector);
    const float arriving =
        all > 0.0F ? at.place->probability(sector) / all * map.pdf(in_map) : 0.0F;
    return at.place->known * arriving + (1.0F - at.place->known) * without_shadows;
}

DistantProbe DistantLights::probe(const V3f& position, std::span<const V2f> random,
                                  const std::function<float(const V3f& to_light)>& passed) const {
    DistantProbe made{position, 0, {}, {}};
    if (environment_) {
        made.directions = static_cast<std::uint32_t>(random.size());
        for (const V2f& numbers : random) {
            const V3f in_map = environment_->map->sample(numbers).direction;
            if (passed((in_map * environment_from_world_.transposed()).normalized()) > 0.0F) {
                made.open.push_back(static_cast<std::uint16_t>(EnvironmentMap::sector_of(in_map)));
            }
        }
    }
    for (const Sun& sun : suns_) {
        made.suns.push_back(passed(sun.to_light()));
    }
    return made;
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
