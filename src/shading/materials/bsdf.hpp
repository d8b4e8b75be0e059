// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reflection of light at a point of a surface.

#include <array>
#include <cstdint>
#include <optional>
#include <variant>

#include <Imath/ImathColor.h>
#include <Imath/ImathVec.h>

#include "shading/materials/appearance.hpp"
#include "shading/materials/bsdf_material.hpp"
#include "shading/materials/energy.hpp"
#include "shading/materials/layers.hpp"

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
/// Upon this may lie sheen (sheen.hpp) and a clearcoat, which is a GGX layer of a dielectric and
/// never a perfect mirror (cover.hpp). A clearcoat with a normal of its own reflects the part E' of
/// even light instead of E, each by its normal, and all that is below it is multiplied by
/// s(viewer) s(light) with s = min(1, (1 - E') / (1 - E)). This is reciprocal, adds no light, and
/// loses a little, the more the two normals differ. In place of the diffuse part light may pass
/// through: through a thin wall straight on, spread like reflected light by the facets, or through
/// the boundary of a solid by Snell's law, with Fresnel's reflectance (glass.hpp).
///
/// Radiance is divided by the square of the index of refraction of the medium, outside 1, so that
/// refraction alone does not change it. With that, reflection is reciprocal, and refraction is so
/// up to the squared ratio of the indices.
///
/// Directions are in world coordinates, unit, and point away from the surface; the viewer is above
/// the surface, in front of both normals.
class Bsdf {
public:
    /// Light is reflected in front of `side_normal` and passes through the surface behind it: the
    /// normal of the triangle, or the smooth one. Light comes from outside, where `entering` says
    /// that the viewer is, through the boundary of a closed solid; elsewhere it has no meaning.
    Bsdf(const Appearance& appearance, const V3f& normal, const V3f& side_normal,
         bool entering = true);

    /// The same from a material that outlives it and that suits the viewer's side.
    Bsdf(const BsdfMaterial& material, const V3f& normal, const V3f& side_normal);

    /// Gives the clearcoat, if there is one, a normal of its own, which the viewer is in front of.
    void set_coat_normal(const V3f& normal) { coat_normal_ = normal; }

    /// The normal of the side from which light is reflected; 0 if light comes from all sides.
    [[nodiscard]] V3f lit_side() const;

    struct Value {
        /// The reflectance, or transmittance, times the cosine between normal and light: the
        /// radiance towards the viewer for an irradiance of 1 on a plane perpendicular to the
        /// light's direction.
        Color3f reflected{0.0F};
        /// The density, by solid angle, with which sample() finds the direction by a lobe other
        /// than the delta lobes. Over the sphere it integrates to 1 minus the probabilities of
        /// those and of finding nothing.
        float pdf = 0.0F;
    };
    class View;
    /// What the viewer's direction alone decides, for any number of lights and samples.
    [[nodiscard]] View view_from(const V3f& to_viewer) const;

    /// `to_light` may be below a surface that transmits light.
    [[nodiscard]] Value evaluate(const View& view, const V3f& to_light) const;
    [[nodiscard]] Value evaluate(const V3f& to_viewer, const V3f& to_light) const;

    /// A direction from three numbers in [0, 1): the first selects the lobe. Nothing if the
    /// direction points to the wrong side of the surface, or if the surface is black.
    [[nodiscard]] std::optional<BsdfSample> sample(const View& view, const V3f& random) const;
    [[nodiscard]] std::optional<BsdfSample> sample(const V3f& to_viewer, const V3f& random) const;

    /// A sample with weight and density; nothing if it carries no light.
    [[nodiscard]] static std::optional<BsdfSample> weighted(const BsdfSample& sample,
                                                            const Value& value);

    /// Only the mirror lobe, with its whole weight; nothing if there is none. A direction that
    /// would point into the surface is reflected by the geometric normal instead.
    [[nodiscard]] std::optional<BsdfSample> sample_mirror(const V3f& to_viewer) const;

    /// Only the light that passes a perfect surface straight on, or refracted, with its whole
    /// weight; nothing if there is none.
    [[nodiscard]] std::optional<BsdfSample> sample_passage(const V3f& to_viewer) const;

    [[nodiscard]] const BsdfMaterial& material() const {
        const auto* const shared = std::get_if<const BsdfMaterial*>(&material_);
        return shared != nullptr ? **shared : *std::get_if<BsdfMaterial>(&material_);
    }

private:
    [[nodiscard]] PlainView plain_view_from(const V3f& to_viewer) const;
    [[nodiscard]] Value evaluate_plain(const PlainView& view, const V3f& to_light) const;
    [[nodiscard]] std::optional<BsdfSample> sample_plain(const PlainView& view,
                                                         const V3f& random) const;
    [[nodiscard]] BsdfSample mirror_sample(const V3f& to_viewer, const Color3f& weight) const;
    std::variant<const BsdfMaterial*, BsdfMaterial> material_;
    V3f normal_;
    V3f side_normal_;
    V3f coat_normal_;

    // Materials with layers beyond the plain ones: bsdf_layers.cpp.
    struct LayersView {
        V3f direction;
        float cosine = 0.0F;
        Covered covered;
        CoatAt coat;
        float below = 0.0F;                  // What passes covers and dielectric layer.
        float lost = 0.0F;                   // What the facets of glass block.
        std::array<float, 5> probability{};  // By lobe.
    };
    [[nodiscard]] LayersView layers_view_from(const V3f& to_viewer) const;
    [[nodiscard]] Value evaluate_layers(const LayersView& view, const V3f& to_light) const;
    [[nodiscard]] CoatAt coat_at(const Covered& covered, const V3f& direction) const;
    [[nodiscard]] Value evaluate_above(const LayersView& view, const V3f& to_light) const;
    [[nodiscard]] Value evaluate_coat(const LayersView& view, const CoatAt& lit,
                                      const V3f& to_light) const;
    [[nodiscard]] Value evaluate_through_wall(const LayersView& view, const V3f& to_light) const;
    [[nodiscard]] Value evaluate_refracted(const LayersView& view, const V3f& to_light) const;
    [[nodiscard]] std::optional<BsdfSample> sample_layers(const LayersView& view,
                                                          const V3f& random) const;
    [[nodiscard]] float passed_outside(const V3f& to_light) const;
    [[nodiscard]] Color3f mirror_weight(const LayersView& view) const;
    [[nodiscard]] std::optional<BsdfSample> sample_straight(const LayersView& view) const;
    [[nodiscard]] BsdfSample sample_lobe(const LayersView& view, std::size_t lobe,
                                         const V3f& random) const;

    void pass(const LayersView& view, const V3f& random, const Frame& frame,
              BsdfSample& sample) const;
};

class Bsdf::View {
    friend class Bsdf;
    explicit View(const PlainView& plain) : of_(plain) {}
    explicit View(const LayersView& layers) : of_(layers) {}

    std::variant<PlainView, LayersView> of_;
};

}  // namespace balcony::render
