// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The base colour, lit from the ray's origin.

#include <array>
#include <cmath>
#include <optional>
#include <vector>

#include "render/integrators/ray_tree.hpp"
#include "render/shading/packet_lanes.hpp"

namespace balcony::render {

namespace {

using embree::Packet;

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
        Color4f base_color{0.0F};
        Color4f emission{0.0F};  // With the opacity.
        const scene::TextureUse* texture = nullptr;
        PlacedMesh mesh{};
    };

    static Look look_of(const TracedScene& traced, std::uint32_t instance) {
        const std::optional<PlacedMesh> mesh = traced.surfaces.mesh_at_rest(instance);
        const auto material = mesh ? traced.materials.plain(*mesh->mesh) : std::nullopt;
        if (!material) {
            return {};
        }
        const Color3f& base = material->constant->base_color;
        return {true,
                {base.x, base.y, base.z, 0.0F},
                opaque(material->constant->emission),
                material->texture,
                *mesh};
    }

    void trace_light(const Packet& packet, const DifferentialSource& differentials,
                     Lanes& radiance) override {
        std::array<const Look*, Packet::size> looks{};
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            if (packet.valid[lane] != 0 && packet.any(lane)) {
                looks[lane] = &looks_[packet.instance(lane)];
                if (looks[lane]->is_plain) {
                    set_normals(packet, lane, looks[lane]->mesh);
                }
            }
        }
        packet_lanes::set_cosines(packet, normals_, cosines_);
        for (std::size_t lane = 0; lane < Packet::size; ++lane) {
            const Look* const look = looks[lane];
            if (look == nullptr) {
                radiance[lane] = Color4f(0.0F);
            } else if (!look->is_plain) {
                radiance[lane] = light(packet, lane, differentials);
            } else if (look->texture == nullptr) {
                radiance[lane] = look->emission + cosines_[lane] * look->base_color;
            } else {
                radiance[lane] = look->emission + cosines_[lane] * look->base_color *
                                                      texel(packet, lane, *look, differentials);
            }
        }
    }

    void set_normals(const Packet& packet, std::size_t lane, const PlacedMesh& mesh) {
        const V3f smooth =
            mesh.smooth_normal(packet.triangle[lane], packet.u[lane], packet.v[lane]);
        const V3f flat = packet.is_placed(lane) ? packet.normal(lane) * mesh.normal_from_mesh
                                                : packet.normal(lane);
        normals_.smooth_x[lane] = smooth.x;
        normals_.smooth_y[lane] = smooth.y;
        normals_.smooth_z[lane] = smooth.z;
        normals_.flat_x[lane] = flat.x;
        normals_.flat_y[lane] = flat.y;
        normals_.flat_z[lane] = flat.z;
    }

    [[nodiscard]] Color4f texel(const Packet& packet, std::size_t lane, const Look& look,
                                const DifferentialSource& differentials) const {
        const std::uint32_t triangle = packet.triangle[lane];
        const V3f normal(normals_.flat_x[lane], normals_.flat_y[lane], normals_.flat_z[lane]);
        const TriangleFootprint footprint =
            look.mesh.footprint(triangle, normal, packet.direction(lane), packet.farthest[lane],
                                differentials.differentials(lane));
        const MeshPoint point{look.mesh.mesh, triangle, packet.u[lane], packet.v[lane]};
        return textures_->look_up(look.texture->index, look.texture->encoding,
                                  point.texture_footprint(*look.texture, footprint));
    }

    [[nodiscard]] Color4f light(const Packet& packet, std::size_t lane,
                                const DifferentialSource& differentials) {
        const Ray ray{packet.origin(lane), packet.direction(lane),
                      differentials.differentials(lane), packet.time[lane]};
        const embree::Hit hit = packet.hit(lane);
        const Interaction at = tracer().interaction(ray, hit);
        return at.appearance.opacity >= 1.0F
                   ? opaque(radiance(at.appearance, at.surface.normal, ray.direction))
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
        if (at.appearance.unlit) {
            return {at.appearance.base_color, Color3f(0.0F), Color3f(0.0F)};
        }
        const float cosine = std::abs(at.surface.normal.dot(ray.direction));
        return {at.appearance.emission, Color3f(0.0F), cosine * at.appearance.base_color};
    }

    const TextureLibrary* textures_;
    std::vector<Look> looks_;  // By instance.
    // Of the packet at work.
    packet_lanes::Normals normals_{};
    alignas(64) Packet::Floats cosines_{};
};

}  // namespace

std::unique_ptr<Integrator> make_preview(const TracedScene& traced, const Settings& settings) {
    return std::make_unique<Preview>(traced, settings);
}

}  // namespace balcony::render
