// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The rays of built-in cameras, for comparison with what is published of them.

#include <numbers>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"

namespace balcony::cameras::test {

using Imath::V2d;
using Imath::V3d;
using rays::Ray;

inline constexpr double degree = std::numbers::pi / 180.0;

/// The file of a built-in camera, by whose name a map is taken without a warning, or another file.
inline std::string file_name(const std::string& camera) {
    return lang::family_of(camera).empty() ? camera : camera + ".cam";
}

/// A built-in camera, or a camera of a file, with values for its parameters: {{"fov", "90deg"}}. A
/// diagnostic fails the test.
inline camera::Camera make(const std::string& name,
                           const std::vector<lang::Override>& overrides = {}) {
    const Result<camera::Camera> made = lang::make_camera(file_name(name), "", overrides);
    EXPECT_TRUE(made) << name;
    EXPECT_EQ(to_text(made.diagnostics), "") << name;
    return *made;
}

/// The same for a picture.
inline camera::Picture make_picture(const std::string& name,
                                    const std::vector<lang::Override>& overrides = {}) {
    const Result<camera::Picture> made = lang::make_picture(file_name(name), "", overrides);
    EXPECT_TRUE(made) << name;
    EXPECT_EQ(to_text(made.diagnostics), "") << name;
    return *made;
}

/// The rays of a camera at points of its picture.
class Rays {
public:
    /// In a picture of a size in pixels; by default 1000 pixels high, with the camera's own aspect.
    explicit Rays(const camera::Camera& camera, double width = 0.0, double height = 1000.0)
        : width_(width > 0.0 ? width : height * camera::Picture(camera).aspect()),
          height_(height),
          program_(*rays::compile(camera, width_, height_,
                                  {.footprints = true, .tiles = false, .points = true})) {}
    explicit Rays(const std::string& name, const std::vector<lang::Override>& overrides = {})
        : Rays(make(name, overrides)) {}

    /// At a point given by fractions from the top left corner, at a time in seconds.
    [[nodiscard]] Ray at(double x, double y, double time = 0.0) const {
        return at_pixel(x * width_, y * height_, time);
    }
    /// At a point in pixels.
    [[nodiscard]] Ray at_pixel(double x, double y, double time = 0.0) const {
        rays::Scratch scratch;
        rays::RayBatch batch;
        const std::vector<double> xs{x};
        const std::vector<double> ys{y};
        rays::Points points;
        points.x = xs;
        points.y = ys;
        points.time = time;
        program_.run(points, scratch, batch);
        return batch[0];
    }
    [[nodiscard]] double width() const { return width_; }
    [[nodiscard]] double height() const { return height_; }

private:
    double width_, height_;
    rays::RayProgram program_;
};

inline void expect_near(const V3d& a, const V3d& b, double tolerance) {
    EXPECT_LE((a - b).length(), tolerance) << a << " is not " << b;
}

}  // namespace balcony::cameras::test
