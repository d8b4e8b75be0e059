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
    [[nodiscard]] std::size_t pixel_x(std::size_t i) const { return region.x + i % region.width; }
    [[nodiscard]] std::size_t pixel_y(std::size_t i) const { return region.y + i / region.width; }
    [[nodiscard]] bool in(const Region& part, std::size_t i) const {
        return part.contains(pixel_x(i), pixel_y(i));
    }
};

/// Traces rays; belongs to one thread.
class TileTracer {
public:
    TileTracer(const TracedScene& traced, const Settings& settings, IntegratorMaker make);

    /// The result of each requested ray. Radiance that is not finite is replaced by black.
    [[nodiscard]] std::vector<Seen> trace(const TilePoints& points, const TileRays& rays,
                                          const Mask& wanted);

    /// The number of samples whose radiance was not finite.
    [[nodiscard]] std::uint64_t repaired() const { return repaired_; }

private:
    const TracedScene* traced_;
    bool opaque_background_;
    double footprint_scale_;
    std::unique_ptr<Integrator> integrator_;
    std::uint64_t repaired_ = 0;
};

}  // namespace balcony::render
