// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/bsdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/shading/frame.hpp"

namespace balcony::render {

namespace {

constexpr Color3f white(1.0F, 1.0F, 1.0F);
constexpr float pi = std::numbers::pi_v<float>;

// Directions closer to the horizon than this are below it.
constexpr float min_cosine = 1e-6F;

float largest(const Color3f& color) { return std::max({color.x, color.y, color.z}); }

// KHR_materials_specular, with KHR_materials_ior.
Color3f dielectric_reflectance(const Appearance& appearance) {
    const Color3f f0 = normal_reflectance(appearance.ior) * appearance.specular_color;
    return appearance.specular *
           Color3f(std::min(f0.x, 1.0F), std::min(f0.y, 1.0F), std::min(f0.z, 1.0F));
}

// The width of GGX; 0 of a mirror.
float width(float roughness) {
    const float alpha = square(roughness);
    return alpha < min_alpha ? 0.0F : alpha;
}

}  // namespace

Bsdf::Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal,
           bool /*entering*/)
    : diffuse_((1.0F - appearance.metallic) * appearance.base_color),
      metal_(appearance.metallic * appearance.base_color),
      roughness_(width(appearance.roughness) > 0.0F ? appearance.roughness : 0.0F),
      facets_(width(appearance.roughness)),
      energies_(width(appearance.roughness)),
      normal_(normal),
      geometric_normal_(geometric_normal) {
    const float metallic = appearance.metallic;
    if (metallic > 0.0F) {
        const Color3f& color = appearance.base_color;
        specular_.add(Color3f(metallic), color, white, color);
    }
    if (metallic < 1.0F) {
        const Color3f f0 = dielectric_reflectance(appearance);
        const Color3f f90(appearance.specular);
        specular_.add(Color3f(1.0F - metallic), f0, f90, f0);
        dielectric_.add(1.0F, largest(f0), appearance.specular, largest(f0));
        const float mean = below(energies_.mean());
        per_mean_below_ = mean > 0.0F ? 1.0F / mean : 0.0F;
    }
}

float Bsdf::below(const LayerEnergy& energy) const {
    return std::max(1.0F - dielectric_.albedo(energy), 0.0F);
}

Bsdf::View Bsdf::view_from(const V3f& to_viewer) const {
    View view{};
    view.direction = to_viewer;
    view.cosine = normal_.dot(to_viewer);
    view.energy = energies_.at(view.cosine);
    view.below = below(view.energy);
    const float specular = largest(specular_.albedo(view.energy));
    const float diffuse = largest(diffuse_) * view.below;
    view.specular = specular > 0.0F ? specular / (specular + diffuse) : 0.0F;
    return view;
}

Bsdf::Value Bsdf::evaluate(const V3f& to_viewer, const V3f& to_light) const {
    return evaluate(view_from(to_viewer), to_light);
}

Bsdf::Value Bsdf::evaluate(const View& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    if (cosine < min_cosine || view.cosine < min_cosine ||
        geometric_normal_.dot(to_light) <= 0.0F) {
        return {};
    }
    const LayerEnergy energy = energies_.at(cosine);
    const float lambert = cosine / pi;
    Value value{lambert * view.below * below(energy) * per_mean_below_ * diffuse_,
                (1.0F - view.specular) * lambert};
    if (!is_mirror()) {
        const HalfVector half(normal_, view.direction, to_light);
        const float density = facets_.density(half.cosine, half.squared_sine);
        const float slant = facets_.slant(view.cosine);
        const float layer =
            density * Ggx::masking(view.cosine, slant, cosine, facets_.slant(cosine));
        value.reflected +=
            cosine * layer *
            specular_.at_facet(schlick(half.viewer), view.energy.scale * energy.scale);
        value.pdf += view.specular * 0.25F * density * Ggx::visible(view.cosine, slant);
    }
    return value;
}

std::optional<BsdfSample> Bsdf::sample(const V3f& to_viewer, const V3f& random) const {
    const View view = view_from(to_viewer);
    const bool by_facet = random.x < view.specular;
    if (by_facet && is_mirror()) {
        std::optional<BsdfSample> sample = sample_mirror(to_viewer);
        sample->weight /= view.specular;
        return sample;
    }
    const Frame frame(normal_);
    BsdfSample sample;
    if (by_facet) {
        sample.facet_normal =
            frame.to_world(facets_.sample_visible(frame.to_local(to_viewer), random.y, random.z));
        sample.to_light = mirrored(to_viewer, sample.facet_normal).normalized();
        sample.roughness = roughness_;
    } else {
        sample.facet_normal = normal_;
        sample.to_light = frame.to_world(sample_cosine(random.y, random.z)).normalized();
        sample.lobe = BsdfLobe::diffuse;
    }
    const Value value = evaluate(view, sample.to_light);
    if (!(largest(value.reflected) > 0.0F) || !(value.pdf > 0.0F)) {
        return std::nullopt;
    }
    sample.pdf = value.pdf;
    sample.weight = value.reflected / value.pdf;
    return sample;
}

std::optional<BsdfSample> Bsdf::sample_mirror(const V3f& to_viewer) const {
    if (!is_mirror()) {
        return std::nullopt;
    }
    BsdfSample sample;
    sample.facet_normal = normal_;
    if (mirrored(to_viewer, normal_).dot(geometric_normal_) <= 0.0F) {
        sample.facet_normal = geometric_normal_;
    }
    sample.to_light = mirrored(to_viewer, sample.facet_normal).normalized();
    sample.weight = specular_.at_facet(schlick(normal_.dot(to_viewer)), 1.0F);
    sample.delta = true;
    sample.roughness = 0.0F;
    return sample;
}

Color3f Bsdf::ambient_reflectance() const { return is_mirror() ? diffuse_ : diffuse_ + metal_; }

}  // namespace balcony::render
