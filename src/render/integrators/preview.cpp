// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The base colour, lit from the ray's origin.

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "render/integrators/ray_tree.hpp"
#include "render/shading/packet_lanes.hpp"
#include "render/shading/surface_lanes.hpp"

namespace balcony::render {

namespace {

using embree::Packet;
using surface_lanes::Group;

class Preview final : public RayTree, private LightTracer {
public:
    Preview(const TracedScene& traced, const Settings& settings)
        : RayTree(traced, settings), textures_(traced.textures.get()) {
        looks_.reserve(traced.scene->instances.size());
        for (std::uint32_t i = 0; i < traced.scene->instances.size(); ++i) {
            looks_.push_back(look_of(traced, i));
        }
    }
    [[nodiscard]] LightTracer* light_tracer() override { return this; }

private:
    // An instance as the integrator shows it.
    struct Look {
        bool is_plain = false;  // At rest, and with a plain material; otherwise the rest is unused.
        Color3f base_color{0.0F};
        Color3f emission{0.0F};
        const scene::TextureUse* texture = nullptr;
        PlacedMesh mesh{};
    };

    static Look look_of(const TracedScene& traced, std::uint32_t instance) {
        const std::optional<PlacedMesh> mesh = traced.surfaces.mesh_at_rest(instance);
        const bool fits = mesh && mesh->mesh->triangles.size() <= surface_lanes::max_mesh_size &&
                          mesh->mesh->positions.size() <= surface_lanes::max_mesh_size;
        const auto material = fits ? traced.materials.plain(*mesh->mesh) : std::nullopt;
        if (!material) {
            return {};
        }
        return {true, material->constant->base_color, material->constant->emission,
                material->texture, *mesh};
    }

    void trace_light(const Packet& packet, DifferentialSource& differentials,
                     Lanes& radiance) override {
        surface_lanes::find_groups(packet, groups_);
        for (const Group& group : groups_.all()) {
            if (const Look& look = looks_[group.instance]; look.is_plain) {
                surface_lanes::set_normals(packet, group.lanes, look.mesh, normals_);
            }
        }
        packet_lanes::set_cosines(packet, normals_, cosines_);
        for (const Group& group : groups_.all()) {
            if (const Look& look = looks_[group.instance]; look.is_plain) {
                surface_lanes::set_radiances(group.lanes, look.emission, look.base_color, cosines_,
                                             texture(packet, group, look, differentials),
                                             radiances_);
            }
        }
        surface_lanes::write(radiances_, groups_, radiance);
        for (const Group& group : groups_.all()) {
            if (!looks_[group.instance].is_plain) {
                set_others(packet, group, differentials, radiance);
            }
        }
    }

    // The colours of the texture of a group; null if it has none.
    [[nodiscard]] const texture_lanes::Colors* texture(const Packet& packet, const Group& group,
                                                       const Look& look,
                                                       DifferentialSource& differentials) {
        if (look.texture == nullptr) {
            return nullptr;
        }
        surface_lanes::set_footprints(packet, group.lanes, look.mesh, normals_,
                                      differentials.differentials(), *look.texture, footprints_);
        textures_->look_up(look.texture->index, look.texture->encoding, footprints_, texels_);
        return &texels_;
    }

    void set_others(const Packet& packet, const Group& group, DifferentialSource& differentials,
                    Lanes& radiance) {
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            if (group.has(lane)) {
                radiance[lane] = light({packet.origin(lane), packet.direction(lane),
                                        differentials.differentials().of(lane), packet.time[lane]},
                                       packet.hit(lane));
            }
        }
    }

    [[nodiscard]] Color4f light(const Ray& ray, const embree::Hit& hit) {
        const Interaction at = tracer().interaction(ray, hit);
        return at.appearance().opacity >= 1.0F
                   ? opaque(radiance(at.appearance(), at.surface.normal, ray.direction))
                   : trace(ray, hit).radiance;
    }

    static Color3f radiance(const Appearance& appearance, const V3f& normal, const V3f& direction) {
        if (appearance.unlit) {
            return appearance.base_color;
        }
        return appearance.emission + std::abs(normal.dot(direction)) * appearance.base_color;
    }
    static Color4f opaque(const Color3f& color) { return {color.x, color.y, color.z, 1.0F}; }

    [[nodiscard]] Shaded shade(const Ray& ray, const Interaction& at) const override {
        if (at.appearance().unlit) {
            return {at.appearance().base_color, Color3f(0.0F), Color3f(0.0F)};
        }
        const float cosine = std::abs(at.surface.normal.dot(ray.direction));
        return {at.appearance().emission, Color3f(0.0F), cosine * at.appearance().base_color};
    }

    const TextureLibrary* textures_;
    std::vector<Look> looks_;  // By instance.
    // Of the packet at work.
    surface_lanes::Groups groups_;
    packet_lanes::Normals normals_{};
    alignas(64) Packet::Floats cosines_{};
    texture_lanes::Footprints footprints_{};
    texture_lanes::Colors texels_{};
    surface_lanes::Radiances radiances_{};
};

}  // namespace

std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<Preview>(traced, settings);
}

}  // namespace balcony::render
