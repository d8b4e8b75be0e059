// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/sun.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "images/luminance.hpp"
#include "shading/geometry/frame.hpp"

namespace balcony::render {

using Imath::Color3f;
using Imath::V2f;
using Imath::V3f;

Sun::Sun(const V3f& to_light, const Color3f& irradiance, double angle)
    : to_light_(to_light), irradiance_(irradiance) {
    constexpr double pi = std::numbers::pi;
    const double half = 0.5 * std::clamp(angle, 0.0, pi);
    const double sine = std::sin(half);
    const double versine = 2.0 * std::sin(0.5 * half) * std::sin(0.5 * half);
    // The integral of the cosine over the disc is pi sine².
    const Color3f radiance = irradiance / static_cast<float>(pi * sine * sine);
    if (half <= 0.0 || !std::isfinite(luminance(radiance))) {
        return;
    }
    radiance_ = radiance;
    sine_ = static_cast<float>(sine);
    versine_ = static_cast<float>(versine);
    solid_angle_ = static_cast<float>(2.0 * pi * versine);
}

Sun Sun::seen_from(const Imath::M33f& rotation, float strength) const {
    Sun sun = *this;
    sun.to_light_ = (to_light_ * rotation).normalized();
    sun.irradiance_ *= strength;
    sun.radiance_ *= strength;
    return sun;
}

float Sun::illuminance(const V3f& normal) const {
    const float cosine = normal == V3f(0.0F) ? 1.0F : std::min(1.0F, normal.dot(to_light_) + sine_);
    return std::max(0.0F, cosine) * luminance(irradiance_);
}

// The square of the distance between two points of the unit sphere is twice the versine.
bool Sun::covers(const V3f& direction) const {
    return (direction - to_light_).length2() <= 2.0F * versine_;
}

V3f Sun::sample(const V2f& random) const {
    const float versine = random.x * versine_;
    const float across = std::sqrt(versine * (2.0F - versine));
    const V2f around = on_circle(random.y);
    return Frame(to_light_)
        .to_world({across * around.x, across * around.y, 1.0F - versine})
        .normalized();
}

}  // namespace balcony::render
