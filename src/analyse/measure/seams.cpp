// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/seams.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace balcony::analyse {

namespace {

/// Measures rays and their differences in lengths of the unit.
class Difference {
public:
    explicit Difference(double unit) : unit_(unit) {}

    [[nodiscard]] double size(const V3d& origin, const V3d& direction) const {
        return std::sqrt(origin.length2() / (unit_ * unit_) + direction.length2());
    }

    [[nodiscard]] double jump(const Ray& a, const Ray& b) const {
        return size(b.origin - a.origin, b.direction - a.direction);
    }

    // The rounding error.
    [[nodiscard]] double noise(const Ray& a) const {
        return 1e-9 * (1.0 + a.origin.length() / unit_);
    }

private:
    double unit_;
};

// Whether the change of the ray between two samples differs strongly from the prediction by its
// derivatives.
bool suspicious(const Ray& a, const Ray& b, bool along_x, double step,
                const Difference& difference) {
    constexpr double max_surprise = 0.25;
    if (!a.valid || !b.valid) {
        return false;
    }
    const auto origin_by = along_x ? &Ray::origin_by_x : &Ray::origin_by_y;
    const auto direction_by = along_x ? &Ray::direction_by_x : &Ray::direction_by_y;
    const double surprise = difference.size(
        b.origin - a.origin - 0.5 * step * (a.*origin_by + b.*origin_by),
        b.direction - a.direction - 0.5 * step * (a.*direction_by + b.*direction_by));
    const double slope = std::max(difference.size(a.*origin_by, a.*direction_by),
                                  difference.size(b.*origin_by, b.*direction_by));
    const bool expected = surprise <= max_surprise * step * slope + difference.noise(a);
    return !expected && difference.jump(a, b) > difference.noise(a);
}

/// Narrows down the largest jump between two neighbouring samples step by step: the interval is
/// divided into parts, and the part with the largest jump is the interval of the next step. A jump
/// of any continuous ray becomes smaller in the process; a steep but continuous change, such as a
/// square root, at least halves in a thousandth of the interval.
class JumpSearch {
public:
    static constexpr std::size_t parts = 8;

    JumpSearch(const SampleGrid& grid, std::size_t sample, bool along_x)
        : sample_(sample), along_x_(along_x), first_(grid.at(sample)), width_(grid.step) {}

    /// The ends of the parts, whose rays take the next step.
    [[nodiscard]] std::array<V2d, parts + 1> points() const {
        std::array<V2d, parts + 1> points;
        for (std::size_t i = 0; i <= parts; ++i) {
            points[i] = first_ + static_cast<double>(i) * width_ / parts * along();
        }
        return points;
    }

    void step(std::span<const Ray> rays, const Difference& difference) {
        const auto is_valid = [](const Ray& ray) { return ray.valid; };
        if (!std::all_of(rays.begin(), rays.end(), is_valid)) {
            ended_ = true;
            return;
        }
        std::array<double, parts> jumps{};
        for (std::size_t i = 0; i < parts; ++i) {
            jumps[i] = difference.jump(rays[i], rays[i + 1]);
        }
        const auto largest =
            static_cast<std::size_t>(std::max_element(jumps.begin(), jumps.end()) - jumps.begin());
        const double maximum = jumps[largest];
        width_ /= parts;
        first_ += static_cast<double>(largest) * width_ * along();
        if (!jump_when_near_ && width_ < near) {
            jump_when_near_ = maximum;
            // Visible only if it exceeds the change over a tenth of a pixel.
            const double rest = std::accumulate(jumps.begin(), jumps.end(), 0.0) - maximum;
            const double tenth_of_a_pixel = 0.1 * rest / (width_ * (parts - 1));
            ended_ = maximum < std::max(tenth_of_a_pixel, difference.noise(rays[largest]));
        }
        if (!ended_ && width_ < nearest) {
            ended_ = true;
            if (maximum >= 0.5 * *jump_when_near_) {
                found_ = crossing(rays[largest], rays[largest + 1]);
            }
        }
    }

    [[nodiscard]] bool ended() const { return ended_; }
    [[nodiscard]] const std::optional<Crossing>& found() const { return found_; }

private:
    static constexpr double near = 1e-2;
    static constexpr double nearest = 1e-5;

    [[nodiscard]] V2d along() const { return along_x_ ? V2d(1, 0) : V2d(0, 1); }

    [[nodiscard]] Crossing crossing(const Ray& a, const Ray& b) const {
        return {sample_, along_x_, first_ + 0.5 * width_ * along(),
                2.0 * std::asin(std::min(0.5 * (b.direction - a.direction).length(), 1.0)),
                (b.origin - a.origin).length()};
    }

