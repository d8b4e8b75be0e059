// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/embree/accelerator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "render/embree/build_monitor.hpp"
#include "render/embree/instance_use.hpp"
#include "render/embree/packet_setup.hpp"
#include "render/embree/rtcore.hpp"
#include "shading/geometry/motion_steps.hpp"
#include "shading/materials/material_set.hpp"

namespace balcony::render::embree {

namespace {

struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::shared_ptr<std::remove_pointer_t<RTCDevice>>;
using BuiltScene = std::shared_ptr<std::remove_pointer_t<RTCScene>>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

// What Embree said of the first call that failed while this thread built a structure. It reports an
// error in the thread of the call.
thread_local std::string first_error;

void record_error(void*, RTCError, const char* message) {
    if (first_error.empty()) {
        first_error = message != nullptr && *message != '\0' ? message : "unknown error";
    }
}

Diagnostics failure_of_build() {
    if (first_error.empty()) {
        return {};
    }
    return {error(fmt::format("the acceleration structure cannot be built: {}", first_error))};
}

// Geometries of the world are numbered as the scene's instances are; inside an instance of a shared
// mesh the instance has the number.
Hit to_hit(unsigned instance, unsigned geometry, unsigned triangle, float u, float v) {
    return {instance != RTC_INVALID_GEOMETRY_ID ? instance : geometry, triangle, u, v};
}

// A filter finds it through its base.
struct ShadowQuery : QueryContext {
    const TransmittanceSource* surfaces;
    std::span<const Ray> rays;                 // By their ids, in world coordinates.
    std::span<Imath::Color3f> transmittances;  // The same.
};

// Lets a shadow ray pass a transparent surface, attenuated by its opacity.
void pass_transparent(const RTCFilterFunctionNArguments* arguments) {
    auto* query = static_cast<ShadowQuery*>(static_cast<QueryContext*>(arguments->context));
    const unsigned count = arguments->N;
    for (unsigned i = 0; i < count; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const Hit hit = to_hit(
            RTCHitN_instID(arguments->hit, count, i, 0), RTCHitN_geomID(arguments->hit, count, i),
            RTCHitN_primID(arguments->hit, count, i), RTCHitN_u(arguments->hit, count, i),
            RTCHitN_v(arguments->hit, count, i));
        const unsigned id = RTCRayN_id(arguments->ray, count, i);
        Imath::Color3f& transmittance = query->transmittances[id];
        transmittance *= query->surfaces->transmittance(hit, query->rays[id]);
        if (!is_black(transmittance)) {
            arguments->valid[i] = 0;
        }
    }
}

// Whether shadow rays ask what passes a mesh.
bool may_pass_light(const scene::Scene& scene, scene::MeshIndex mesh) {
    const scene::Material& material = scene.materials[scene.meshes[mesh.value()]->material.value()];
    return material.alpha_mode != scene::AlphaMode::opaque || may_be_pane(material) ||
           is_glass(material);
}

// A mesh as triangles, placed as an instance is if one is given. Null after a stop, or for lack of
// memory.
Geometry make_triangles(RTCDevice device, const scene::Scene& scene, const MotionSteps& motion,
                        scene::MeshIndex index, std::optional<std::size_t> instance,
                        const BuildMonitor& monitor) {
    const scene::Mesh& mesh = scene.meshes[index.value()];
    Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE));
    const std::size_t steps =
        std::max(motion.shape_count(index), instance ? motion.matrices(*instance).size() : 1);
    rtcSetGeometryTimeStepCount(geometry.get(), static_cast<unsigned>(steps));
    for (std::size_t step = 0; step < steps; ++step) {
        auto* positions = static_cast<V3f*>(rtcSetNewGeometryBuffer(
            geometry.get(), RTC_BUFFER_TYPE_VERTEX, static_cast<unsigned>(step), RTC_FORMAT_FLOAT3,
            sizeof(V3f), mesh.positions.size()));
        if (positions == nullptr) {
            return {};
        }
        const float time =
            steps == 1 ? 0.0F : static_cast<float>(step) / static_cast<float>(steps - 1);
        const scene::M44d placed = instance ? motion.matrix(*instance, time) : scene::M44d();
        constexpr std::size_t until_next = 1U << 16U;
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            if (v % until_next == 0 && monitor.is_stopped()) {
                return {};
            }
            const V3f p = motion.position(index, v, time);
            positions[v] = instance ? V3f(scene::V3d(p) * placed) : p;
        }
    }
    auto* triangles = static_cast<std::array<std::uint32_t, 3>*>(
        rtcSetNewGeometryBuffer(geometry.get(), RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                sizeof(mesh.triangles[0]), mesh.triangles.size()));
    if (triangles == nullptr) {
        return {};
    }
    std::copy(mesh.triangles.begin(), mesh.triangles.end(), triangles);
    if (may_pass_light(scene, index)) {
        rtcSetGeometryOccludedFilterFunction(geometry.get(), pass_transparent);
    }
    rtcCommitGeometry(geometry.get());
    return geometry;
}

