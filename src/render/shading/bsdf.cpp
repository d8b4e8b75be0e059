// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/shading/bsdf.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "render/shading/frame.hpp"

namespace balcony::render {

namespace {

using std::numbers::pi_v;

// KHR_materials_specular, with KHR_materials_ior.
Color3f dielectric_reflectance(const Appearance& appearance) {
    const Color3f f0 = normal_reflectance(appearance.ior) * appearance.specular_color;
    return appearance.specular *
           Color3f(std::min(f0.x, 1.0F), std::min(f0.y, 1.0F), std::min(f0.z, 1.0F));
}

// The width of GGX; 0 of a mirror.
float width(float roughness) {
    const float alpha = square(roughness);
    return alpha < min_alpha ? 0.0F : alpha;
}

}  // namespace

Bsdf::Bsdf(const Appearance& appearance, const V3f& normal, const V3f& geometric_normal,
           bool entering)
    : diffuse_((1.0F - appearance.metallic) * (1.0F - appearance.transmission) *
               appearance.base_color),
      metal_(appearance.metallic * appearance.base_color),
      roughness_(width(appearance.roughness) > 0.0F ? appearance.roughness : 0.0F),
      facets_(width(appearance.roughness)),
      energies_(width(appearance.roughness)),
      normal_(normal),
      geometric_normal_(geometric_normal) {
    const float metallic = appearance.metallic;
    if (metallic > 0.0F) {
        const Color3f& color = appearance.base_color;
        specular_.add(Color3f(metallic), color, Color3f(1.0F), color);
    }
    if (metallic < 1.0F) {
        const Color3f f0 = dielectric_reflectance(appearance);
        const Color3f f90(appearance.specular);
        const float opaque = (1.0F - metallic) * (1.0F - appearance.transmission);
        specular_.add(Color3f(opaque), f0, f90, f0);
        dielectric_.add(1.0F, largest(f0), appearance.specular, largest(f0));
        if (appearance.transmission > 0.0F) {
            add_passage(appearance, f0, entering);
        }
    }
    if (appearance.clearcoat > 0.0F || largest(appearance.sheen_color) > 0.0F) {
        add_covers(appearance);
    }
    const float mean = layers_ ? mean_below_covers() : below(energies_.mean());
    per_mean_below_ = mean > 0.0F ? 1.0F / mean : 0.0F;
}

void Bsdf::add_passage(const Appearance& appearance, const Color3f& f0, bool entering) {
    layers_.emplace().passage.emplace(appearance, width(roughness_), f0, appearance.specular,
                                      entering);
    const Passage& passage = *layers_->passage;
    if (!passage.refracts) {
        specular_.add(Color3f(passage.share), f0, Color3f(passage.f90), Color3f(1.0F));
    }
}

void Bsdf::add_covers(const Appearance& appearance) {
    if (!layers_) {
        layers_.emplace();
    }
    if (appearance.clearcoat > 0.0F) {
        layers_->coat.emplace(appearance, width(roughness_));
    }
    if (largest(appearance.sheen_color) > 0.0F) {
        layers_->fibres.emplace(appearance, width(roughness_));
    }
}

float Bsdf::below(const LayerEnergy& energy, float reaching) const {
    return std::max(reaching - dielectric_.albedo(energy), 0.0F);
}

Bsdf::View Bsdf::view_from(const V3f& to_viewer) const {
    return layers_ ? View(layers_view_from(to_viewer)) : View(plain_view_from(to_viewer));
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
    view.energy = energies_.at(view.cosine);
    view.below = below(view.energy);
    const float specular = largest(specular_.albedo(view.energy));
    const float diffuse = largest(diffuse_) * view.below;
    view.specular = specular > 0.0F ? specular / (specular + diffuse) : 0.0F;
    return view;
}

Bsdf::Value Bsdf::evaluate_plain(const PlainView& view, const V3f& to_light) const {
    const float cosine = normal_.dot(to_light);
    if (cosine < min_cosine || view.cosine < min_cosine ||
        geometric_normal_.dot(to_light) <= 0.0F) {
        return {};
    }
    const LayerEnergy energy = energies_.at(cosine);
    const float lambert = cosine / pi_v<float>;
    Value value{lambert * view.below * below(energy) * per_mean_below_ * diffuse_,
                (1.0F - view.specular) * lambert};
    if (!is_mirror()) {
        const HalfVector halfway(normal_, view.direction, to_light);
        const Microfacets at(facets_, halfway, view.cosine, cosine);
        const float scale = view.energy.scale * energy.scale;
        value.reflected +=
            cosine * at.reflectance * specular_.at_facet(schlick(halfway.viewer), scale);
        value.pdf += view.specular * at.pdf;
    }
    return value;
}

std::optional<BsdfSample> Bsdf::sample_plain(const PlainView& view, const V3f& random) const {
    const bool by_facet = random.x < view.specular;
    if (by_facet && is_mirror()) {
        return mirror_sample(view.direction,
                             specular_.at_facet(schlick(view.cosine), 1.0F) / view.specular);
    }
    const Frame frame(normal_);
    BsdfSample sample;
    if (by_facet) {
        sample.facet_normal = frame.to_world(
            facets_.sample_visible(frame.to_local(view.direction), random.y, random.z));
        sample.to_light = mirrored(view.direction, sample.facet_normal).normalized();
        sample.roughness = roughness_;
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
    if (!is_mirror()) {
        return std::nullopt;
    }
    return mirror_sample(to_viewer,
                         layers_ ? mirror_weight(layers_view_from(to_viewer))
                                 : specular_.at_facet(schlick(normal_.dot(to_viewer)), 1.0F));
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

bool Bsdf::is_rough() const {
    constexpr float wide = 0.3F;
    const bool coat_is_rough = !layers_ || !layers_->coat || layers_->coat->roughness > wide;
    return roughness_ > wide && coat_is_rough && !transmits();
}

Color3f Bsdf::ambient_reflectance() const { return is_mirror() ? diffuse_ : diffuse_ + metal_; }

}  // namespace balcony::render
