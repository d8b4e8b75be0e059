// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/light_set.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include "images/luminance.hpp"
#include "shading/lights/choice.hpp"
#include "shading/lights/distant_lights.hpp"
#include "shading/lights/emissive_triangles.hpp"
#include "shading/lights/light_tree.hpp"
#include "shading/lights/moving_lamps.hpp"
#include "shading/lights/triangle_sampling.hpp"

namespace balcony::render {

namespace {

using Imath::Color3f;
using Imath::V2f;
using Imath::V3f;

// Of the light at the viewer: a white wall seen frontally has radiance 1.
constexpr Color3f eye_irradiance(std::numbers::pi_v<float>, std::numbers::pi_v<float>,
                                 std::numbers::pi_v<float>);

// Whether the emission depends on the point of a triangle, or on the direction.
bool varies(const scene::Material& material) {
    return material.emission_texture.valid() || material.clearcoat > 0.0F ||
           material.alpha_mode != scene::AlphaMode::opaque;
}

}  // namespace

// The lights at finite distances: point and spot lights, then runs of emissive triangles.
struct LightSet::Finite {
    Finite(const scene::Scene& scene, const TextureLibrary* textures,
           const scene::Movement& movement, const std::stop_token& stop)
        : triangles(scene, movement, stop), moving(scene, movement) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (scene.lights[i].kind != scene::LightKind::directional) {
                lamps.push_back(i);
            }
        }
        std::vector<LightBounds> bounds;
        bounds.reserve(lamps.size() + triangles.runs().size());
        for (const std::size_t lamp : lamps) {
            bounds.push_back(moving.bounds(lamp));
        }
        for (const EmissiveRun& run : triangles.runs()) {
            if (stop.stop_requested()) {
                break;
            }
            bounds.push_back(triangles.bounds(run, textures));
        }
        tree = std::make_unique<const LightTree>(bounds, stop);
    }

    EmissiveTriangles triangles;
    MovingLamps moving;
    std::vector<std::size_t> lamps;  // Indices into Scene::lights.
    std::unique_ptr<const LightTree> tree;
};

LightSet::LightSet(const scene::Scene& scene, const TextureLibrary* textures,
                   const scene::Movement& movement, const std::stop_token& stop)
    : scene_(&scene),
      finite_(std::make_shared<const Finite>(scene, textures, movement, stop)),
      distant_(std::make_shared<const DistantLights>(scene, std::nullopt, std::nullopt)) {}

LightSet LightSet::with(const std::optional<Environment>& environment,
                        const std::optional<double>& sun_angle) const {
    LightSet made = *this;
    made.distant_ = std::make_shared<const DistantLights>(*scene_, environment, sun_angle);
    return made;
}

LightSet LightSet::with(std::shared_ptr<const DistantVisibility> visibility) const {
    LightSet made = *this;
    made.visibility_ = std::move(visibility);
    return made;
}

DistantReceiver LightSet::receiver(const LitPoint& point) const {
    return {point.normal, visibility_ ? &visibility_->at(point.position) : nullptr};
}

LightSet LightSet::lit_from_eye() const {
    LightSet made = *this;
    made.lit_from_eye_ = true;
    return made;
}

std::size_t LightSet::emissive_triangles() const { return finite_->triangles.count(); }

// Half evenly, since shadows are not known, and half by the light that would arrive without them.
float LightSet::probability_of_distant(const LitPoint& point, const DistantReceiver& at) const {
    if (distant_->empty() || finite_->tree->empty()) {
        return distant_->empty() ? 0.0F : 1.0F;
    }
    const float distant = distant_->illuminance(at);
    const float all = distant + finite_->tree->illuminance(point.position, point.normal);
    return 0.25F + 0.5F * (all > 0.0F && std::isfinite(all) ? distant / all : 0.5F);
}

std::optional<LightSample> LightSet::sample(const LitPoint& point, const V3f& random) const {
    if (lit_from_eye_) {
        return LightSample{point.to_viewer, 0.0F, eye_irradiance, 1.0F, true};
    }
    const DistantReceiver at = receiver(point);
    const float distant = probability_of_distant(point, at);
    const bool chosen = random.x < distant;
    const float probability = chosen ? distant : 1.0F - distant;
    if (!(probability > 0.0F)) {
        return std::nullopt;
    }
    const float rest = chosen ? rest_below(random.x, distant) : rest_above(random.x, distant);
    const V3f numbers(rest, random.y, random.z);
    std::optional<LightSample> sample =
        chosen ? sample_distant(at, numbers) : sample_finite(point, numbers);
    if (sample) {
        sample->pdf *= probability;
    }
    return sample;
}

