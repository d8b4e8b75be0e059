// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/seams.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <optional>

namespace balcony::analyse {

namespace {

/// Looks for a jump between two neighbouring samples.
class JumpSearch {
public:
    JumpSearch(const SampleGrid& grid, const std::vector<Ray>& rays, RayProgram& program,
               double unit)
        : grid_(grid), rays_(rays), program_(program), unit_(unit) {}

    [[nodiscard]] std::optional<Crossing> between(std::size_t sample, bool along_x) const {
        const Ray& a = rays_[sample];
        const Ray& b = rays_[sample + (along_x ? 1 : grid_.columns)];
        if (!a.valid || !b.valid || !suspicious(a, b, along_x)) {
            return std::nullopt;
        }
        return narrow_down(sample, along_x);
    }

private:
    [[nodiscard]] double size(const V3d& origin, const V3d& direction) const {
        return std::sqrt(origin.length2() / (unit_ * unit_) + direction.length2());
    }

    [[nodiscard]] double jump(const Ray& a, const Ray& b) const {
        return size(b.origin - a.origin, b.direction - a.direction);
    }

    // What rounding may do.
    [[nodiscard]] double noise(const Ray& a) const {
        return 1e-9 * (1.0 + a.origin.length() / unit_);
    }

    // Far from what the derivatives at both ends let one expect.
    [[nodiscard]] bool suspicious(const Ray& a, const Ray& b, bool along_x) const {
        constexpr double most_surprise = 0.25;
        const auto origin_by = along_x ? &Ray::origin_by_x : &Ray::origin_by_y;
        const auto direction_by = along_x ? &Ray::direction_by_x : &Ray::direction_by_y;
        const double half = 0.5 * grid_.step;
        const double surprise =
            size(b.origin - a.origin - half * (a.*origin_by + b.*origin_by),
                 b.direction - a.direction - half * (a.*direction_by + b.*direction_by));
        const double slope =
            std::max(size(a.*origin_by, a.*direction_by), size(b.*origin_by, b.*direction_by));
        const bool expected = surprise <= most_surprise * grid_.step * slope + noise(a);
        return !expected && jump(a, b) > noise(a);
    }

    // Follows the larger jump down. A jump of any continuous ray gets smaller on the way; what
    // looks steep for its neighbours' sake, such as a root, gets at least half as small in a
    // thousandth of the way.
    [[nodiscard]] std::optional<Crossing> narrow_down(std::size_t sample, bool along_x) const {
        constexpr std::size_t parts = 8;
        constexpr double near = 1e-2;
        constexpr double nearest = 1e-5;
        const V2d along = along_x ? V2d(1, 0) : V2d(0, 1);
        V2d point = grid_.at(sample);
        std::optional<double> jump_when_near;
        for (double width = grid_.step;;) {
            const std::vector<Ray> rays = program_.along(point, width / parts, parts + 1, along_x);
            std::size_t largest = 0;
            double most = -1.0;
            double rest = 0.0;
            for (std::size_t i = 0; i < parts; ++i) {
                if (!rays[i].valid || !rays[i + 1].valid) {
                    return std::nullopt;
                }
                const double here = jump(rays[i], rays[i + 1]);
                rest += here;
                if (here > most) {
                    most = here;
                    largest = i;
                }
            }
            width /= parts;
            point += static_cast<double>(largest) * width * along;
            if (!jump_when_near && width < near) {
                jump_when_near = most;
                // Seen in the picture only if it is more than what a tenth of a pixel does anyway.
                const double tenth_of_a_pixel = 0.1 * (rest - most) / (width * (parts - 1));
                if (most < std::max(tenth_of_a_pixel, noise(rays[largest]))) {
                    return std::nullopt;
                }
            }
            if (width < nearest) {
                if (most < 0.5 * *jump_when_near) {
                    return std::nullopt;
                }
                const Ray& a = rays[largest];
                const Ray& b = rays[largest + 1];
                return Crossing{
                    sample, along_x, point + 0.5 * width * along,
                    2.0 * std::asin(std::min(0.5 * (b.direction - a.direction).length(), 1.0)),
                    (b.origin - a.origin).length()};
            }
        }
    }

    const SampleGrid& grid_;
    const std::vector<Ray>& rays_;
    RayProgram& program_;
    double unit_;
};

/// Sets of crossings, joined one by one.
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
// ends in the cell, at the picture's border or elsewhere, goes half a step on.
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
                                     RayProgram& program, double unit) {
    const JumpSearch search(grid, rays, program, unit);
    std::vector<Crossing> found;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        for (const bool along_x : {true, false}) {
            const bool has_neighbour =
                along_x ? i % grid.columns + 1 < grid.columns : i + grid.columns < grid.size();
            if (!has_neighbour) {
                continue;
            }
            if (auto crossing = search.between(i, along_x)) {
                found.push_back(*crossing);
            }
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
