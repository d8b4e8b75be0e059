// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Composites the layers of a picture in a tile.

#include <cstdint>
#include <vector>

#include "render/job/blend.hpp"
#include "render/job/picture_rays.hpp"
#include "render/job/tile_tracer.hpp"

namespace balcony::render {

/// Samples pictures, tile by tile; belongs to one thread.
class Compositor {
public:
    Compositor(const rays::CompiledPicture& picture, PictureRays rays, TileTracer tracer);

    /// The optional parts of a sample.
    struct Wanted {
        bool data = false;
        bool display = false;
        bool mirrored = false;
        bool contributions = false;
    };

    /// One sample at each point. Only points in the region `counted` are counted. The result is
    /// valid until the next call.
    [[nodiscard]] TileImage& sample(const TilePoints& points, const Region& counted,
                                    const Wanted& wanted);

    [[nodiscard]] const std::vector<RayCounts>& ray_counts() const { return counts_; }
    /// Points of pass 0 where nothing is drawn.
    [[nodiscard]] std::uint64_t invalid_pixels() const { return invalid_pixels_; }
    [[nodiscard]] std::uint64_t repaired() const { return tracer_.repaired(); }
    [[nodiscard]] double camera_seconds() const { return rays_.seconds(); }

private:
    using Element = rays::CompiledPicture::Element;
    struct Work;
    struct Veil;
    struct Master;

    void sample_all(const TilePoints& points, const Region& counted, const Wanted& wanted);
    void sample_light(const TilePoints& points, const Region& counted);
    [[nodiscard]] Contributions contributions(const Work& work) const;
    void trace(const std::vector<Element>& elements, Veil& veil, Work& work);
    void trace_group(const Element& element, Veil& veil, Work& work);
    void trace_by_depth(const std::vector<Element>& layers, Veil& veil, Work& work);
    void trace_layer(const Element& element, const Veil& veil, Work& work, Master* master);
    // `part` is the straight part of the ray that sees it.
    void add_data(const Element& element, const Veil& veil, std::size_t i, const Seen& seen,
                  std::size_t part, Work& work, Master* master) const;

    const rays::CompiledPicture* picture_;
    PictureRays rays_;
    TileTracer tracer_;
    TileRays tile_rays_;             // Of the layer at work; kept for its memory.
    TileImage image_;                // Likewise.
    std::vector<RayCounts> counts_;  // By camera layer.
    std::uint64_t invalid_pixels_ = 0;
};

}  // namespace balcony::render
