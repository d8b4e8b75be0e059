// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "scenes/temple/measure_temple.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "measure/measure.hpp"
#include "scenes/temple/dimensions.hpp"

namespace balcony::plates {

using scene::V3d;

namespace {

double distance_from_axis(const V3d& point) { return std::hypot(point.x, point.y); }

}  // namespace

bool Extent::about(const V3d& point) const {
    const double r = distance_from_axis(point);
    return r >= min_r && r <= max_r;
}

Extent extent_of(const scene::Scene& scene, const std::string& object) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    Extent extent{infinite, 0.0, infinite, -infinite};
    for (const scene::Instance& instance : scene.instances) {
        if (scene.objects.at(instance.object).name != object) {
            continue;
        }
        for (const scene::V3f& position : scene.meshes.at(instance.mesh.value())->positions) {
            const V3d point = V3d(position) * instance.world_from_mesh;
            const double r = distance_from_axis(point);
            extent.min_r = std::min(extent.min_r, r);
            extent.max_r = std::max(extent.max_r, r);
            extent.min_z = std::min(extent.min_z, point.z);
            extent.max_z = std::max(extent.max_z, point.z);
        }
    }
    if (extent.min_r > extent.max_r) {
        throw std::runtime_error("no object is named " + object);
    }
    return extent;
}

double clearance(const render::Film& film) {
    double least = std::numeric_limits<double>::infinity();
    for (const scene::V3f& origin : film.layers.value().origin) {
        const V3d point(origin);
        if (point.z > temple::spring_z) {
            continue;
        }
        for (int k = 0; k < temple::column_count; ++k) {
            const V3d axis(temple::radius * std::cos(k * temple::bay),
                           temple::radius * std::sin(k * temple::bay), point.z);
            least = std::min(least, (point - axis).length());
        }
    }
    return least;
}

double share_of(const render::Film& film, const std::string& begin) {
    const auto& ids = film.layers.value().object;
    const auto shown = std::count_if(ids.begin(), ids.end(), [&](std::uint32_t id) {
        return id != 0 && film.objects.at(id - 1).starts_with(begin);
    });
    return static_cast<double>(shown) / static_cast<double>(ids.size());
}

double share_from_outside(const render::Film& film) {
    const render::DataLayers& layers = film.layers.value();
    std::size_t columns = 0;
    std::size_t outside = 0;
    for (std::size_t i = 0; i < layers.object.size(); ++i) {
        const std::uint32_t id = layers.object[i];
        if (id == 0 || !film.objects.at(id - 1).starts_with("column ")) {
            continue;
        }
        ++columns;
        const V3d position(layers.position[i]);
        const V3d away = V3d(position.x, position.y, 0.0).normalized();
        outside +=
            away.dot(V3d(layers.direction[i])) < 0.0 && away.dot(V3d(layers.normal[i])) > -0.5 ? 1
                                                                                               : 0;
    }
    return static_cast<double>(outside) / static_cast<double>(columns);
}

}  // namespace balcony::plates
