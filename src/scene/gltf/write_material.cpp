// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/gltf/write_material.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::scene {

namespace {

using nlohmann::json;

json array_of(const Color3f& color) { return {color.x, color.y, color.z}; }

class MaterialWriter {
public:
    MaterialWriter(const Material& material, std::set<std::string>& extensions)
        : m_(material), extensions_(extensions) {}

    json write() {
        json written = {{"name", m_.name}, {"pbrMetallicRoughness", surface()}};
        add_normal_map(written, "normalTexture", m_.normal_texture, m_.normal_scale);
        add_emission(written);
        if (m_.alpha_mode == AlphaMode::mask) {
            written["alphaMode"] = "MASK";
            written["alphaCutoff"] = m_.alpha_cutoff;
        } else if (m_.alpha_mode == AlphaMode::blend) {
            written["alphaMode"] = "BLEND";
        }
        if (m_.double_sided) {
            written["doubleSided"] = true;
        }
        add_dielectric(written);
        add_transmission(written);
        add_coats(written);
        if (m_.unlit) {
            extension(written, "KHR_materials_unlit") = json::object();
        }
        return written;
    }

private:
    json& extension(json& owner, const std::string& name) {
        extensions_.insert(name);
        return owner["extensions"][name];
    }

    void add_texture(json& owner, const char* key, const TextureUse& use) {
        if (!use.valid()) {
            return;
        }
        json& info = owner[key];
        info["index"] = use.index.value();
        if (use.coordinates != 0) {
            info["texCoord"] = use.coordinates;
        }
        const V2f& u = use.u_axis;
        const V2f& v = use.v_axis;
        if (use.offset == V2f(0.0F) && u == V2f(1.0F, 0.0F) && v == V2f(0.0F, 1.0F)) {
            return;
        }
        // The axes are the columns of a rotation times a scale.
        const float angle = std::atan2(-u.y, u.x);
        const float along_v = std::sin(angle) * v.x + std::cos(angle) * v.y;
        extension(info, "KHR_texture_transform") = {{"offset", {use.offset.x, use.offset.y}},
                                                    {"rotation", angle},
                                                    {"scale", {u.length(), along_v}}};
    }

    json surface() {
        json written = {
            {"baseColorFactor", {m_.base_color.x, m_.base_color.y, m_.base_color.z, m_.alpha}},
            {"metallicFactor", m_.metallic},
            {"roughnessFactor", m_.roughness}};
        add_texture(written, "baseColorTexture", m_.base_color_texture);
        const bool one_texture = m_.roughness_texture.shares_texels(m_.metallic_texture);
        if (one_texture || m_.metallic == 0.0F) {
            add_texture(written, "metallicRoughnessTexture", m_.roughness_texture);
        }
        return written;
    }

    void add_normal_map(json& written, const char* key, const TextureUse& use, float scale) {
        add_texture(written, key, use);
        if (use.valid() && scale != 1.0F) {
            written[key]["scale"] = scale;
        }
    }

    // A factor is at most 1.
    void add_emission(json& written) {
        const float strength = std::max({m_.emission.x, m_.emission.y, m_.emission.z});
        if (strength > 1.0F) {
            extension(written, "KHR_materials_emissive_strength")["emissiveStrength"] = strength;
            written["emissiveFactor"] = array_of(m_.emission / strength);
        } else if (strength > 0.0F) {
            written["emissiveFactor"] = array_of(m_.emission);
        }
        add_texture(written, "emissiveTexture", m_.emission_texture);
    }

    void add_dielectric(json& written) {
        if (m_.ior != Material().ior) {
            extension(written, "KHR_materials_ior")["ior"] = m_.ior;
        }
        if (m_.specular == 1.0F && m_.specular_color == Color3f(1.0F)) {
            return;
        }
        json& specular = extension(written, "KHR_materials_specular");
        specular = {{"specularFactor", m_.specular},
                    {"specularColorFactor", array_of(m_.specular_color)}};
        add_texture(specular, "specularTexture", m_.specular_texture);
        add_texture(specular, "specularColorTexture", m_.specular_color_texture);
    }

    void add_transmission(json& written) {
        if (m_.transmission > 0.0F) {
            json& through = extension(written, "KHR_materials_transmission");
            through["transmissionFactor"] = m_.transmission;
            add_texture(through, "transmissionTexture", m_.transmission_texture);
        }
        if (m_.thin_walled) {
            return;
        }
        // Any thickness states that there is a volume.
        json& volume = extension(written, "KHR_materials_volume");
        volume["thicknessFactor"] = 1.0F;
        const float strongest = std::max({m_.absorption.x, m_.absorption.y, m_.absorption.z});
        if (strongest > 0.0F) {
            const Color3f depth = m_.absorption / strongest;
            volume["attenuationDistance"] = 1.0F / strongest;
            volume["attenuationColor"] = {std::exp(-depth.x), std::exp(-depth.y),
                                          std::exp(-depth.z)};
        }
    }

    void add_coats(json& written) {
        if (m_.clearcoat > 0.0F) {
            json& coat = extension(written, "KHR_materials_clearcoat");
            coat = {{"clearcoatFactor", m_.clearcoat},
                    {"clearcoatRoughnessFactor", m_.clearcoat_roughness}};
            add_texture(coat, "clearcoatTexture", m_.clearcoat_texture);
            add_texture(coat, "clearcoatRoughnessTexture", m_.clearcoat_roughness_texture);
            add_normal_map(coat, "clearcoatNormalTexture", m_.clearcoat_normal_texture,
                           m_.clearcoat_normal_scale);
        }
        if (m_.sheen_color != Color3f(0.0F)) {
            json& sheen = extension(written, "KHR_materials_sheen");
            sheen = {{"sheenColorFactor", array_of(m_.sheen_color)},
                     {"sheenRoughnessFactor", m_.sheen_roughness}};
            add_texture(sheen, "sheenColorTexture", m_.sheen_color_texture);
            add_texture(sheen, "sheenRoughnessTexture", m_.sheen_roughness_texture);
        }
    }

    const Material& m_;
    std::set<std::string>& extensions_;
};

}  // namespace

json gltf_material(const Material& material, std::set<std::string>& extensions) {
    return MaterialWriter(material, extensions).write();
}

}  // namespace balcony::scene
