// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/repeats.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <unordered_map>

#include <Imath/ImathBox.h>

#include "analyse/measure/jacobian.hpp"

namespace balcony::analyse {

namespace {

/// An oriented line, or a difference of two, in Plücker coordinates: direction and moment. The
/// moment is divided by the unit of length, so that both parts have equal weight.
struct Line {
    V3d direction;
    V3d moment;

    [[nodiscard]] double dot(const Line& other) const {
        return direction.dot(other.direction) + moment.dot(other.moment);
    }
    [[nodiscard]] double length() const { return std::sqrt(dot(*this)); }
    Line operator-(const Line& other) const {
        return {direction - other.direction, moment - other.moment};
    }
    Line operator+(const Line& other) const {
        return {direction + other.direction, moment + other.moment};
    }
    Line operator*(double factor) const { return {factor * direction, factor * moment}; }
};

/// The view of a sample: a point on its line, how far it moves to the next sample, and the line
/// with its derivatives per pixel.
struct View {
    bool usable = false;
    V3d point;
    double radius = 0.0;
    Line line, by_x, by_y;
};

/// Finds views by their points. A view is stored in a grid whose cells match its radius,
/// so that a magnified part of the picture does not overfill a cell.
class ViewIndex {
public:
    void add(std::size_t sample, const View& view) {
        const int level = level_of(view.radius);
        cells_[key(level, cell(view.point, level))].push_back(sample);
        if (std::find(levels_.begin(), levels_.end(), level) == levels_.end()) {
            levels_.push_back(level);
        }
    }

    /// Calls visit(sample), until it returns false, for all views that may reach to the point.
    /// False if that takes more than so many steps, to cells and to samples, and is cut off.
    template <class Visit>
    [[nodiscard]] bool near(const V3d& point, std::size_t max_steps, const Visit& visit) const {
        std::size_t steps = 0;
        for (const int level : levels_) {
            const V3d reach(std::ldexp(1.0, level));
            const Cell first = cell(point - reach, level);
            const Cell last = cell(point + reach, level);
            for (auto x = first[0]; x <= last[0]; ++x) {
                for (auto y = first[1]; y <= last[1]; ++y) {
                    for (auto z = first[2]; z <= last[2]; ++z) {
                        if (++steps > max_steps) {
                            return false;
                        }
                        const auto found = cells_.find(key(level, {x, y, z}));
                        if (found == cells_.end()) {
                            continue;
                        }
                        for (const std::size_t sample : found->second) {
                            if (++steps > max_steps) {
                                return false;
                            }
                            if (!visit(sample)) {
                                return true;
                            }
                        }
                    }
                }
            }
        }
        return true;
    }

private:
    using Cell = std::array<std::int64_t, 3>;

    // The exponent of the smallest power of two that is at least the radius.
    static int level_of(double radius) { return static_cast<int>(std::ceil(std::log2(radius))); }

    // A cell is twice as wide as the range, so that the range of a point overlaps at most two per
    // axis.
    static Cell cell(const V3d& point, int level) {
        const auto index = [level](double x) {
            return static_cast<std::int64_t>(
                std::floor(std::clamp(std::ldexp(x, -level - 1), -maximum, maximum)));
        };
        return {index(point.x), index(point.y), index(point.z)};
    }

    static constexpr double maximum = 1e15;  // Cells from the origin.

