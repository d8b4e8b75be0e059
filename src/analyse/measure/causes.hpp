// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <optional>

#include "analyse/measure/work.hpp"
#include "balcony/camera.hpp"

namespace balcony::analyse {

/// What makes a picture fold: the stages without which it does not.
enum class FoldCause : std::uint8_t {
    arrangement,  ///< The stages that arrange the picture.
    warp,         ///< Those that transform parameters.
    move,         ///< Those that transform objects.
    object,       ///< None of these, hence the objects or the rule.
};

/// Leaves out one kind of stages after the other. The distance is that of a CameraReport.
[[nodiscard]] FoldCause cause_of_fold(const camera::Camera& camera, double width, double height,
                                      double time, const std::optional<double>& distance,
                                      const Work& work);

}  // namespace balcony::analyse
