// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The base colour, lit from the ray's origin.

#include <cmath>
#include <optional>
#include <span>
#include <vector>

#include "render/integrators/ray_tree.hpp"
#include "shading/surfaces/packet_lanes.hpp"
#include "shading/surfaces/surface_lanes.hpp"

namespace balcony::render {

namespace {

using embree::Packet;
using surface_lanes::Group;
using surface_lanes::Look;
using surface_lanes::Radiances;

class Preview final : public RayTree, private LightTracer {
public:
    explicit Preview(const TracedScene& traced)
        : RayTree(traced), textures_(traced.textures.get()) {
        looks_.reserve(traced.scene->instances.size());
        for (std::uint32_t i = 0; i < traced.scene->instances.size(); ++i) {
            looks_.push_back(look_of(traced, i));
        }
    }
    [[nodiscard]] LightTracer* light_tracer() override { return this; }

private:
    static Look look_of(const TracedScene& traced, std::uint32_t instance) {
        const std::optional<PlacedMesh> mesh = traced.surfaces.mesh_at_rest(instance);
        const bool fits = mesh && mesh->mesh->triangles.size() <= surface_lanes::max_mesh_size &&
                          mesh->mesh->positions.size() <= surface_lanes::max_mesh_size;
        const auto material = fits ? traced.materials.plain(*mesh->mesh) : std::nullopt;
        if (!material) {
            return {};
        }
        return {true,
                !mesh->mesh->normals.empty(),
                material->constant->base_color,
                material->constant->emission,
                material->texture,
                *mesh};
    }

    void trace_light(std::span<const Packet> packets, DifferentialSource& differentials,
                     std::span<Radiances> radiances) override {
        for (std::size_t k = 0; k < packets.size(); ++k) {
            surface_lanes::light(packets[k], looks_, lit_, radiances[k]);
            for (const Group& group : lit_.groups.all()) {
                const Look& look = looks_[group.instance];
                if (!look.is_plain) {
                    set_others(packets[k], group, differentials.of_packet(k), radiances[k]);
                } else if (look.texture != nullptr) {
                    set_textured(packets[k], group, differentials.of_packet(k), radiances[k]);
                }
            }
        }
    }

    void set_textured(const Packet& packet, const Group& group,
                      const packet_lanes::Differentials& differentials, Radiances& radiances) {
        const Look& look = looks_[group.instance];
        surface_lanes::set_footprints(packet, group.lanes, look.mesh, differentials, *look.texture,
                                      footprints_);
        textures_->look_up(look.texture->index, look.texture->encoding, footprints_, texels_);
        surface_lanes::set_radiances(group.lanes, look, lit_.cosines, texels_, radiances);
    }

    void set_others(const Packet& packet, const Group& group,
                    const packet_lanes::Differentials& differentials, Radiances& radiances) {
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            if (group.has(lane)) {
                radiances.set(lane, light({packet.origin(lane), packet.direction(lane),
                                           differentials.of(lane), packet.time[lane]},
                                          packet.hit(lane)));
            }
        }
    }

    [[nodiscard]] Color4f light(const DifferentialRay& ray, const embree::Hit& hit) {
        const Interaction at = tracer().interaction(ray, hit);
        return at.appearance().opacity >= 1.0F ? opaque(radiance(at, ray.direction))
                                               : trace(ray, hit, {}).radiance;
    }

    static Color3f radiance(const Interaction& at, const V3f& direction) {
        const Appearance& appearance = at.appearance();
        return appearance.unlit
                   ? appearance.base_color
                   : at.emission(direction) +
                         std::abs(at.surface.normal.dot(direction)) * appearance.base_color;
    }
    static Color4f opaque(const Color3f& color) { return {color.x, color.y, color.z, 1.0F}; }

    [[nodiscard]] Shaded shade(const DifferentialRay& ray, const Interaction& at) const override {
        if (at.appearance().unlit) {
            return {at.appearance().base_color, Color3f(0.0F), Color3f(0.0F)};
        }
        const float cosine = std::abs(at.surface.normal.dot(ray.direction));
        return {at.emission(ray.direction), Color3f(0.0F), cosine * at.appearance().base_color};
    }

    const TextureLibrary* textures_;
    std::vector<Look> looks_;  // By instance.
    // Of the packet at work.
    surface_lanes::Lit lit_{};
    texture_lanes::Footprints footprints_;
    LaneVectors texels_;
};

}  // namespace

std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings&) {
    return std::make_unique<Preview>(traced);
}

}  // namespace balcony::render
