// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bsdf_support.hpp"

#include <algorithm>
#include <cstdint>
#include <numbers>

#include "shading/geometry/frame.hpp"

namespace balcony::render::test {

namespace {

constexpr Color3f gold(0.9F, 0.5F, 0.2F);

float radical_inverse(std::uint32_t base, std::size_t index) {
    double result = 0.0;
    double digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= base;
        result += digit * static_cast<double>(index % base);
    }
    return std::min(static_cast<float>(result), std::nextafter(1.0F, 0.0F));
}

}  // namespace

Appearance dielectric(float roughness, const Color3f& color) {
    Appearance made;
    made.base_color = color;
    made.emission = Color3f(0.0F);
    made.roughness = roughness;
    return made;
}

Appearance metal(float roughness, const Color3f& color) {
    Appearance made = dielectric(roughness, color);
    made.metallic = 1.0F;
    return made;
}

Appearance coated(Appearance appearance, float roughness) {
    appearance.clearcoat = 1.0F;
    appearance.clearcoat_roughness = roughness;
    return appearance;
}

Appearance fibrous(Appearance appearance, float roughness, const Color3f& color) {
    appearance.sheen_color = color;
    appearance.sheen_roughness = roughness;
    return appearance;
}

Appearance wall(float roughness, const Color3f& color) {
    Appearance made = dielectric(roughness, color);
    made.transmission = 1.0F;
    return made;
}

Appearance glass(float roughness, float ior, const Color3f& color) {
    Appearance made = wall(roughness, color);
    made.thin_walled = false;
    made.ior = ior;
    return made;
}

std::vector<NamedAppearance> all_kinds() {
    std::vector<NamedAppearance> all;
    for (const float roughness : {0.0F, 0.3F, 0.6F, 1.0F}) {
        const std::string suffix = " " + std::to_string(roughness);
        Appearance both = dielectric(roughness, gold);
        both.metallic = 0.4F;
        both.ior = 1.8F;
        both.specular = 0.7F;
        both.specular_color = Color3f(0.5F, 1.0F, 2.0F);
        Appearance everything = fibrous(coated(both, 0.4F), 0.6F, {0.2F, 0.5F, 0.8F});
        everything.clearcoat = 0.6F;
        everything.transmission = 0.5F;
        const V3f tilted = V3f(0.3F, -0.2F, 0.9F).normalized();
        Appearance solid = everything;
        solid.thin_walled = false;
        all.insert(all.end(),
                   {{"dielectric" + suffix, dielectric(roughness, gold)},
                    {"metal" + suffix, metal(roughness, gold)},
                    {"both" + suffix, both},
                    {"coated" + suffix, coated(metal(roughness, gold), 0.3F)},
                    {"fibrous" + suffix, fibrous(dielectric(roughness, gold), 0.5F, gold)},
                    {"wall" + suffix, wall(roughness, gold)},
                    {"glass" + suffix, glass(roughness, 1.5F, gold)},
                    {"glass from inside" + suffix, glass(roughness, 1.5F, gold), false},
                    {"everything" + suffix, everything},
                    {"solid" + suffix, solid},
                    {"solid from inside" + suffix, solid, false},
                    {"tilted" + suffix, coated(dielectric(roughness, gold), 0.3F), true, tilted},
                    {"tilted on everything" + suffix, everything, true, tilted},
                    {"tilted on a solid" + suffix, solid, true, tilted},
                    {"tilted on a solid, from inside" + suffix, solid, false, tilted}});
    }
    return all;
}

Bsdf on_plane(const NamedAppearance& material, const V3f& normal) {
    Bsdf made(material.appearance, normal, normal, material.entering);
    made.set_coat_normal(Frame(normal).to_world(material.coat_normal));
    return made;
}

Bsdf flat(const NamedAppearance& material) { return on_plane(material, {0.0F, 0.0F, 1.0F}); }

Bsdf flat(const Appearance& appearance) { return flat(NamedAppearance{{}, appearance}); }

V3f at_cosine(float cosine) { return {std::sqrt(1.0F - cosine * cosine), 0.0F, cosine}; }

float brightest(const Color3f& color) { return std::max({color.x, color.y, color.z}); }

V3f Directions::on_sphere() {
    const float z = 2.0F * uniform() - 1.0F;
    const float angle = 2.0F * std::numbers::pi_v<float> * uniform();
    const float radius = std::sqrt(std::max(1.0F - z * z, 0.0F));
    return V3f(radius * std::cos(angle), radius * std::sin(angle), z).normalized();
}

V3f Directions::above(const V3f& normal, float min_cosine) {
    for (;;) {
        if (const V3f v = on_sphere(); v.dot(normal) > min_cosine) {
            return v;
        }
    }
}

NamedAppearance Directions::material() {
    // 0, 1 or between, each as often.
    const auto part = [this] { return std::clamp(3.0F * uniform() - 1.0F, 0.0F, 1.0F); };
    const auto color = [&] { return Color3f(part(), part(), part()); };
    Appearance made;
    made.base_color = color();
    made.emission = Color3f(0.0F);
    made.metallic = part();
    made.roughness = part();
    // Few, since each rough glass has tables of its own.
    made.ior =
        std::vector{1.1F, 1.33F, 1.5F, 2.0F, 3.0F}[static_cast<std::size_t>(5.0F * uniform())];
    made.specular = part();
    made.specular_color = 3.0F * color();
    made.transmission = part();
    made.thin_walled = uniform() < 0.5F;
    made.clearcoat = part();
    made.clearcoat_roughness = part();
    made.sheen_color = color();
    made.sheen_roughness = part();
    const V3f up(0.0F, 0.0F, 1.0F);
    const V3f coat_normal = uniform() < 0.5F ? above(up, 0.5F) : up;
    return {"random", made, uniform() < 0.5F, coat_normal};
}

Color3f albedo(const Bsdf& bsdf, const V3f& to_viewer, std::size_t samples) {
    Color3f total(0.0F);
    for (std::size_t i = 0; i < samples; ++i) {
        const V3f point((static_cast<float>(i) + 0.5F) / static_cast<float>(samples),
                        radical_inverse(2, i), radical_inverse(3, i));
        if (const auto sample = bsdf.sample(to_viewer, point)) {
            total += sample->weight / static_cast<float>(samples);
        }
    }
    return total;
}

}  // namespace balcony::render::test
