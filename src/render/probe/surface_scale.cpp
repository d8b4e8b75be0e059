// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <optional>
#include <vector>

#include "balcony/probe.hpp"
#include "render/job/camera_rays.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/probe/probed_scene.hpp"

namespace balcony::render {

namespace {

using Imath::V3d;
using Imath::V3f;

// What the rays of a grid meet first, row by row.
std::vector<std::optional<V3d>> places_met(const ProbedScene& scene,
                                           const rays::RayProgram& program,
                                           const rays::Tile& grid) {
    rays::Scratch scratch;
    rays::RayBatch batch;
    program.run(grid, scratch, batch);
    std::vector<std::optional<V3d>> places(batch.size());
    for (std::size_t i = 0; i < batch.size(); ++i) {
        if (traceable(batch, i)) {
            const embree::Hit hit =
                scene.nearest(scene.ray(V3f(batch.origin(i)), V3f(batch.direction(i))));
            places[i] = hit.any() ? std::optional(V3d(scene.place(hit))) : std::nullopt;
        }
    }
    return places;
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
    const ProbedScene scene(renderer);
    const Result<rays::RayProgram> program = compile(camera, settings, scene.scene().axes, stop);
    if (!program) {
        return program.diagnostics;
    }
    constexpr double points = 16384.0;
    const rays::Tile grid = coarse_grid(settings.width, settings.height, points, settings.time);
    const std::vector<std::optional<V3d>> places = places_met(scene, *program, grid);
    std::vector<double> across;
    std::vector<double> upwards;
    const auto add = [&](std::vector<double>& lengths, std::size_t i, std::size_t j,
                         double pixels) {
        if (places[i] && places[j] && pixels > 0.0) {
            lengths.push_back((*places[i] - *places[j]).length() / pixels);
        }
    };
    for (std::size_t i = 0; i < places.size(); ++i) {
        const std::size_t x = i % grid.width;
        const std::size_t y = i / grid.width;
        if (x + 1 < grid.width) {
            add(across, i, i + 1, grid.column(x + 1) - grid.column(x));
        }
        if (y + 1 < grid.height) {
            add(upwards, i, i + grid.width, grid.row(y + 1) - grid.row(y));
        }
    }
    const auto in_rows = range_of(std::move(across));
    const auto in_columns = range_of(std::move(upwards));
    if (!in_rows || !in_columns) {
        return std::optional<SurfaceScale>();
    }
    return std::optional(SurfaceScale{*in_rows, *in_columns});
}

}  // namespace balcony::render
