// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/light_bounds.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

using Imath::V3f;

float sine_of(float cosine) { return std::sqrt(std::max(0.0F, 1.0F - cosine * cosine)); }

// The cosine of the angle from an axis to the far side of a cone; -1 if it exceeds half a turn.
float cosine_to_far_side(float cosine_between, float cosine_spread) {
    if (cosine_between <= -cosine_spread) {
        return -1.0F;
    }
    return cosine_between * cosine_spread - sine_of(cosine_between) * sine_of(cosine_spread);
}

}  // namespace

LightBounds bounds_of(std::span<const LightBounds> lights) {
    LightBounds all;
    V3f axes(0.0F);
    for (const LightBounds& one : lights) {
        all.box.extendBy(one.box);
        all.cosine_falloff = std::min(all.cosine_falloff, one.cosine_falloff);
        all.two_sided = all.two_sided || one.two_sided;
        all.power += one.power;
        axes += one.two_sided && one.axis.dot(axes) < 0.0F ? -one.axis : one.axis;
    }
    all.axis = axes.length2() > 0.0F ? axes.normalized() : V3f(0.0F, 0.0F, 1.0F);
    for (const LightBounds& one : lights) {
        const float cosine = one.axis.dot(all.axis);
        // Both ends of an axis count if all of the cone is two-sided.
        const float nearest = all.two_sided ? std::abs(cosine) : cosine;
        all.cosine_spread =
            std::min(all.cosine_spread, cosine_to_far_side(nearest, one.cosine_spread));
    }
    return all;
}

}  // namespace balcony::render
