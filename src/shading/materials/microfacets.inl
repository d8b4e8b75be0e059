// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// Direction `v` turned by half a turn about a unit normal.
BALCONY_FORMULA Float3 mirrored(const Float3& v, const Float3& normal) {
    return 2.0F * dot(v, normal) * normal - v;
}

/// Schlick's (1 - cosine)^5: Fresnel's reflectance rises from f0 to f90 by this part.
BALCONY_FORMULA Float schlick(Float cosine) {
    const Float c = clamped(1.0F - cosine, 0.0F, 1.0F);
    return square(square(c)) * c;
}

/// The GGX distribution of facets (Walter et al., "Microfacet Models for Refraction through Rough
/// Surfaces", 2007) with Smith's masking, correlated by height (Heitz 2014). Cosines are those of
/// directions with the normal of the surface, in (0, 1].
class Ggx {
public:
    BALCONY_FORMULA explicit Ggx(Float alpha) : alpha_(alpha), a2_(square(alpha)) {}

    BALCONY_FORMULA Float alpha() const { return alpha_; }

    /// The density of facets by solid angle. The squared sine is an argument of its own because a
    /// float's cosine near 1 tells little about it.
    BALCONY_FORMULA Float density(Float cosine, Float squared_sine) const {
        return a2_ / (std::numbers::pi_v<float> * square(a2_ * square(cosine) + squared_sine));
    }

    /// sqrt(a² + (1 - a²) cosine²): Smith's Λ is (slant / cosine - 1) / 2.
    BALCONY_FORMULA Float slant(Float cosine) const {
        return root(a2_ + (1.0F - a2_) * square(cosine));
    }

    /// The visible fraction of the facets, from both directions, over four times both cosines.
    BALCONY_FORMULA static Float masking(Float viewer, Float viewer_slant, Float light,
                                         Float light_slant) {
        return 0.5F / (light * viewer_slant + viewer * light_slant);
    }

    /// The density of the facets that the viewer sees is this times density(), times the cosine
    /// between viewer and facet.
    BALCONY_FORMULA static Float visible(Float viewer, Float viewer_slant) {
        return 2.0F / (viewer + viewer_slant);
    }

    /// A facet that a viewer sees, in the frame of the surface, from on_circle() of a number in
    /// [0, 1), and another one: Dupuy and Benyoub, "Sampling Visible GGX Normals with Spherical
    /// Caps" (2023).
    BALCONY_FORMULA Float3 visible_facet(const Float3& to_viewer, const Float2& around,
                                         Float v) const {
        const Float3 stretched =
            unit(Float3{alpha_ * to_viewer.x, alpha_ * to_viewer.y, to_viewer.z});
        const Float z = (1.0F - v) * (1.0F + stretched.z) - stretched.z;
        const Float radius = root(clamped(1.0F - z * z, 0.0F, 1.0F));
        const Float3 facet = Float3{radius * around.x, radius * around.y, z} + stretched;
        return unit(Float3{alpha_ * facet.x, alpha_ * facet.y, larger(facet.z, 0.0F)});
    }

private:
    Float alpha_;
    Float a2_;
};

/// The reflection of two directions above a surface by its facets.
struct HalfVector {
    BALCONY_FORMULA HalfVector(const Float3& normal, const Float3& to_viewer,
                               const Float3& to_light) {
        const Float3 sum = to_viewer + to_light;
        const Float length = root(dot(sum, sum));
        direction = sum / length;
        cosine = dot(normal, direction);
        const Float3 across = cross(normal, direction);
        squared_sine = dot(across, across);
        viewer = 0.5F * length;
    }

    Float3 direction;    ///< Unit: the normal of the facet.
    Float cosine;        ///< Between it and the surface's normal.
    Float squared_sine;  ///< The same.
    Float viewer;        ///< The cosine between it and either direction.
};

/// Reflection by the facets of a layer in which all facets reflect all light.
struct Microfacets {
    BALCONY_FORMULA Microfacets(const Ggx& facets, const HalfVector& halfway, Float viewer,
                                Float light) {
        const Float density = facets.density(halfway.cosine, halfway.squared_sine);
        const Float slant = facets.slant(viewer);
        reflectance = density * Ggx::masking(viewer, slant, light, facets.slant(light));
        pdf = 0.25F * density * Ggx::visible(viewer, slant);
    }

    Float reflectance;
    Float pdf;  ///< Of the light's direction, where Ggx::visible_facet() gives the facet.
};
