// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "balcony/lang.hpp"
#include "balcony/ray_difference.hpp"

namespace balcony::rays::ray_difference_test {
namespace {

constexpr double everywhere = std::numeric_limits<double>::infinity();

// The rays of a camera at two points that are a small step apart.
struct Neighbours {
    Ray here, there;
};

Neighbours neighbours(const char* camera, double dx, double dy) {
    const auto made = lang::make_camera(camera, "");
    const auto program =
        compile(*made, 96, 54, {.footprints = true, .tiles = false, .points = true});
    const std::array x{30.5, 30.5 + dx};
    const std::array y{20.5, 20.5 + dy};
    Scratch scratch;
    RayBatch rays;
    program->run({.x = x, .y = y}, scratch, rays);
    return {rays[0], rays[1]};
}

TEST(RayDifference, IsTheDistanceOfThePicturePoints) {
    constexpr double step = 1e-4;
    for (const char* camera : {"pinhole", "fisheye", "superelliptic", "orthographic", "cylinder"}) {
        for (const auto& [dx, dy] : {std::pair(3.0, 4.0), {1.0, 0.0}, {0.0, -2.0}, {-1.0, 1.0}}) {
            const auto [here, there] = neighbours(camera, step * dx, step * dy);
            // To first order: the second derivatives add about a step of the offset itself.
            const double pixels = step * std::hypot(dx, dy);
            EXPECT_NEAR(pixels_between(here, there, 50.0), pixels, 0.01 * pixels) << camera;
        }
    }
}

TEST(RayDifference, CountsWhatNoPointOfThePictureHas) {
    // A pinhole's origin never moves: a tenth of the distance is as much as a tenth of a radian.
    auto [here, there] = neighbours("pinhole", 0.0, 0.0);
    there.origin += 5.0 * here.direction;
    const double radians_per_pixel =
        std::max(here.direction_by_x.length(), here.direction_by_y.length());
    EXPECT_NEAR(pixels_between(here, there, 50.0), 0.1 / radians_per_pixel, 1e-9);
    EXPECT_EQ(pixels_between(here, there, everywhere), 0.0);
}

TEST(RayDifference, IsInfiniteWhereAPixelIsAPoint) {
    const auto [left, right] = neighbours("orthographic", 1e-3, 0.0);
    EXPECT_EQ(pixels_between(left, right, everywhere), 0.0) << "all directions are equal";
    EXPECT_NEAR(pixels_between(left, right, 1.0), 1e-3, 1e-9);
    auto turned = right;
    turned.direction = -right.direction;
    EXPECT_EQ(pixels_between(left, turned, everywhere), everywhere);
}

}  // namespace
}  // namespace balcony::rays::ray_difference_test
