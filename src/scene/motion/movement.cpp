// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "balcony/motion.hpp"
#include "scene/geometry.hpp"
#include "scene/import.hpp"
#include "scene/motion/equal_steps.hpp"
#include "scene/placement.hpp"

namespace balcony::scene {

namespace {

// Animators hide things by a scale of 0. They become very small instead, so that a node always has
// an inverse.
double not_zero(double scale) {
    constexpr double smallest = 1e-6;
    return std::abs(scale) < smallest ? std::copysign(smallest, scale) : scale;
}

V3d vector_at(const Motion& motion, TrackIndex track, double time, const V3d& fallback) {
    if (!track.valid()) {
        return fallback;
    }
    std::array<double, 3> v{};
    evaluate(motion.tracks[track.value()], time, v);
    return {v[0], v[1], v[2]};
}

M44d parent_from_node(const Motion& motion, const Node& node, double time) {
    if (!node.translation_track.valid() && !node.rotation_track.valid() &&
        !node.scale_track.valid()) {
        return node.parent_from_node;
    }
    const V3d scale = vector_at(motion, node.scale_track, time, node.scale);
    const Quatd turn = node.rotation_track.valid()
                           ? evaluate_rotation(motion.tracks[node.rotation_track.value()], time)
                           : node.rotation;
    return transform_of(vector_at(motion, node.translation_track, time, node.translation), turn,
                        node.scale_track.valid()
                            ? V3d(not_zero(scale.x), not_zero(scale.y), not_zero(scale.z))
                            : scale);
}

// The bounds of meshes, each computed when it is needed.
class Boxes {
public:
    explicit Boxes(const Scene& scene) : scene_(scene) {}

    const Box3f& of(const Instance& instance) {
        std::optional<Box3f>& box = boxes_[instance.mesh.value()];
        if (!box) {
            box = box_of(scene_.meshes[instance.mesh.value()]->positions);
        }
        return *box;
    }

private:
    const Scene& scene_;
    std::map<std::uint32_t, std::optional<Box3f>> boxes_;
};

// The most keys that a track has within an interval.
std::size_t keys_within(const Motion& motion, const TimeInterval& interval) {
    std::size_t most = 0;
    for (const Track& track : motion.tracks) {
        const auto first = std::upper_bound(track.times.begin(), track.times.end(), interval.begin);
        const auto last = std::lower_bound(first, track.times.end(), interval.end);
        most = std::max(most, static_cast<std::size_t>(last - first));
    }
    return most;
}

// How far a corner of a box is moved at most by the difference between a matrix and the line from
// one to another.
double deviation(const Box3f& box, const M44d& matrix, const M44d& a, const M44d& b, double part) {
    double largest = 0.0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto side = [&](unsigned axis) {
            const V3f& end = (corner >> axis & 1U) != 0 ? box.max : box.min;
            return double{end[static_cast<int>(axis)]};
        };
        const V3d p(side(0), side(1), side(2));
        const V3d line = (1.0 - part) * (p * a) + part * (p * b);
        largest = std::max(largest, (p * matrix - line).length());
    }
    return largest;
}

std::string not_moved(std::string_view what, const std::string& name, double time,
                      const std::string& fault) {
    return fmt::format("{} {} keeps its place at time {:g}: {}", what, in_quotes(name), time,
                       fault);
}

InstanceSteps steps_of(const Scene& scene, const MovingInstance& moving, const Box3f& box,
                       const TimeInterval& interval, std::size_t pieces) {
    const M44d& now = scene.instances[moving.instance].world_from_mesh;
    const auto at = [&](double part) {
        const M44d placed = world_from_node(*scene.motion, moving.node, interval.at(part));
        return fault_of_placement(box, placed) ? now : placed;
    };
    const auto distance = [&](const M44d& matrix, const M44d& a, const M44d& b, double part) {
        return deviation(box, matrix, a, b, part);
    };
    V3d diagonal;
    now.multDirMatrix(V3d(box.size()), diagonal);
    return {moving.instance, equal_steps(at, distance, step_error * diagonal.length(), pieces)};
}

// The largest distance of a vertex from the line between two shapes.
double deviation(const Shape& shape, const Shape& a, const Shape& b, double part) {
    const auto t = static_cast<float>(part);
    float largest = 0.0F;
    for (std::size_t v = 0; v < shape.positions.size(); ++v) {
        const V3f line = (1.0F - t) * a.positions[v] + t * b.positions[v];
        largest = std::max(largest, (shape.positions[v] - line).length());
    }
    return static_cast<double>(largest);
}

bool is_usable(const Shape& shape) {
    return std::all_of(shape.positions.begin(), shape.positions.end(), usable);
}

// A power of 2 and 1.
std::size_t largest_step_count(std::size_t vertices) {
    const std::size_t most = max_step_vertices / std::max<std::size_t>(vertices, 1);
    return std::clamp<std::size_t>(std::bit_floor(most), 2, max_steps - 1) + 1;
}

MeshSteps steps_of(const Scene& scene, const Deformation& deformation, const TimeInterval& interval,
                   std::size_t pieces) {
    const Mesh& mesh = scene.meshes[deformation.mesh.value()];
    const auto at = [&](double part) {
        Shape shape = shape_at(*scene.motion, deformation, interval.at(part));
        return is_usable(shape) ? shape : Shape{mesh.positions, mesh.normals};
    };
    const auto distance = [](const Shape& shape, const Shape& a, const Shape& b, double part) {
        return deviation(shape, a, b, part);
    };
    const auto size = static_cast<double>(box_of(mesh.positions).size().length());
    return {deformation.mesh, std::make_shared<const std::vector<Shape>>(
                                  equal_steps(at, distance, step_error * size, pieces,
                                              largest_step_count(mesh.positions.size())))};
}

LightSteps steps_of(const Scene& scene, const MovingLight& moving, const TimeInterval& interval) {
    LightSteps steps{moving.light, {}, {}};
    for (std::size_t i = 0; i < max_steps; ++i) {
        const double part = static_cast<double>(i) / static_cast<double>(max_steps - 1);
        Light light = scene.lights[moving.light];
        static_cast<void>(
            place(light, world_from_node(*scene.motion, moving.node, interval.at(part))));
        steps.positions.push_back(light.position);
        steps.directions.push_back(light.direction);
    }
    return steps;
}

bool moves(const LightSteps& steps) {
    const auto differ = [](const std::vector<V3d>& values) {
        return std::any_of(values.begin(), values.end(),
                           [&](const V3d& value) { return value != values.front(); });
    };
    return differ(steps.positions) || differ(steps.directions);
}

}  // namespace

