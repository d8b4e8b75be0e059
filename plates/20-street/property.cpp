// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <limits>
#include <unordered_map>
#include <vector>

#include <fmt/format.h>

#include "measure/measure.hpp"
#include "measure/property.hpp"
#include "scenes/street/street.hpp"

namespace balcony::plates {

namespace street_plate {

using scene::V3d;

std::string front_of(const street::Lot& lot) {
    return fmt::format("{} house {} front", lot.north ? "north" : "south", lot.number);
}

// What a picture shows of an object: its first and last column, and the box of what is seen there.
struct Seen {
    std::size_t first = std::numeric_limits<std::size_t>::max();
    std::size_t last = 0;
    double first_x = 0.0;
    double last_x = 0.0;
    double top = 0.0;

    /// Columns a metre.
    [[nodiscard]] double scale() const {
        return static_cast<double>(last - first) / std::max(last_x - first_x, 1e-9);
    }
};

std::unordered_map<std::string, Seen> seen_in(const render::Film& film) {
    std::vector<Seen> seen(film.objects.size());
    for (std::size_t i = 0; i < film.width * film.height; ++i) {
        const std::uint32_t id = film.layers->object[i];
        if (id == 0) {
            continue;
        }
        Seen& object = seen[id - 1];
        const V3d at(film.layers->position[i]);
        const std::size_t column = i % film.width;
        if (column < object.first) {
            object.first = column;
            object.first_x = at.x;
        }
        if (column >= object.last) {
            object.last = column;
            object.last_x = at.x;
        }
        object.top = std::max(object.top, at.z);
    }
    std::unordered_map<std::string, Seen> by_name;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        by_name[film.objects[i]] = seen[i];
    }
    return by_name;
}

double height_of(const scene::Scene& scene, const std::string& object) {
    double height = 0.0;
    for (const scene::Instance& instance : scene.instances) {
        if (scene.objects[instance.object].name == object) {
            for (const scene::V3f& p : scene.meshes[instance.mesh.value()]->positions) {
                height = std::max(height, (V3d(p) * instance.world_from_mesh).z);
            }
        }
    }
    return height;
}

// Every house is seen from side to side and from its foot to its top, and all have one scale along
// the street, whether they stand back or not.
Measurements measure(Studio& studio, const Overrides& overrides) {
    const render::Film film = studio.look(
        {.scene = "street", .camera = "20-street/camera.cam", .width = 1120, .height = 530},
        overrides);
    const std::unordered_map<std::string, Seen> seen = seen_in(film);
    const scene::Scene& scene = studio.scene("street");
    double width_seen = 1.0;
    double height_seen = 1.0;
    double min_scale = std::numeric_limits<double>::infinity();
    double max_scale = 0.0;
    for (const street::Lot& lot : street::lots()) {
        const Seen& front = seen.at(front_of(lot));
        width_seen = std::min(width_seen, (front.last_x - front.first_x) / lot.width);
        height_seen = std::min(height_seen, front.top / height_of(scene, front_of(lot)));
        min_scale = std::min(min_scale, front.scale());
        max_scale = std::max(max_scale, front.scale());
    }
    return {{"smallest share of a house's width that is seen", width_seen, 0.97},
            {"smallest share of a house's height that is seen", height_seen, 0.95},
            {"largest scale of a house along the street, relative to the smallest one",
             max_scale / min_scale, 1, 1.01}};
}

}  // namespace street_plate

Property plate_20() {
    return {20,
            street_plate::measure,
            {{{"converging", "0.5"}}, {{"length", "100"}}, {{"height", "12"}}}};
}

}  // namespace balcony::plates
