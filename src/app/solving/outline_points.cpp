// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/outline_points.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <tuple>

namespace balcony::app {

namespace {

using scene::V3d;

constexpr double parts_of_size = 16.0;  // Edges have a point at least every 16th of the size.
constexpr std::size_t most_points = 20'000;
constexpr std::size_t directions = 2'000;

bool is_before(const V3d& a, const V3d& b) {
    return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
}

void keep_each_once(std::vector<V3d>& points) {
    std::sort(points.begin(), points.end(), is_before);
    points.erase(std::unique(points.begin(), points.end()), points.end());
}

template <class Use>
void for_instances(const scene::Scene& scene, const std::vector<std::uint32_t>& objects,
                   const Use& use) {
    for (const scene::Instance& instance : scene.instances) {
        if (std::find(objects.begin(), objects.end(), instance.object) != objects.end()) {
            const scene::Mesh& mesh = scene.meshes[instance.mesh.value()];
            use(mesh,
                [&](std::uint32_t i) { return V3d(mesh.positions[i]) * instance.world_from_mesh; });
        }
    }
}

// Between the ends of an edge, which two triangles may traverse in opposite directions.
void add_between(V3d a, V3d b, double longest, std::vector<V3d>& points) {
    if (is_before(b, a)) {
        std::swap(a, b);
    }
    const double parts = std::ceil((b - a).length() / longest);
    for (double i = 1.0; i < parts; ++i) {
        points.push_back(a + i / parts * (b - a));
    }
}

// Directions on a spiral over the sphere, as far from each other as others are.
V3d direction(std::size_t i) {
    const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0));
    const double z = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / static_cast<double>(directions);
    const double radius = std::sqrt(1.0 - z * z);
    const double angle = turn * static_cast<double>(i);
    return {radius * std::cos(angle), radius * std::sin(angle), z};
}

std::vector<V3d> farthest(const std::vector<V3d>& points) {
    std::vector<V3d> made;
    for (std::size_t i = 0; i < directions; ++i) {
        const V3d along = direction(i);
        made.push_back(*std::max_element(
            points.begin(), points.end(),
            [&](const V3d& a, const V3d& b) { return a.dot(along) < b.dot(along); }));
    }
    keep_each_once(made);
    return made;
}

}  // namespace

std::vector<V3d> outline_points(const scene::Scene& scene,
                                const std::vector<std::uint32_t>& objects) {
    std::vector<V3d> points;
    Imath::Box3d box;
    for_instances(scene, objects, [&](const scene::Mesh& mesh, const auto& vertex) {
        for (const std::array<std::uint32_t, 3>& triangle : mesh.triangles) {
            for (const std::uint32_t i : triangle) {
                points.push_back(vertex(i));
                box.extendBy(points.back());
            }
        }
    });
    keep_each_once(points);
    const double longest = box.size().length() / parts_of_size;
    for_instances(scene, objects, [&](const scene::Mesh& mesh, const auto& vertex) {
        for (const auto& [a, b, c] : mesh.triangles) {
            for (const auto& [from, to] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
                add_between(vertex(from), vertex(to), longest, points);
            }
        }
    });
    keep_each_once(points);
    return points.size() > most_points ? farthest(points) : points;
}

}  // namespace balcony::app
