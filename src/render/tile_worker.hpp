// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One thread's work: a tile of the picture in one pass.

#include <cstdint>
#include <vector>

#include "balcony/program.hpp"
#include "balcony/render.hpp"
#include "render/camera_rays.hpp"
#include "render/tracer.hpp"

namespace balcony::render {

/// A rectangle of pixels.
struct PixelTile {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t width = 0;
    std::size_t height = 0;
};

/// The largest tile. Its grid of rays has a column and a row more, for differences.
inline constexpr std::size_t tile_width = 63;
inline constexpr std::size_t tile_height = 31;
static_assert(tile_width < program::max_tile_width && tile_height < program::max_tile_height);

struct WorkCounts {
    std::uint64_t camera_rays = 0;
    std::uint64_t invalid_rays = 0;
    std::uint64_t invalid_pixels = 0;
    std::uint64_t repaired = 0;
    double camera_seconds = 0.0;
    double seconds = 0.0;

    void add(const WorkCounts& other);
};

class TileWorker {
public:
    TileWorker(const TracedScene& traced, const program::Program& camera, const Settings& settings,
               Film& film);

    /// Adds one sample to each pixel of the tile. Pass 0 also fills the film's layers.
    void render(const PixelTile& tile, std::size_t pass);

    [[nodiscard]] const WorkCounts& counts() const { return counts_; }

private:
    void make_rays(const PixelTile& tile, std::size_t pass);
    void render_pixel(const PixelTile& tile, std::size_t x, std::size_t y, bool first_pass);
    [[nodiscard]] RayDifferentials differentials(std::size_t point, std::size_t x,
                                                 std::size_t y) const;
    void write_layers(std::size_t pixel, std::size_t point, const VisibleSurface& visible);

    const TracedScene* traced_;
    const program::Program* camera_;
    const Settings* settings_;
    Film* film_;
    Tracer tracer_;
    double footprint_scale_;

    program::Scratch scratch_;
    RayGrid grid_;
    std::size_t grid_width_ = 0;           // In points.
    std::vector<std::uint8_t> traceable_;  // By point of the grid.
    std::vector<embree::Ray> rays_;        // By pixel of the tile, as are these two.
    std::vector<std::uint8_t> has_ray_;
    std::vector<embree::Hit> hits_;
    WorkCounts counts_;
};

/// Where in each pixel the samples of a pass lie, from the pixel's centre: the centre itself in
/// pass 0, then points of a low-discrepancy sequence, spread like a tent of radius 1.
[[nodiscard]] Imath::V2d pass_offset(std::size_t pass);

}  // namespace balcony::render
