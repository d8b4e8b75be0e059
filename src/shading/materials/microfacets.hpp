// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The microfacets of a rough surface, and Fresnel's laws on one of them.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Imath/ImathVec.h>

#include "shading/geometry/circle.hpp"
#include "shading/lanes/scalar.hpp"

namespace balcony::render {

using Imath::V3f;

/// Directions closer to the horizon than this are below it.
inline constexpr float min_cosine = 1e-6F;

#include "shading/materials/microfacets.inl"

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

}  // namespace balcony::render
