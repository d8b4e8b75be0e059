// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/bsdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace balcony::render {

namespace {

constexpr Color3f white(1.0F, 1.0F, 1.0F);
constexpr float pi = std::numbers::pi_v<float>;

float square(float x) { return x * x; }

float largest(const Color3f& color) { return std::max({color.x, color.y, color.z}); }

V3f mirrored(const V3f& v, const V3f& normal) { return v - 2.0F * v.dot(normal) * normal; }

// GGX's distribution of normals; n_h is the cosine between the facet and the surface.
float distribution(float a2, float n_h) {
    return a2 / (pi * square(square(n_h) * (a2 - 1.0F) + 1.0F));
}

// Smith's height-correlated masking is 2 n_l n_v over this.
float masking(float a2, float n_l, float n_v) {
    return n_l * std::sqrt(square(n_v) * (1.0F - a2) + a2) +
           n_v * std::sqrt(square(n_l) * (1.0F - a2) + a2);
}

// The visible fraction of the facets turned to the viewer, divided by the viewing cosine.
float visible_part(float a2, float n_v) {
    return 2.0F / (n_v + std::sqrt(a2 + (1.0F - a2) * square(n_v)));
}

// Axes x and y that make a right-handed frame with a unit z: Duff et al., "Building an Orthonormal
// Basis, Revisited" (2017).
struct Frame {
    explicit Frame(const V3f& normal) : z(normal) {
        const float sign = std::copysign(1.0F, z.z);
        const float a = -1.0F / (sign + z.z);
        const float b = z.x * z.y * a;
        x = {1.0F + sign * z.x * z.x * a, sign * b, -sign * z.x};
        y = {b, sign + z.y * z.y * a, -z.y};
    }

    [[nodiscard]] V3f to_local(const V3f& v) const { return {v.dot(x), v.dot(y), v.dot(z)}; }
    [[nodiscard]] V3f to_world(const V3f& v) const { return v.x * x + v.y * y + v.z * z; }

    V3f x, y, z;
};

// On the unit hemisphere about z, with density cosine over pi.
V3f sample_cosine(float u, float v) {
    const float radius = std::sqrt(u);
    const float angle = 2.0F * pi * v;
    return {radius * std::cos(angle), radius * std::sin(angle), std::sqrt(1.0F - u)};
}

// Samples a visible facet: Dupuy and Benyoub, "Sampling Visible GGX Normals with
// Spherical Caps" (2023).
V3f sample_facet(const V3f& to_viewer, float alpha, float u, float v) {
    const V3f stretched = V3f(alpha * to_viewer.x, alpha * to_viewer.y, to_viewer.z).normalized();
    const float angle = 2.0F * pi * u;
    const float z = (1.0F - v) * (1.0F + stretched.z) - stretched.z;
    const float radius = std::sqrt(std::clamp(1.0F - z * z, 0.0F, 1.0F));
    const V3f facet = V3f(radius * std::cos(angle), radius * std::sin(angle), z) + stretched;
    return V3f(alpha * facet.x, alpha * facet.y, facet.z).normalized();
}

}  // namespace

bool may_be_mirror(const scene::Material& material) {
    return material.roughness < mirror_roughness || material.roughness_texture.valid();
}

// Reflectance at normal incidence: 4 %, for an index of refraction of 1.5, or the metal's colour.
Bsdf::Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal, bool)
    : diffuse_((1.0F - appearance.metallic) * appearance.base_color),
      specular_((1.0F - appearance.metallic) * 0.04F * white +
                appearance.metallic * appearance.base_color),
      metal_(appearance.metallic * appearance.base_color),
      alpha_(square(appearance.roughness)),
      mirror_(is_mirror(appearance)),
      normal_(normal),
      geometric_normal_(geometric_normal) {}

Color3f Bsdf::fresnel(float cosine) const {
    const float c = std::clamp(1.0F - cosine, 0.0F, 1.0F);
    return specular_ + square(square(c)) * c * (white - specular_);
}

Color3f Bsdf::eval(const V3f& to_viewer, const V3f& to_light) const {
    const float n_l = normal_.dot(to_light);
    const float n_v = normal_.dot(to_viewer);
    if (n_l <= 0.0F || n_v <= 0.0F || geometric_normal_.dot(to_light) <= 0.0F) {
        return Color3f(0.0F);
    }
    const V3f halfway = (to_light + to_viewer).normalized();
    const Color3f reflected = fresnel(to_viewer.dot(halfway));
    Color3f total = (white - reflected) * diffuse_ / pi;
    if (!mirror_) {
        const float a2 = square(alpha_);
        total += distribution(a2, normal_.dot(halfway)) * 0.5F / masking(a2, n_l, n_v) * reflected;
    }
    return n_l * total;
}

float Bsdf::specular_probability(const V3f& to_viewer) const {
    const Color3f reflected = fresnel(normal_.dot(to_viewer));
    const float specular = largest(reflected);
    const float diffuse = largest((white - reflected) * diffuse_);
    return specular > 0.0F ? specular / (specular + diffuse) : 0.0F;
}

float Bsdf::pdf(const V3f& to_viewer, const V3f& to_light) const {
    const float specular = specular_probability(to_viewer);
    const float n_l = normal_.dot(to_light);
    float density = (1.0F - specular) * std::max(n_l, 0.0F) / pi;
    const V3f halfway = (to_light + to_viewer).normalized();
    const float n_h = normal_.dot(halfway);
    if (!mirror_ && n_h > 0.0F) {
        const float a2 = square(alpha_);
        const float n_v = normal_.dot(to_viewer);
        density += specular * visible_part(a2, n_v) * distribution(a2, n_h) / 4.0F;
    }
    return density;
}

std::optional<BsdfSample> Bsdf::sample(const V3f& to_viewer, const V3f& random) const {
    const float specular = specular_probability(to_viewer);
    const bool by_facet = random.x < specular;
    if (by_facet && mirror_) {
        std::optional<BsdfSample> sample = sample_mirror(to_viewer);
        sample->weight /= specular;
        return sample;
    }
    const Frame frame(normal_);
    BsdfSample sample;
    if (by_facet) {
        sample.facet_normal =
            frame.to_world(sample_facet(frame.to_local(to_viewer), alpha_, random.y, random.z));
        sample.to_light = mirrored(-to_viewer, sample.facet_normal).normalized();
    } else {
        sample.facet_normal = normal_;
        sample.lobe = BsdfLobe::diffuse;
        sample.to_light = frame.to_world(sample_cosine(random.y, random.z)).normalized();
    }
    sample.pdf = pdf(to_viewer, sample.to_light);
    const Color3f reflected = eval(to_viewer, sample.to_light);
    if (!(largest(reflected) > 0.0F) || !(sample.pdf > 0.0F)) {
        return std::nullopt;
    }
    sample.weight = reflected / sample.pdf;
    return sample;
}

std::optional<BsdfSample> Bsdf::sample_mirror(const V3f& to_viewer) const {
    if (!mirror_) {
        return std::nullopt;
    }
    V3f normal = normal_;
    if (mirrored(-to_viewer, normal).dot(geometric_normal_) <= 0.0F) {
        normal = geometric_normal_;
    }
    return BsdfSample{mirrored(-to_viewer, normal).normalized(), fresnel(normal_.dot(to_viewer)),
                      0.0F, true, normal};
}

Color3f Bsdf::ambient_reflectance() const { return mirror_ ? diffuse_ : diffuse_ + metal_; }

}  // namespace balcony::render
