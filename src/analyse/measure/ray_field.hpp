// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of a camera at the points of a grid, or at points anywhere.

#include <span>
#include <vector>

#include "analyse/measure/work.hpp"
#include "balcony/diagnose.hpp"
#include "balcony/rays.hpp"

namespace balcony::analyse {

using rays::Ray;

/// A camera in a picture of one size at one time, in its own axes. Belongs to one thread.
class RayField {
public:
    enum class Derivatives : bool { without, with };
    /// Of bent rays: the first straight part, which is the ray, or all.
    enum class Parts : bool { first, all };

    /// Its functions throw if the work is to stop.
    [[nodiscard]] static Result<RayField> make(const camera::Camera& camera, double picture_width,
                                               double picture_height, double time,
                                               Derivatives derivatives, Work work = {},
                                               Parts parts = Parts::first);

    /// Row by row. Without derivatives, those of the rays are 0.
    [[nodiscard]] std::vector<Ray> run(const SampleGrid& grid);
    [[nodiscard]] Ray at(const V2d& point);
    /// The straight parts of a ray that have a length, if it was made for all; none without a ray.
    [[nodiscard]] std::vector<rays::RayBatch::Part> path_at(const V2d& point);
    /// Much faster than one by one; at most program::max_points points.
    [[nodiscard]] std::vector<Ray> at(std::span<const V2d> points);

private:
    RayField(rays::RayProgram program, double time, Work work)
        : program_(std::move(program)), time_(time), work_(std::move(work)) {}

    rays::RayProgram program_;
    double time_;
    Work work_;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
};

}  // namespace balcony::analyse
