// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The microfacets of a rough surface, and Fresnel's laws on one of them.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Imath/ImathVec.h>

#include "shading/geometry/circle.hpp"

namespace balcony::render {

using Imath::V3f;

[[nodiscard]] inline float square(float x) { return x * x; }

/// Direction `v` turned by half a turn about a unit normal.
[[nodiscard]] inline V3f mirrored(const V3f& v, const V3f& normal) {
    return 2.0F * v.dot(normal) * normal - v;
}

/// Directions closer to the horizon than this are below it.
inline constexpr float min_cosine = 1e-6F;

/// Schlick's (1 - cosine)^5: Fresnel's reflectance rises from f0 to f90 by this part.
[[nodiscard]] inline float schlick(float cosine) {
    const float c = std::clamp(1.0F - cosine, 0.0F, 1.0F);
    return square(square(c)) * c;
}

/// Reflectance at normal incidence between two media with this relative index of refraction.
[[nodiscard]] inline float normal_reflectance(float ior) {
    return square((ior - 1.0F) / (ior + 1.0F));
}

/// Fresnel's reflectance of unpolarised light at the boundary to a medium whose index of refraction
/// is `eta` times that of the light's side; 1 where the light is totally reflected.
[[nodiscard]] inline float fresnel(float cosine, float eta) {
    const float squared_sine = (1.0F - square(cosine)) / square(eta);
    if (squared_sine >= 1.0F) {
        return 1.0F;
    }
    const float refracted = std::sqrt(1.0F - squared_sine);
    const float across = (cosine - eta * refracted) / (cosine + eta * refracted);
    const float along = (eta * cosine - refracted) / (eta * cosine + refracted);
    return 0.5F * (square(across) + square(along));
}

/// What refraction adds along the facet: refracted() is this times the facet's normal minus the
/// direction over eta.
[[nodiscard]] inline float refraction_shift(float cosine, float eta) {
    const float squared_sine = (1.0F - square(cosine)) / square(eta);
    return cosine / eta - std::sqrt(std::max(1.0F - squared_sine, 0.0F));
}

/// A direction with this cosine to a facet, refracted by Snell's law to the other side, if it is
/// not totally reflected. Both directions point away from the surface.
[[nodiscard]] inline V3f refracted(const V3f& direction, const V3f& facet, float cosine,
                                   float eta) {
    return refraction_shift(cosine, eta) * facet - direction / eta;
}

/// The GGX distribution of facets (Walter et al., "Microfacet Models for Refraction through Rough
/// Surfaces", 2007) with Smith's masking, correlated by height (Heitz 2014). Cosines are those of
/// directions with the normal of the surface, in (0, 1].
class Ggx {
public:
    explicit Ggx(float alpha) : alpha_(alpha), a2_(square(alpha)) {}

    [[nodiscard]] float alpha() const { return alpha_; }

    /// The density of facets by solid angle. The squared sine is an argument of its own because a
    /// float's cosine near 1 tells little about it.
    [[nodiscard]] float density(float cosine, float squared_sine) const {
        return a2_ / (std::numbers::pi_v<float> * square(a2_ * square(cosine) + squared_sine));
    }

    /// sqrt(a² + (1 - a²) cosine²): Smith's Λ is (slant / cosine - 1) / 2.
    [[nodiscard]] float slant(float cosine) const {
        return std::sqrt(a2_ + (1.0F - a2_) * square(cosine));
    }

    /// The visible fraction of the facets, from both directions, over four times both cosines.
    [[nodiscard]] static float masking(float viewer, float viewer_slant, float light,
                                       float light_slant) {
        return 0.5F / (light * viewer_slant + viewer * light_slant);
    }

    /// The density of the facets that the viewer sees is this times density(), times the cosine
    /// between viewer and facet.
    [[nodiscard]] static float visible(float viewer, float viewer_slant) {
        return 2.0F / (viewer + viewer_slant);
    }

    /// A facet that a viewer sees, for two numbers in [0, 1), in the frame of the surface: Dupuy
    /// and Benyoub, "Sampling Visible GGX Normals with Spherical Caps" (2023).
    [[nodiscard]] V3f sample_visible(const V3f& to_viewer, float u, float v) const {
        const V3f stretched =
            V3f(alpha_ * to_viewer.x, alpha_ * to_viewer.y, to_viewer.z).normalized();
        const Imath::V2f around = on_circle(u);
        const float z = (1.0F - v) * (1.0F + stretched.z) - stretched.z;
        const float radius = std::sqrt(std::clamp(1.0F - z * z, 0.0F, 1.0F));
        const V3f facet = V3f(radius * around.x, radius * around.y, z) + stretched;
        return V3f(alpha_ * facet.x, alpha_ * facet.y, std::max(facet.z, 0.0F)).normalized();
    }

private:
    float alpha_;
    float a2_;
};

/// The reflection of two directions above a surface by its facets.
struct HalfVector {
    HalfVector(const V3f& normal, const V3f& to_viewer, const V3f& to_light) {
        const V3f sum = to_viewer + to_light;
        const float squared_length = sum.length2();
        const float length = std::sqrt(squared_length);
        direction = sum / length;
        cosine = normal.dot(direction);
        squared_sine = normal.cross(direction).length2();
        viewer = 0.5F * length;
    }

    V3f direction;       ///< Unit: the normal of the facet.
    float cosine;        ///< Between it and the surface's normal.
    float squared_sine;  ///< The same.
    float viewer;        ///< The cosine between it and either direction.
};

/// The facet that refracts light from the other side to the viewer: Walter et al. 2007, section 4.
/// `eta` is the index of refraction of the light's side over that of the viewer's side.
struct RefractingFacet {
    RefractingFacet(const V3f& normal, const V3f& to_viewer, const V3f& to_light, float eta) {
        V3f direction = (to_viewer + eta * to_light).normalized();
        if (direction.dot(normal) < 0.0F) {
            direction = -direction;
        }
        cosine = direction.dot(normal);
        squared_sine = direction.cross(normal).length2();
        viewer = to_viewer.dot(direction);
        light = -to_light.dot(direction);
        per_light = square(eta) * light / square(viewer - eta * light);
    }

    float cosine;        ///< Between it and the surface's normal.
    float squared_sine;  ///< The same.
    float viewer;        ///< Its cosine with the viewer, and with the light on its other side;
    float light;         ///< not refracted if either is negative.
    float per_light;     ///< The solid angle of facets over that of the light: equation 17.
};

/// Reflection by the facets of a layer in which all facets reflect all light.
struct Microfacets {
    Microfacets(const Ggx& facets, const HalfVector& halfway, float viewer, float light) {
        const float density = facets.density(halfway.cosine, halfway.squared_sine);
        const float slant = facets.slant(viewer);
        reflectance = density * Ggx::masking(viewer, slant, light, facets.slant(light));
        pdf = 0.25F * density * Ggx::visible(viewer, slant);
    }

    float reflectance;
    float pdf;  ///< Of the light's direction, where Ggx::sample_visible() gives the facet.
};

}  // namespace balcony::render
