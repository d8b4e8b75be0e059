// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/light_levels.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "base/parallel_for.hpp"
#include "render/job/coarse_rays.hpp"

namespace balcony::render {

namespace {

constexpr std::size_t look_passes = 16;

Settings settings_of_look(Settings settings) {
    settings.samples = look_passes;
    settings.path.reuse = false;
    return settings;
}

/// The indirect light that samples at a point of the grid find, in the brightest channel. Negative
/// where a ray meets nothing.
struct Found {
    float largest = -1.0F;
    float sum = 0.0F;
};

void look_along(std::size_t row, const rays::Tile& grid, const TileRays& rays,
                const SceneTracer& tracer, std::span<const PassNumbers> passes,
                Integrator& integrator, std::vector<Found>& found) {
    std::vector<CameraRay> batch;
    std::vector<std::size_t> places;
    const auto sampler = [&](std::size_t i, const PassNumbers& pass) {
        return Sampler(i % grid.width, row, pass);
    };
    for (std::size_t i = row * grid.width; i < (row + 1) * grid.width; ++i) {
        if (!traceable(rays.all, i)) {
            continue;
        }
        const DifferentialRay ray = coarse_ray(tracer.scene(), grid, rays, i);
        if (const embree::Hit hit = tracer.nearest(ray, rays.shown->only()); hit.any()) {
            batch.push_back({ray, hit, sampler(i, passes[0]), static_cast<std::uint32_t>(i)});
            places.push_back(i);
        }
    }
    std::vector<Seen> seen(batch.size());
    for (const PassNumbers& pass : passes) {
        for (std::size_t k = 0; k < batch.size(); ++k) {
            batch[k].sampler = sampler(places[k], pass);
        }
        integrator.trace(batch, *rays.shown, seen);
        for (std::size_t k = 0; k < batch.size(); ++k) {
            const Color4f& all = seen[k].radiance;
            const float light = largest(Color3f(all.r, all.g, all.b) - seen[k].parts.emission -
                                        seen[k].parts.direct);
            Found& at = found[places[k]];
            if (std::isfinite(light)) {
                at.largest = std::max(at.largest, light);
                at.sum += light;
            }
        }
    }
}

// Around each point, the largest value that a sample has at one in six of the 5 x 5 points: about
// one sample in a hundred is brighter. In the dark, a part of the mean of all.
std::vector<float> common_largest(const std::vector<Found>& found, const rays::Tile& grid) {
    constexpr std::size_t reach = 2;
    constexpr std::size_t one_of = 6;
    constexpr double least = 0.25;
    double sum = 0.0;
    std::size_t count = 0;
    for (const Found& one : found) {
        sum += double{one.sum};
        count += one.largest >= 0.0F ? look_passes : 0;
    }
    const float floor = sum > 0.0 ? static_cast<float>(least * sum / static_cast<double>(count))
                                  : std::numeric_limits<float>::infinity();
    std::vector<float> made;
    std::vector<float> around;
    for (std::size_t i = 0; i < found.size(); ++i) {
        const std::size_t x = i % grid.width;
        const std::size_t y = i / grid.width;
        around.clear();
        for (std::size_t v = y - std::min(y, reach); v <= std::min(y + reach, grid.height - 1);
             ++v) {
            for (std::size_t u = x - std::min(x, reach); u <= std::min(x + reach, grid.width - 1);
                 ++u) {
                if (const Found& one = found[v * grid.width + u]; one.largest >= 0.0F) {
                    around.push_back(one.largest);
                }
            }
        }
        const auto common = around.begin() + static_cast<std::ptrdiff_t>(around.size() / one_of);
        std::nth_element(around.begin(), common, around.end(), std::greater<>());
        made.push_back(around.empty() ? floor : std::max(floor, *common));
    }
    return made;
}

}  // namespace

LightLevels::LightLevels(const TracedScene& traced, const Settings& settings,
                         const IntegratorRow& integrator, PictureRays& rays, const Film& film,
                         const std::stop_token& stop)
    : grid_(coarse_grid(film, settings.time)) {
    const Settings look = settings_of_look(settings);
    const SceneTracer tracer(traced);
    std::vector<PassNumbers> passes;
    for (std::size_t pass = 0; pass < look_passes; ++pass) {
        passes.emplace_back(pass, 0U);
    }
    TileRays found;
    for (std::size_t layer = 0; layer < rays.layer_count(); ++layer) {
        rays.find_rays(layer, grid_, found);
        std::vector<Found> light(found.all.size());
        const auto look_along_row = [&](std::size_t row) {
            if (!stop.stop_requested()) {
                look_along(row, grid_, found, tracer, passes, *integrator.make(traced, look),
                           light);
            }
        };
        parallel_for(grid_.height, look_along_row, settings.threads);
        levels_.push_back(common_largest(light, grid_));
    }
}

float LightLevels::limit(std::size_t layer, std::size_t x, std::size_t y, std::size_t pass) const {
    constexpr float passes_to_twice = 16.0F;
    if (levels_.empty()) {
        return std::numeric_limits<float>::infinity();
    }
    const auto cell = [this](std::size_t pixel, std::size_t count) {
        return std::min(static_cast<std::size_t>(static_cast<double>(pixel) / grid_.step),
                        count - 1);
    };
    return (1.0F + static_cast<float>(pass) / passes_to_twice) *
           levels_[layer][cell(y, grid_.height) * grid_.width + cell(x, grid_.width)];
}

}  // namespace balcony::render
