// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The weights of two methods that find the same light: directions to lamps, and directions in which
// surfaces scatter light.

#include "balcony/integrators.hpp"

namespace balcony::render {

/// The power heuristic (Veach 1997), or one of the methods alone.
struct LampWeights {
    LampSampling sampling;

    /// Of a direction that was chosen towards a lamp.
    [[nodiscard]] float of_lamp(float pdf_of_lamp, float pdf_of_surface) const {
        switch (sampling) {
            case LampSampling::both: return power_heuristic(pdf_of_lamp, pdf_of_surface);
            case LampSampling::lamps: return 1.0F;
            case LampSampling::surfaces: return 0.0F;
        }
        return 0.0F;
    }

    /// Of a direction that a surface has scattered light to, and in which a lamp was found.
    [[nodiscard]] float of_scattered(float pdf_of_surface, float pdf_of_lamp) const {
        switch (sampling) {
            case LampSampling::both: return power_heuristic(pdf_of_surface, pdf_of_lamp);
            case LampSampling::lamps: return pdf_of_lamp > 0.0F ? 0.0F : 1.0F;
            case LampSampling::surfaces: return 1.0F;
        }
        return 0.0F;
    }

private:
    [[nodiscard]] static float power_heuristic(float own, float other) {
        const float ratio = other / own;
        return 1.0F / (1.0F + ratio * ratio);
    }
};

}  // namespace balcony::render