std::optional<LightSample> LightSet::sample_distant(const DistantReceiver& at,
                                                    const V3f& random) const {
    const auto found = distant_->sample(at, random);
    return found
               ? std::optional(LightSample{found->to_light, std::numeric_limits<float>::infinity(),
                                           found->radiance, found->pdf, found->delta})
               : std::nullopt;
}

std::optional<LightSample> LightSet::sample_finite(const LitPoint& point, const V3f& random) const {
    const auto chosen = finite_->tree->choose(point.position, point.normal, random.x);
    if (!chosen) {
        return std::nullopt;
    }
    if (chosen->light < finite_->lamps.size()) {
        const scene::Light& lamp = finite_->moving.lamp(finite_->lamps[chosen->light], point.time);
        const Illumination found = light_of(lamp, point.position, scene_->meters_per_unit);
        return luminance(found.irradiance) > 0.0F
                   ? std::optional(LightSample{found.to_light, found.distance, found.irradiance,
                                               chosen->probability, true})
                   : std::nullopt;
    }
    const EmissiveTriangles& triangles = finite_->triangles;
    const EmissiveRun& run = triangles.runs()[chosen->light - finite_->lamps.size()];
    const auto in_run = std::min(
        static_cast<std::uint32_t>(random.y * static_cast<float>(run.count)), run.count - 1);
    const float within = random.y * static_cast<float>(run.count) - static_cast<float>(in_run);
    const std::uint32_t triangle = run.first + in_run;
    const WorldTriangle shape = triangles.triangle(run.instance, triangle, point.time);
    const auto found = sample_triangle(shape, point.position, V2f(within, random.z));
    if (!found || !triangles.shines(run.instance, shape, found->direction)) {
        return std::nullopt;
    }
    const scene::Material& material = triangles.material(run.instance);
    LightSample sample{found->direction, found->distance, material.emission,
                       found->pdf * chosen->probability / static_cast<float>(run.count)};
    if (varies(material)) {
        sample.emitter = {run.instance, triangle, found->u, found->v};
        sample.radiance = Color3f(1.0F);
    }
    return sample;
}

float LightSet::pdf_of_emitter(const LitPoint& point, const V3f& to_light, float distance,
                               const embree::Hit& emitter) const {
    const EmissiveTriangles& triangles = finite_->triangles;
    const std::optional<std::size_t> run = triangles.run_with(emitter);
    if (!run) {
        return 0.0F;
    }
    const WorldTriangle shape = triangles.triangle(emitter.instance, emitter.triangle, point.time);
    if (!triangles.shines(emitter.instance, shape, to_light)) {
        return 0.0F;
    }
    const float probability =
        finite_->tree->probability(point.position, point.normal, finite_->lamps.size() + *run) /
        static_cast<float>(triangles.runs()[*run].count);
    const float density = pdf_of_triangle(shape, point.position, to_light, distance);
    return (1.0F - probability_of_distant(point, receiver(point))) * probability * density;
}

Color3f LightSet::radiance_from(const V3f& direction) const {
    return distant_->radiance(direction);
}

float LightSet::pdf_of_distant(const LitPoint& point, const V3f& direction) const {
    const DistantReceiver at = receiver(point);
    return probability_of_distant(point, at) * distant_->pdf(at, direction);
}

bool LightSet::has_distant() const { return distant_->has_radiance(); }

bool LightSet::has_environment() const { return distant_->has_environment(); }

std::size_t LightSet::size() const {
    return scene_->lights.size() + (scene_->default_light ? 1 : 0);
}

Illumination LightSet::arriving(std::size_t light, const LitPoint& point) const {
    if (scene_->default_light && light == 0) {
        return {point.to_viewer, 0.0F, eye_irradiance};
    }
    return light_of(finite_->moving.lamp(light - (scene_->default_light ? 1 : 0), point.time),
                    point.position, scene_->meters_per_unit);
}

}  // namespace balcony::render
