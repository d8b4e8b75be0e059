// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/probe/object_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace balcony::render {

namespace {

using Imath::V3d;

V3d corner_of(const scene::Scene& scene, const scene::Instance& instance, std::uint32_t index) {
    return V3d(scene.meshes[instance.mesh.value()]->positions[index]) * instance.world_from_mesh;
}

// The middles of some triangles of an object, in the scene's axes.
std::vector<V3d> samples_of(const scene::Scene& scene, std::uint32_t object) {
    constexpr std::size_t wanted = 96;
    std::size_t count = 0;
    for (const scene::Instance& instance : scene.instances) {
        count +=
            instance.object == object ? scene.meshes[instance.mesh.value()]->triangles.size() : 0;
    }
    const std::size_t step = std::max<std::size_t>(count / wanted, 1);
    std::vector<V3d> samples;
    std::size_t number = 0;
    for (const scene::Instance& instance : scene.instances) {
        if (instance.object != object) {
            continue;
        }
        for (const auto& triangle : scene.meshes[instance.mesh.value()]->triangles) {
            if (number++ % step == 0) {
                samples.push_back((corner_of(scene, instance, triangle[0]) +
                                   corner_of(scene, instance, triangle[1]) +
                                   corner_of(scene, instance, triangle[2])) /
                                  3.0);
            }
        }
    }
    return samples;
}

double seen_part(const Viewer& viewer, const V3d& from, const std::vector<V3d>& samples) {
    constexpr double rounding = 1e-3;  // Of the distance, of float positions on the surface.
    std::size_t seen = 0;
    for (const V3d& sample : samples) {
        const V3d way = sample - from;
        const double distance = way.length();
        seen +=
            distance > 0.0 && viewer.distance(from, way / distance) >= (1.0 - rounding) * distance
                ? 1
                : 0;
    }
    return samples.empty() ? 0.0 : static_cast<double>(seen) / static_cast<double>(samples.size());
}

}  // namespace

V3d place_before(const scene::Scene& scene, const Viewer& viewer, std::uint32_t object,
                 const Imath::Box3d& box, const std::stop_token& stop) {
    constexpr int turns = 16;
    constexpr double degree = std::numbers::pi / 180.0;
    const V3d center = 0.5 * (box.min + box.max);
    const double radius = box.size().length() > 0.0 ? 0.5 * box.size().length() : 1.0;
    const std::vector<V3d> samples = samples_of(scene, object);
    V3d best = center + 3.0 * radius * V3d(0.0, -1.0, 0.0);
    double highest = 0.0;
    for (const double distance : {3.0, 2.2, 1.6, 1.2}) {
        for (const double elevation : {15.0 * degree, 40.0 * degree, 0.0, 70.0 * degree}) {
            for (int turn = 0; turn < turns && !stop.stop_requested(); ++turn) {
                // From the front, which is -y, alternately to both sides.
                const double angle =
                    2.0 * std::numbers::pi * ((turn + 1) / 2) * (turn % 2 == 0 ? 1 : -1) / turns;
                const V3d direction(std::sin(angle) * std::cos(elevation),
                                    -std::cos(angle) * std::cos(elevation), std::sin(elevation));
                const V3d place = center + distance * radius * direction;
                const V3d from = turned(place, Axes::z_up, scene.axes);
                const Sight round = viewer.look_round(from);
                if (round.hits > 0 && 2 * round.fronts <= round.hits) {
                    continue;  // Within a solid.
                }
                // What is as good is preferred from further in front, and from further away.
                const double merit = seen_part(viewer, from, samples) *
                                     (1.0 + 0.2 * std::cos(angle)) * std::pow(distance, 0.25);
                if (merit > highest) {
                    highest = merit;
                    best = place;
                }
            }
        }
    }
    return best;
}

}  // namespace balcony::render
