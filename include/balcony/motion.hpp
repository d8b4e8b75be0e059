// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Motion: what moves in a scene, and the scene at any time.
//
//     Result<Scene> scene = load("clock.glb");         // as it stands at time 0
//     Result<Scene> later = moved_to(*scene, 2.5);     // as it stands after 2.5 seconds
//     Movement blurred = movement(*later, {2.49, 2.51});
//
// A scene in which nothing moves has no Motion and pays nothing for this.

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <Imath/ImathQuat.h>

#include "balcony/scene.hpp"

namespace balcony::scene {

using Imath::Quatd;

// ------------------------------------------------------------------------- quantities by time

enum class Interpolation : std::uint8_t { step, linear, cubic_spline };

/// Numbers that change with time. Before the first key and after the last one they stay the same.
struct Track {
    Interpolation interpolation = Interpolation::linear;
    std::size_t width = 1;      ///< How many numbers there are at a time.
    std::vector<double> times;  ///< Of the keys, in seconds: finite, increasing, at least one.
    /// `width` numbers for each key. In a cubic spline three times as many: the derivatives by time
    /// before the key, the numbers at the key, the derivatives after it.
    std::vector<float> values;
};

/// The numbers of a track at a time, `width` of them: glTF 2.0, appendix C.
void evaluate(const Track& track, double time, std::span<double> numbers);
/// The same for a unit quaternion (x, y, z, w), whose linear interpolation is spherical.
[[nodiscard]] Quatd evaluate_rotation(const Track& track, double time);

// --------------------------------------------------------------------------- what can move

using TrackIndex = StrongIndex<struct TrackTag>;
using NodeIndex = StrongIndex<struct NodeTag>;

/// A node of the file that moves, by itself or with a node above it.
struct Node {
    NodeIndex parent;          ///< An earlier node; invalid if no node above this one moves.
    M44d world_from_parent{};  ///< If there is no parent in motion.
    M44d parent_from_node{};   ///< If none of the three tracks is valid.
    V3d translation{0.0};      ///< Where one of the tracks is not valid, these apply.
    Quatd rotation{};
    V3d scale{1.0};
    TrackIndex translation_track, rotation_track, scale_track;
};

/// Parts of the scene that hang on nodes.
struct MovingInstance {
    std::size_t instance = 0;  ///< Index into Scene::instances.
    NodeIndex node;
};
struct MovingLight {
    std::size_t light = 0;  ///< Index into Scene::lights.
    NodeIndex node;
};
struct MovingCamera {
    std::size_t camera = 0;  ///< Index into Scene::cameras.
    NodeIndex node;
};

/// Displacements of the vertices of a mesh, multiplied by a weight.
struct MorphTarget {
    std::vector<V3f> positions;  ///< Empty or one per vertex.
    std::vector<V3f> normals;    ///< Empty or one per vertex.
};

/// A node that vertices follow.
struct Joint {
    NodeIndex node;
    M44d joint_from_mesh;  ///< As the mesh is bound to it.
};

/// How much a vertex follows a joint.
struct Influence {
    std::uint32_t joint = 0;  ///< Index into Deformation::joints.
    float weight = 0.0F;      ///< Those of a vertex add up to 1.
};

/// A mesh whose shape depends on time: first by morph targets, then by joints. Only one instance
/// has the mesh; if there are joints, it places in the world what these have placed there.
struct Deformation {
    MeshIndex mesh;
    std::vector<V3f> positions;  ///< Of the mesh without deformation.
    std::vector<V3f> normals;
    std::vector<std::array<std::uint32_t, 3>> flat;  ///< The triangles of the mesh, if its normals
                                                     ///< are theirs; otherwise empty.
    std::vector<MorphTarget> targets;
    std::vector<float> weights;  ///< Of the targets, if the track is not valid.
    TrackIndex weights_track;
    std::vector<Joint> joints;
    std::vector<Influence> influences;  ///< The same number for each vertex.
};

/// The vertices of a mesh at a time.
struct Shape {
    std::vector<V3f> positions;
    std::vector<V3f> normals;  ///< Unit.
};

/// An animation of the file. All of them play at the same time; what two of them move follows the
/// first.
struct Animation {
    std::string name;
    double duration = 0.0;     ///< Seconds: the time of the last key.
    std::size_t channels = 0;  ///< The number of quantities that follow it.
};

/// What moves in a scene, and how.
struct Motion {
    std::vector<Animation> animations;
    std::vector<Track> tracks;
    std::vector<Node> nodes;  ///< Parents come first.
    std::vector<MovingInstance> instances;
    std::vector<MovingLight> lights;
    std::vector<MovingCamera> cameras;
    std::vector<Deformation> deformations;
};

/// A scale, then a rotation, then a translation, as glTF's nodes have them.
[[nodiscard]] M44d transform_of(const V3d& translation, const Quatd& rotation, const V3d& scale);

/// Where a node stands.
[[nodiscard]] M44d world_from_node(const Motion& motion, NodeIndex node, double time);

[[nodiscard]] Shape shape_at(const Motion& motion, const Deformation& deformation, double time);

// ----------------------------------------------------------------------- a scene at a time

/// The scene with its instances, lights, cameras and the vertices of its meshes where they stand at
/// a time, which is Scene::time of the result. What cannot stand there (a transform that is
/// singular or beyond the limits of a scene) keeps its place with a warning that names it. Shares
/// the images of textures and the meshes that keep their shape with the given scene.
[[nodiscard]] Result<Scene> moved_to(Scene scene, double time);

/// The cameras of a scene as they stand at a time. One that cannot stand there keeps its place.
[[nodiscard]] std::vector<Camera> cameras_at(const Scene& scene, double time);

/// From one time to another, in seconds.
struct TimeInterval {
    double begin = 0.0;
    double end = 0.0;

