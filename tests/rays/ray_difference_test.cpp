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

TEST(RayDifference, OfDirectionsIsWhatIsSeenFarAway) {
    const auto [here, there] = neighbours("superelliptic", 1e-3, 2e-3);
    EXPECT_NEAR(pixels_between(here, there, everywhere), pixels_between(here, there, 1e9), 1e-6);
    const auto [left, right] = neighbours("orthographic", 1e-3, 0.0);
    EXPECT_EQ(pixels_between(left, right, everywhere), 0.0) << "all directions are equal";
    EXPECT_NEAR(pixels_between(left, right, 1.0), 1e-3, 1e-9);
}

TEST(RayDifference, IsInfiniteWhereAPixelIsAPoint) {
    auto [here, there] = neighbours("pinhole", 0.0, 0.0);
    EXPECT_EQ(pixels_between(here, there, 0.0), 0.0);
    there.origin.x += 1.0;
    there.origin.y += 1.0;
    EXPECT_EQ(pixels_between(here, there, 0.0), everywhere);
}

}  // namespace
}  // namespace balcony::rays::ray_difference_test