BuiltScene make_scene(RTCDevice device) {
    BuiltScene built(rtcNewScene(device), ReleaseScene());
    rtcSetSceneFlags(built.get(), RTC_SCENE_FLAG_ROBUST);
    // Medium is the highest quality whose result does not depend on the number of threads.
    rtcSetSceneBuildQuality(built.get(), RTC_BUILD_QUALITY_MEDIUM);
    return built;
}

// The columns of a matrix for column vectors, which are the rows of Imath's matrix.
std::array<float, 16> columns_of(const scene::M44d& matrix) {
    std::array<float, 16> columns{};
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 4; ++column) {
            columns[static_cast<std::size_t>(4 * row + column)] =
                static_cast<float>(matrix[row][column]);
        }
    }
    return columns;
}

// A shared mesh, placed by matrices at equal steps of time.
Geometry make_instance(RTCDevice device, RTCScene mesh,
                       std::span<const scene::M44d> world_from_mesh) {
    Geometry geometry(rtcNewGeometry(device, RTC_GEOMETRY_TYPE_INSTANCE));
    rtcSetGeometryInstancedScene(geometry.get(), mesh);
    rtcSetGeometryTimeStepCount(geometry.get(), static_cast<unsigned>(world_from_mesh.size()));
    for (unsigned step = 0; step < world_from_mesh.size(); ++step) {
        rtcSetGeometryTransform(geometry.get(), step, RTC_FORMAT_FLOAT4X4_COLUMN_MAJOR,
                                columns_of(world_from_mesh[step]).data());
    }
    rtcCommitGeometry(geometry.get());
    return geometry;
}

RTCRayHit to_ray_hit(const Ray& ray) {
    RTCRayHit query{};
    query.ray = {ray.origin.x,
                 ray.origin.y,
                 ray.origin.z,
                 0.0F,
                 ray.direction.x,
                 ray.direction.y,
                 ray.direction.z,
                 ray.time,
                 ray.farthest,
                 0xffffffffU,
                 0,
                 0};
    query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    return query;
}

static_assert(Packet::size == 16 && sizeof(Packet) % alignof(RTCRayHit16) == 0 &&
              offsetof(Packet, valid) >= sizeof(RTCRayHit16) &&
              offsetof(Packet, farthest) == offsetof(RTCRayHit16, ray.tfar) &&
              offsetof(Packet, normal_x) == offsetof(RTCRayHit16, hit.Ng_x) &&
              offsetof(Packet, geometry) == offsetof(RTCRayHit16, hit.geomID) &&
              offsetof(Packet, placement) == offsetof(RTCRayHit16, hit.instID));

// What there is to build, in triangles and instances.
struct Sizes {
    std::size_t world = 0;   // Of the structure of all.
    std::size_t meshes = 0;  // Of those of shared meshes, which may have been built before.
};

Sizes sizes_of(const scene::Scene& scene, const std::vector<Use>& uses) {
    Sizes sizes;
    std::vector<bool> placed(scene.meshes.size());
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const std::uint32_t mesh = scene.instances[i].mesh.value();
        const std::size_t triangles = scene.meshes[mesh]->triangles.size();
        if (uses[i] == Use::copied) {
            sizes.world += triangles;
        } else if (uses[i] == Use::placed) {
            ++sizes.world;
            sizes.meshes += placed[mesh] ? 0 : triangles;
            placed[mesh] = true;
        }
    }
    return sizes;
}

}  // namespace

// The structure of a mesh that instances place.
struct BuiltMesh {
    BuiltScene built{};  // Null if no instance places it.
    std::optional<scene::Shared<scene::Mesh>> mesh{};
    bool passes_light = false;
};

