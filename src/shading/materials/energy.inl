// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

/// What a GGX layer reflects of even light, seen from a direction. It is linear in the reflectance
/// f0 + (f90 - f0) schlick(cosine) of the facets:
///
///     f0 single + (f90 - f0) single_edge      by the facets that the light meets first,
///     f0 all    + (f90 - f0) all_edge         multiplied by c(viewer) c(light).
struct LayerEnergy {
    Float scale;  ///< c
    Float single;
    Float single_edge;
    Float all;  ///< 1, unless something covers the layer.
    Float all_edge;
};

/// The reflectance of a layer as factors of LayerEnergy: of the parts with and without c, each at
/// normal incidence and rising to the edge. A colour, or a number.
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
    BALCONY_FORMULA T albedo(const LayerEnergy& energy) const {
        return single * energy.single + single_edge * energy.single_edge + all * energy.all +
               all_edge * energy.all_edge;
    }
    /// Of one facet; `scale` is c(viewer) c(light).
    BALCONY_FORMULA T at_facet(Float edge, Float scale) const {
        return single + edge * single_edge + scale * (all + edge * all_edge);
    }
};
