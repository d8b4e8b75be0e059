// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays at arbitrary picture points, with derivatives.

#include <array>
#include <cstddef>
#include <vector>

#include "analyse/measure/ray_field.hpp"
#include "balcony/rays.hpp"

namespace balcony::analyse {

/// A ray as a function of the picture at one time. Immutable.
class PointRays {
public:
    /// `program` is compiled for points and with footprints. Of bent rays it is one of their
    /// straight parts, which goes on beyond its end.
    PointRays(rays::RayProgram program, double time, std::size_t part = 0)
        : program_(std::move(program)), time_(time), part_(part) {}

    [[nodiscard]] bool is_bent() const { return program_.part_count() > 1; }

    /// What the ray of a point costs.
    [[nodiscard]] std::size_t instruction_count() const { return program_.instruction_count(); }

    /// Up to program::max_points points and their rays. Belongs to one thread. run() throws if the
    /// work is to stop.
    class Batch {
    public:
        explicit Batch(const PointRays& rays, const Work& work = {})
            : rays_(&rays), work_(work.silent()) {}

        void place(std::size_t i, const V2d& at);
        [[nodiscard]] V2d at(std::size_t i) const { return {x_[i], y_[i]}; }
        /// Computes the rays of the first `count` points.
        void run(std::size_t count);
        /// Valid only if the derivatives are finite too.
        [[nodiscard]] Ray ray(std::size_t i) const;
        /// Where the ray's path begins, its turns and its length up to this part, and the length of
        /// this part.
        struct Path {
            V3d origin;
            std::vector<V3d> turns;
            double before;
            double length;
        };
        [[nodiscard]] Path path(std::size_t i) const;

    private:
        const PointRays* rays_;
        Work work_;
        rays::Scratch scratch_;
        std::array<double, program::max_points> x_{};
        std::array<double, program::max_points> y_{};
        rays::RayBatch batch_;
    };

private:
    rays::RayProgram program_;
    double time_;
    std::size_t part_;
};

}  // namespace balcony::analyse