    // Different cells may share a key; visitors compare views anyway.
    static std::uint64_t key(int level, const Cell& cell) {
        auto mixed = static_cast<std::uint64_t>(level);
        for (const std::int64_t index : cell) {
            mixed = (mixed ^ static_cast<std::uint64_t>(index)) * 0x9e3779b97f4a7c15U;
            mixed ^= mixed >> 29U;
        }
        return mixed;
    }

    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
    std::vector<int> levels_;
};

class RepeatSearch {
public:
    RepeatSearch(const SampleGrid& grid, const std::vector<Ray>& rays, RayField& program,
                 const std::optional<double>& distance, double unit)
        : grid_(grid), program_(program), distance_(distance), unit_(unit) {
        Imath::Box3d box;
        for (const Ray& ray : rays) {
            if (ray.valid) {
                box.extendBy(ray.origin);
            }
        }
        center_ = box.isEmpty() ? V3d(0.0) : box.center();
        views_.reserve(rays.size());
        for (std::size_t i = 0; i < rays.size(); ++i) {
            views_.push_back(view_of(rays[i]));
            if (views_.back().usable) {
                index_.add(i, views_.back());
            }
        }
    }

    [[nodiscard]] bool usable(std::size_t sample) const { return views_[sample].usable; }
    [[nodiscard]] bool complete() const { return complete_; }

    /// The other points of the picture with the ray of a sample.
    [[nodiscard]] std::vector<V2d> others(std::size_t sample) {
        constexpr int max_trials = 8;
        constexpr std::size_t max_steps = 4096;
        std::vector<V2d> found;
        int trials = 0;
        const View& wanted = views_[sample];
        const bool all = index_.near(wanted.point, max_steps, [&](std::size_t candidate) {
            const View& start = views_[candidate];
            if ((start.point - wanted.point).length2() > start.radius * start.radius ||
                apart(grid_.at(candidate), grid_.at(sample)) <= nearest_other * grid_.step) {
                return true;
            }
            const std::optional<V2d> step = step_towards(wanted.line, start.line, start);
            if (step && is_new(grid_.at(candidate) + *step, sample, found)) {
                ++trials;
                if (const auto point = solve(wanted.line, candidate, *step);
                    point && is_new(*point, sample, found)) {
                    found.push_back(*point);
                }
            }
            return trials < max_trials;
        });
        complete_ = complete_ && all;
        return found;
    }

private:
    static constexpr double nearest_other = 2.0;  // In samples.
    // If a line changes by more from sample to sample (1 is about a radian), its derivatives say
    // nothing about neighbouring samples: lines agree with everything or with nothing.
    static constexpr double widest_view = 1.0;

    static double apart(const V2d& a, const V2d& b) {
        return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y));
    }

    [[nodiscard]] Line line_of(const Ray& ray) const {
        return {ray.direction, (ray.origin - center_).cross(ray.direction) / unit_};
    }

    [[nodiscard]] View view_of(const Ray& ray) const {
        View view;
        if (!ray.valid || !jacobian(ray, distance_).regular()) {
            return view;
        }
        const V3d from_center = ray.origin - center_;
        const auto slope = [&](const V3d& origin_by, const V3d& direction_by) {
            return Line{direction_by,
                        (origin_by.cross(ray.direction) + from_center.cross(direction_by)) / unit_};
        };
        view.line = line_of(ray);
        view.by_x = slope(ray.origin_by_x, ray.direction_by_x);
        view.by_y = slope(ray.origin_by_y, ray.direction_by_y);
        // The point depends only on the line: it is at a fixed distance from the point nearest to
        // the centre.
        const double along = (distance_ ? *distance_ : 1.0) - from_center.dot(ray.direction);
        view.point = distance_ ? from_center + along * ray.direction : ray.direction;
        const Jacobian moved = jacobian(ray, distance_ ? std::optional(along) : std::nullopt);
        // Half the diagonal between samples, plus a margin of one half for curvature.
        view.radius = 0.75 * grid_.step * (moved.by_x.length() + moved.by_y.length());
        view.usable = std::isfinite(view.radius) &&
                      view.radius > 1e-12 * (1.0 + view.point.length()) &&
                      grid_.step * std::max(view.by_x.length(), view.by_y.length()) < widest_view;
        return view;
    }

