// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Describes findings in words.

#include <vector>

#include "analyse/measure/ray_field.hpp"
#include "analyse/measure/repeats.hpp"
#include "analyse/measure/seams.hpp"
#include "analyse/measure/turns.hpp"

namespace balcony::analyse {

/// The input of findings: a report with its samples, and their sources.
struct Evidence {
    const camera::Camera& camera;
    double time;
    const CameraReport& report;
    const std::vector<Ray>& rays;
    const std::vector<Crossing>& crossings;
    const Repeats& repeats;
    const Turns& turns;
    RayField& program;
    const Work& work;
};

/// Defects first, then by kind. A map with forgotten `deg` precedes all others, because
/// it explains the rest.
[[nodiscard]] std::vector<Finding> find_all(const Evidence& evidence);

}  // namespace balcony::analyse
