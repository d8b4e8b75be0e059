// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// RayTarget: a surface that rays can be followed to, as a projector throws a slide on a backdrop.

#include <cstdint>

#include "balcony/emitter.hpp"

namespace balcony::camera {

/// A surface that rays can be followed to.
class RayTarget {
public:
    RayTarget() = default;
    RayTarget(const RayTarget&) = delete;
    RayTarget& operator=(const RayTarget&) = delete;
    virtual ~RayTarget() = default;

    /// Which point of a surface that a ray meets several times.
    enum class Which : std::uint8_t { first, last };
    /// Meaningful where the condition `met` holds.
    struct Distance {
        Expr s;  ///< Of the point from + s * direction; above 0.
        Expr met;
    };
    [[nodiscard]] virtual Distance distance(const ObjectPoint& from, const ObjectVector& direction,
                                            Which which, Emitter& emit) const = 0;
};

}  // namespace balcony::camera
