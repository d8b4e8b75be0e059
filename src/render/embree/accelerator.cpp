// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/embree/accelerator.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <mutex>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include <embree3/rtcore.h>
#include <fmt/format.h>

#include "render/shading/motion_steps.hpp"
#include "render/shading/scene_check.hpp"

namespace balcony::render::embree {

namespace {

struct ReleaseDevice {
    void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
};
struct ReleaseScene {
    void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
struct ReleaseGeometry {
    void operator()(RTCGeometry geometry) const { rtcReleaseGeometry(geometry); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, ReleaseDevice>;
using BuiltScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, ReleaseScene>;
using Geometry = std::unique_ptr<std::remove_pointer_t<RTCGeometry>, ReleaseGeometry>;

// The first error that Embree reported.
struct ErrorLog {
    std::mutex mutex;
    std::string first;
};

void record_error(void* user, RTCError, const char* message) {
    auto* log = static_cast<ErrorLog*>(user);
    const std::lock_guard lock(log->mutex);
    if (log->first.empty()) {
        log->first = message != nullptr && *message != '\0' ? message : "unknown error";
    }
}

// Geometries of the world are numbered as the scene's instances are; inside an instance of a shared
// mesh the instance has the number.
Hit to_hit(unsigned instance, unsigned geometry, unsigned triangle, float u, float v) {
    return {instance != RTC_INVALID_GEOMETRY_ID ? instance : geometry, triangle, u, v};
}

struct ShadowQuery {
    RTCIntersectContext
        context;  // The first member, so that a filter can access the others through it.
    const OpacitySource* opacities;
    std::span<float> transmittances;  // By the rays' ids.
};

// Lets a shadow ray pass a transparent surface, attenuated by its opacity.
void pass_transparent(const RTCFilterFunctionNArguments* arguments) {
    auto* query = reinterpret_cast<ShadowQuery*>(arguments->context);
    const unsigned count = arguments->N;
    for (unsigned i = 0; i < count; ++i) {
        if (arguments->valid[i] != -1) {
            continue;
        }
        const Hit hit = to_hit(
            RTCHitN_instID(arguments->hit, count, i, 0), RTCHitN_geomID(arguments->hit, count, i),
            RTCHitN_primID(arguments->hit, count, i), RTCHitN_u(arguments->hit, count, i),
            RTCHitN_v(arguments->hit, count, i));
        float& transmittance = query->transmittances[RTCRayN_id(arguments->ray, count, i)];
        transmittance *= 1.0F - query->opacities->opacity(hit);
        if (transmittance > 0.0F) {
            arguments->valid[i] = 0;
        }
    }
}

// Whether a matrix is finite and affine, so that it maps finite points to finite points.
bool is_affine(const scene::M44d& m) {
    for (int row = 0; row < 4; ++row) {
        for (int column = 0; column < 3; ++column) {
            if (!std::isfinite(m[row][column])) {
                return false;
            }
        }
    }
    return m[0][3] == 0.0 && m[1][3] == 0.0 && m[2][3] == 0.0 && m[3][3] == 1.0;
}

// Whether the whole mesh can be traced, in its own coordinates and as placed.
bool can_be_traced(const scene::Mesh& mesh, const scene::M44d& world_from_mesh) {
    return is_affine(world_from_mesh) &&
           std::all_of(mesh.positions.begin(), mesh.positions.end(), [&](const V3f& p) {
               return in_range(p) && in_range(scene::V3d(p) * world_from_mesh);
           });
}

// The largest coordinate in the image of the unit cube under a linear map.
double norm(const scene::M44d& m) {
    double maximum = 0.0;
    for (int column = 0; column < 3; ++column) {
        maximum = std::max(
            maximum, std::abs(m[0][column]) + std::abs(m[1][column]) + std::abs(m[2][column]));
    }
    return maximum;
}

// The largest coordinate of a ray's origin for which Embree, which inverts the matrix in floats,
// can transform it to the coordinates of a shared mesh. Nothing if this may fail even at 1e12: the
// matrix is then nearly singular, or scales by more than a million.
std::optional<double> reach_into(const scene::M44d& world_from_mesh) {
    constexpr double max_scale = 1e6;
    constexpr double max_condition = 1e3;  // Its square times a float's rounding is below 0.1.
    constexpr double min_reach = 1e12;
    if (world_from_mesh.determinant() == 0.0) {
        return std::nullopt;
    }
    const scene::M44d mesh_from_world = world_from_mesh.inverse();
    const double scale = norm(world_from_mesh);
    const double inverse_scale = norm(mesh_from_world);
    if (!(scale <= max_scale && inverse_scale <= max_scale &&
          scale * inverse_scale <= max_condition)) {
        return std::nullopt;
    }
    const scene::V3d shift = mesh_from_world.translation();
    const double largest_shift =
        std::max({std::abs(shift.x), std::abs(shift.y), std::abs(shift.z)});
    constexpr double rounding = 0.9;
    const double reach = (rounding * max_coordinate - largest_shift) / inverse_scale;
    return reach >= min_reach ? std::optional(reach) : std::nullopt;
}

// A mesh as triangles, placed as an instance is if one is given.
Geometry make_triangles(RTCDevice device, const scene::Scene& scene, const MotionSteps& motion,
                        scene::MeshIndex index, std::optional<std::size_t> instance) {
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
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
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
    if (scene.materials[mesh.material.value()].alpha_mode != scene::AlphaMode::opaque) {
        rtcSetGeometryOccludedFilterFunction(geometry.get(), pass_transparent);
    }
    rtcCommitGeometry(geometry.get());
    return geometry;
}

BuiltScene make_scene(RTCDevice device) {
    BuiltScene built(rtcNewScene(device));
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

// How an instance is built: it is skipped, copied into world space, or placed by a matrix.
enum class Use : std::uint8_t { none, copied, placed };

// A mesh with one instance that stands still is copied into world space, which is faster to trace.
std::vector<Use> choose_uses(const scene::Scene& scene, const MotionSteps& motion) {
    std::vector<std::size_t> counts(scene.meshes.size());
    std::vector<Use> uses(scene.instances.size(), Use::none);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
        const auto steps = motion.matrices(i);
        if (std::all_of(steps.begin(), steps.end(), [&](const scene::M44d& world_from_mesh) {
                return can_be_traced(mesh, world_from_mesh);
            })) {
            uses[i] = Use::copied;
            ++counts[instance.mesh.value()];
        }
    }
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const auto steps = motion.matrices(i);
        const bool is_shared = counts[scene.instances[i].mesh.value()] > 1 || steps.size() > 1;
        if (uses[i] == Use::copied && is_shared &&
            std::all_of(steps.begin(), steps.end(), reach_into)) {
            uses[i] = Use::placed;
        }
    }
    return uses;
}

// One warning for each object with a skipped part.
Diagnostics name_left_out(const scene::Scene& scene, const std::vector<Use>& uses) {
    std::set<std::uint32_t> objects;
    for (std::size_t i = 0; i < uses.size(); ++i) {
        if (uses[i] == Use::none) {
            objects.insert(scene.instances[i].object);
        }
    }
    Diagnostics warnings;
    for (const std::uint32_t object : objects) {
        warnings.push_back(warning(
            fmt::format("object '{}' extends beyond {:.3g} or is placed by a matrix that is not "
                        "affine; it is skipped",
                        scene.objects[object].name, max_coordinate),
            {}, "scale the scene down, or repair its transforms"));
    }
    return warnings;
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

constexpr std::size_t packet_size = Accelerator::packet_size;

// Embree's coherent packets lose rays with a direction component of nearly 0, whose reciprocal is
// out of range for the bounds of a packet. The minimum passed to Embree is less than the rounding
// error of the other components of a unit direction.
float away_from_zero(float component) {
    constexpr float minimum = 1e-8F;
    return std::fabs(component) < minimum ? std::copysign(minimum, component) : component;
}

void set_lane(RTCRay16& packet, std::size_t lane, const Ray& ray) {
    packet.org_x[lane] = ray.origin.x;
    packet.org_y[lane] = ray.origin.y;
    packet.org_z[lane] = ray.origin.z;
    packet.tnear[lane] = 0.0F;
    packet.dir_x[lane] = away_from_zero(ray.direction.x);
    packet.dir_y[lane] = away_from_zero(ray.direction.y);
    packet.dir_z[lane] = away_from_zero(ray.direction.z);
    packet.time[lane] = ray.time;
    packet.tfar[lane] = ray.farthest;
    packet.mask[lane] = 0xffffffffU;
    packet.id[lane] = static_cast<unsigned>(lane);
    packet.flags[lane] = 0;
}

void intersect_packet(RTCScene world, std::span<const std::size_t> indices,
                      std::span<const Ray> rays, std::span<Hit> hits) {
    if (indices.empty()) {
        return;
    }
    alignas(64) std::array<int, packet_size> valid{};
    RTCRayHit16 packet{};
    for (std::size_t lane = 0; lane < indices.size(); ++lane) {
        valid[lane] = -1;
        set_lane(packet.ray, lane, rays[indices[lane]]);
        packet.hit.geomID[lane] = RTC_INVALID_GEOMETRY_ID;
        packet.hit.instID[0][lane] = RTC_INVALID_GEOMETRY_ID;
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    rtcIntersect16(valid.data(), world, &context, &packet);
    for (std::size_t lane = 0; lane < indices.size(); ++lane) {
        if (packet.hit.geomID[lane] != RTC_INVALID_GEOMETRY_ID) {
            hits[indices[lane]] =
                to_hit(packet.hit.instID[0][lane], packet.hit.geomID[lane], packet.hit.primID[lane],
                       packet.hit.u[lane], packet.hit.v[lane]);
        }
    }
}

}  // namespace

struct Accelerator::State {
    std::unique_ptr<ErrorLog> errors = std::make_unique<ErrorLog>();
    Device device;
    std::vector<BuiltScene> meshes;  // By mesh; null for one that no instance places.
    BuiltScene world;
    float reach = max_coordinate;

    void place(const scene::Scene& scene, const MotionSteps& motion, std::size_t instance);
    void copy(const scene::Scene& scene, const MotionSteps& motion, std::size_t instance);
    [[nodiscard]] bool traceable(const Ray& ray) const;
};

void Accelerator::State::place(const scene::Scene& scene, const MotionSteps& motion,
                               std::size_t instance) {
    const scene::MeshIndex index = scene.instances[instance].mesh;
    BuiltScene& mesh = meshes[index.value()];
    if (!mesh) {
        mesh = make_scene(device.get());
        if (const Geometry triangles =
                make_triangles(device.get(), scene, motion, index, std::nullopt)) {
            rtcAttachGeometry(mesh.get(), triangles.get());
        }
        rtcCommitScene(mesh.get());
    }
    const auto steps = motion.matrices(instance);
    const Geometry placed = make_instance(device.get(), mesh.get(), steps);
    rtcAttachGeometryByID(world.get(), placed.get(), static_cast<unsigned>(instance));
    for (const scene::M44d& world_from_mesh : steps) {
        reach = std::min(reach, static_cast<float>(*reach_into(world_from_mesh)));
    }
}

void Accelerator::State::copy(const scene::Scene& scene, const MotionSteps& motion,
                              std::size_t instance) {
    if (const Geometry triangles =
            make_triangles(device.get(), scene, motion, scene.instances[instance].mesh, instance)) {
        rtcAttachGeometryByID(world.get(), triangles.get(), static_cast<unsigned>(instance));
    }
}

// Embree's requirements on a ray, with its origin also in the coordinates of placed meshes.
bool Accelerator::State::traceable(const Ray& ray) const {
    return std::abs(ray.origin.x) <= reach && std::abs(ray.origin.y) <= reach &&
           std::abs(ray.origin.z) <= reach && in_range(ray.direction) && ray.farthest >= 0.0F &&
           ray.time >= 0.0F && ray.time <= 1.0F;
}

Result<Accelerator> Accelerator::build(const scene::Scene& scene, const scene::Movement& movement) {
    if (Diagnostics broken = check(scene); !broken.empty()) {
        return broken;
    }
    auto state = std::make_shared<State>();
    state->device.reset(rtcNewDevice(nullptr));
    if (!state->device) {
        return error("Embree cannot start on this machine");
    }
    rtcSetDeviceErrorFunction(state->device.get(), record_error, state->errors.get());

    state->world = make_scene(state->device.get());
    state->meshes.resize(scene.meshes.size());
    const MotionSteps motion(scene, movement);
    const std::vector<Use> uses = choose_uses(scene, motion);
    for (std::size_t i = 0; i < uses.size(); ++i) {
        const scene::Instance& instance = scene.instances[i];
        if (uses[i] == Use::none || scene.meshes[instance.mesh.value()].triangles.empty()) {
            continue;
        }
        if (uses[i] == Use::placed) {
            state->place(scene, motion, i);
        } else {
            state->copy(scene, motion, i);
        }
    }
    rtcCommitScene(state->world.get());

    if (!state->errors->first.empty()) {
        return error(
            fmt::format("the acceleration structure cannot be built: {}", state->errors->first));
    }
    return {Accelerator(std::move(state)), name_left_out(scene, uses)};
}

float Accelerator::reach() const { return state_->reach; }

Hit Accelerator::intersect(const Ray& ray) const {
    if (!state_->traceable(ray)) {
        return {};
    }
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    RTCRayHit query = to_ray_hit(ray);
    rtcIntersect1(state_->world.get(), &context, &query);
    if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) {
        return {};
    }
    return to_hit(query.hit.instID[0], query.hit.geomID, query.hit.primID, query.hit.u,
                  query.hit.v);
}

void Accelerator::intersect_grid(std::size_t width, std::span<const Ray> rays,
                                 std::span<const std::uint8_t> active, std::span<Hit> hits) const {
    const std::size_t height = rays.size() / width;
    std::array<std::size_t, packet_size> indices{};
    for (std::size_t y = 0; y < height; y += packet_side) {
        for (std::size_t x = 0; x < width; x += packet_side) {
            std::size_t count = 0;
            for (std::size_t j = y; j < std::min(y + packet_side, height); ++j) {
                for (std::size_t i = x; i < std::min(x + packet_side, width); ++i) {
                    const std::size_t ray = j * width + i;
                    hits[ray] = {};
                    indices[count] = ray;
                    count += active[ray] != 0 && state_->traceable(rays[ray]) ? 1 : 0;
                }
            }
            intersect_packet(state_->world.get(), std::span(indices).first(count), rays, hits);
        }
    }
}

float Accelerator::transmittance(const Ray& ray, const OpacitySource& opacities) const {
    if (!state_->traceable(ray)) {
        return 1.0F;
    }
    float transmittance = 1.0F;
    ShadowQuery query{{}, &opacities, std::span(&transmittance, 1)};
    rtcInitIntersectContext(&query.context);
    RTCRay shadow = to_ray_hit(ray).ray;
    rtcOccluded1(state_->world.get(), &query.context, &shadow);
    return shadow.tfar < 0.0F ? 0.0F : transmittance;
}

void Accelerator::transmittance(std::span<const Ray> rays, const OpacitySource& opacities,
                                std::span<float> results) const {
    alignas(64) std::array<int, packet_size> valid{};
    RTCRay16 packet{};
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        results[lane] = 1.0F;
        if (state_->traceable(rays[lane])) {
            valid[lane] = -1;
            set_lane(packet, lane, rays[lane]);
        }
    }
    ShadowQuery query{{}, &opacities, results};
    rtcInitIntersectContext(&query.context);
    rtcOccluded16(valid.data(), state_->world.get(), &query.context, &packet);
    for (std::size_t lane = 0; lane < rays.size(); ++lane) {
        if (valid[lane] != 0 && packet.tfar[lane] < 0.0F) {
            results[lane] = 0.0F;
        }
    }
}

}  // namespace balcony::render::embree
