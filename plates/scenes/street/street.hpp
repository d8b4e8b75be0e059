// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A street between two rows of houses, in autumn.
//
// z is up, units are metres. The street runs along x from 0 to its length; the fronts of the
// northern houses are at y = half_width, those of the southern ones at y = -half_width, but for
// those that stand back.

#include <span>

#include "balcony/base.hpp"
#include "balcony/scene.hpp"
#include "common/scene_options.hpp"

namespace balcony::plates {

namespace street {

inline constexpr double half_width = 8.0;
inline constexpr double length = 112.0;

/// Where a house stands along the street, in the order of x.
struct Lot {
    bool north = true;
    int number = 0;  ///< Within its row, from 1; its front is the object "north house 1 front".
    double x = 0.0;  ///< Of its western corner.
    double width = 0.0;
};

[[nodiscard]] std::span<const Lot> lots();

}  // namespace street

[[nodiscard]] Result<scene::Scene> make_street(const SceneOptions& options);

}  // namespace balcony::plates
