// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Materials without further layers; bsdf.hpp explains them. `Material` has the members of
// PlainMaterial.

/// What passes the dielectric layer of the part that reaches it.
template <class Material>
BALCONY_FORMULA Float passed_below(const Material& material, const LayerEnergy& energy,
                                   Float reaching) {
    return larger(reaching - material.dielectric.albedo(energy), 0.0F);
}

/// What the viewer's direction alone decides.
struct PlainView {
    Float3 direction;
    Float cosine;
    LayerEnergy energy;
    Float below;     ///< The part of the light that passes the dielectric layer.
    Float specular;  ///< The probability with which sampling chooses the layer.
};

template <class Material>
BALCONY_FORMULA PlainView plain_view(const Material& material, const Float3& direction,
                                     Float cosine, const LayerEnergy& energy) {
    const Float below = passed_below(material, energy, 1.0F);
    const Float specular = largest(material.specular.albedo(energy));
    const Float diffuse = largest(material.diffuse) * below;
    return {direction, cosine, energy, below,
            or_zero(specular > 0.0F, specular / (specular + diffuse))};
}

/// Whether light is reflected, by the cosines of light and viewer with the normal, and of the light
/// with the normal of the side.
BALCONY_FORMULA Where is_lit(Float light, Float viewer, Float side) {
    return both(both(light >= min_cosine, viewer >= min_cosine), side > 0.0F);
}

struct PlainValue {
    Float3 reflected;
    Float pdf;
};

/// Where is_lit(), with the energy at the cosine of the light.
template <class Material>
BALCONY_FORMULA PlainValue plain_value(const Material& material, const Float3& normal,
                                       const PlainView& view, const Float3& to_light, Float cosine,
                                       const LayerEnergy& energy) {
    const Float lambert = cosine / std::numbers::pi_v<float>;
    const Float3 diffuse = lambert * view.below * passed_below(material, energy, 1.0F) *
                           material.per_mean_below * material.diffuse;
    const HalfVector halfway(normal, view.direction, to_light);
    const Microfacets at(material.facets, halfway, view.cosine, cosine);
    const Float3 glossy =
        cosine * at.reflectance *
        material.specular.at_facet(schlick(halfway.viewer), view.energy.scale * energy.scale);
    const Where rough = material.facets.alpha() > 0.0F;
    return {diffuse + or_zero(rough, glossy),
            (1.0F - view.specular) * lambert + or_zero(rough, view.specular * at.pdf)};
}

struct PlainDirection {
    Float3 to_light;
    Float3 facet_normal;
    Where by_facet;  ///< A facet reflects; otherwise it is diffuse.
};

/// A direction of a rough material from three numbers in [0, 1).
BALCONY_FORMULA PlainDirection plain_direction(const Ggx& facets, const Float3& normal,
                                               const Float3& viewer, Float specular,
                                               const Float3& random) {
    const Frame frame(normal);
    const Where by_facet = random.x < specular;
    const Float2 around = on_circle(select(by_facet, random.y, random.z));
    const Float3 facet =
        frame.to_world(facets.visible_facet(frame.to_local(viewer), around, random.z));
    const Float3 diffuse = frame.to_world(cosine_direction(random.y, around));
    return {unit(select(by_facet, mirrored(viewer, facet), diffuse)),
            select(by_facet, facet, normal), by_facet};
}
