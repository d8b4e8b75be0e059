// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/causes.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include "analyse/measure/jacobian.hpp"
#include "analyse/measure/ray_field.hpp"

namespace balcony::analyse {

namespace {

using Parts = camera::Camera::Parts;

// Each returns false if there is nothing to leave out.

bool leave_out_arrangement(Parts& parts) { return !std::exchange(parts.arrangers, {}).empty(); }

bool leave_out_warps(Parts& parts) {
    const bool of_eye = !std::exchange(parts.eye.parameter_transformers, {}).empty();
    const bool of_toward =
        parts.toward && !std::exchange(parts.toward->parameter_transformers, {}).empty();
    return of_eye || of_toward;
}

bool leave_out_moves(Parts& parts) {
    const bool of_eye = !std::exchange(parts.eye.object_transformers, {}).empty();
    const bool of_toward =
        parts.toward && !std::exchange(parts.toward->object_transformers, {}).empty();
    return of_eye || of_toward;
}

// Whether a noticeable part of the picture is mirrored, but not all of it.
bool folds(const camera::Camera& camera, double width, double height, double time,
           const std::optional<double>& distance, const Work& work) {
    auto field = RayField::make(camera, width, height, time, RayField::Derivatives::with, work);
    if (!field) {
        return true;
    }
    constexpr double samples_of_longer_side = 128.0;
    std::size_t mirrored = 0;
    std::size_t upright = 0;
    for (const Ray& ray : field->run(
             SampleGrid::over(width, height, std::max(width, height) / samples_of_longer_side))) {
        const Jacobian map = ray.valid ? jacobian(ray, distance) : Jacobian();
        mirrored += map.regular() && map.minimum < 0.0 ? 1U : 0U;
        upright += map.regular() && map.minimum > 0.0 ? 1U : 0U;
    }
    constexpr double negligible_share = 0.001;
    return static_cast<double>(std::min(mirrored, upright)) >
           negligible_share * static_cast<double>(mirrored + upright);
}

}  // namespace

FoldCause cause_of_fold(const camera::Camera& camera, double width, double height, double time,
                        const std::optional<double>& distance, const Work& work) {
    struct Kind {
        FoldCause cause;
        bool (*leave_out)(Parts&);
    };
    constexpr std::array kinds{Kind{FoldCause::arrangement, leave_out_arrangement},
                               Kind{FoldCause::warp, leave_out_warps},
                               Kind{FoldCause::move, leave_out_moves}};
    for (const auto& [cause, leave_out] : kinds) {
        Parts parts = camera.parts();
        if (leave_out(parts)) {
            const auto rest = camera::Camera::make(std::move(parts));
            if (rest && !folds(*rest, width, height, time, distance, work)) {
                return cause;
            }
        }
    }
    return FoldCause::object;
}

}  // namespace balcony::analyse