struct Accelerator::State {
    Device engine;
    std::vector<BuiltMesh> meshes;  // By mesh.
    BuiltScene world;
    std::vector<bool> attached;  // To the world, by instance.
    float reach = max_coordinate;

    [[nodiscard]] RTCDevice device() const { return engine.get(); }
    void reuse(const std::vector<BuiltMesh>& before, const scene::Scene& scene);
    void place(const scene::Scene& scene, const MotionSteps& motion, std::size_t instance,
               BuildMonitor& monitor);
    void copy(const scene::Scene& scene, const MotionSteps& motion, std::size_t instance,
              const BuildMonitor& monitor);
    [[nodiscard]] bool traceable(const Ray& ray) const;
};

// Takes over the meshes that are still in a scene and keep their shape.
void Accelerator::State::reuse(const std::vector<BuiltMesh>& before, const scene::Scene& scene) {
    std::unordered_map<const scene::Mesh*, const BuiltMesh*> known;
    for (const BuiltMesh& one : before) {
        if (one.built) {
            known.emplace(&**one.mesh, &one);
        }
    }
    meshes.resize(scene.meshes.size());
    for (std::size_t i = 0; i < meshes.size(); ++i) {
        const auto found = known.find(&*scene.meshes[i]);
        if (found != known.end() &&
            found->second->passes_light == may_pass_light(scene, scene::MeshIndex(i))) {
            meshes[i] = *found->second;
        }
    }
    if (scene.motion) {
        for (const scene::Deformation& deformation : scene.motion->deformations) {
            meshes[deformation.mesh.value()] = {};
        }
    }
}

void Accelerator::State::place(const scene::Scene& scene, const MotionSteps& motion,
                               std::size_t instance, BuildMonitor& monitor) {
    const scene::MeshIndex index = scene.instances[instance].mesh;
    BuiltScene& mesh = meshes[index.value()].built;
    if (!mesh) {
        mesh = make_scene(device());
        meshes[index.value()].mesh = scene.meshes[index.value()];
        meshes[index.value()].passes_light = may_pass_light(scene, index);
        if (const Geometry triangles =
                make_triangles(device(), scene, motion, index, std::nullopt, monitor)) {
            rtcAttachGeometry(mesh.get(), triangles.get());
        }
        monitor.commit(mesh.get(), scene.meshes[index.value()]->triangles.size());
    }
    const auto steps = motion.matrices(instance);
    const Geometry placed = make_instance(device(), mesh.get(), steps);
    rtcAttachGeometryByID(world.get(), placed.get(), static_cast<unsigned>(instance));
    attached[instance] = true;
    for (const scene::M44d& world_from_mesh : steps) {
        reach = std::min(reach, static_cast<float>(*reach_into(world_from_mesh)));
    }
}

void Accelerator::State::copy(const scene::Scene& scene, const MotionSteps& motion,
                              std::size_t instance, const BuildMonitor& monitor) {
    if (const Geometry triangles = make_triangles(
            device(), scene, motion, scene.instances[instance].mesh, instance, monitor)) {
        rtcAttachGeometryByID(world.get(), triangles.get(), static_cast<unsigned>(instance));
        attached[instance] = true;
    }
}

// Embree's requirements on a ray, with its origin also in the coordinates of placed meshes.
bool Accelerator::State::traceable(const Ray& ray) const {
    return std::abs(ray.origin.x) <= reach && std::abs(ray.origin.y) <= reach &&
           std::abs(ray.origin.z) <= reach && in_range(ray.direction) && ray.farthest >= 0.0F &&
           ray.time >= 0.0F && ray.time <= 1.0F;
}

Result<Accelerator> Accelerator::build(const scene::Scene& scene, const scene::Movement& movement,
                                       const std::stop_token& stop, const PartDone& progress) {
    auto state = std::make_shared<State>();
    const RTCDevice device = rtcNewDevice(nullptr);
    if (device == nullptr) {
        return error("Embree cannot start on this machine");
    }
    state->engine.reset(device, rtcReleaseDevice);
    rtcSetDeviceErrorFunction(device, record_error, nullptr);
    state->meshes.resize(scene.meshes.size());
    return fill(std::move(state), scene, movement, stop, progress);
}

Result<Accelerator> Accelerator::moved(const scene::Scene& scene, const scene::Movement& movement,
                                       const std::stop_token& stop,
                                       const PartDone& progress) const {
    auto state = std::make_shared<State>();
    state->engine = state_->engine;
    state->reuse(state_->meshes, scene);
    return fill(std::move(state), scene, movement, stop, progress);
}

