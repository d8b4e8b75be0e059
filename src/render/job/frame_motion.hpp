// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The layer `motion`: where what a pixel shows is in the pictures a frame earlier and later.

#include <cstdint>
#include <span>
#include <vector>

#include "balcony/motion.hpp"
#include "balcony/render.hpp"
#include "film/sums/tile_image.hpp"
#include "shading/geometry/motion_steps.hpp"

namespace balcony::render {

/// Pixels by how their motion was found.
struct MotionCounts {
    std::uint64_t unknown = 0;    ///< A surface that neither of the other pictures shows.
    std::uint64_t ambiguous = 0;  ///< A surface that one of them shows at several places.
};

/// Immutable, for any number of threads.
class FrameMotion {
public:
    /// Rays have times in the interval. The scene must outlive it.
    FrameMotion(const scene::Scene& scene, const FrameSettings& frames,
                const scene::TimeInterval& times);
    FrameMotion(const FrameMotion&) = delete;
    FrameMotion& operator=(const FrameMotion&) = delete;
    ~FrameMotion() = default;

    /// Sets the motion of the valid points, which are those of the region row by row. Only pixels
    /// of the region `counted` are counted.
    void find(const Region& region, const Region& counted, std::span<PointData> points,
              MotionCounts& counts) const;

private:
    /// The way of the scene to the time of another picture.
    struct Way {
        scene::TimeInterval interval;
        scene::Movement movement;
        MotionSteps steps;

        Way(const scene::Scene& scene, const scene::TimeInterval& times);
    };

    [[nodiscard]] V3d moved(const Way& way, const PointData& point, double time) const;
    [[nodiscard]] std::vector<rays::ImagePoint> places(const rays::ImagePointFinder* picture,
                                                       const Way& way, double later,
                                                       const Region& region,
                                                       std::span<const PointData> points) const;

    const scene::Scene* scene_;
    FrameSettings frames_;
    Way before_;
    Way after_;
};

}  // namespace balcony::render
