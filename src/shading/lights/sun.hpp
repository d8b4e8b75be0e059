// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <Imath/ImathColor.h>
#include <Imath/ImathMatrix.h>
#include <Imath/ImathVec.h>

namespace balcony::render {

/// A disc of even radiance, infinitely far away.
class Sun {
public:
    /// The irradiance is that of a plane perpendicular to the direction. The angle is the diameter
    /// of the disc, in radians, from 0 (a single direction) to pi.
    Sun(const Imath::V3f& to_light, const Imath::Color3f& irradiance, double angle);

    /// The same in other axes, with a factor for its light.
    [[nodiscard]] Sun seen_from(const Imath::M33f& rotation, float strength) const;

    [[nodiscard]] const Imath::V3f& to_light() const { return to_light_; }
    [[nodiscard]] const Imath::Color3f& irradiance() const { return irradiance_; }
    [[nodiscard]] bool is_point() const { return solid_angle_ <= 0.0F; }

    /// An upper bound of the luminance of the light on a surface with this normal, which is 0 for
    /// all sides.
    [[nodiscard]] float illuminance(const Imath::V3f& normal) const;

    // Of a disc that is no point.
    [[nodiscard]] bool covers(const Imath::V3f& direction) const;
    [[nodiscard]] const Imath::Color3f& radiance() const { return radiance_; }
    [[nodiscard]] float pdf() const { return 1.0F / solid_angle_; }
    /// Evenly from the disc.
    [[nodiscard]] Imath::V3f sample(const Imath::V2f& random) const;

private:
    Imath::V3f to_light_;
    Imath::Color3f irradiance_;
    Imath::Color3f radiance_{0};
    float sine_ = 0.0F;     // Of half the angle.
    float versine_ = 0.0F;  // 1 - cosine of half the angle, which rounding does not touch.
    float solid_angle_ = 0.0F;
};

}  // namespace balcony::render
