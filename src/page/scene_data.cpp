// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "page/scene_data.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <limits>
#include <map>
#include <span>
#include <vector>

#include <nlohmann/json.hpp>

#include "page/textures.hpp"

namespace balcony::page {

namespace {

using nlohmann::json;

/// A number of a unit vector as 16 bits, which is off by at most 1.6e-5.
std::int16_t quantised(float value) {
    return static_cast<std::int16_t>(std::lround(std::clamp(value, -1.0F, 1.0F) * 32767.0F));
}

std::uint8_t byte_of(float value) {
    return static_cast<std::uint8_t>(std::lround(std::clamp(value, 0.0F, 1.0F) * 255.0F));
}

// The coordinates of points, one after another.
template <class Point>
std::span<const float> numbers_of(const std::vector<Point>& points) {
    static_assert(sizeof(Point) % sizeof(float) == 0);
    return {reinterpret_cast<const float*>(points.data()),
            points.size() * (sizeof(Point) / sizeof(float))};
}

json mesh_data(const scene::Mesh& mesh, Blob& blob) {
    json made{{"vertices", mesh.positions.size()},
              {"triangles", mesh.triangles.size()},
              {"material", mesh.material.value()},
              {"positions", blob.add(numbers_of(mesh.positions))}};
    if (!mesh.normals.empty()) {
        std::vector<std::int16_t> normals;
        for (const scene::V3f& normal : mesh.normals) {
            normals.insert(normals.end(),
                           {quantised(normal.x), quantised(normal.y), quantised(normal.z)});
        }
        made["normals"] = blob.add(std::span<const std::int16_t>(normals));
    }
    for (const std::vector<scene::V2f>& all : mesh.texture_coordinates) {
        made["coordinates"].push_back(all.empty() ? json() : json(blob.add(numbers_of(all))));
    }
    if (!mesh.colors.empty()) {
        std::vector<std::uint8_t> colors;
        for (const scene::Color4f& color : mesh.colors) {
            colors.insert(colors.end(),
                          {byte_of(color.r), byte_of(color.g), byte_of(color.b), byte_of(color.a)});
        }
        made["colors"] = blob.add(std::span<const std::uint8_t>(colors));
    }
    // Two bytes for a corner where they suffice.
    if (mesh.positions.size() <= std::numeric_limits<std::uint16_t>::max()) {
        std::vector<std::uint16_t> corners;
        for (const auto& triangle : mesh.triangles) {
            std::transform(triangle.begin(), triangle.end(), std::back_inserter(corners),
                           [](std::uint32_t corner) { return static_cast<std::uint16_t>(corner); });
        }
        made["corners"] = blob.add(std::span<const std::uint16_t>(corners));
    } else {
        made["corners"] = blob.add(std::span<const std::array<std::uint32_t, 3>>(mesh.triangles));
    }
    return made;
}

/// By columns, the last one being the translation: 12 numbers.
json placement_data(const scene::M44d& m) {
    json made = json::array();
    for (int row = 0; row < 4; ++row) {
        for (int axis = 0; axis < 3; ++axis) {
            made.push_back(m[row][axis]);
        }
    }
    return made;
}

json color_data(const scene::Color3f& color) { return {color.x, color.y, color.z}; }

class MaterialWriter {
public:
    explicit MaterialWriter(const std::set<scene::TextureIndex>& textures) {
        for (const scene::TextureIndex index : textures) {
            numbers_.emplace(index, numbers_.size());
        }
    }

    [[nodiscard]] json data(const scene::Material& material) const {
        static constexpr std::array modes{"opaque", "mask", "blend"};
        const auto [base, opacity, emission, normal] = shown_uses(material);
        return {{"baseColor", color_data(material.base_color)},
                {"baseColorTexture", use_data(*base)},
                {"alphaMode", modes[static_cast<std::size_t>(material.alpha_mode)]},
                {"alpha", material.alpha},
                {"cutoff", material.alpha_cutoff},
                {"opacityTexture", use_data(*opacity)},
                {"emission", color_data(material.emission)},
                {"emissionTexture", use_data(*emission)},
                {"normalScale", material.normal_scale},
                {"normalTexture", use_data(*normal)},
                {"unlit", material.unlit}};
    }

private:
    [[nodiscard]] json use_data(const scene::TextureUse& use) const {
        if (!use.valid() || !numbers_.contains(use.index)) {
            return nullptr;
        }
        return {{"texture", numbers_.at(use.index)},
                {"srgb", use.encoding == scene::TextureEncoding::srgb},
                {"coordinates", use.coordinates},
                {"channel", use.channel},
                {"offset", {use.offset.x, use.offset.y}},
                {"u", {use.u_axis.x, use.u_axis.y}},
                {"v", {use.v_axis.x, use.v_axis.y}}};
    }

    std::map<scene::TextureIndex, std::size_t> numbers_;
};

}  // namespace

json scene_data(const scene::Scene& scene, const std::set<scene::TextureIndex>& textures,
                Blob& blob) {
    // Meshes that stand nowhere are left out.
    std::map<scene::MeshIndex, std::size_t> numbers;
    json meshes = json::array();
    json instances = json::array();
    for (const scene::Instance& instance : scene.instances) {
        const auto [entry, is_new] = numbers.try_emplace(instance.mesh, meshes.size());
        if (is_new) {
            meshes.push_back(mesh_data(*scene.meshes[instance.mesh.value()], blob));
        }
        instances.push_back(
            {{"mesh", entry->second}, {"place", placement_data(instance.world_from_mesh)}});
    }
    json materials = json::array();
    const MaterialWriter writer(textures);
    for (const scene::Material& material : scene.materials) {
        materials.push_back(writer.data(material));
    }
    return {{"meshes", std::move(meshes)},
            {"instances", std::move(instances)},
            {"materials", std::move(materials)}};
}

}  // namespace balcony::page
