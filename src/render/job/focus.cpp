// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/focus.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <Imath/ImathBox.h>
#include <fmt/format.h>

#include "balcony/median.hpp"
#include "balcony/object_names.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;

// The middle of the box around the vertices of some objects, which are flagged.
V3d middle_of(const scene::Scene& scene, const std::vector<bool>& objects) {
    Imath::Box3d box;
    for (const scene::Instance& instance : scene.instances) {
        if (objects[instance.object]) {
            for (const V3f& position : scene.meshes[instance.mesh.value()]->positions) {
                box.extendBy(V3d(position) * instance.world_from_mesh);
            }
        }
    }
    return box.isEmpty() ? V3d(0.0) : box.center();
}

// How far away an object is along the rays of one layer.
class Rangefinder {
public:
    Rangefinder(const TracedScene& traced, const TileRays& rays) : traced_(traced), rays_(rays) {}

    [[nodiscard]] double operator()(const std::string& name) const {
        std::vector<bool> objects(traced_.scene->objects.size());
        for (const std::uint32_t object : scene::objects_named(*traced_.scene, name)) {
            objects[object] = true;
        }
        std::vector<double> lengths;
        for (std::size_t i = 0; i < rays_.all.size(); ++i) {
            if (traceable(rays_.all, i)) {
                if (const auto length = length_to(objects, i)) {
                    lengths.push_back(*length);
                }
            }
        }
        const std::optional<double> visible = median(std::move(lengths));
        return visible ? *visible : past(middle_of(*traced_.scene, objects));
    }

private:
    [[nodiscard]] std::optional<double> length_to(const std::vector<bool>& objects,
                                                  std::size_t i) const {
        const embree::Ray ray{.origin = V3f(rays_.all.origin(i)),
                              .direction = V3f(rays_.all.direction(i)),
                              .time = rays_.time_of(i)};
        const embree::Hit hit = rays_.shown->in(traced_).intersect(ray);
        if (!hit.any() || !objects[traced_.scene->instances[hit.instance].object]) {
            return std::nullopt;
        }
        const V3d position(traced_.surfaces.find(hit, ray.direction, ray.time).position);
        return (position - V3d(ray.origin)).length();
    }

    [[nodiscard]] double past(const V3d& point) const {
        double length = std::numeric_limits<double>::infinity();
        double smallest = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < rays_.all.size(); ++i) {
            if (!traceable(rays_.all, i)) {
                continue;
            }
            const V3d direction(V3f(rays_.all.direction(i)));
            const V3d to_point = point - V3d(V3f(rays_.all.origin(i)));
            const double along = to_point.dot(direction);
            const double angle = std::atan2(to_point.cross(direction).length(), along);
            if (along > 0.0 && angle < smallest) {
                smallest = angle;
                length = along;
            }
        }
        return length;
    }

    const TracedScene& traced_;
    const TileRays& rays_;
};

}  // namespace

Result<LensFocus> lenses_of(const camera::Picture& picture, const scene::Scene& scene) {
    LensFocus made;
    Diagnostics found;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        const camera::LensPointer& lens = shown.camera.parts().lens;
        made.any_lens = made.any_lens || lens;
        const auto object = lens ? lens->focus().object() : std::nullopt;
        if (!object ||
            std::find(made.objects.begin(), made.objects.end(), *object) != made.objects.end()) {
            continue;
        }
        made.objects.push_back(*object);
        if (scene::objects_named(scene, *object).empty()) {
            found.push_back(scene::no_object(
                scene,
                fmt::format("the lens is focused on '{}', but the scene has no object of this name",
                            printable(*object)),
                *object, shown.camera.parts().lens_span));
        }
    }
    if (!found.empty()) {
        return found;
    }
    return made;
}

std::vector<double> distances_to(const std::vector<std::string>& objects, const TracedScene& traced,
                                 PictureRays& central, const Film& film, double time) {
    std::vector<double> distances;
    TileRays grid;
    for (std::size_t layer = 0; layer < central.layer_count() && !objects.empty(); ++layer) {
        central.find_rays(layer, coarse_grid(film, time), grid);
        const Rangefinder distance(traced, grid);
        for (const std::string& object : objects) {
            distances.push_back(distance(object));
        }
    }
    return distances;
}

}  // namespace balcony::render
