// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "shading/materials/plain_lanes.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <numbers>

#include "shading/materials/plain_lanes.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::plain_lanes::HWY_NAMESPACE {

#include "shading/lanes/registers.inl"

#include "shading/geometry/circle.inl"
#include "shading/geometry/frame.inl"
#include "shading/materials/energy.inl"
#include "shading/materials/microfacets.inl"
#include "shading/materials/table.inl"

#include "shading/materials/plain_bsdf.inl"

template <class T, class Values>
HWY_INLINE LayerReflectance<T> load_layer(const Reflectance<Values>& from, std::size_t lane) {
    return {load(from.single, lane), load(from.single_edge, lane), load(from.all, lane),
            load(from.all_edge, lane)};
}

// As PlainMaterial; what a formula does not use is not loaded.
struct Material {
    HWY_INLINE Material(const Surfaces& from, std::size_t lane)
        : specular(load_layer<Float3>(from.specular, lane)),
          dielectric(load_layer<Float>(from.dielectric, lane)),
          diffuse(load(from.diffuse, lane)),
          per_mean_below(load(from.per_mean_below, lane)),
          facets(load(from.alpha, lane)) {}

    LayerReflectance<Float3> specular;
    LayerReflectance<Float> dielectric;
    Float3 diffuse;
    Float per_mean_below;
    Ggx facets;
};

HWY_INLINE LayerEnergy load(const Energies& from, std::size_t lane) {
    return {load(from.scale, lane), load(from.single, lane), load(from.single_edge, lane),
            Float(1.0F), load(from.all_edge, lane)};
}

HWY_INLINE PlainView load(const Views& from, std::size_t lane) {
    return {load(from.direction, lane), load(from.cosine, lane), load(from.energy, lane),
            load(from.below, lane), load(from.specular, lane)};
}

void find_cosines(const Surfaces& surfaces, const Vectors& directions, Cosines& found) {
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Float cosine = dot(load(surfaces.normal, lane), load(directions, lane));
        const TablePosition at = position_of_cosine(cosine);
        store(cosine, found.cosine, lane);
        lanes::Store(at.node.v, int_tag, found.node.data() + lane);
        store(at.fraction, found.fraction, lane);
    }
}

// Interpolates.
HWY_INLINE void set_energies(const Cosines& at, Energies& energies) {
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Float fraction = load(at.fraction, lane);
        lanes::Vec<Tag> scale, single, single_edge, all_edge;
        lanes::LoadInterleaved4(tag, &at.lower[lane].scale, scale, single, single_edge, all_edge);
        lanes::Vec<Tag> scale_2, single_2, single_edge_2, all_edge_2;
        lanes::LoadInterleaved4(tag, &at.upper[lane].scale, scale_2, single_2, single_edge_2,
                                all_edge_2);
        store(mix(scale, scale_2, fraction), energies.scale, lane);
        store(mix(single, single_2, fraction), energies.single, lane);
        store(mix(single_edge, single_edge_2, fraction), energies.single_edge, lane);
        store(mix(all_edge, all_edge_2, fraction), energies.all_edge, lane);
    }
}

void finish_views(const Surfaces& surfaces, const Cosines& cosines, Views& views) {
    views.cosine = cosines.cosine;
    set_energies(cosines, views.energy);
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const PlainView view = plain_view(Material(surfaces, lane), load(views.direction, lane),
                                          load(views.cosine, lane), load(views.energy, lane));
        store(view.below, views.below, lane);
        store(view.specular, views.specular, lane);
    }
}

// Where the surfaces reflect light, by the cosines with their normals.
LaneBits lit_lanes(LaneBits bits, const Surfaces& surfaces, const Views& views,
                   const Vectors& to_light, const Floats& cosines) {
    LaneBits found = 0;
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Float side = dot(load(surfaces.side_normal, lane), load(to_light, lane));
        found |= bits_of(is_lit(load(cosines, lane), load(views.cosine, lane), side), lane);
    }
    return found & bits;
}

void finish_values(LaneBits bits, const Surfaces& surfaces, const Views& views,
                   const Vectors& to_light, const Cosines& cosines, Values& values) {
    alignas(64) Energies energies;
    set_energies(cosines, energies);
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const Where asked = where_of(bits, lane);
        if (!any(asked)) {
            store(Float3{0.0F, 0.0F, 0.0F}, values.reflected, lane);
            store(Float(0.0F), values.pdf, lane);
            continue;
        }
        const PlainValue value =
            plain_value(Material(surfaces, lane), load(surfaces.normal, lane), load(views, lane),
                        load(to_light, lane), load(cosines.cosine, lane), load(energies, lane));
        store(or_zero(asked, value.reflected), values.reflected, lane);
        store(or_zero(asked, value.pdf), values.pdf, lane);
    }
}

