// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cameras from their text, and the points of a picture at which their rays are compared.

#include <functional>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "balcony/lang.hpp"
#include "balcony/rays.hpp"

namespace balcony::rays::test {

inline constexpr double width = 160.0;
inline constexpr double height = 90.0;
/// Some dozen roundings of numbers of the size of the scenes, which is 10 units.
inline constexpr double rounding = 1e-12;

/// The only camera of a text. A diagnostic fails the test.
inline camera::Camera camera_of(const std::string& text) {
    const Result<camera::Camera> made =
        lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

/// Points spread over a picture of this width and height.
inline void at_pixels(const std::function<void(const V2d& point)>& check) {
    for (double x = 3.5; x < width; x += 31.0) {
        for (double y = 2.5; y < height; y += 17.0) {
            check({x, y});
        }
    }
}

}  // namespace balcony::rays::test
