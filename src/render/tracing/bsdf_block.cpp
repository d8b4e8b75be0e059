// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/tracing/bsdf_block.hpp"

namespace balcony::render {

void BsdfBlock::clear() { plain_ = given_ = 0; }

bool BsdfBlock::add(std::size_t place, const Interaction& at, const V3f& to_viewer,
                    float least_roughness) {
    const Surface& surface = at.surface;
    const std::optional<Appearance> softened =
        least_roughness > 0.0F ? at.appearance().softened(least_roughness) : std::nullopt;
    const BsdfMaterial* const uniform = softened ? nullptr : at.uniform;
    const BsdfMaterial& material =
        uniform != nullptr
            ? *uniform
            : varying_[place].emplace(softened ? *softened : at.appearance(), surface.entering);
    materials_[place] = &material;
    if (material.layers || material.is_mirror()) {
        Bsdf bsdf(material, surface.normal, surface.smooth_normal);
        bsdf.set_coat_normal(surface.coat_normal);
        singles_[place].emplace(Single{bsdf, bsdf.view_from(to_viewer)});
        return softened.has_value();
    }
    plain_ |= lane_bit(place);
    if (uniform == nullptr || known_[place] != uniform) {
        surfaces_.set_material(place, material);
        known_[place] = uniform;
    }
    surfaces_.normal.set(place, surface.normal);
    surfaces_.side_normal.set(place, surface.smooth_normal);
    to_viewer_.set(place, to_viewer);
    return softened.has_value();
}

void BsdfBlock::set_views() { plain_lanes::set_views(plain_, surfaces_, to_viewer_, views_); }

V3f BsdfBlock::lit_side(std::size_t place) const {
    return (plain_ & lane_bit(place)) != 0 ? surfaces_.normal.of(place)
                                           : singles_[place]->bsdf.lit_side();
}

void BsdfBlock::evaluate(LaneBits places) {
    plain_lanes::evaluate(places & plain_, surfaces_, views_, to_light_, values_);
    for_each_lane(places & ~plain_, [&](std::size_t place) {
        Single& single = *singles_[place];
        single.value = single.bsdf.evaluate(single.view, to_light_.of(place));
    });
}

Bsdf::Value BsdfBlock::value(std::size_t place) const {
    return (plain_ & lane_bit(place)) != 0
               ? Bsdf::Value{values_.reflected.of(place), values_.pdf[place]}
               : singles_[place]->value;
}

void BsdfBlock::sample(LaneBits places) {
    if ((places & plain_) != 0) {
        plain_lanes::sample(surfaces_, views_, random_, directions_);
        for_each_lane(given_, [&](std::size_t place) {
            directions_.to_light.set(place, to_light_.of(place));
            directions_.facet_normal.set(place, surfaces_.normal.of(place));
            directions_.by_facet &= ~lane_bit(place);
        });
        plain_lanes::evaluate(places & plain_, surfaces_, views_, directions_.to_light, sampled_);
    }
    for_each_lane(places & ~plain_, [&](std::size_t place) {
        Single& single = *singles_[place];
        single.sample = single.bsdf.sample(single.view, random_.of(place));
    });
}

std::optional<BsdfSample> BsdfBlock::sampled(std::size_t place) const {
    if ((plain_ & lane_bit(place)) == 0) {
        return singles_[place]->sample;
    }
    const bool by_facet = (directions_.by_facet & lane_bit(place)) != 0;
    BsdfSample sample;
    sample.to_light = directions_.to_light.of(place);
    sample.facet_normal = directions_.facet_normal.of(place);
    if (by_facet) {
        sample.roughness = materials_[place]->roughness;
    } else {
        sample.lobe = BsdfLobe::diffuse;
    }
    return Bsdf::weighted(sample, {sampled_.reflected.of(place), sampled_.pdf[place]});
}

}  // namespace balcony::render
