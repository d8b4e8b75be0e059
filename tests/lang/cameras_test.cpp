// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The built-in cameras against their textbook formulas, and what statements mean, by rays.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "support.hpp"

namespace balcony::lang::cameras_test {
namespace {

using std::numbers::pi;
using test::Ray;

// Values of order one after some ten rounded operations.
constexpr double tolerance = 1e-12;

void expect_near(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(a[i], b[i], tolerance) << "component " << i;
    }
}

constexpr std::array standard_cameras{"cylinder", "fisheye", "hyperbolic",   "orthographic",
                                      "panorama", "pinhole", "superelliptic"};

camera::Camera standard(const char* name, const std::vector<Override>& overrides = {}) {
    Result<camera::Camera> made = make_camera(name, "", overrides);
    EXPECT_TRUE(made.diagnostics.empty()) << to_text(made.diagnostics);
    return *made;
}

TEST(StandardCameras, AllLoadWithoutDiagnostics) {
    for (const std::string name : standard_cameras) {
        const Result<camera::Camera> made = make_camera(name, "");
        ASSERT_TRUE(made) << to_text(made.diagnostics);
        EXPECT_EQ(to_text(made.diagnostics), "");
        EXPECT_EQ(made->name(), name);
        const Result<std::vector<Description>> said = Workspace().describe(name);
        ASSERT_TRUE(said);
        EXPECT_FALSE(said->front().comment.empty());
    }
}

// Every one looks along x in the middle, with what is left (y) on the left and what is up above;
// the superelliptic one if its seam is not in a corner.
TEST(StandardCameras, FaceForwardUnmirrored) {
    for (const std::string name : standard_cameras) {
        std::vector<Override> overrides;
        if (name == "superelliptic") {
            overrides.push_back({"seam", "0deg"});
        }
        const camera::Camera camera = standard(name.c_str(), overrides);
        const Ray middle = test::ray(camera, 100, 50, 200, 100);
        EXPECT_TRUE(middle.valid) << name;
        expect_near(middle.direction, {1, 0, 0});
        const auto hits = [&](double x, double y) {
            const Ray ray = test::ray(camera, x, y, 200, 100);
            return std::pair(ray.origin[1] + ray.direction[1], ray.origin[2] + ray.direction[2]);
        };
        EXPECT_GT(hits(90, 50).first, hits(110, 50).first) << name;
        EXPECT_GT(hits(100, 40).second, hits(100, 60).second) << name;
    }
}

TEST(StandardCameras, PinholeIsPerspective) {
    const camera::Camera camera = standard("pinhole", {{"fov", "90deg"}, {"px", "3"}});
    const Ray corner = test::ray(camera, 0, 0, 200, 100);
    const double length = std::sqrt(1 + 1 + 0.25);
    expect_near(corner.origin, {3, 0, 0});
    expect_near(corner.direction, {1 / length, 1 / length, 0.5 / length});
}

TEST(StandardCameras, PinholeTurnsAsDocumented) {
    const auto middle = [](const char* name, const char* value) {
        return test::ray(standard("pinhole", {{name, value}}), 50, 50, 100, 100).direction;
    };
    expect_near(middle("yaw", "90deg"), {0, 1, 0});
    expect_near(middle("pitch", "90deg"), {0, 0, 1});
    // Rolled clockwise by a quarter, the camera's upper edge lies to the right.
    const Ray up = test::ray(standard("pinhole", {{"roll", "90deg"}}), 50, 0, 100, 100);
    EXPECT_LT(up.direction[1], -0.1);
    EXPECT_NEAR(up.direction[2], 0.0, tolerance);
}

TEST(StandardCameras, OrthographicRaysAreParallel) {
    const camera::Camera camera = standard("orthographic", {{"width", "8"}});
    const Ray corner = test::ray(camera, 0, 0, 200, 100);
    expect_near(corner.origin, {0, 4, 2});
    expect_near(corner.direction, {1, 0, 0});
}

// As wide as any camera that takes every aspect.
TEST(StandardCameras, OrthographicHasAScaleAndAnyAspect) {
    for (const char* width : {"10", "3.7", "0.0231"}) {
        const camera::Camera camera = standard("orthographic", {{"width", width}});
        ASSERT_TRUE(camera.parts().sides);
        EXPECT_EQ((*camera.parts().sides)[0], std::stod(width));
        EXPECT_NEAR(camera.parts().aspect, camera::default_aspect, 1e-15);
        EXPECT_FALSE(camera.fixed_aspect());
    }
    const camera::Camera tower = standard("orthographic", {{"width", "4"}, {"height", "9"}});
    EXPECT_EQ(*tower.parts().sides, (std::array{4.0, 9.0}));
}

TEST(StandardCameras, PanoramaIsEquirectangular) {
    const camera::Camera camera = standard("panorama");
    for (double x = 5; x < 200; x += 30) {
        for (double y = 5; y < 100; y += 30) {
            const double longitude = pi - 2 * pi * x / 200;
            const double latitude = pi / 2 - pi * y / 100;
            expect_near(test::ray(camera, x, y, 200, 100).direction,
                        {std::cos(longitude) * std::cos(latitude),
                         std::sin(longitude) * std::cos(latitude), std::sin(latitude)});
        }
    }
}

TEST(StandardCameras, FisheyeAngleGrowsWithTheDistance) {
    const camera::Camera camera = standard("fisheye");
    for (double x = 0; x <= 100; x += 12.5) {
        for (double y = 0; y <= 100; y += 12.5) {
            const double distance = std::hypot(x - 50, y - 50) / 50 * pi / 2;
            EXPECT_NEAR(test::ray(camera, x, y, 100, 100).direction[0], std::cos(distance),
                        tolerance);
        }
    }
}

TEST(StandardCameras, HyperbolicRaysEndUpAtRightAnglesToTheWalls) {
    const camera::Camera camera = standard("hyperbolic", {{"width", "20"}});
    const double half = std::sqrt(0.5);
    const Ray left = test::ray(camera, 0, 50, 100, 100);
    EXPECT_NEAR(left.direction[0], half, 1e-6);  // At parameter 10, tanh is 1 to 4e-9.
    EXPECT_NEAR(left.direction[1], half, 1e-6);
}

TEST(StandardCameras, SuperellipticSidesLookAtRightAngles) {
    const camera::Camera camera = standard("superelliptic");
    const double left_wall = 1000.0 * (90.0 + 30.85) / 360.0;
    const Ray left = test::ray(camera, left_wall, 100, 1000, 200);
    expect_near(left.direction, {0, 1, 0});
    EXPECT_NEAR(left.origin[1], 25.0, 1e-9);
}

// ---------------------------------------------------------------------------------- statements

camera::Camera made(const std::string& body) {
    Result<camera::Camera> camera = test::make(test::joined({"camera c {", body, "}"}));
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return *camera;
}

TEST(Statements, WarpsGoInSequence) {
    const Ray ray = test::ray(made("map u = 0 .. 2, v = 0 .. 2 eye plane "
                                   "warp translate(1, 0), formula(u, v) = [2*u, v]"),
                              5, 5, 10, 10);
    expect_near(ray.origin, {0, 4, 1});
}

TEST(Statements, MovesGoInSequence) {
    const Ray ray = test::ray(made("map u = 0 .. 2, v = 0 .. 2 eye plane look normal "
                                   "move translate(0, 1, 0), rotate(x, 90deg) "
                                   "move formula(x, y, z) = [x + 1, y, z]"),
                              5, 5, 10, 10);
    expect_near(ray.origin, {1, -1, 2});
}

TEST(Statements, AxesCanBeNegative) {
    const Ray a = test::ray(made("map u = 0 .. 2, v = 0 .. 2 eye plane move rotate(-z, 90deg)"), 5,
                            5, 10, 10);
    expect_near(a.origin, {1, 0, 1});
}

TEST(Statements, ABlocksWarpsFollowAndItsMovesPrecedeTheCameras) {
    const camera::Camera camera = made(R"(
        map  u = 0 .. 2, v = 0 .. 2
        warp scale(2)
        move translate(0, 0, 10)
        eye {
            map    u = 0 .. 4, v = 0 .. 4
            warp   translate(1, 0)
            object plane
            move   scale(3)
        }
        toward plane((1, 0, 0)))");
    const Ray ray = test::ray(camera, 5, 5, 10, 10);
    // The eye: (2, 2), doubled, moved by 1 to (5, 4), tripled, raised by 10.
    expect_near(ray.origin, {0, 15, 22});
    // The direction object: (1, 1), doubled, raised by 10.
    const std::array<double, 3> d = {1, 2 - 15, 12 - 22};
    const double length = std::hypot(d[0], d[1], d[2]);
    expect_near(ray.direction, {d[0] / length, d[1] / length, d[2] / length});
}

TEST(Statements, LetsMayBeInAnyOrder) {
    const Ray ray = test::ray(made("let a = b + 1 map u = 0 .. a, v = square eye plane let b = 2"),
                              10, 5, 10, 10);
    expect_near(ray.origin, {0, 3, 0});
}

TEST(Statements, AspectAndAxes) {
    const camera::Camera camera =
        made("aspect 21/9 axes y_up map u = 0 .. 1, v = square eye plane");
    EXPECT_EQ(camera.parts().aspect, 21.0 / 9.0);
    EXPECT_EQ(camera.parts().axes, Axes::y_up);
}

TEST(Statements, AnAspectMayBeTheSidesInSceneUnits) {
    const camera::Camera sized = made("aspect (6, 1.5) map u = 0 .. 1, v = 0 .. 1 eye plane");
    EXPECT_EQ(sized.parts().aspect, 4.0);
    EXPECT_EQ(sized.parts().sides, (std::array{6.0, 1.5}));
    EXPECT_EQ(camera::Picture(sized).parts().sides, (std::array{6.0, 1.5}));
    EXPECT_FALSE(made("aspect 4 map u = 0 .. 1, v = 0 .. 1 eye plane").parts().sides);
}

TEST(Statements, LookDefaultsToRelativeOrNormal) {
    EXPECT_TRUE(made("map u = 0 .. 1, v = square eye point toward plane((1, 0, 0))")
                    .parts()
                    .look->needs_direction_object());
    EXPECT_EQ(made("map u = 0 .. 1, v = square eye plane").parts().look->min_eye_dimension(), 2);
}

TEST(Statements, AStageWithoutParenthesesTakesItsDefaults) {
    const Ray front =
        test::ray(made("map u = 0 .. 1, v = square eye plane look normal"), 1, 1, 2, 2);
    const Ray back = test::ray(
        made("map u = 0 .. 1, v = square eye plane look normal(side = back)"), 1, 1, 2, 2);
    expect_near(front.direction, {1, 0, 0});
    expect_near(back.direction, {-1, 0, 0});
}

TEST(Statements, FormulasDependOnParametersLetsAndTime) {
    const camera::Camera camera =
        made("let k = 3 map u = 0 .. 2, v = 0 .. 2 eye surface(u, v) = [t, k*u, v + u*v]");
    expect_near(test::ray(camera, 5, 5, 10, 10, 7.0).origin, {7, 3, 2});
}

TEST(Statements, PlaceGivesACameraAPart) {
    const camera::Camera camera = made(
        "place (0.5, 0) .. (1, 1) "
        "map u = 0 .. 1, v = 0 .. 1 eye plane");
    EXPECT_FALSE(test::ray(camera, 40, 50, 100, 100).valid);
    expect_near(test::ray(camera, 75, 50, 100, 100).origin, {0, 0.5, 0.5});
}

}  // namespace
}  // namespace balcony::lang::cameras_test