M44d transform_of(const V3d& translation, const Quatd& rotation, const V3d& scale) {
    M44d scaled;
    scaled.setScale(scale);
    M44d moved;
    moved.setTranslation(translation);
    return scaled * rotation.toMatrix44() * moved;
}

M44d world_from_node(const Motion& motion, NodeIndex index, double time) {
    M44d world;
    for (;;) {
        const Node& node = motion.nodes[index.value()];
        world = world * parent_from_node(motion, node, time);
        if (!node.parent.valid()) {
            return world * node.world_from_parent;
        }
        index = node.parent;
    }
}

Result<Scene> moved_to(Scene scene, double time) {
    scene.time = time;
    if (!scene.motion) {
        return scene;
    }
    Diagnostics found;
    const Motion& motion = *scene.motion;
    const auto warn = [&](std::string_view what, const std::string& name,
                          const PlacementFault& fault) {
        if (fault && found.size() < Import::max_warnings) {
            found.push_back(warning(not_moved(what, name, time, *fault)));
        }
    };
    Boxes boxes(scene);
    for (const MovingInstance& moving : motion.instances) {
        Instance& instance = scene.instances[moving.instance];
        const M44d placed = world_from_node(motion, moving.node, time);
        const PlacementFault fault = fault_of_placement(boxes.of(instance), placed);
        warn("object", scene.objects[instance.object].name, fault);
        instance.world_from_mesh = fault ? instance.world_from_mesh : placed;
    }
    for (const MovingLight& moving : motion.lights) {
        Light& light = scene.lights[moving.light];
        warn("light", light.name, place(light, world_from_node(motion, moving.node, time)));
    }
    for (const MovingCamera& moving : motion.cameras) {
        Camera& camera = scene.cameras[moving.camera];
        warn("camera", camera.name, place(camera, world_from_node(motion, moving.node, time)));
    }
    for (const Deformation& deformation : motion.deformations) {
        Shared<Mesh>& mesh = scene.meshes[deformation.mesh.value()];
        Shape shape = shape_at(motion, deformation, time);
        if (is_usable(shape)) {
            Mesh& deformed = mesh.edit();
            deformed.positions = std::move(shape.positions);
            deformed.normals = std::move(shape.normals);
        } else {
            warn("mesh", mesh->name, "a vertex is not finite or too large");
        }
    }
    return {std::move(scene), std::move(found)};
}

std::vector<Camera> cameras_at(const Scene& scene, double time) {
    std::vector<Camera> cameras = scene.cameras;
    if (scene.motion) {
        for (const MovingCamera& moving : scene.motion->cameras) {
            static_cast<void>(
                place(cameras[moving.camera], world_from_node(*scene.motion, moving.node, time)));
        }
    }
    return cameras;
}

Movement movement(const Scene& scene, const TimeInterval& interval) {
    Movement found;
    if (!scene.motion || !(interval.duration() > 0.0) || !std::isfinite(interval.duration())) {
        return found;
    }
    const std::size_t pieces = keys_within(*scene.motion, interval) + 1;
    Boxes boxes(scene);
    for (const MovingInstance& moving : scene.motion->instances) {
        InstanceSteps steps =
            steps_of(scene, moving, boxes.of(scene.instances[moving.instance]), interval, pieces);
        if (steps.world_from_mesh.size() > 1) {
            found.instances.push_back(std::move(steps));
        }
    }
    for (const MovingLight& moving : scene.motion->lights) {
        LightSteps steps = steps_of(scene, moving, interval);
        if (moves(steps)) {
            found.lights.push_back(std::move(steps));
        }
    }
    for (const Deformation& deformation : scene.motion->deformations) {
        MeshSteps steps = steps_of(scene, deformation, interval, pieces);
        if (steps.shapes->size() > 1) {
            found.meshes.push_back(std::move(steps));
        }
    }
    return found;
}

}  // namespace balcony::scene
