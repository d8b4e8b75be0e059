// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Traces the rays of a tile.

#include <cstdint>
#include <memory>
#include <vector>

#include "render/integrators/integrator.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// The points of a tile in one pass: a sample in each pixel of a region.
struct TilePoints {
    Region region;
    std::size_t pass = 0;
    rays::Tile grid;

    [[nodiscard]] std::size_t size() const { return region.size(); }
};

/// Traces rays; belongs to one thread.
class TileTracer {
public:
    TileTracer(const TracedScene& traced, const Settings& settings, IntegratorMaker make);

    /// Calls show(i, seen) with the result of each requested ray i. Radiance that is not finite is
    /// replaced by black.
    template <class Show>
    void trace(const TilePoints& points, const TileRays& rays, const Mask& wanted,
               const Show& show) {
        hits_.resize(points.size());
        traced_->accelerator.intersect_grid(points.region.width, rays.rays, wanted, hits_);
        for_each_pixel(points.region, [&](std::size_t i, std::size_t x, std::size_t y) {
            if (wanted[i] != 0) {
                show(i, seen(rays, i, hits_[i], Sampler(x, y, points.pass)));
            }
        });
    }

    /// The number of samples whose radiance was not finite.
    [[nodiscard]] std::uint64_t repaired() const { return repaired_; }

private:
    [[nodiscard]] Seen seen(const TileRays& rays, std::size_t i, const embree::Hit& first,
                            const Sampler& sampler);

    const TracedScene* traced_;
    double footprint_scale_;
    std::unique_ptr<Integrator> integrator_;
    std::vector<embree::Hit> hits_;  // Of the rays at work; kept for its memory.
    std::uint64_t repaired_ = 0;
};

}  // namespace balcony::render
