// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inverse.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <tuple>

#include <fmt/format.h>

#include "analyse/inverse/linear_rays.hpp"
#include "analyse/inverse/point_portions.hpp"
#include "analyse/inverse/point_rays.hpp"
#include "analyse/inverse/point_search.hpp"
#include "analyse/inverse/ray_tree.hpp"
#include "base/precondition.hpp"

namespace balcony::analyse {

namespace {

// Sightings closer to each other than this, in pixels, are merged.
constexpr double same_place = 1e-3;

// Each straight part of bent rays is searched by itself: those of a bend, and what is behind it.
constexpr std::size_t max_searched_parts = 64 + 1;

// Clamps a position that rounding moved outside; nothing if it is really outside.
std::optional<V2d> inside(const V2d& place, const V2d& picture) {
    constexpr double rounding = 1e-6;
    const bool is_inside =
        place.x >= -rounding && place.x < picture.x && place.y >= -rounding && place.y < picture.y;
    return is_inside ? std::optional(V2d(std::max(place.x, 0.0), std::max(place.y, 0.0)))
                     : std::nullopt;
}

// Beyond this distance, in scene units, only the direction matters, and products of
// coordinates could overflow.
constexpr double far_away = 1e60;

double max_coordinate(const V3d& point) {
    return std::max({std::abs(point.x), std::abs(point.y), std::abs(point.z)});
}

// By point, then from left to right.
bool comes_before(const Sighting& a, const Sighting& b) {
    return std::tie(a.point, a.position.x, a.position.y) <
           std::tie(b.point, b.position.x, b.position.y);
}

// Sorts the sightings and removes duplicates.
void tidy(std::vector<Sighting>& found) {
    if (!std::is_sorted(found.begin(), found.end(), comes_before)) {
        std::sort(found.begin(), found.end(), comes_before);
    }
    std::size_t kept = 0;
    for (const Sighting& sighting : found) {
        bool known = false;
        for (std::size_t i = kept; i-- > 0 && !known;) {
            const V2d apart = sighting.position - found[i].position;
            if (found[i].point != sighting.point || apart.x > same_place) {
                break;
            }
            known = std::abs(apart.y) <= same_place;
        }
        if (!known) {
            found[kept++] = sighting;
        }
    }
    found.resize(kept);
}

// The end of a straight part of bent rays is the beginning of the next: a point there is found on
// both. They are in order.
void remove_doubles(std::vector<Sighting>& found) {
    std::vector<Sighting> kept;
    for (const Sighting& one : found) {
        const auto is_same = [&](const Sighting& other) {
            return other.point == one.point && other.layer == one.layer &&
                   (other.position - one.position).length() <= same_place;
        };
        if (std::none_of(kept.begin(), kept.end(), is_same)) {
            kept.push_back(one);
        }
    }
    found = std::move(kept);
}

// Closed-form rays: the position, if there is a ray and the point is in front of its origin.
void solve(const PointRays& rays, const LinearRays& linear, const V2d& picture,
           std::span<const V3d> points, std::vector<Sighting>& found, const Work& work) {
    PointRays::Batch batch(rays, work);
    std::array<std::size_t, program::max_points> numbers{};
    std::size_t count = 0;
    const auto judge = [&] {
        batch.run(count);
        for (std::size_t i = 0; i < count; ++i) {
            const Ray ray = batch.ray(i);
            const V3d& point = points[numbers[i]];
            const Approach approach(ray, point);
            if (ray.valid && meets(ray, approach, point)) {
                found.push_back(sighting_of(numbers[i], batch.at(i), ray, approach));
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

// All other rays. Points are processed in batches, to limit memory. Points that more patches may
// see than can be searched are searched in part.
void search(const PointRays& rays, const RayTree& tree, const V2d& picture,
            std::span<const V3d> points, std::vector<Sighting>& found,
            std::vector<std::size_t>& in_part, const Work& work) {
    constexpr std::size_t portion = 256;
    constexpr std::size_t max_starts = 4096;
    PointSearch newton(rays, work);
    std::vector<std::uint32_t> patches;
    std::vector<SearchStart> starts;
    for (std::size_t begin = 0; begin < points.size(); begin += portion) {
        starts.clear();
        work.done(static_cast<double>(begin) / static_cast<double>(points.size()));
        const std::size_t end = std::min(begin + portion, points.size());
        for (std::size_t number = begin; number < end; ++number) {
            work.go_on();
            patches.clear();
            tree.find(points[number], patches);
            const std::size_t enough = starts.size() + max_starts;
            for (const std::uint32_t patch : patches) {
                if (starts.size() >= enough) {
                    in_part.push_back(number);
                    break;
                }
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

// The lengths of bent rays count from the beginning of their paths. Leaves out sightings that are
// not on the straight part that was searched.
void keep_part(const PointRays& rays, std::vector<Sighting>& found, const Work& work) {
    PointRays::Batch batch(rays, work);
    std::size_t kept = 0;
    for (std::size_t begin = 0; begin < found.size(); begin += program::max_points) {
        const std::size_t count = std::min(program::max_points, found.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            batch.place(i, found[begin + i].position);
        }
        batch.run(count);
        for (std::size_t i = 0; i < count; ++i) {
            PointRays::Batch::Path path = batch.path(i);
            Sighting sighting = found[begin + i];
            constexpr double rounding = 1e-9;
            if (sighting.distance <= path.length + rounding * (path.before + path.length)) {
                sighting.origin = path.origin;
                sighting.distance += path.before;
                sighting.turns = std::move(path.turns);
                found[kept++] = sighting;
            }
        }
    }
    found.resize(kept);
}

// The search in one camera layer, along one straight part of its rays.
class LayerIndex {
public:
    LayerIndex(const rays::VisibleLayer& layer, std::size_t number, std::size_t part,
               const V2d& picture, double time, const Work& work)
        : name_(layer.name), number_(number), picture_(picture), rays_(layer.rays, time, part) {
        Survey seen = survey(rays_, picture, work);
        linear_ = LinearRays::fit(seen);
        if (!linear_) {
            const double extent = seen.extent;
            Division division = divide(rays_, std::move(seen), work.part(0.1, 0.9));
            divided_ = division.complete;
            tree_.emplace(std::move(division.patches), extent, work);
        }
        work.done(1.0);
    }

    [[nodiscard]] const std::string& name() const { return name_; }
    /// That of the layer.
    [[nodiscard]] std::size_t number() const { return number_; }
    [[nodiscard]] bool closed_form() const { return linear_.has_value(); }
    [[nodiscard]] std::size_t patch_count() const { return tree_ ? tree_->patches().size() : 0; }
    /// Whether its patches are as small as they should be.
    [[nodiscard]] bool divided() const { return divided_; }

    [[nodiscard]] std::vector<Sighting> locate(std::span<const V3d> points,
                                               std::vector<std::size_t>& in_part,
                                               const Work& work) const {
        std::vector<Sighting> found;
        if (linear_) {
            solve(rays_, *linear_, picture_, points, found, work);
        } else {
            search(rays_, *tree_, picture_, points, found, in_part, work);
        }
        if (rays_.is_bent()) {
            keep_part(rays_, found, work);
        }
        tidy(found);
        return found;
    }

private:
    std::string name_;
    std::size_t number_;
    V2d picture_;
    PointRays rays_;
    std::optional<LinearRays> linear_;
    std::optional<RayTree> tree_;
    bool divided_ = true;
};

// Leaves out sightings in layers that are hidden there by what is in front of them.
void remove_hidden(const rays::VisibleLayers& layers, double time, std::vector<Sighting>& found) {
    using Values = std::array<double, program::max_points>;
    rays::Scratch scratch;
    Values x{};
    Values y{};
    std::vector<Values> hidden(layers.layers().size());
    std::vector<double*> results;
    std::transform(hidden.begin(), hidden.end(), std::back_inserter(results),
                   [](Values& values) { return values.data(); });
    std::size_t kept = 0;
    for (std::size_t begin = 0; begin < found.size(); begin += program::max_points) {
        const std::size_t count = std::min(program::max_points, found.size() - begin);
        for (std::size_t i = 0; i < count; ++i) {
            x[i] = found[begin + i].position.x;
            y[i] = found[begin + i].position.y;
        }
        layers.run_hidden({std::span(x).first(count), std::span(y).first(count), time}, scratch,
                          results);
        for (std::size_t i = 0; i < count; ++i) {
            if (hidden[found[begin + i].layer][i] == 0.0) {
                found[kept++] = found[begin + i];
            }
        }
    }
    found.resize(kept);
}

}  // namespace

std::vector<const Sighting*> foremost(std::span<const Sighting> sightings, std::size_t points) {
    std::vector<const Sighting*> chosen(points, nullptr);
    for (const Sighting& one : sightings) {
        const Sighting*& best = chosen[one.point];
        if (best == nullptr || one.layer > best->layer ||
            (one.layer == best->layer && one.distance < best->distance)) {
            best = &one;
        }
    }
    return chosen;
}

class Locator::Index {
public:
    Index(rays::VisibleLayers visible, const V2d& picture, double time, const Work& work)
        : visible_(std::move(visible)), time_(time) {
        std::size_t count = 0;
        for (const rays::VisibleLayer& layer : visible_.layers()) {
            count += layer.rays.part_count();
        }
        const auto part_of_work = [&](std::size_t i) {
            return static_cast<double>(i) / static_cast<double>(count);
        };
        for (std::size_t number = 0; number < visible_.layers().size(); ++number) {
            const rays::VisibleLayer& layer = visible_.layers()[number];
            for (std::size_t part = 0; part < layer.rays.part_count(); ++part) {
                layers_.emplace_back(
                    layer, number, part, picture, time,
                    work.part(part_of_work(layers_.size()), part_of_work(layers_.size() + 1)));
            }
        }
    }

    [[nodiscard]] Axes axes() const { return visible_.layers().front().axes; }
    [[nodiscard]] const std::vector<rays::VisibleLayer>& visible() const {
        return visible_.layers();
    }
    /// A layer has one of these for each straight part of its rays.
    [[nodiscard]] const std::vector<LayerIndex>& layers() const { return layers_; }

    // Points beyond far_away are moved to that distance.
    [[nodiscard]] std::vector<Sighting> locate(std::span<const V3d> points,
                                               std::vector<std::size_t>& in_part,
                                               const Work& work) const {
        const auto beyond = [](const V3d& p) { return max_coordinate(p) > far_away; };
        if (std::none_of(points.begin(), points.end(), beyond)) {
            return locate_near(points, in_part, work);
        }
        std::vector<V3d> nearer(points.begin(), points.end());
        for (V3d& point : nearer) {
            if (beyond(point)) {
                point = point / max_coordinate(point) * far_away;
            }
        }
        std::vector<Sighting> found = locate_near(nearer, in_part, work);
        for (Sighting& sighting : found) {
            if (beyond(points[sighting.point])) {
                const double times = max_coordinate(points[sighting.point]) / far_away;
                sighting.distance *= times;
                sighting.miss *= times;
            }
        }
        return found;
    }

private:
    [[nodiscard]] std::vector<Sighting> locate_near(std::span<const V3d> points,
                                                    std::vector<std::size_t>& in_part,
                                                    const Work& work) const {
        if (layers_.size() == 1 && !visible_.any_hidden()) {
            return layers_.front().locate(points, in_part, work);
        }
        std::vector<Sighting> all;
        const auto count = static_cast<double>(layers_.size());
        for (std::size_t number = 0; number < layers_.size(); ++number) {
            const Work own = work.part(static_cast<double>(number) / count,
                                       static_cast<double>(number + 1) / count);
            for (Sighting& sighting : layers_[number].locate(points, in_part, own)) {
                sighting.layer = layers_[number].number();
                all.push_back(sighting);
            }
        }
        if (visible_.any_hidden()) {
            remove_hidden(visible_, time_, all);
        }
        std::stable_sort(all.begin(), all.end(), comes_before);
        if (layers_.size() > visible_.layers().size()) {
            remove_doubles(all);
        }
        return all;
    }

    rays::VisibleLayers visible_;
    double time_;
    std::vector<LayerIndex> layers_;
};

Result<Locator> Locator::make(const camera::Picture& picture, double width, double height,
                              double time, std::optional<Axes> axes, const PartDone& progress,
                              std::stop_token stop) {
    return unless_stopped(
        [&] { return make(picture, width, height, time, axes, Work(progress, std::move(stop))); });
}

Result<Locator> Locator::make(const camera::Picture& picture, double width, double height,
                              double time, std::optional<Axes> axes, const Work& work) {
    Result<rays::VisibleLayers> visible = rays::compile_layers(
        picture, width, height,
        {.axes = axes, .footprints = true, .tiles = false, .points = true, .bends = true},
        work.stop());
    if (!visible) {
        return visible.diagnostics;
    }
    const auto& layers = visible->layers();
    for (const rays::VisibleLayer& layer : layers) {
        if (layer.rays.part_count() > max_searched_parts) {
            return error(fmt::format("the rays of '{}' have {} straight parts, of which points are "
                                     "searched along at most {}",
                                     layer.name, layer.rays.part_count(), max_searched_parts),
                         {}, "give its bend a larger tolerance, or fewer parts");
        }
    }
    const auto differs = [&](const rays::VisibleLayer& one) { return one.axes != layers[0].axes; };
    if (std::any_of(layers.begin(), layers.end(), differs)) {
        return error(fmt::format("the cameras of picture '{}' have different axes", picture.name()),
                     {}, "specify the axes of the points: y_up or z_up");
    }
    const auto index =
        std::make_shared<const Index>(std::move(*visible), V2d(width, height), time, work);
    Diagnostics diagnostics;
    for (const LayerIndex& layer : index->layers()) {
        if (!layer.divided()) {
            diagnostics.push_back(warning(
                fmt::format("the rays of '{}' change so often from place to place that not all "
                            "places can be searched",
                            layer.name()),
                {}, "check the ranges of its map"));
        }
    }
    return {Locator(index), std::move(diagnostics)};
}

Axes Locator::axes() const { return index_->axes(); }

std::vector<std::string> Locator::layers() const {
    std::vector<std::string> names;
    for (const rays::VisibleLayer& layer : index_->visible()) {
        names.push_back(layer.name);
    }
    return names;
}

std::vector<Sighting> Locator::locate(const V3d& point) const {
    return locate(std::span(&point, 1));
}

std::vector<Sighting> Locator::locate(std::span<const V3d> points) const {
    std::vector<std::size_t> in_part;
    return index_->locate(points, in_part, Work());
}

Result<std::vector<Sighting>> Locator::locate(std::span<const V3d> points,
                                              std::vector<std::size_t>& in_part,
                                              const PartDone& progress,
                                              std::stop_token stop) const {
    return unless_stopped([&]() -> Result<std::vector<Sighting>> {
        in_part.clear();
        const Work work(progress, std::move(stop));
        std::vector<Sighting> found = locate_in_portions(
            points, in_part, work, [this](auto some, auto& in_part_of_some, const Work& own) {
                return index_->locate(some, in_part_of_some, own);
            });
        std::sort(in_part.begin(), in_part.end());
        in_part.erase(std::unique(in_part.begin(), in_part.end()), in_part.end());
        work.done(1.0);
        return found;
    });
}

void Locator::find(std::span<const rays::ImagePointQuery> queries,
                   std::span<rays::ImagePoint> found) const {
    precondition(found.size() == queries.size(), "each query of an image point has a result");
    std::vector<V3d> points;
    points.reserve(queries.size());
    for (const rays::ImagePointQuery& query : queries) {
        points.push_back(query.point);
    }
    std::fill(found.begin(), found.end(), rays::ImagePoint{0, V2d(0.0)});
    for (const Sighting& sighting : locate(points)) {
        const rays::ImagePointQuery& query = queries[sighting.point];
        rays::ImagePoint& nearest = found[sighting.point];
        if (sighting.layer != query.layer) {
            continue;
        }
        const auto distance = [&](const V2d& place) { return (place - query.expected).length2(); };
        if (nearest.places == 0 || distance(sighting.position) < distance(nearest.position)) {
            nearest.position = sighting.position;
        }
        ++nearest.places;
    }
}

bool Locator::closed_form() const {
    return std::all_of(index_->layers().begin(), index_->layers().end(),
                       [](const LayerIndex& layer) { return layer.closed_form(); });
}

std::size_t Locator::patch_count() const {
    std::size_t count = 0;
    for (const LayerIndex& layer : index_->layers()) {
        count += layer.patch_count();
    }
    return count;
}

}  // namespace balcony::analyse