    // By least squares, in pixels; nothing if it leaves the view's own cell.
    [[nodiscard]] std::optional<V2d> step_towards(const Line& wanted, const Line& line,
                                                  const View& slopes) const {
        const Line missing = wanted - line;
        const double xx = slopes.by_x.dot(slopes.by_x);
        const double xy = slopes.by_x.dot(slopes.by_y);
        const double yy = slopes.by_y.dot(slopes.by_y);
        const double determinant = xx * yy - xy * xy;
        const double x = missing.dot(slopes.by_x);
        const double y = missing.dot(slopes.by_y);
        const V2d step((yy * x - xy * y) / determinant, (xx * y - xy * x) / determinant);
        const Line rest = missing - slopes.by_x * step.x - slopes.by_y * step.y;
        const double of_a_sample = grid_.step * std::sqrt(std::max(xx, yy));
        const bool near = std::abs(step.x) <= grid_.step && std::abs(step.y) <= grid_.step &&
                          rest.length() <= 0.5 * of_a_sample;
        return near ? std::optional(step) : std::nullopt;
    }

    [[nodiscard]] bool is_new(const V2d& point, std::size_t sample,
                              const std::vector<V2d>& found) const {
        const double minimum = nearest_other * grid_.step;
        const bool in_picture = point.x >= 0.0 && point.x <= grid_.picture_width &&
                                point.y >= 0.0 && point.y <= grid_.picture_height;
        return in_picture && apart(point, grid_.at(sample)) > minimum &&
               std::none_of(found.begin(), found.end(),
                            [&](const V2d& other) { return apart(point, other) <= minimum; });
    }

    // The change of the line per pixel in the direction of least change.
    static double min_slope(const View& slopes) {
        const double xx = slopes.by_x.dot(slopes.by_x);
        const double xy = slopes.by_x.dot(slopes.by_y);
        const double yy = slopes.by_y.dot(slopes.by_y);
        const double largest = 0.5 * (xx + yy) + std::hypot(0.5 * (xx - yy), xy);
        return std::sqrt(std::max(xx * yy - xy * xy, 0.0) / largest);
    }

    // Newton's method with the slopes of the candidate.
    [[nodiscard]] std::optional<V2d> solve(const Line& wanted, std::size_t candidate,
                                           const V2d& first_step) {
        constexpr int max_steps = 5;
        const View& slopes = views_[candidate];
        const double tenth_of_a_pixel = 0.1 * min_slope(slopes);
        V2d point = grid_.at(candidate) + first_step;
        for (int i = 0; i < max_steps; ++i) {
            const Ray ray = program_.at(point);
            if (!ray.valid) {
                return std::nullopt;
            }
            const Line line = line_of(ray);
            if ((wanted - line).length() <= tenth_of_a_pixel) {
                return point;
            }
            const auto step = step_towards(wanted, line, slopes);
            if (!step) {
                return std::nullopt;
            }
            point += *step;
        }
        return std::nullopt;
    }

    const SampleGrid& grid_;
    RayField& program_;
    std::optional<double> distance_;
    double unit_;
    V3d center_;
    std::vector<View> views_;
    ViewIndex index_;
    bool complete_ = true;
};

}  // namespace

Repeats find_repeats(const SampleGrid& grid, const std::vector<Ray>& rays, RayField& program,
                     const std::optional<double>& distance, double unit, const Work& work) {
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    RepeatSearch search(grid, rays, program, distance, unit);
    Repeats repeats{std::vector<std::uint8_t>(rays.size(), 0),
                    std::vector<V2d>(rays.size(), V2d(none, none)), true};
    for (std::size_t i = 0; i < rays.size(); ++i) {
        if (i % grid.columns == 0) {
            work.done(static_cast<double>(i) / static_cast<double>(rays.size()));
        }
        if (!search.usable(i)) {
            continue;
        }
        const std::vector<V2d> others = search.others(i);
        repeats.views[i] = static_cast<std::uint8_t>(1 + others.size());
        if (!others.empty()) {
            repeats.other[i] = others.front();
        }
    }
    repeats.complete = search.complete();
    return repeats;
}

}  // namespace balcony::analyse
