// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/materials/bsdf.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

Bsdf::Bsdf(const Appearance& appearance, const V3f& normal, const V3f& side_normal, bool entering)
    : material_(BsdfMaterial(appearance, entering)),
      normal_(normal),
      side_normal_(side_normal),
      coat_normal_(normal) {}

Bsdf::Bsdf(const BsdfMaterial& material, const V3f& normal, const V3f& side_normal)
    : material_(&material), normal_(normal), side_normal_(side_normal), coat_normal_(normal) {}

V3f Bsdf::lit_side() const {
    if (material().transmits()) {
        return V3f(0.0F);
    }
    return material().layers && material().layers->coat ? side_normal_ : normal_;
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

PlainView Bsdf::plain_view_from(const V3f& to_viewer) const {
    const float cosine = normal_.dot(to_viewer);
    return plain_view(material(), to_viewer, cosine, material().energies.at(cosine));
}

Bsdf::Value Bsdf::evaluate_plain(const PlainView& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    if (!is_lit(cosine, view.cosine, side_normal_.dot(to_light))) {
        return {};
    }
    const PlainValue found =
        plain_value(material(), normal_, view, to_light, cosine, material().energies.at(cosine));
    return {found.reflected, found.pdf};
}

std::optional<BsdfSample> Bsdf::sample_plain(const PlainView& view, const V3f& random) const {
    if (material().is_mirror() && random.x < view.specular) {
        return mirror_sample(
            view.direction,
            material().specular.at_facet(schlick(view.cosine), 1.0F) / view.specular);
    }
    const PlainDirection found =
        plain_direction(material().facets, normal_, view.direction, view.specular, random);
    BsdfSample sample;
    sample.to_light = found.to_light;
    sample.facet_normal = found.facet_normal;
    if (found.by_facet) {
        sample.roughness = material().roughness;
    } else {
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

std::optional<BsdfSample> Bsdf::sample_passage(const V3f& to_viewer) const {
    if (!material().is_clear()) {
        return std::nullopt;
    }
    const LayersView view = layers_view_from(to_viewer);
    return view.cosine < min_cosine ? std::nullopt : sample_straight(view);
}

BsdfSample Bsdf::mirror_sample(const V3f& to_viewer, const Color3f& weight) const {
    BsdfSample sample;
    sample.facet_normal = normal_;
    if (mirrored(to_viewer, normal_).dot(side_normal_) <= 0.0F) {
        sample.facet_normal = side_normal_;
    }
    sample.to_light = mirrored(to_viewer, sample.facet_normal).normalized();
    sample.weight = weight;
    sample.delta = true;
    sample.roughness = 0.0F;
    return sample;
}

}  // namespace balcony::render
