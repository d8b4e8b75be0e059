// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A Bsdf with a clearcoat, sheen or transmission.

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "shading/geometry/frame.hpp"
#include "shading/materials/bsdf.hpp"

namespace balcony::render {

namespace {

using std::numbers::pi_v;

// Evenly on the unit hemisphere about z.
V3f sample_hemisphere(float u, float v) {
    const float radius = std::sqrt(std::max(1.0F - u * u, 0.0F));
    const Imath::V2f around = on_circle(v);
    return {radius * around.x, radius * around.y, u};
}

// The direction on the other side of a wall, or of a facet's horizon.
V3f through(const V3f& v, const V3f& normal) { return v - 2.0F * v.dot(normal) * normal; }

// Indices of LayersView::probability.
enum Lobe : std::size_t { coat_lobe, fibres_lobe, layer_lobe, diffuse_lobe, passage_lobe };
}  // namespace

CoatAt Bsdf::coat_at(const Covered& covered, const V3f& direction) const {
    if (!(covered.coat > 0.0F)) {
        return {};
    }
    const float cosine = coat_normal_.dot(direction);
    return coat_normal_ == normal_ ? CoatAt{cosine, covered.coat_energy.scale, covered.coat}
                                   : material().layers->tilted_coat(covered, cosine);
}

Bsdf::LayersView Bsdf::layers_view_from(const V3f& to_viewer) const {
    LayersView view;
    view.direction = to_viewer;
    view.cosine = normal_.dot(to_viewer);
    view.covered = material().covered(view.cosine);
    view.coat = coat_at(view.covered, to_viewer);
    view.below = passed_below(material(), view.covered.layer, view.covered.passed);
    const float shade = view.coat.shade;
    auto& weights = view.probability;
    weights[coat_lobe] = view.coat.cosine < min_cosine ? 0.0F : view.coat.reflected;
    weights[fibres_lobe] = shade * view.covered.fibres;
    weights[layer_lobe] = shade * largest(material().specular.albedo(view.covered.layer));
    weights[diffuse_lobe] = shade * largest(material().diffuse) * view.below;
    if (material().layers->passage) {
        const Passage& passage = *material().layers->passage;
        const float share = shade * passage.share * view.covered.passed;
        const Color3f reflected = passage.reflectance(view.cosine);
        weights[passage_lobe] = share * largest(passage.transmittance(reflected));
        if (passage.refracts) {
            weights[material().is_mirror() ? layer_lobe : passage_lobe] +=
                share * largest(reflected);
            view.lost =
                passage.lost * passage.energies.lost(passage.viewer_side(), view.cosine,
                                                     material().energies.at(view.cosine).single);
        }
    }
    float total = 0.0F;
    for (const float weight : weights) {
        total += weight;
    }
    for (float& weight : weights) {
        weight = total > 0.0F ? weight / total : 0.0F;
    }
    return view;
}

Bsdf::Value Bsdf::evaluate_layers(const LayersView& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    const float side = side_normal_.dot(to_light);
    if (view.cosine < min_cosine) {
        return {};
    }
    if (side > 0.0F) {
        return evaluate_above(view, to_light);
    }
    if (cosine > -min_cosine || side >= 0.0F || !material().transmits() || material().is_clear()) {
        return {};
    }
    return material().layers->passage->refracts ? evaluate_refracted(view, to_light)
                                                : evaluate_through_wall(view, to_light);
}

Bsdf::Value Bsdf::evaluate_above(const LayersView& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    const Covered& seen = view.covered;
    const Covered lit = material().covered(std::max(cosine, 0.0F));
    const CoatAt coat = coat_at(lit, to_light);
    Value value = evaluate_coat(view, coat, to_light);
    if (cosine < min_cosine) {
        return value;
    }
    const float shade = view.coat.shade * coat.shade;
    const float lambert = cosine / pi_v<float>;
    value.reflected += shade * lambert * view.below *
                       passed_below(material(), lit.layer, lit.passed) * material().per_mean_below *
                       material().diffuse;
    value.pdf += view.probability[diffuse_lobe] * lambert;
    const HalfVector halfway(normal_, view.direction, to_light);
    const float edge = schlick(halfway.viewer);
    if (seen.fibres > 0.0F) {
        const Fibres& fibres = *material().layers->fibres;
        // Of either direction that which the coat shades more: reciprocal, and never too much.
        const float scale =
            shade * seen.sheen.scale * lit.sheen.scale * (1.0F - std::max(seen.coat, lit.coat));
        value.reflected +=
            cosine * fibres.sheen.reflectance(view.cosine, cosine, halfway.squared_sine, scale) *
            fibres.color;
        value.pdf += view.probability[fibres_lobe] / (2.0F * pi_v<float>);
    }
    if (material().is_mirror()) {
        return value;
    }
    const Microfacets facets(material().facets, halfway, view.cosine, cosine);
    const float factor = shade * material().layers->cover_factor(seen, lit);
    const float scale = seen.layer.scale * lit.layer.scale;
    value.reflected +=
        cosine * facets.reflectance * factor * material().specular.at_facet(edge, scale);
    value.pdf += view.probability[layer_lobe] * facets.pdf;
    if (material().transmits() && material().layers->passage->refracts) {
        const Passage& glass = *material().layers->passage;
        const GlassSide side = glass.viewer_side();
        const float probability = view.probability[passage_lobe];
        const Color3f color = glass.reflectance(halfway.viewer);
        // Reciprocal, and together with the covers never too much.
        const float share = shade * glass.share * std::min(seen.passed, lit.passed);
        value.reflected += cosine * facets.reflectance * share * color;
        value.pdf +=
            probability * (1.0F - view.lost) * glass.reflection_probability(color) * facets.pdf;
        const float lost = glass.energies.lost(side, cosine, material().energies.at(cosine).single);
        value.reflected +=
            Color3f(lambert * share * view.lost * lost * glass.energies.scattered(side));
        value.pdf += probability * view.lost * glass.energies.share(side) * lambert;
    }
    return value;
}

// The coat reflects on its own side, where the layers below it may not.
Bsdf::Value Bsdf::evaluate_coat(const LayersView& view, const CoatAt& lit,
                                const V3f& to_light) const {
    if (lit.cosine < min_cosine || view.coat.cosine < min_cosine) {
        return {};
    }
    const Coat& coat = *material().layers->coat;
    const HalfVector halfway(coat_normal_, view.direction, to_light);
    const Microfacets at(coat.facets, halfway, view.coat.cosine, lit.cosine);
    const float color =
        coat.weight * coat_reflectance(schlick(halfway.viewer), view.coat.scale * lit.scale);
    return {Color3f(lit.cosine * at.reflectance * color), view.probability[coat_lobe] * at.pdf};
}

Bsdf::Value Bsdf::evaluate_through_wall(const LayersView& view, const V3f& to_light) const {
    const Passage& wall = *material().layers->passage;
    const V3f reflected = through(to_light, normal_);
    const float cosine = normal_.dot(reflected);
    const Covered lit = material().covered(cosine);
    const HalfVector halfway(normal_, view.direction, reflected);
    const Microfacets at(material().facets, halfway, view.cosine, cosine);
    const float all = view.coat.shade * coat_at(lit, -to_light).shade * view.covered.layer.scale *
                      lit.layer.scale * material().layers->cover_factor(view.covered, lit) *
                      wall.share;
    return {cosine * at.reflectance * all * wall.transmittance(wall.reflectance(halfway.viewer)),
            view.probability[passage_lobe] * at.pdf};
}

Bsdf::Value Bsdf::evaluate_refracted(const LayersView& view, const V3f& to_light) const {
    const Passage& glass = *material().layers->passage;
    const GlassSide side = glass.other_side();
    const float cosine = -normal_.dot(to_light);
    const float lambert = cosine / pi_v<float>;
    const LayerEnergy layer = material().energies.at(cosine);
    const float passed =
        glass.outside ? view.coat.shade * view.covered.passed : passed_outside(to_light);
    const float lost = glass.energies.lost(side, cosine, layer.single);
    Value value{lambert * view.lost * lost * glass.energies.scattered(side) * glass.tint,
                view.lost * glass.energies.share(side) * lambert};
    const RefractingFacet facet(normal_, view.direction, to_light, glass.eta);
    if (facet.viewer > 0.0F && facet.light > 0.0F) {
        const float density = material().facets.density(facet.cosine, facet.squared_sine) *
                              facet.viewer * facet.per_light;
        const float slant = material().facets.slant(view.cosine);
        const float masking =
            Ggx::masking(view.cosine, slant, cosine, material().facets.slant(cosine));
        const Color3f reflected = glass.reflectance(facet.viewer);
        value.reflected += 4.0F * cosine * masking * density * glass.transmittance(reflected);
        value.pdf += (1.0F - view.lost) * (1.0F - glass.reflection_probability(reflected)) *
                     density * Ggx::visible(view.cosine, slant);
    }
    return {glass.share * passed * value.reflected, view.probability[passage_lobe] * value.pdf};
}

// What the covers let pass of light on the outside that meets a viewer inside.
float Bsdf::passed_outside(const V3f& to_light) const {
    const float cosine = -normal_.dot(to_light);
    const Covered lit = material().layers->at(material().energies.at(cosine), cosine);
    return coat_at(lit, -to_light).shade * lit.passed;
}

Color3f Bsdf::mirror_weight(const LayersView& view) const {
    const CoatAt lit = coat_at(view.covered, mirrored(view.direction, normal_));
    Color3f weight = material().layers->cover_factor(view.covered, view.covered) *
                     material().specular.at_facet(schlick(view.cosine), 1.0F);
    if (material().transmits() && material().layers->passage->refracts) {
        const Passage& glass = *material().layers->passage;
        weight += glass.share * view.covered.passed * glass.reflectance(view.cosine);
    }
    return view.coat.shade * lit.shade * weight;
}

std::optional<BsdfSample> Bsdf::sample_straight(const LayersView& view) const {
    const Passage& passage = *material().layers->passage;
    BsdfSample sample;
    sample.facet_normal = normal_;
    sample.lobe = BsdfLobe::transmission;
    sample.transmitted = true;
    sample.delta = true;
    sample.roughness = 0.0F;
    float passed = view.coat.shade * view.covered.passed;
    if (passage.refracts) {
        sample.to_light = refracted(view.direction, normal_, view.cosine, passage.eta).normalized();
        sample.eta = 1.0F / passage.eta;
        if (!passage.outside) {
            passed = passed_outside(sample.to_light);
        }
    } else {
        sample.to_light = -view.direction;
        passed =
            square(view.coat.shade) * material().layers->cover_factor(view.covered, view.covered);
    }
    if (side_normal_.dot(sample.to_light) >= 0.0F) {
        return std::nullopt;
    }
    sample.weight =
        passage.share * passed * passage.transmittance(passage.reflectance(view.cosine));
    return sample;
}

// A direction by a lobe that is not a delta lobe, without its density.
BsdfSample Bsdf::sample_lobe(const LayersView& view, std::size_t lobe, const V3f& random) const {
    const Frame frame(lobe == coat_lobe ? coat_normal_ : normal_);
    const auto sample_facet = [&](const Ggx& facets) {
        return frame.to_world(
            facets.visible_facet(frame.to_local(view.direction), on_circle(random.y), random.z));
    };
    BsdfSample sample;
    sample.facet_normal = normal_;
    switch (lobe) {
        case coat_lobe:
            sample.facet_normal = sample_facet(material().layers->coat->facets);
            sample.to_light = mirrored(view.direction, sample.facet_normal);
            sample.roughness = material().layers->coat->roughness;
            break;
        case fibres_lobe:
            sample.to_light = frame.to_world(sample_hemisphere(random.y, random.z));
            sample.lobe = BsdfLobe::diffuse;
            break;
        case diffuse_lobe:
            sample.to_light = frame.to_world(sample_cosine(random.y, random.z));
            sample.lobe = BsdfLobe::diffuse;
            break;
        default:
            sample.facet_normal = sample_facet(material().facets);
            sample.to_light = mirrored(view.direction, sample.facet_normal);
            sample.roughness = material().roughness;
    }
    if (lobe == passage_lobe) {
        pass(view, random, frame, sample);
    }
    sample.to_light.normalize();
    return sample;
}

// Makes a sample that is reflected by a facet pass the surface, or leave it in another way.
void Bsdf::pass(const LayersView& view, const V3f& random, const Frame& frame,
                BsdfSample& sample) const {
    const Passage& passage = *material().layers->passage;
    if (!passage.refracts) {
        sample.to_light = through(sample.to_light, normal_);
        sample.transmitted = true;
    } else if (random.x < view.lost) {
        const float back = view.lost * passage.energies.share(passage.viewer_side());
        sample.transmitted = random.x >= back;
        sample.facet_normal = normal_;
        sample.roughness = 1.0F;
        sample.to_light = frame.to_world(sample_cosine(random.y, random.z));
        if (sample.transmitted) {
            sample.to_light = through(sample.to_light, normal_);
        }
    } else {
        const float cosine = view.direction.dot(sample.facet_normal);
        const float rest = (random.x - view.lost) / (1.0F - view.lost);
        if (rest >= passage.reflection_probability(passage.reflectance(cosine))) {
            sample.to_light = refracted(view.direction, sample.facet_normal, cosine, passage.eta);
            sample.transmitted = true;
        }
    }
    if (sample.transmitted) {
        sample.lobe = BsdfLobe::transmission;
        sample.eta = passage.refracts ? 1.0F / passage.eta : 1.0F;
    }
}

std::optional<BsdfSample> Bsdf::sample_layers(const LayersView& view, const V3f& random) const {
    std::size_t lobe = 0;
    float rest = random.x;
    while (lobe < passage_lobe && rest >= view.probability[lobe]) {
        rest -= view.probability[lobe++];
    }
    const float probability = view.probability[lobe];
    if (!(probability > 0.0F) || view.cosine < min_cosine) {
        return std::nullopt;
    }
    const bool reflects = lobe == layer_lobe && material().is_mirror();
    if (reflects || (lobe == passage_lobe && material().is_clear())) {
        std::optional<BsdfSample> sample =
            reflects ? std::optional(mirror_sample(view.direction, mirror_weight(view)))
                     : sample_straight(view);
        if (sample) {
            sample->weight /= probability;
        }
        return sample;
    }
    BsdfSample sample = sample_lobe(view, lobe, {rest / probability, random.y, random.z});
    const V3f& side = lobe == coat_lobe ? coat_normal_ : normal_;
    if (sample.transmitted != (side.dot(sample.to_light) < 0.0F) ||
        sample.transmitted != (side_normal_.dot(sample.to_light) < 0.0F)) {
        return std::nullopt;
    }
    return weighted(sample, evaluate_layers(view, sample.to_light));
}

}  // namespace balcony::render
