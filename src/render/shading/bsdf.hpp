// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reflection of light at a point of a surface.

#include <cstdint>
#include <optional>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "render/shading/appearance.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

/// Whether a point with this material can be a perfect mirror; a texture only reduces the
/// roughness.
[[nodiscard]] bool may_be_mirror(const scene::Material& material);

/// What a surface does with the light of a sample.
enum class BsdfLobe : std::uint8_t { diffuse, glossy, transmission };

/// A sampled direction of incident light.
struct BsdfSample {
    V3f to_light;
    Color3f weight;      ///< eval() divided by the density: the factor for the incident radiance.
    float pdf = 0.0F;    ///< Bsdf::pdf() of the direction; 0 of a delta lobe, which has no density.
    bool delta = false;  ///< Whether it is from the mirror lobe.
    V3f facet_normal;    ///< Unit: that of the facet that reflects, or of the surface if diffuse.
    BsdfLobe lobe = BsdfLobe::glossy;
    bool transmitted = false;  ///< The light comes from the other side.
    float eta = 1.0F;  ///< If transmitted: the index of refraction of the viewer's side, divided by
                       ///< that of the light's side.
};

/// Surfaces with a roughness below this are perfect mirrors.
inline constexpr float mirror_roughness = 0.1F;

[[nodiscard]] inline bool is_mirror(const Appearance& appearance) {
    return appearance.roughness < mirror_roughness;
}

/// glTF 2.0's metallic-roughness material (appendix B): Lambert's law under a GGX microfacet layer
/// (Walter et al. 2007) with Smith's height-correlated masking and Schlick's approximation of
/// Fresnel's reflectance. Where is_mirror() holds the layer is a perfect mirror, a delta lobe:
/// eval() and pdf() exclude it; sample() and sample_mirror() include it.
///
/// Directions are in world coordinates, unit, and point away from the surface; the viewer is above
/// the surface, in front of both normals. Light from below is not reflected.
///
/// Both lobes share the light by the Fresnel reflectance at the half vector. This is reciprocal,
/// but a dielectric seen at a grazing angle reflects more light than it receives, as in glTF's own
/// formula; docs/rendering.md has the figures.
class Bsdf {
public:
    Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal,
         bool entering = true);

    /// eval() and pdf() at once.
    struct Value {
        Color3f reflected;
        float pdf = 0.0F;
    };
    [[nodiscard]] Value evaluate(const V3f& to_viewer, const V3f& to_light) const {
        return {eval(to_viewer, to_light), pdf(to_viewer, to_light)};
    }

    /// Whether light passes through the surface.
    [[nodiscard]] bool transmits() const { return false; }
    /// Whether all light is scattered widely, so that sampling the lights alone finds it.
    [[nodiscard]] bool is_rough() const { return alpha_ > 0.1F; }

    /// The reflectance times the cosine between normal and light: the radiance towards the viewer
    /// for an irradiance of 1 on a plane perpendicular to the light's direction.
    [[nodiscard]] Color3f eval(const V3f& to_viewer, const V3f& to_light) const;

    /// The density, by solid angle, with which sample() chooses a direction from its lobes other
    /// than the mirror. Over the sphere it integrates to 1 minus the probability of the mirror;
    /// part of it is below the surface, where sample() returns nothing.
    [[nodiscard]] float pdf(const V3f& to_viewer, const V3f& to_light) const;

    /// A direction from three numbers in [0, 1): the first selects the lobe. Nothing if the
    /// direction points into the surface, or if the surface is black.
    [[nodiscard]] std::optional<BsdfSample> sample(const V3f& to_viewer, const V3f& random) const;

    /// Only the mirror lobe, with its whole weight; nothing if there is none. A direction that
    /// would point into the surface is reflected by the geometric normal instead.
    [[nodiscard]] std::optional<BsdfSample> sample_mirror(const V3f& to_viewer) const;

    /// The reflectance for uniform light from all directions, without the mirror and without
    /// the Fresnel effect: an approximation for ambient light.
    [[nodiscard]] Color3f ambient_reflectance() const;

private:
    /// The probability with which sample() chooses mirror or highlight.
    [[nodiscard]] float specular_probability(const V3f& to_viewer) const;
    [[nodiscard]] Color3f fresnel(float cosine) const;

    Color3f diffuse_;
    Color3f specular_;  // Reflectance at normal incidence.
    Color3f metal_;     // The metallic part of the base colour.
    float alpha_;       // GGX's width: the roughness squared.
    bool mirror_;
    V3f normal_;
    V3f geometric_normal_;
};

}  // namespace balcony::render
