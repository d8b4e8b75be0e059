// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/bsdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "shading/geometry/frame.hpp"

namespace balcony::render {

namespace {

using std::numbers::pi_v;

}  // namespace

Bsdf::Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal,
           bool entering)
    : material_(BsdfMaterial(appearance, entering)),
      normal_(normal),
      geometric_normal_(geometric_normal),
      coat_normal_(normal) {}

Bsdf::Bsdf(const BsdfMaterial& material, const V3f& normal, const V3f& geometric_normal)
    : material_(&material),
      normal_(normal),
      geometric_normal_(geometric_normal),
      coat_normal_(normal) {}

V3f Bsdf::lit_side() const {
    if (material().transmits()) {
        return V3f(0.0F);
    }
    return material().layers && material().layers->coat ? geometric_normal_ : normal_;
}

Bsdf::View Bsdf::view_from(const V3f& to_viewer) const {
    return material().layers ? View(layers_view_from(to_viewer)) : View(plain_view_from(to_viewer));
}

Bsdf::Value Bsdf::evaluate(const View& view, const V3f& to_light) const {
    const auto* const plain = std::get_if<PlainView>(&view.of_);
    return plain != nullptr ? evaluate_plain(*plain, to_light)
                            : evaluate_layers(std::get<LayersView>(view.of_), to_light);
}

Bsdf::Value Bsdf::evaluate(const V3f& to_viewer, const V3f& to_light) const {
    return evaluate(view_from(to_viewer), to_light);
}

std::optional<BsdfSample> Bsdf::sample(const View& view, const V3f& random) const {
    const auto* const plain = std::get_if<PlainView>(&view.of_);
    return plain != nullptr ? sample_plain(*plain, random)
                            : sample_layers(std::get<LayersView>(view.of_), random);
}

std::optional<BsdfSample> Bsdf::sample(const V3f& to_viewer, const V3f& random) const {
    return sample(view_from(to_viewer), random);
}

Bsdf::PlainView Bsdf::plain_view_from(const V3f& to_viewer) const {
    PlainView view;
    view.direction = to_viewer;
    view.cosine = normal_.dot(to_viewer);
    view.energy = material().energies.at(view.cosine);
    view.below = material().below(view.energy);
    const float specular = largest(material().specular.albedo(view.energy));
    const float diffuse = largest(material().diffuse) * view.below;
    view.specular = specular > 0.0F ? specular / (specular + diffuse) : 0.0F;
    return view;
}

Bsdf::Value Bsdf::evaluate_plain(const PlainView& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    if (cosine < min_cosine || view.cosine < min_cosine ||
        geometric_normal_.dot(to_light) <= 0.0F) {
        return {};
    }
    const LayerEnergy energy = material().energies.at(cosine);
    const float lambert = cosine / pi_v<float>;
    Value value{lambert * view.below * material().below(energy) * material().per_mean_below *
                    material().diffuse,
                (1.0F - view.specular) * lambert};
    if (!material().is_mirror()) {
        const HalfVector halfway(normal_, view.direction, to_light);
        const Microfacets at(material().facets, halfway, view.cosine, cosine);
        const float scale = view.energy.scale * energy.scale;
        value.reflected +=
            cosine * at.reflectance * material().specular.at_facet(schlick(halfway.viewer), scale);
        value.pdf += view.specular * at.pdf;
    }
    return value;
}

std::optional<BsdfSample> Bsdf::sample_plain(const PlainView& view, const V3f& random) const {
    const bool by_facet = random.x < view.specular;
    if (by_facet && material().is_mirror()) {
        return mirror_sample(
            view.direction,
            material().specular.at_facet(schlick(view.cosine), 1.0F) / view.specular);
    }
    const Frame frame(normal_);
    BsdfSample sample;
    if (by_facet) {
        sample.facet_normal = frame.to_world(
            material().facets.sample_visible(frame.to_local(view.direction), random.y, random.z));
        sample.to_light = mirrored(view.direction, sample.facet_normal).normalized();
        sample.roughness = material().roughness;
    } else {
        sample.facet_normal = normal_;
        sample.to_light = frame.to_world(sample_cosine(random.y, random.z)).normalized();
        sample.lobe = BsdfLobe::diffuse;
    }
    return weighted(sample, evaluate_plain(view, sample.to_light));
}

std::optional<BsdfSample> Bsdf::weighted(const BsdfSample& sample, const Value& value) {
    if (!(largest(value.reflected) > 0.0F) || !(value.pdf > 0.0F)) {
        return std::nullopt;
    }
    BsdfSample found = sample;
    found.pdf = value.pdf;
    found.weight = value.reflected / value.pdf;
    return found;
}

std::optional<BsdfSample> Bsdf::sample_mirror(const V3f& to_viewer) const {
    if (!material().is_mirror()) {
        return std::nullopt;
    }
    return mirror_sample(to_viewer, material().layers ? mirror_weight(layers_view_from(to_viewer))
                                                      : material().specular.at_facet(
                                                            schlick(normal_.dot(to_viewer)), 1.0F));
}

BsdfSample Bsdf::mirror_sample(const V3f& to_viewer, const Color3f& weight) const {
    BsdfSample sample;
    sample.facet_normal = normal_;
    if (mirrored(to_viewer, normal_).dot(geometric_normal_) <= 0.0F) {
        sample.facet_normal = geometric_normal_;
    }
    sample.to_light = mirrored(to_viewer, sample.facet_normal).normalized();
    sample.weight = weight;
    sample.delta = true;
    sample.roughness = 0.0F;
    return sample;
}

}  // namespace balcony::render
