// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a report says in words.

#include <vector>

#include "analyse/measure/ray_field.hpp"
#include "analyse/measure/repeats.hpp"
#include "analyse/measure/seams.hpp"
#include "analyse/measure/turns.hpp"

namespace balcony::analyse {

/// All that findings are made of: a report whose samples are filled in, and what they came from.
struct Evidence {
    const Report& report;
    const std::vector<Ray>& rays;
    const std::vector<Crossing>& crossings;
    const Repeats& repeats;
    const Turns& turns;
    RayField& program;
};

/// Defects first, then by kind; before all others a map in degrees that is read as radians, since
/// it explains the rest.
[[nodiscard]] std::vector<Finding> find_all(const Evidence& evidence);

}  // namespace balcony::analyse
