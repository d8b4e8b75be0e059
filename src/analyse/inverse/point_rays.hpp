// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays at picture points that lie anywhere, with derivatives.

#include <array>
#include <cstddef>
#include <vector>

#include "analyse/measure/ray_field.hpp"
#include "balcony/camera.hpp"
#include "balcony/program.hpp"

namespace balcony::analyse {

/// A ray as a function of the picture, compiled for points. Immutable.
class PointRays {
public:
    PointRays(const camera::RayExpressions& ray, double time);

    /// Up to program::max_points points and then their rays. Belongs to one thread.
    class Batch {
    public:
        explicit Batch(const PointRays& rays);

        void place(std::size_t i, const V2d& at);
        [[nodiscard]] V2d at(std::size_t i) const { return {x_[i], y_[i]}; }
        /// Computes the rays of the first `count` points.
        void run(std::size_t count);
        /// Valid only if the derivatives are finite too. Its parameters are not computed.
        [[nodiscard]] Ray ray(std::size_t i) const;

    private:
        const PointRays* rays_;
        program::Scratch scratch_;
        std::array<double, program::max_points> x_{};
        std::array<double, program::max_points> y_{};
        std::vector<std::array<double, program::max_points>> values_;  ///< By root.
        std::vector<double*> results_;
    };

private:
    program::Program program_;
    double time_;
};

}  // namespace balcony::analyse
