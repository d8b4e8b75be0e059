// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bare_embree.hpp"

#include <algorithm>
#include <array>
#include <cstdint>
#include <limits>
#include <type_traits>

#if BALCONY_EMBREE == 3
#include <embree3/rtcore.h>
#else
#include <embree4/rtcore.h>
#endif

#include "timing.hpp"

namespace balcony::bench {

namespace {

constexpr std::size_t packet_side = 4;
constexpr std::size_t packet_size = packet_side * packet_side;

struct Packet {
    alignas(64) std::array<int, packet_size> valid{};
    RTCRayHit16 rays{};
};

void set_ray(Packet& packet, std::size_t lane, const rays::Ray& ray) {
    RTCRay16& to = packet.rays.ray;
    packet.valid[lane] = ray.valid ? -1 : 0;
    to.org_x[lane] = static_cast<float>(ray.origin.x);
    to.org_y[lane] = static_cast<float>(ray.origin.y);
    to.org_z[lane] = static_cast<float>(ray.origin.z);
    to.dir_x[lane] = static_cast<float>(ray.direction.x);
    to.dir_y[lane] = static_cast<float>(ray.direction.y);
    to.dir_z[lane] = static_cast<float>(ray.direction.z);
    to.tfar[lane] = std::numeric_limits<float>::infinity();
    to.mask[lane] = 0xffffffffU;
    packet.rays.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
    packet.rays.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
}

std::vector<Packet> packets_of(const rays::RayBatch& rays, const rays::Tile& tile) {
    std::vector<Packet> packets;
    for (std::size_t top = 0; top < tile.height; top += packet_side) {
        for (std::size_t left = 0; left < tile.width; left += packet_side) {
            Packet& packet = packets.emplace_back();
            std::size_t lane = 0;
            for (std::size_t y = top; y < std::min(top + packet_side, tile.height); ++y) {
                for (std::size_t x = left; x < std::min(left + packet_side, tile.width); ++x) {
                    set_ray(packet, lane++, rays[y * tile.width + x]);
                }
            }
        }
    }
    return packets;
}

void attach(RTCDevice device, RTCScene world, const scene::Mesh& mesh,
            const scene::M44d& world_from_mesh) {
    const RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* positions = static_cast<scene::V3f*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                sizeof(scene::V3f), mesh.positions.size()));
    auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(mesh.triangles[0]), mesh.triangles.size()));
    std::transform(
        mesh.positions.begin(), mesh.positions.end(), positions,
        [&](const scene::V3f& p) { return scene::V3f(scene::V3d(p) * world_from_mesh); });
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(world, geometry);
    rtcReleaseGeometry(geometry);
}

void trace(RTCScene world, Packet& packet) {
#if BALCONY_EMBREE == 3
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(packet.valid.data(), world, &context, &packet.rays);
#else
    RTCIntersectArguments arguments;
    rtcInitIntersectArguments(&arguments);
    arguments.flags = RTC_RAY_QUERY_FLAG_COHERENT;
    rtcIntersect16(packet.valid.data(), world, &packet.rays, &arguments);
#endif
}

}  // namespace

struct BareEmbree::State {
    RTCDevice device = rtcNewDevice(nullptr);
    RTCScene world = rtcNewScene(device);

    State() = default;
    State(const State&) = delete;
    State& operator=(const State&) = delete;
    ~State() {
        rtcReleaseScene(world);
        rtcReleaseDevice(device);
    }
};

// The same flags as in the renderer.
BareEmbree::BareEmbree(const scene::Scene& scene) : state_(std::make_unique<State>()) {
    rtcSetSceneFlags(state_->world, RTC_SCENE_FLAG_ROBUST);
    rtcSetSceneBuildQuality(state_->world, RTC_BUILD_QUALITY_MEDIUM);
    for (const scene::Instance& instance : scene.instances) {
        attach(state_->device, state_->world, scene.meshes[instance.mesh.value()],
               instance.world_from_mesh);
    }
    rtcCommitScene(state_->world);
}

BareEmbree::~BareEmbree() = default;
BareEmbree::BareEmbree(BareEmbree&&) noexcept = default;

double BareEmbree::seconds(const rays::RayProgram& rays,
                           const std::vector<rays::Tile>& tiles) const {
    double total = 0.0;
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (const rays::Tile& tile : tiles) {
        rays.run(tile, scratch, batch);
        std::vector<Packet> packets = packets_of(batch, tile);
        Stopwatch stopwatch(1);
        stopwatch.time(0, [&] {
            for (Packet& packet : packets) {
                trace(state_->world, packet);
            }
        });
        total += stopwatch.seconds();
    }
    return total;
}

}  // namespace balcony::bench
