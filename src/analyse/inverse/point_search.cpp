// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/inverse/point_search.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace balcony::analyse {

namespace {

// How far from the centre of its patch an iteration may move, in half sizes.
constexpr double farthest = 1.6;
constexpr double position_tolerance = 1e-7;  // pixels
constexpr int max_evaluations = 40;
// After this number of consecutive steps that end at the limit, the solution is outside.
constexpr int max_steps_to_the_limit = 3;

// The rounding error of the difference between a point and a point on a ray.
double rounding_at(const Ray& ray, const V3d& point) {
    return 1e-14 * (point.length() + ray.origin.length());
}

double allowed_miss(const Ray& ray, const Approach& approach, const V3d& point) {
    return 1e-6 * std::abs(approach.distance) + rounding_at(ray, point);
}

// The step to within a rectangle after which, to first order, the ray is nearest to the point.
struct BestStep {
    V2d step{0.0, 0.0};
    bool limited = false;  ///< The step was shortened to the limit.
};

BestStep best_step(const Approach& approach, const V2d& minimum, const V2d& maximum) {
    const V2d free = approach.step_to(approach.offset);
    if (free.x >= minimum.x && free.x <= maximum.x && free.y >= minimum.y && free.y <= maximum.y) {
        return {free, false};
    }
    BestStep best{{0.0, 0.0}, true};
    double nearest = std::numeric_limits<double>::infinity();
    const auto consider = [&](const V2d& step) {
        const double left = approach.after(step).length2();
        if (left < nearest) {
            nearest = left;
            best.step = step;
        }
    };
    // The nearest point of a line, kept within a side of the rectangle.
    const auto along = [](const V3d& by, const V3d& to, double first, double last) {
        const double squared = by.length2();
        return std::clamp(squared > 0.0 ? by.dot(to) / squared : 0.0, first, last);
    };
    for (const double x : {minimum.x, maximum.x}) {
        consider({x, along(approach.by_y, approach.after({x, 0.0}), minimum.y, maximum.y)});
    }
    for (const double y : {minimum.y, maximum.y}) {
        consider({along(approach.by_x, approach.after({0.0, y}), minimum.x, maximum.x), y});
    }
    return best;
}

double max_part(const V2d& v) { return std::max(std::abs(v.x), std::abs(v.y)); }

// One running iteration. A step that increases the distance from the point, or leads to an invalid
// ray, is halved until it no longer does.
class Search {
public:
    explicit Search(const SearchStart& start)
        : start_(start),
          from_(start.from),
          step_(start.step),
          at_(start.from + start.step),
          miss_(start.miss) {}

    [[nodiscard]] const V2d& at() const { return at_; }
    [[nodiscard]] bool ended() const { return ended_; }

    // Accepts the ray at the current position; true if it is a sighting.
    [[nodiscard]] bool advance(const Ray& ray) {
        ended_ = ++evaluations_ == max_evaluations;
        if (!ray.valid) {
            halve();
            return false;
        }
        const Approach approach(ray, start_.point);
        const double rounding = rounding_at(ray, start_.point);
        const double miss = approach.distance > 0.0 ? approach.offset.length()
                                                    : (start_.point - ray.origin).length();
        if (miss > miss_ && miss > rounding) {
            halve();
            return false;
        }
        miss_ = miss;
        const BestStep best = next_step(approach);
        const bool still = max_part(best.step) < position_tolerance;
        const bool met = miss <= allowed_miss(ray, approach, start_.point);
        if (miss <= rounding || (still && met && !best.limited)) {
            ended_ = true;
            return meets(ray, approach, start_.point);
        }
        steps_to_the_limit_ = best.limited ? steps_to_the_limit_ + 1 : 0;
        ended_ = ended_ || (still && best.limited) || steps_to_the_limit_ == max_steps_to_the_limit;
        from_ = at_;
        step_ = best.step;
        at_ = from_ + step_;
        return false;
    }