    std::size_t sample_;
    bool along_x_;
    V2d first_;
    double width_;
    std::optional<double> jump_when_near_;
    std::optional<Crossing> found_;
    bool ended_ = false;
};

// In parallel, because many points at once cost little more than one.
void run(std::span<JumpSearch> searches, RayField& program, const Difference& difference) {
    constexpr std::size_t ends = JumpSearch::parts + 1;
    std::vector<JumpSearch*> going;
    for (JumpSearch& search : searches) {
        going.push_back(&search);
    }
    while (!going.empty()) {
        for (std::size_t first = 0; first < going.size(); first += program::max_points / ends) {
            const auto some = std::span(going).subspan(
                first, std::min(program::max_points / ends, going.size() - first));
            std::vector<V2d> points;
            for (const JumpSearch* search : some) {
                const auto own = search->points();
                points.insert(points.end(), own.begin(), own.end());
            }
            const std::vector<Ray> rays = program.at(points);
            for (std::size_t i = 0; i < some.size(); ++i) {
                some[i]->step(std::span(rays).subspan(i * ends, ends), difference);
            }
        }
        std::erase_if(going, [](const JumpSearch* search) { return search->ended(); });
    }
}

/// Disjoint sets of crossings (union-find).
class DisjointSets {
public:
    explicit DisjointSets(std::size_t count) : parents_(count) {
        std::iota(parents_.begin(), parents_.end(), std::size_t{0});
    }

    [[nodiscard]] std::size_t root(std::size_t i) {
        while (parents_[i] != i) {
            i = parents_[i] = parents_[parents_[i]];
        }
        return i;
    }

    void join(std::size_t a, std::size_t b) { parents_[root(a)] = root(b); }

private:
    std::vector<std::size_t> parents_;
};

// The cells, squares between four samples, on whose sides a crossing lies, by their upper left
// sample; with a border of cells that reach half out of the picture.
std::array<std::size_t, 2> cells_beside(const SampleGrid& grid, const Crossing& crossing) {
    const std::size_t stride = grid.columns + 1;
    const std::size_t column = crossing.sample % grid.columns + 1;
    const std::size_t row = crossing.sample / grid.columns + 1;
    const std::size_t here = row * stride + column;
    return {here, crossing.along_x ? here - stride : here - 1};
}

// The length of the line in a cell: straight through it from one crossing to the other. A line that
// ends in the cell, at the picture's border or elsewhere, is extended by half a step.
double length_in_cell(const SampleGrid& grid, const std::vector<V2d>& points) {
    if (points.size() == 1) {
        return 0.5 * grid.step;
    }
    if (points.size() == 2) {
        return (points[0] - points[1]).length();
    }
    const V2d middle = std::accumulate(points.begin(), points.end(), V2d(0.0)) /
                       static_cast<double>(points.size());
    double length = 0.0;
    for (const V2d& point : points) {
        length += (point - middle).length();
    }
    return length;
}

}  // namespace

std::vector<Crossing> find_crossings(const SampleGrid& grid, const std::vector<Ray>& rays,
                                     RayField& program, double unit) {
    const Difference difference(unit);
    std::vector<JumpSearch> searches;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        for (const bool along_x : {true, false}) {
            const bool has_neighbour =
                along_x ? i % grid.columns + 1 < grid.columns : i + grid.columns < grid.size();
            if (has_neighbour && suspicious(rays[i], rays[i + (along_x ? 1 : grid.columns)],
                                            along_x, grid.step, difference)) {
                searches.emplace_back(grid, i, along_x);
            }
        }
    }
    run(searches, program, difference);
    std::vector<Crossing> found;
    for (const JumpSearch& search : searches) {
        if (search.found()) {
            found.push_back(*search.found());
        }
    }
    return found;
}

std::vector<Seam> join_seams(const SampleGrid& grid, const std::vector<Crossing>& crossings) {
    std::map<std::size_t, std::vector<std::size_t>> in_cell;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        for (const std::size_t cell : cells_beside(grid, crossings[i])) {
            in_cell[cell].push_back(i);
        }
    }
    DisjointSets sets(crossings.size());
    for (const auto& [cell, members] : in_cell) {
        for (const std::size_t member : members) {
            sets.join(members.front(), member);
        }
    }
    std::map<std::size_t, Seam> by_root;
    for (std::size_t i = 0; i < crossings.size(); ++i) {
        by_root[sets.root(i)].crossings.push_back(crossings[i]);
    }
    for (const auto& [cell, members] : in_cell) {
        std::vector<V2d> points;
        for (const std::size_t member : members) {
            points.push_back(crossings[member].point);
        }
        by_root[sets.root(members.front())].length += length_in_cell(grid, points);
    }
    std::vector<Seam> seams;
    for (auto& [root, seam] : by_root) {
        seams.push_back(std::move(seam));
    }
    std::stable_sort(seams.begin(), seams.end(),
                     [](const Seam& a, const Seam& b) { return a.length > b.length; });
    return seams;
}

}  // namespace balcony::analyse
