// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One thread's work: a tile of the picture in one pass.

#include <cstdint>
#include <vector>

#include "balcony/rays.hpp"
#include "balcony/render.hpp"
#include "render/film/blend.hpp"
#include "render/job/camera_rays.hpp"
#include "render/shading/tracer.hpp"

namespace balcony::render {

/// A rectangle of pixels.
struct PixelTile {
    std::size_t x = 0;
    std::size_t y = 0;
    std::size_t width = 0;
    std::size_t height = 0;
};

/// The largest tile.
inline constexpr std::size_t tile_width = 63;
inline constexpr std::size_t tile_height = 31;
static_assert(tile_width <= program::max_tile_width && tile_height <= program::max_tile_height);

struct RayCounts {
    std::uint64_t camera_rays = 0;
    std::uint64_t invalid_rays = 0;
};

struct WorkCounts {
    std::vector<RayCounts> layers;  ///< By camera layer.
    std::uint64_t invalid_pixels = 0;
    std::uint64_t repaired = 0;
    double camera_seconds = 0.0;
    double seconds = 0.0;

    void add(const WorkCounts& other);
};

class TileWorker {
public:
    TileWorker(const TracedScene& traced, const rays::CompiledPicture& picture,
               const Settings& settings, Film& film);

    /// Adds one sample to each pixel of the tile. Pass 0 also fills the film's layers.
    void render(const PixelTile& tile, std::size_t pass);

    [[nodiscard]] const WorkCounts& counts() const { return counts_; }

private:
    using Element = rays::CompiledPicture::Element;
    using Mask = std::vector<std::uint8_t>;  // By pixel of the tile.

    void render_single();
    void render_layers();
    void find_rays(const std::vector<Element>& elements, Mask& hidden,
                   const std::vector<float>& share);
    void trace_layer(const Element& element, const Mask& hidden, const std::vector<float>& share);
    void find_rays_of_group(const Element& element, Mask& hidden, const std::vector<float>& share);
    [[nodiscard]] Drawn drawn(const std::vector<Element>& elements, std::size_t i) const;

    void make_rays(std::size_t layer);
    [[nodiscard]] Tracer::Result trace(std::size_t i);
    [[nodiscard]] float coverage(const Element& element, std::size_t i) const;
    [[nodiscard]] rays::Tile points() const;
    [[nodiscard]] std::size_t pixel(std::size_t i) const {
        return (tile_.y + i / tile_.width) * film_->width + tile_.x + i % tile_.width;
    }
    void write_data(std::size_t i, std::size_t layer, const VisibleSurface& visible);

    const TracedScene* traced_;
    const rays::CompiledPicture* picture_;
    const Settings* settings_;
    Film* film_;
    Tracer tracer_;
    double footprint_scale_;

    // The tile and pass at work.
    PixelTile tile_;
    std::size_t pass_ = 0;
    std::size_t pixels_ = 0;

    // By pixel of the tile.
    rays::Scratch scratch_;
    rays::RayBatch grid_;
    Mask wanted_;  // Whether the ray is asked for; only where there is more than one layer.
    Mask has_ray_;
    std::vector<embree::Ray> rays_;
    std::vector<embree::Hit> hits_;
    std::vector<std::vector<double>> coverages_;  // By root.
    std::vector<double*> coverage_roots_;
    std::vector<std::vector<Drawn>> drawn_;  // By camera layer; empty if it does not show.
    Mask has_data_;
    WorkCounts counts_;
};

/// Where in each pixel the samples of a pass lie, from the pixel's centre: the centre itself in
/// pass 0, then points of a low-discrepancy sequence, spread like a tent of radius 1.
[[nodiscard]] Imath::V2d pass_offset(std::size_t pass);

}  // namespace balcony::render
