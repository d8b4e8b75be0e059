// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Evaluates a picture's formulas over a tile: the rays of its camera layers, and the coverages.

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/motion.hpp"
#include "balcony/rays.hpp"
#include "render/job/camera_rays.hpp"
#include "render/job/picture_inputs.hpp"
#include "render/tracing/shown_objects.hpp"

namespace balcony::render {

/// A flag for each point of a tile.
using Mask = std::vector<std::uint8_t>;

/// The rays of one camera layer at the points of a tile.
struct TileRays {
    std::size_t layer = 0;
    rays::RayBatch all;
    scene::TimeInterval interval{};  ///< Of the times of rays.
    float time = 0.0F;               ///< Of rays without times of their own, as time_of().
    bool through_lens = false;       ///< They took the first pair of random numbers of each sample.
    const ShownObjects* shown = nullptr;  ///< What they may meet first.

    /// From 0 to 1 over the interval.
    [[nodiscard]] float time_of(std::size_t i) const {
        return all.has_times() ? static_cast<float>(interval.part_at(all.time(i))) : time;
    }
};

/// The coverages and paints of a picture at the points of a tile.
class TileCoverages {
public:
    /// From 0 to 1; NaN counts as 0.
    [[nodiscard]] float coverage(const rays::CompiledPicture::Element& element,
                                 std::size_t i) const {
        return element.coverage ? clamped(values_[*element.coverage][i]) : 1.0F;
    }
    [[nodiscard]] Color4f paint(std::size_t root, std::size_t i) const;

private:
    friend class PictureRays;
    [[nodiscard]] static float clamped(double value) {
        return value > 0.0 ? static_cast<float>(std::min(value, 1.0)) : 0.0F;
    }
    program::ResultArrays values_;
};

/// Runs the programs of a picture; belongs to one thread.
class PictureRays {
public:
    /// The interval is that of the times of rays. The picture was compiled with declared(inputs).
    /// What its layers show must outlive this.
    PictureRays(const rays::CompiledPicture& picture, const std::vector<ShownObjects>& shown,
                const scene::TimeInterval& interval, PictureInputs inputs)
        : picture_(&picture), shown_(&shown), interval_(interval), inputs_(std::move(inputs)) {}

    [[nodiscard]] TileCoverages coverages(const rays::Tile& points);
    [[nodiscard]] std::size_t layer_count() const { return picture_->layers().size(); }
    [[nodiscard]] bool has_lens(std::size_t layer) const {
        return picture_->layers()[layer].rays.has_lens();
    }
    /// The central rays. Fills `rays`, whose memory is used again.
    void find_rays(std::size_t layer, const rays::Tile& points, TileRays& rays);
    /// The rays through the lens, if the layer has one, for the samples of a pass.
    void find_rays_of_pass(std::size_t layer, const rays::Tile& points, const Region& region,
                           const PassNumbers& numbers, TileRays& rays);

    /// The total time spent in these functions.
    [[nodiscard]] double seconds() const { return seconds_; }

private:
    void run(std::size_t layer, rays::Tile points, TileRays& rays);

    const rays::CompiledPicture* picture_;
    const std::vector<ShownObjects>* shown_;
    scene::TimeInterval interval_;
    InputArrays inputs_;
    rays::Scratch scratch_;
    double seconds_ = 0.0;
};

}  // namespace balcony::render