Result<Accelerator> Accelerator::fill(std::shared_ptr<State> state, const scene::Scene& scene,
                                      const scene::Movement& movement, const std::stop_token& stop,
                                      const PartDone& progress) {
    first_error.clear();
    state->world = make_scene(state->device());
    state->attached.assign(scene.instances.size(), false);
    const MotionSteps motion(scene, movement);
    const std::vector<Use> uses = choose_uses(scene, motion);
    const Sizes sizes = sizes_of(scene, uses);
    BuildMonitor monitor(stop, progress, sizes.world + sizes.meshes);
    for (std::size_t i = 0; i < uses.size() && !monitor.is_stopped(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        if (uses[i] == Use::none || scene.meshes[instance.mesh.value()]->triangles.empty()) {
            continue;
        }
        if (uses[i] == Use::placed) {
            state->place(scene, motion, i, monitor);
        } else {
            state->copy(scene, motion, i, monitor);
        }
    }
    monitor.commit(state->world.get(), sizes.world);
    if (monitor.is_stopped()) {
        return stopped();  // Embree calls it an error.
    }
    if (Diagnostics failure = failure_of_build(); !failure.empty()) {
        return failure;
    }
    return {Accelerator(std::move(state)), name_left_out(scene, uses)};
}

Result<Accelerator> Accelerator::only(std::span<const std::uint8_t> shown) const {
    first_error.clear();
    auto state = std::make_shared<State>();
    state->engine = state_->engine;
    state->meshes = state_->meshes;
    state->reach = state_->reach;
    state->world = make_scene(state->device());
    state->attached.assign(shown.size(), false);
    for (std::size_t i = 0; i < shown.size(); ++i) {
        if (shown[i] != 0 && state_->attached[i]) {
            const auto id = static_cast<unsigned>(i);
            rtcAttachGeometryByID(state->world.get(), rtcGetGeometry(state_->world.get(), id), id);
            state->attached[i] = true;
        }
    }
    rtcCommitScene(state->world.get());
    if (Diagnostics failure = failure_of_build(); !failure.empty()) {
        return failure;
    }
    return Accelerator(std::move(state));
}

float Accelerator::reach() const { return state_->reach; }

Hit Accelerator::intersect(const Ray& ray) const {
    if (!state_->traceable(ray)) {
        return {};
    }
    RTCRayHit query = to_ray_hit(ray);
    embree::intersect(state_->world.get(), query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return {};
    }
    return to_hit(query.hit.instID[0], query.hit.geomID, query.hit.primID, query.hit.u,
                  query.hit.v);
}

void Accelerator::intersect(std::span<Packet> packets) const {
    prepare(packets, state_->reach);
    for (std::size_t first = 0; first < packets.size(); first += 2) {
        embree::intersect(state_->world.get(),
                          packets.subspan(first, std::min<std::size_t>(2, packets.size() - first)));
    }
}

Imath::Color3f Accelerator::transmittance(const Ray& ray,
                                          const TransmittanceSource& surfaces) const {
    Imath::Color3f transmittance(1.0F);
    if (!state_->traceable(ray)) {
        return transmittance;
    }
    ShadowQuery query{{}, &surfaces, std::span(&ray, 1), std::span(&transmittance, 1)};
    RTCRay shadow = to_ray_hit(ray).ray;
    occluded(state_->world.get(), query, shadow);
    return shadow.tfar < 0.0F ? Imath::Color3f(0.0F) : transmittance;
}

void Accelerator::transmittance(std::span<const Ray> rays, const TransmittanceSource& surfaces,
                                std::span<Imath::Color3f> results) const {
    Packet packet;
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        packet.set(lane, rays[lane]);
        packet.id[lane] = static_cast<std::uint32_t>(lane);
        results[lane] = Imath::Color3f(1.0F);
    }
    prepare(std::span(&packet, 1), state_->reach);
    const Packet::Floats lengths = packet.farthest;
    ShadowQuery query{{}, &surfaces, rays, results};
    occluded(state_->world.get(), query, packet.valid.data(), reinterpret_cast<RTCRay16*>(&packet));
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        if (lengths[lane] >= 0.0F && packet.farthest[lane] < 0.0F) {
            results[lane] = Imath::Color3f(0.0F);
        }
    }
}

}  // namespace balcony::render::embree
