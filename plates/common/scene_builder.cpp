// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include <fmt/format.h>

namespace balcony::plates {

scene::Color3f tint(std::uint32_t rrggbb) { return scene::Color3f(from_srgb(rrggbb)); }

SceneBuilder::SceneBuilder(std::string name, const SceneOptions& options) : options_(options) {
    scene_.name = std::move(name);
    scene_.axes = Axes::z_up;
}

scene::MaterialIndex SceneBuilder::material(scene::Material material) {
    scene_.materials.push_back(std::move(material));
    return scene::MaterialIndex(scene_.materials.size() - 1);
}

scene::MaterialIndex SceneBuilder::material(std::string name, const scene::Color3f& color,
                                            float roughness, scene::TextureIndex texture) {
    scene::Material made;
    made.name = std::move(name);
    made.base_color = color;
    made.roughness = roughness;
    made.base_color_texture.index = texture;
    return material(std::move(made));
}

scene::TextureIndex SceneBuilder::texture(std::string name, int width, int height,
                                          const Painter& painter, scene::Wrap wrap,
                                          scene::TextureEncoding encoding, Sampling sampling) {
    const auto scaled = [this](int pixels) {
        return std::max(1, static_cast<int>(std::lround(pixels * options_.texture_scale)));
    };
    std::vector<std::uint8_t> png =
        to_png(paint(scaled(width), scaled(height), painter, encoding, sampling));
    if (png.empty()) {
        problems_.push_back(error(fmt::format("cannot encode '{}' as PNG", name), {},
                                  "OpenImageIO was built without PNG support"));
    }
    scene_.textures.push_back({std::move(name), {}, std::move(png), wrap, wrap});
    return scene::TextureIndex(scene_.textures.size() - 1);
}

scene::TextureIndex SceneBuilder::hung_picture(std::string_view name) {
    const std::string file = fmt::format("{}/pictures/{}.jpg", BALCONY_PLATES, name);
    std::ifstream stream(file, std::ios::binary);
    std::vector<std::uint8_t> bytes{std::istreambuf_iterator<char>(stream), {}};
    if (bytes.empty()) {
        problems_.push_back(error(fmt::format("cannot read the picture {}", file), {},
                                  fmt::format("run scripts/plates --pictures {}", name)));
    }
    scene_.textures.push_back(
        {std::string(name), {}, std::move(bytes), scene::Wrap::clamp, scene::Wrap::clamp});
    return scene::TextureIndex(scene_.textures.size() - 1);
}

scene::MeshIndex SceneBuilder::mesh(std::string name, scene::Mesh mesh,
                                    scene::MaterialIndex material) {
    mesh.name = std::move(name);
    mesh.material = material;
    scene_.meshes.push_back(std::move(mesh));
    return scene::MeshIndex(scene_.meshes.size() - 1);
}

void SceneBuilder::place(std::string name, scene::MeshIndex mesh, const M44d& world_from_mesh) {
    scene_.instances.push_back(
        {mesh, world_from_mesh, static_cast<std::uint32_t>(scene_.objects.size())});
    scene_.objects.push_back({std::move(name)});
}

void SceneBuilder::light(scene::Light light) { scene_.lights.push_back(std::move(light)); }

Result<scene::Scene> SceneBuilder::finish() && {
    if (!problems_.empty()) {
        return std::move(problems_);
    }
    return std::move(scene_);
}

}  // namespace balcony::plates