    [[nodiscard]] double duration() const { return end - begin; }
    /// The time after a part of the interval, from 0 to 1.
    [[nodiscard]] double at(double part) const { return (1.0 - part) * begin + part * end; }
    /// The part of the interval that is over at a time: 0 before it, 1 after it.
    [[nodiscard]] double part_at(double time) const {
        return time > begin ? std::min((time - begin) / duration(), 1.0) : 0.0;
    }
};

/// The places of an instance at equal steps of time, the first and the last one at the ends of the
/// interval. Between them, the elements of the matrices change linearly.
struct InstanceSteps {
    std::size_t instance = 0;  ///< Index into Scene::instances.
    std::vector<M44d> world_from_mesh;
};

/// A light at equal steps of time.
struct LightSteps {
    std::size_t light = 0;  ///< Index into Scene::lights.
    std::vector<V3d> positions;
    std::vector<V3d> directions;  ///< Unit.
};

/// The shapes of a mesh at equal steps of time. Between them, vertices move along straight lines.
struct MeshSteps {
    MeshIndex mesh;
    std::shared_ptr<const std::vector<Shape>> shapes;
};

/// How a scene moves during an interval: what does not move is not listed.
struct Movement {
    std::vector<InstanceSteps> instances;
    std::vector<LightSteps> lights;
    std::vector<MeshSteps> meshes;
};

/// The largest number of steps, as Embree has it.
inline constexpr std::size_t max_steps = 129;
/// The number of steps is such that no vertex leaves its true path by more than this part of
/// the size of its mesh, or it is the largest.
inline constexpr double step_error = 1e-3;
/// A mesh has fewer steps if they would have more vertices than this, but at least 3.
inline constexpr std::size_t max_step_vertices = std::size_t{1} << 25U;

/// The movement of a scene during an interval. Nothing moves in an interval that is an instant, or
/// not finite.
[[nodiscard]] Movement movement(const Scene& scene, const TimeInterval& interval);

}  // namespace balcony::scene
