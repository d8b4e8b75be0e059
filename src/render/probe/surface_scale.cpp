// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "balcony/probe.hpp"
#include "render/job/bent_rays.hpp"
#include "render/job/camera_rays.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/probe/probed_scene.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;
using Imath::V3f;

/// What the rays of a grid meet first.
class PlacesMet {
public:
    PlacesMet(const ProbedScene& scene, const rays::RayProgram& program, const rays::Tile& grid)
        : grid_(grid) {
        rays::Scratch scratch;
        rays::RayBatch batch;
        program.run(grid, scratch, batch);
        places_.resize(batch.size());
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (traceable(batch, i)) {
                const embree::Hit hit = first_hit(scene.shown(), batch, i, scene.time()).hit;
                places_[i] = hit.any() ? std::optional(V3d(scene.place(hit))) : std::nullopt;
            }
        }
    }

    /// The way to the next point of the row, by pixel; nothing at its end and beside a void.
    [[nodiscard]] std::optional<V3d> across(std::size_t x, std::size_t y) const {
        return x + 1 < grid_.width
                   ? way(index(x, y), index(x + 1, y), grid_.column(x + 1) - grid_.column(x))
                   : std::nullopt;
    }
    /// The same in a column.
    [[nodiscard]] std::optional<V3d> down(std::size_t x, std::size_t y) const {
        return y + 1 < grid_.height
                   ? way(index(x, y), index(x, y + 1), grid_.row(y + 1) - grid_.row(y))
                   : std::nullopt;
    }

private:
    [[nodiscard]] std::size_t index(std::size_t x, std::size_t y) const {
        return y * grid_.width + x;
    }
    [[nodiscard]] std::optional<V3d> way(std::size_t from, std::size_t to, double pixels) const {
        return places_[from] && places_[to] && pixels > 0.0
                   ? std::optional((*places_[to] - *places_[from]) / pixels)
                   : std::nullopt;
    }

    rays::Tile grid_;
    std::vector<std::optional<V3d>> places_;
};

// Of the ways to both neighbours: where one leads over an edge to a surface behind it, it is
// longer.
std::optional<V3d> shorter(const std::optional<V3d>& a, const std::optional<V3d>& b) {
    return !b || (a && a->length() <= b->length()) ? a : b;
}

// Of the ellipse that a circle of the picture becomes, the half-axis that is farthest from 1.
double largest_error(const V3d& by_x, const V3d& by_y) {
    const double middle = 0.5 * (by_x.dot(by_x) + by_y.dot(by_y));
    const double spread = std::hypot(0.5 * (by_x.dot(by_x) - by_y.dot(by_y)), by_x.dot(by_y));
    const double longest = std::sqrt(middle + spread) - 1.0;
    const double shortest = std::sqrt(std::max(middle - spread, 0.0)) - 1.0;
    return std::abs(longest) >= std::abs(shortest) ? longest : shortest;
}

// Nothing of too few.
std::optional<SurfaceScale::Range> range_of(std::vector<double> lengths) {
    constexpr std::size_t fewest = 50;
    if (lengths.size() < fewest) {
        return std::nullopt;
    }
    std::sort(lengths.begin(), lengths.end());
    const auto quantile = [&](std::size_t hundredths) {
        return lengths[(lengths.size() - 1) * hundredths / 100];
    };
    return SurfaceScale::Range{quantile(1), quantile(50), quantile(99)};
}

}  // namespace

Result<std::optional<SurfaceScale>> measure_scale(const Renderer& renderer,
                                                  const camera::Camera& camera,
                                                  const ProbeSettings& settings,
                                                  const std::stop_token& stop) {
    const Result<ProbedScene> scene = ProbedScene::make(renderer, settings);
    if (!scene) {
        return scene.diagnostics;
    }
    const Result<rays::RayProgram> program = compile(camera, settings, scene->scene().axes, stop);
    if (!program) {
        return program.diagnostics;
    }
    constexpr double points = 16384.0;
    const rays::Tile grid = coarse_grid(settings.width, settings.height, points, settings.time);
    const PlacesMet met(*scene, *program, grid);
    std::vector<double> across;
    std::vector<double> upwards;
    for (std::size_t y = 0; y < grid.height; ++y) {
        for (std::size_t x = 0; x < grid.width; ++x) {
            if (const auto way = met.across(x, y)) {
                across.push_back(way->length());
            }
            if (const auto way = met.down(x, y)) {
                upwards.push_back(way->length());
            }
        }
    }
    const auto in_rows = range_of(std::move(across));
    const auto in_columns = range_of(std::move(upwards));
    if (!in_rows || !in_columns) {
        return std::optional<SurfaceScale>();
    }
    return std::optional(SurfaceScale{*in_rows, *in_columns});
}

Result<std::vector<std::optional<double>>> scale_errors(const Renderer& renderer,
                                                        const camera::Camera& camera,
                                                        const ProbeSettings& settings,
                                                        const rays::Tile& grid, double pixel,
                                                        const std::stop_token& stop) {
    const Result<ProbedScene> scene = ProbedScene::make(renderer, settings);
    if (!scene) {
        return scene.diagnostics;
    }
    const Result<rays::RayProgram> program = compile(camera, settings, scene->scene().axes, stop);
    if (!program) {
        return program.diagnostics;
    }
    const PlacesMet met(*scene, *program, grid);
    std::vector<std::optional<double>> errors(grid.width * grid.height);
    for (std::size_t y = 0; y < grid.height; ++y) {
        for (std::size_t x = 0; x < grid.width; ++x) {
            const auto by_x =
                shorter(met.across(x, y), x > 0 ? met.across(x - 1, y) : std::nullopt);
            const auto by_y = shorter(met.down(x, y), y > 0 ? met.down(x, y - 1) : std::nullopt);
            if (by_x && by_y) {
                errors[y * grid.width + x] = largest_error(*by_x / pixel, *by_y / pixel);
            }
        }
    }
    return errors;
}

}  // namespace balcony::render
