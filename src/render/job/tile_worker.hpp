// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// One thread's part of a job.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "balcony/render.hpp"
#include "render/job/compositor.hpp"
#include "render/job/frame_motion.hpp"
#include "render/job/supersampling.hpp"
#include "render/sampling/pass_offset.hpp"

namespace balcony::render {

/// What the compiled rays of a picture depend on beside it.
struct PictureForm {
    std::array<std::size_t, 2> size;  ///< In pixels.
    bool footprints = false;
    bool parameters = false;

    bool operator==(const PictureForm&) const = default;
};

/// Data shared by all threads of a job.
struct JobParts {
    TracedScene traced;  ///< With the lights of the picture.
    PictureForm form;
    Settings settings;
    const IntegratorRow* integrator;
    rays::CompiledPicture picture{};
    std::vector<ShownObjects> shown{};  ///< By camera layer.
    /// The central rays, if distances of objects in focus are measured along them.
    std::optional<rays::CompiledPicture> central{};
    std::string light{};                          ///< As Summary::light.
    std::optional<SubstituteLight> substitute{};  ///< As Summary::substitute.
    std::shared_ptr<const FrameMotion> motion{};  ///< Null if the film has no such layer.
    LightLevels levels{};
    std::optional<float> common_light{};  ///< common_light() of `path`.
    double compile_seconds = 0.0;
};

/// The counts of one thread, or the sum of several.
struct WorkCounts {
    std::vector<RayCounts> layers;  ///< By camera layer.
    std::uint64_t invalid_pixels = 0;
    std::uint64_t repaired = 0;
    MotionCounts motion;
    double camera_seconds = 0.0;
    double seconds = 0.0;

    void add(const WorkCounts& other);
};

/// Adds passes to the tiles of a film; belongs to one thread.
class TileWorker {
public:
    TileWorker(const JobParts& parts, const PictureInputs& inputs, Supersampling& supersampling,
               Film& film);

    /// Adds the tile's next pass. Pass 0 also fills the film's layers. False if no pixel of the
    /// tile needs it.
    bool render(std::size_t tile);

    [[nodiscard]] WorkCounts counts() const;

private:
    // What all tiles of a pass share.
    struct Pass {
        std::size_t number;
        Imath::V2d offset;
        PassNumbers numbers;
    };
    [[nodiscard]] const Pass& pass(std::size_t number);
    // A sample of the marked points of a region, or of all if there is no mask.
    [[nodiscard]] TileImage& sample(const Region& region, std::size_t number, const Mask* active,
                                    const Region& counted);
    // A sample of most points, and several of the marked ones, which are counted once.
    [[nodiscard]] TileImage& sample_more(const Region& region, std::size_t number,
                                         const Mask& marked);

    const Settings* settings_;
    const FrameMotion* motion_;
    Film* film_;
    const PixelFilter* filter_;
    std::array<std::optional<Pass>, samples_of_pass + 1> passes_;  // Kept for the next tile.
    Supersampling* supersampling_;
    PictureRays rays_;
    Compositor compositor_;
    MotionCounts motion_counts_;
    Mask active_;      // Of the tile at work; kept for its memory.
    TileImage mixed_;  // Likewise.
    double seconds_ = 0.0;
};

}  // namespace balcony::render