    [[nodiscard]] Sighting sighting(const Ray& ray) const {
        const Approach approach(ray, start_.point);
        return sighting_of(start_.number, at_, ray, approach);
    }

private:
    [[nodiscard]] BestStep next_step(const Approach& approach) const {
        const V2d from_center = at_ - start_.center;
        const V2d maximum = farthest * start_.half;
        return best_step(approach, -maximum - from_center, maximum - from_center);
    }

    void halve() {
        step_ *= 0.5;
        at_ = from_ + step_;
        ended_ = ended_ || max_part(step_) < position_tolerance;
    }

    SearchStart start_;
    V2d from_;
    V2d step_;
    V2d at_;
    double miss_;
    int evaluations_ = 0;
    int steps_to_the_limit_ = 0;
    bool ended_ = false;
};

}  // namespace

bool meets(const Ray& ray, const Approach& approach, const V3d& point) {
    const double rounding = rounding_at(ray, point);
    const double motion = std::max(approach.by_x.length(), approach.by_y.length());
    return approach.distance >= -rounding && motion > 10.0 * rounding &&
           approach.offset.length() <= allowed_miss(ray, approach, point);
}

Sighting sighting_of(std::size_t point, const V2d& place, const Ray& ray,
                     const Approach& approach) {
    Sighting sighting;
    sighting.point = point;
    sighting.position = place;
    sighting.origin = ray.origin;
    sighting.distance = std::max(approach.distance, 0.0);
    sighting.miss = approach.offset.length();
    return sighting;
}

void add_starts(const RayPatch& patch, std::size_t number, const V3d& point,
                std::vector<SearchStart>& starts) {
    const Approach approach(patch.ray, point);
    const V2d maximum = RayPatch::reach * patch.half;
    const V2d step = best_step(approach, -maximum, maximum).step;
    const double bend = patch.bend(approach.distance);
    // Twice, because bends are estimates and the range extends beyond the patch.
    if (approach.after(step).length() > 2.0 * bend + rounding_at(patch.ray, point)) {
        return;
    }
    const double miss =
        approach.distance > 0.0 ? approach.offset.length() : (point - patch.ray.origin).length();
    starts.push_back({number, point, patch.center, patch.half, patch.center, miss, step});
    // Half the narrowest size of the patch, as seen at the point. If bends are as large,
    // the patch may be folded there.
    const V3d x = approach.by_x * patch.half.x;
    const V3d y = approach.by_y * patch.half.y;
    const double longest = std::sqrt(x.length2() + y.length2());
    if (bend * longest > x.cross(y).length()) {
        constexpr double anything = std::numeric_limits<double>::infinity();
        for (const V2d& quarter :
             {V2d(-0.5, -0.5), V2d(0.5, -0.5), V2d(-0.5, 0.5), V2d(0.5, 0.5)}) {
            const V2d place = patch.center + quarter * patch.half;
            starts.push_back({number, point, patch.center, patch.half, place, anything, V2d(0.0)});
        }
    }
}

void PointSearch::run(const std::vector<SearchStart>& starts, std::vector<Sighting>& found) {
    std::vector<Search> searches;
    searches.reserve(program::max_points);
    std::size_t next = 0;
    while (next < starts.size() || !searches.empty()) {
        while (next < starts.size() && searches.size() < program::max_points) {
            searches.emplace_back(starts[next++]);
        }
        for (std::size_t i = 0; i < searches.size(); ++i) {
            batch_.place(i, searches[i].at());
        }
        batch_.run(searches.size());
        for (std::size_t i = 0; i < searches.size(); ++i) {
            const Ray ray = batch_.ray(i);
            if (searches[i].advance(ray)) {
                found.push_back(searches[i].sighting(ray));
            }
        }
        std::erase_if(searches, [](const Search& search) { return search.ended(); });
    }
}

}  // namespace balcony::analyse
