// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scene/edits/edited_motion.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>
#include <utility>
#include <vector>

#include "scene/placement.hpp"

namespace balcony::scene {

namespace {

// The motion of a scene, to be changed; copies of the scene keep theirs. There is none where
// nothing moves.
template <class Change>
void edit(Scene& scene, const Change& change) {
    if (scene.motion) {
        auto changed = std::make_shared<Motion>(*scene.motion);
        change(*changed);
        const bool is_at_rest = changed->instances.empty() && changed->lights.empty() &&
                                changed->cameras.empty() && changed->deformations.empty();
        scene.motion = is_at_rest ? nullptr : std::move(changed);
    }
}

// Keeps the moving parts that are still there, by their new numbers.
template <class Moving>
void renumber(std::vector<Moving>& all, std::size_t Moving::*member, const NewNumber& number) {
    std::erase_if(all, [&](const Moving& one) { return !number(one.*member); });
    for (Moving& one : all) {
        one.*member = *number(one.*member);
    }
}

// Marks a node and all above it.
void mark(const std::vector<Node>& nodes, NodeIndex node, std::vector<bool>& marked) {
    for (; node.valid() && !marked[node.value()]; node = nodes[node.value()].parent) {
        marked[node.value()] = true;
    }
}

// The nodes that something else than an object hangs on.
std::vector<bool> nodes_of_others(const Scene& scene, const Motion& motion, std::size_t object) {
    std::vector<bool> marked(motion.nodes.size());
    for (const MovingInstance& moving : motion.instances) {
        if (scene.instances[moving.instance].object != object) {
            mark(motion.nodes, moving.node, marked);
        }
    }
    for (const MovingLight& moving : motion.lights) {
        mark(motion.nodes, moving.node, marked);
    }
    for (const MovingCamera& moving : motion.cameras) {
        mark(motion.nodes, moving.node, marked);
    }
    for (const Deformation& deformation : motion.deformations) {
        for (const Joint& joint : deformation.joints) {
            mark(motion.nodes, joint.node, marked);
        }
    }
    return marked;
}

// Nodes of an object's own: those that it shares are copied.
class OwnNodes {
public:
    OwnNodes(Motion& motion, std::vector<bool> shared)
        : motion_(motion), shared_(std::move(shared)) {}

    NodeIndex own(NodeIndex node) {
        const auto known = own_.find(node);
        if (known != own_.end()) {
            return known->second;
        }
        const NodeIndex parent = motion_.nodes[node.value()].parent;
        const NodeIndex own_parent = parent.valid() ? own(parent) : parent;
        NodeIndex made = node;
        if (shared_[node.value()] || own_parent != parent) {
            Node copy = motion_.nodes[node.value()];
            copy.parent = own_parent;
            motion_.nodes.push_back(copy);
            made = NodeIndex(motion_.nodes.size() - 1);
        }
        if (!parent.valid()) {
            roots_.insert(made);
        }
        return own_[node] = made;
    }
    /// Those above which nothing moves.
    [[nodiscard]] const std::set<NodeIndex>& roots() const { return roots_; }

private:
    Motion& motion_;
    std::vector<bool> shared_;
    std::map<NodeIndex, NodeIndex> own_;
    std::set<NodeIndex> roots_;
};

}  // namespace

void renumber_instances(Scene& scene, const NewNumber& number) {
    edit(scene,
         [&](Motion& motion) { renumber(motion.instances, &MovingInstance::instance, number); });
}

void renumber_meshes(Scene& scene, const NewNumber& number) {
    edit(scene, [&](Motion& motion) {
        std::erase_if(motion.deformations, [&](const Deformation& deformation) {
            return !number(deformation.mesh.value());
        });
        for (Deformation& deformation : motion.deformations) {
            deformation.mesh = MeshIndex(*number(deformation.mesh.value()));
        }
    });
}

void renumber_lights(Scene& scene, const NewNumber& number) {
    edit(scene, [&](Motion& motion) { renumber(motion.lights, &MovingLight::light, number); });
}

void stop_object(Scene& scene, std::size_t object) {
    edit(scene, [&](Motion& motion) {
        std::erase_if(motion.instances, [&](const MovingInstance& moving) {
            return scene.instances[moving.instance].object == object;
        });
    });
}

void stop_light(Scene& scene, std::size_t light) {
    edit(scene, [&](Motion& motion) {
        std::erase_if(motion.lights,
                      [&](const MovingLight& moving) { return moving.light == light; });
    });
}

void transform_paths(Scene& scene, std::size_t object, const M44d& change) {
    edit(scene, [&](Motion& motion) {
        OwnNodes nodes(motion, nodes_of_others(scene, motion, object));
        std::vector<MovingInstance*> moved;
        for (MovingInstance& moving : motion.instances) {
            if (scene.instances[moving.instance].object == object) {
                moving.node = nodes.own(moving.node);
                moved.push_back(&moving);
            }
        }
        for (const NodeIndex root : nodes.roots()) {
            motion.nodes[root.value()].world_from_parent *= change;
        }
        for (const MovingInstance* const one : moved) {
            Instance& instance = scene.instances[one->instance];
            const M44d placed = world_from_node(motion, one->node, scene.time);
            const Box3f box = box_of(scene.meshes[instance.mesh.value()]->positions);
            instance.world_from_mesh =
                fault_of_placement(box, placed) ? instance.world_from_mesh : placed;
        }
    });
}

}  // namespace balcony::scene
