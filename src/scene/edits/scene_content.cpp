// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <span>
#include <string>
#include <type_traits>
#include <vector>

#include "balcony/content_hash.hpp"
#include "balcony/scene_edits.hpp"

namespace balcony::scene {

namespace {

/// Hashes numbers and texts, each sequence with its length.
class SceneHash {
public:
    template <class T>
    void add(std::span<const T> values) {
        static_assert(std::is_standard_layout_v<T>);  // Numbers, without anything between them.
        const std::size_t count = values.size();
        hash_.add(std::as_bytes(std::span(&count, 1)));
        hash_.add(std::as_bytes(values));
    }
    template <class T>
    void add(const std::vector<T>& values) {
        add(std::span<const T>(values));
    }
    void add(const std::string& text) { add(std::span<const char>(text)); }
    void add(double number) { add(std::span<const double>(&number, 1)); }

    void add(const Mesh& mesh) {
        add(mesh.positions);
        add(mesh.normals);
        add(mesh.tangents);
        for (const auto& set : mesh.texture_coordinates) {
            add(set);
        }
        add(mesh.colors);
        add(mesh.triangles);
        add(mesh.material.value());
    }
    void add(const Instance& instance) {
        add(instance.mesh.value());
        add(instance.object);
        add(std::span<const double>(instance.world_from_mesh[0], 16));
    }
    template <class Part>
    void add(const Part& part, std::span<const PropertyInfo> properties) {
        add(part.name);
        for (const PropertyInfo& one : properties) {
            add(*property_of(part, one.name));
        }
    }

    [[nodiscard]] std::uint64_t value() const { return hash_.value(); }

private:
    ContentHash hash_;
};

}  // namespace

std::uint64_t content_hash(const Scene& scene) {
    SceneHash hash;
    for (const auto& mesh : scene.meshes) {
        hash.add(*mesh);
    }
    for (const Instance& instance : scene.instances) {
        hash.add(instance);
    }
    for (const Object& object : scene.objects) {
        hash.add(object.name);
    }
    for (const Material& material : scene.materials) {
        hash.add(material, material_properties());
    }
    for (const Light& light : scene.lights) {
        hash.add(light, light_properties());
        hash.add(static_cast<double>(light.kind));
    }
    hash.add(scene.default_light ? 1.0 : 0.0);
    return hash.value();
}

}  // namespace balcony::scene