void sample(const Surfaces& surfaces, const Views& views, const Vectors& random,
            Directions& directions) {
    directions.by_facet = 0;
    for (std::size_t lane = 0; lane < size; lane += lanes::Lanes(tag)) {
        const PlainDirection found = plain_direction(
            Ggx(load(surfaces.alpha, lane)), load(surfaces.normal, lane),
            load(views.direction, lane), load(views.specular, lane), load(random, lane));
        store(found.to_light, directions.to_light, lane);
        store(found.facet_normal, directions.facet_normal, lane);
        directions.by_facet |= bits_of(found.by_facet, lane);
    }
}

}  // namespace balcony::render::plain_lanes::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render::plain_lanes {

HWY_EXPORT(find_cosines);
HWY_EXPORT(finish_views);
HWY_EXPORT(lit_lanes);
HWY_EXPORT(finish_values);
HWY_EXPORT(sample);

namespace {

// The entries of the table around the cosines, lane by lane.
void look_up(LaneBits bits, const Surfaces& surfaces, Cosines& at) {
    for_each_lane(bits, [&](std::size_t lane) {
        const LayerEnergies& energies = *surfaces.energies[lane];
        if (const EnergyEntry* const row = energies.row()) {
            at.lower[lane] = row[at.node[lane]];
            at.upper[lane] = row[at.node[lane] + 1];
        } else {
            const LayerEnergy energy = energies.at(at.cosine[lane]);
            at.lower[lane] =
                at.upper[lane] = {energy.scale, energy.single, energy.single_edge, energy.all_edge};
        }
    });
}

// Calls set(array, number) for each number of a material.
template <class Set>
void put(const PlainMaterial& material, Surfaces& all, const Set& set) {
    const auto set_vector = [&set](Vectors& values, const V3f& value) {
        set(values.x, value.x);
        set(values.y, value.y);
        set(values.z, value.z);
    };
    set_vector(all.specular.single, material.specular.single);
    set_vector(all.specular.single_edge, material.specular.single_edge);
    set_vector(all.specular.all, material.specular.all);
    set_vector(all.specular.all_edge, material.specular.all_edge);
    set(all.dielectric.single, material.dielectric.single);
    set(all.dielectric.single_edge, material.dielectric.single_edge);
    set(all.dielectric.all, material.dielectric.all);
    set(all.dielectric.all_edge, material.dielectric.all_edge);
    set_vector(all.diffuse, material.diffuse);
    set(all.per_mean_below, material.per_mean_below);
    set(all.alpha, material.facets.alpha());
}

}  // namespace

void Surfaces::set_material(std::size_t lane, const PlainMaterial& material) {
    put(material, *this, [lane](Floats& values, float value) { values[lane] = value; });
    energies[lane] = &material.energies;
}

void Surfaces::set(std::size_t lane, const Surface& surface) {
    set_material(lane, surface.material);
    normal.set(lane, surface.normal);
    side_normal.set(lane, surface.side_normal);
}

void Surfaces::fill(std::size_t first, std::size_t count, const Surface& surface) {
    put(surface.material, *this,
        [=](Floats& values, float value) { std::fill_n(values.begin() + first, count, value); });
    std::fill_n(energies.begin() + first, count, &surface.material.energies);
    normal.fill(first, count, surface.normal);
    side_normal.fill(first, count, surface.side_normal);
}

void set_views(LaneBits lanes, const Surfaces& surfaces, const Vectors& to_viewer, Views& views) {
    Cosines cosines;
    views.direction = to_viewer;
    HWY_DYNAMIC_DISPATCH(find_cosines)(surfaces, to_viewer, cosines);
    look_up(lanes, surfaces, cosines);
    HWY_DYNAMIC_DISPATCH(finish_views)(surfaces, cosines, views);
}

void evaluate(LaneBits lanes, const Surfaces& surfaces, const Views& views, const Vectors& to_light,
              Values& values) {
    Cosines cosines;
    HWY_DYNAMIC_DISPATCH(find_cosines)(surfaces, to_light, cosines);
    const LaneBits lit =
        HWY_DYNAMIC_DISPATCH(lit_lanes)(lanes, surfaces, views, to_light, cosines.cosine);
    look_up(lit, surfaces, cosines);
    HWY_DYNAMIC_DISPATCH(finish_values)(lit, surfaces, views, to_light, cosines, values);
}

void sample(const Surfaces& surfaces, const Views& views, const Vectors& random,
            Directions& directions) {
    HWY_DYNAMIC_DISPATCH(sample)(surfaces, views, random, directions);
}

}  // namespace balcony::render::plain_lanes

#endif
