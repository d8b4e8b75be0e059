// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "analyse/linear_rays.hpp"
#include "analyse/point_rays.hpp"
#include "analyse/point_search.hpp"
#include "analyse/ray_tree.hpp"

namespace balcony::analyse {

struct Locator::Index {
    PointRays rays;
    V2d picture;
    std::optional<LinearRays> linear;
    std::optional<RayTree> tree;

    Index(const camera::Camera& camera, double width, double height, double time)
        : rays(camera, width, height, time), picture(width, height) {
        Survey seen = survey(rays, width, height);
        linear = LinearRays::fit(seen);
        if (!linear) {
            const double extent = seen.extent;
            tree.emplace(divide(rays, std::move(seen)), extent);
        }
    }
};

namespace {

// Sightings nearer to each other than this are one, in pixels.
constexpr double same_place = 1e-3;

// A place that rounding put outside is put back; none if it is outside indeed.
std::optional<V2d> inside(const V2d& place, const V2d& picture) {
    constexpr double rounding = 1e-6;
    const bool is_inside =
        place.x >= -rounding && place.x < picture.x && place.y >= -rounding && place.y < picture.y;
    return is_inside ? std::optional(V2d(std::max(place.x, 0.0), std::max(place.y, 0.0)))
                     : std::nullopt;
}

// Sorts what was found by point and place and leaves out what was found before.
void tidy(std::vector<Sighting>& found) {
    std::sort(found.begin(), found.end(), [](const Sighting& a, const Sighting& b) {
        return std::tie(a.point, a.position.x, a.position.y) <
               std::tie(b.point, b.position.x, b.position.y);
    });
    std::vector<Sighting> kept;
    for (const Sighting& sighting : found) {
        bool known = false;
        for (std::size_t i = kept.size(); i-- > 0 && !known;) {
            const V2d apart = sighting.position - kept[i].position;
            if (kept[i].point != sighting.point || apart.x > same_place) {
                break;
            }
            known = std::abs(apart.y) <= same_place;
        }
        if (!known) {
            kept.push_back(sighting);
        }
    }
    found = std::move(kept);
}

// Of a camera that is solved in closed form: the place, if there is a ray and it goes forward.
void solve(const PointRays& rays, const LinearRays& linear, const V2d& picture,
           std::span<const V3d> points, std::vector<Sighting>& found) {
    PointRays::Batch batch(rays);
    std::array<std::size_t, program::max_points> numbers{};
    std::size_t count = 0;
    const auto judge = [&] {
        batch.run(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Ray ray = batch.ray(i);
            const V3d& point = points[numbers[i]];
            const Approach approach(ray, point);
            if (ray.valid && meets(ray, approach, point)) {
                found.push_back({numbers[i], batch.at(i), std::max(approach.distance, 0.0),
                                 approach.offset.length()});
            }
        }
        count = 0;
    };
    for (std::size_t number = 0; number < points.size(); ++number) {
        const std::optional<V2d> place = linear.place_of(points[number]);
        if (const auto shown = place ? inside(*place, picture) : std::nullopt) {
            batch.place(count, *shown);
            numbers[count++] = number;
        }
        if (count == program::max_points) {
            judge();
        }
    }
    judge();
}

// Of any other camera. Points come in portions, so that what is in work at once stays small.
void search(const PointRays& rays, const RayTree& tree, const V2d& picture,
            std::span<const V3d> points, std::vector<Sighting>& found) {
    constexpr std::size_t portion = 256;
    PointSearch newton(rays);
    std::vector<std::uint32_t> patches;
    std::vector<SearchStart> starts;
    for (std::size_t begin = 0; begin < points.size(); begin += portion) {
        starts.clear();
        const std::size_t end = std::min(begin + portion, points.size());
        for (std::size_t number = begin; number < end; ++number) {
            patches.clear();
            tree.find(points[number], patches);
            for (const std::uint32_t patch : patches) {
                add_starts(tree.patches()[patch], number, points[number], starts);
            }
        }
        newton.run(starts, found);
    }
    std::erase_if(found, [&](Sighting& sighting) {
        const std::optional<V2d> place = inside(sighting.position, picture);
        sighting.position = place.value_or(sighting.position);
        return !place;
    });
}

}  // namespace

Result<Locator> Locator::make(const camera::Camera& camera, double width, double height,
                              double time) {
    if (!(width > 0.0 && height > 0.0 && std::isfinite(width) && std::isfinite(height))) {
        return error(fmt::format("a picture of {} x {} pixels has no places", width, height), {},
                     "give a positive width and height");
    }
    return Locator(std::make_shared<const Index>(camera, width, height, time));
}

std::vector<Sighting> Locator::locate(const V3d& point) const {
    return locate(std::span(&point, 1));
}

std::vector<Sighting> Locator::locate(std::span<const V3d> points) const {
    std::vector<Sighting> found;
    if (index_->linear) {
        solve(index_->rays, *index_->linear, index_->picture, points, found);
    } else {
        search(index_->rays, *index_->tree, index_->picture, points, found);
    }
    tidy(found);
    return found;
}

bool Locator::closed_form() const { return index_->linear.has_value(); }

std::size_t Locator::patch_count() const {
    return index_->tree ? index_->tree->patches().size() : 0;
}

}  // namespace balcony::analyse
