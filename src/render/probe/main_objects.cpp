// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/probe/main_objects.hpp"

#include <algorithm>
#include <vector>

namespace balcony::render {

namespace {

using Box = Imath::Box3d;
using Imath::V3d;

Box box_of(const scene::Mesh& mesh) {
    Box box;
    for (const scene::V3f& position : mesh.positions) {
        box.extendBy(V3d(position));
    }
    return box;
}

// Of the objects with a surface: around the boxes of their meshes.
std::vector<Box> boxes_of_objects(const scene::Scene& scene) {
    std::vector<Box> of_meshes;
    for (const scene::Mesh& mesh : scene.meshes) {
        of_meshes.push_back(box_of(mesh));
    }
    std::vector<Box> boxes(scene.objects.size());
    for (const scene::Instance& instance : scene.instances) {
        const Box& mesh = of_meshes[instance.mesh.value()];
        for (unsigned i = 0; i < 8 && !mesh.isEmpty(); ++i) {
            const auto side = [&](unsigned axis) {
                return ((i >> axis & 1U) != 0 ? mesh.max : mesh.min)[static_cast<int>(axis)];
            };
            boxes[instance.object].extendBy(V3d(side(0), side(1), side(2)) *
                                            instance.world_from_mesh);
        }
    }
    std::erase_if(boxes, [](const Box& box) { return box.isEmpty(); });
    return boxes;
}

double diagonal(const Box& box) { return box.size().length(); }

bool is_ground(const Box& box, Axes axes) {
    constexpr double flat = 0.05;
    const V3d size = turned(box.size(), axes, Axes::z_up);
    return std::abs(size.z) < flat * diagonal(box);
}

bool is_around(const Box& box, const Box& others) {
    const auto below = [](const V3d& a, const V3d& b) {
        return a.x < b.x && a.y < b.y && a.z < b.z;
    };
    return below(box.min, others.min) && below(others.max, box.max);
}

}  // namespace

std::optional<Imath::Box3d> box_of_main_objects(const scene::Scene& scene) {
    constexpr std::size_t most = 3;
    constexpr double much_larger = 2.0;
    std::vector<Box> boxes = boxes_of_objects(scene);
    std::stable_sort(boxes.begin(), boxes.end(),
                     [](const Box& a, const Box& b) { return diagonal(a) > diagonal(b); });
    std::optional<Box> main;
    for (std::size_t count = 1; count <= most && count < boxes.size(); ++count) {
        Box others;
        for (std::size_t i = count; i < boxes.size(); ++i) {
            others.extendBy(boxes[i]);
        }
        const bool surround = std::all_of(
            boxes.begin(), boxes.begin() + static_cast<std::ptrdiff_t>(count), [&](const Box& box) {
                return diagonal(box) > much_larger * diagonal(others) &&
                       (is_ground(box, scene.axes) || is_around(box, others));
            });
        if (surround) {
            main = others;
        }
    }
    return main;
}

}  // namespace balcony::render
