// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "common/scene_builder.hpp"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <memory>
#include <numbers>

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

scene::NodeIndex SceneBuilder::turntable(const V3d& place, double seconds, int turns,
                                         double start) {
    // A key for each quarter of a turn, since a rotation takes the shorter way to the next.
    scene::Track track;
    track.width = 4;
    for (int quarter = 0; quarter <= 4 * turns; ++quarter) {
        const double half_angle = 0.5 * start + 0.25 * std::numbers::pi * quarter;
        track.times.push_back(0.25 * seconds * quarter);
        track.values.insert(track.values.end(),
                            {0.0F, 0.0F, static_cast<float>(std::sin(half_angle)),
                             static_cast<float>(std::cos(half_angle))});
    }
    motion_.animations.push_back({"turning", track.times.back(), 1});
    scene::Node node;
    node.translation = place;
    node.rotation_track = scene::TrackIndex(motion_.tracks.size());
    motion_.tracks.push_back(std::move(track));
    motion_.nodes.push_back(node);
    return scene::NodeIndex(motion_.nodes.size() - 1);
}

void SceneBuilder::place_on(scene::NodeIndex turntable, std::string name, scene::MeshIndex mesh) {
    motion_.instances.push_back({scene_.instances.size(), turntable});
    place(std::move(name), mesh, world_from_node(motion_, turntable, 0.0));
}

void SceneBuilder::light(scene::Light light) { scene_.lights.push_back(std::move(light)); }

Result<scene::Scene> SceneBuilder::finish() && {
    if (!problems_.empty()) {
        return std::move(problems_);
    }
    if (!motion_.nodes.empty()) {
        scene_.motion = std::make_shared<const scene::Motion>(std::move(motion_));
    }
    return std::move(scene_);
}

}  // namespace balcony::plates
