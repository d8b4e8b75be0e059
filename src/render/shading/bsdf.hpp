// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reflection of light at a point of a surface.

#include <cstdint>
#include <optional>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "render/shading/appearance.hpp"
#include "render/shading/energy.hpp"
#include "render/shading/microfacets.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V3f;

/// What a surface does with the light of a sample.
enum class BsdfLobe : std::uint8_t { diffuse, glossy, transmission };

/// A sampled direction of incident light.
struct BsdfSample {
    V3f to_light;
    Color3f weight;      ///< eval() divided by the density: the factor for the incident radiance.
    float pdf = 0.0F;    ///< Bsdf::pdf() of the direction; 0 of a delta lobe, which has no density.
    bool delta = false;  ///< Whether it is from the mirror lobe.
    V3f facet_normal;    ///< Unit: that of the facet that reflects, or of the surface if diffuse.
    float roughness = 1.0F;  ///< That of the lobe, as glTF measures it: 0 of a delta lobe.
    BsdfLobe lobe = BsdfLobe::glossy;
    bool transmitted = false;  ///< The light comes from the other side.
    float eta = 1.0F;  ///< If transmitted: the index of refraction of the viewer's side, divided by
                       ///< that of the light's side.
};

/// The reflectance of a layer as factors of LayerEnergy: of the parts with and without c, each at
/// normal incidence and rising to the edge.
template <typename T>
struct LayerReflectance {
    T single{0.0F};
    T single_edge{0.0F};
    T all{0.0F};
    T all_edge{0.0F};

    /// Adds a layer with the reflectance f0 + (f90 - f0) schlick(cosine), of which c acts on the
    /// part `repeated`.
    void add(const T& share, const T& f0, const T& f90, const T& repeated) {
        const T repeats = share * repeated;
        const T once = share - repeats;
        single += once * f0;
        single_edge += once * (f90 - f0);
        all += repeats * f0;
        all_edge += repeats * (f90 - f0);
    }
    /// Of even light.
    [[nodiscard]] T albedo(const LayerEnergy& energy) const {
        return single * energy.single + single_edge * energy.single_edge + all * energy.all +
               all_edge * energy.all_edge;
    }
    /// Of one facet; `scale` is c(viewer) c(light).
    [[nodiscard]] T at_facet(float edge, float scale) const {
        return single + edge * single_edge + scale * (all + edge * all_edge);
    }
};

/// glTF 2.0's metallic-roughness material (appendix B): Lambert's law under a GGX microfacet layer
/// with Schlick's approximation of Fresnel's reflectance; a mirror, that is, a delta lobe, where
/// the roughness squared is below min_alpha. eval() and pdf() exclude it; sample() and
/// sample_mirror() include it. KHR_materials_ior and KHR_materials_specular give its reflectance.
///
/// The layer has the energy of energy.hpp. Facets that reflect the part f0 of the light do so at
/// each of several reflections, so that c acts on the part f0 (Turquin 2019). Below a dielectric,
/// the diffuse part receives what the layer leaves, from either direction, which is reciprocal and
/// conserves energy (Kelemen and Szirmay-Kalos 2001, in the form of Kulla and Conty 2017): with the
/// layer's albedo E and its mean Ē,
///
///     diffuse = colour / π · (1 - E(viewer)) (1 - E(light)) / (1 - Ē).
///
/// Directions are in world coordinates, unit, and point away from the surface; the viewer is above
/// the surface, in front of both normals.
class Bsdf {
public:
    Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal,
         bool entering = true);

    struct Value {
        /// The reflectance times the cosine between normal and light: the radiance towards the
        /// viewer for an irradiance of 1 on a plane perpendicular to the light's direction.
        Color3f reflected{0.0F};
        /// The density, by solid angle, with which sample() finds the direction by a lobe other
        /// than the mirror. Over the sphere it integrates to 1 minus the probabilities of the
        /// mirror and of finding nothing.
        float pdf = 0.0F;
    };
    [[nodiscard]] Value evaluate(const V3f& to_viewer, const V3f& to_light) const;
    [[nodiscard]] Color3f eval(const V3f& to_viewer, const V3f& to_light) const {
        return evaluate(to_viewer, to_light).reflected;
    }
    [[nodiscard]] float pdf(const V3f& to_viewer, const V3f& to_light) const {
        return evaluate(to_viewer, to_light).pdf;
    }

    /// A direction from three numbers in [0, 1): the first selects the lobe. Nothing if the
    /// direction points into the surface, or if the surface is black.
    [[nodiscard]] std::optional<BsdfSample> sample(const V3f& to_viewer, const V3f& random) const;

    /// Only the mirror lobe, with its whole weight; nothing if there is none. A direction that
    /// would point into the surface is reflected by the geometric normal instead.
    [[nodiscard]] std::optional<BsdfSample> sample_mirror(const V3f& to_viewer) const;

    /// Whether light passes through the surface.
    [[nodiscard]] bool transmits() const { return false; }
    /// Whether all light is scattered widely, so that sampling the lights alone finds it.
    [[nodiscard]] bool is_rough() const { return roughness_ > 0.3F; }

    /// The reflectance for uniform light from all directions, without the mirror and without
    /// the Fresnel effect: an approximation for ambient light.
    [[nodiscard]] Color3f ambient_reflectance() const;

private:
    /// What the viewer's direction alone decides.
    struct View {
        V3f direction;
        float cosine;
        LayerEnergy energy;
        float below;     // The part of the light that passes the dielectric layer.
        float specular;  // The probability with which sample() chooses the layer.
    };
    [[nodiscard]] View view_from(const V3f& to_viewer) const;
    [[nodiscard]] float below(const LayerEnergy& energy) const;
    [[nodiscard]] bool is_mirror() const { return roughness_ == 0.0F; }
    [[nodiscard]] Value evaluate(const View& view, const V3f& to_light) const;

    LayerReflectance<Color3f> specular_;
    LayerReflectance<float> dielectric_;  // The brightest channel, without metal.
    Color3f diffuse_;
    float per_mean_below_ = 0.0F;  // 1 / (1 - Ē); 0 if no light comes below.
    Color3f metal_;                // The metallic part of the base colour.
    float roughness_;              // 0 of a mirror.
    Ggx facets_;
    LayerEnergies energies_;
    V3f normal_;
    V3f geometric_normal_;
};

}  // namespace balcony::render
