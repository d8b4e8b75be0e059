// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// morph A .. B: cameras between two others.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "support.hpp"

namespace balcony::lang::morph_test {

namespace {

using std::numbers::pi;
using Vector = std::array<double, 3>;

constexpr double tolerance = 1e-12;

double length(const Vector& a) { return std::hypot(a[0], a[1], a[2]); }
double angle(const Vector& a, const Vector& b) {
    const Vector across{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2],
                        a[0] * b[1] - a[1] * b[0]};
    return std::atan2(length(across), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]);
}

camera::Camera made(const std::string& text, const std::vector<Override>& overrides = {}) {
    const auto camera = test::make(text, overrides);
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return camera ? *camera : *make_camera(CameraSource("pinhole"), "");
}

std::string message_of(const std::string& text) {
    const auto camera = test::make(text);
    return camera.diagnostics.empty() ? "" : camera.diagnostics.front().message;
}

constexpr double width = 160.0;
constexpr double height = 90.0;

test::Ray ray_at(const camera::Camera& camera, double x, double y, double time = 0.0) {
    return test::ray(camera, x * width, y * height, width, height, time);
}

void expect_same(const camera::Camera& a, const camera::Camera& b, double time = 0.0) {
    for (const double x : {0.01, 0.3, 0.5, 0.86}) {
        for (const double y : {0.02, 0.5, 0.77}) {
            const test::Ray one = ray_at(a, x, y, time);
            const test::Ray other = ray_at(b, x, y, time);
            EXPECT_EQ(one.valid, other.valid) << x << ' ' << y;
            for (std::size_t i = 0; one.valid && other.valid && i < 3; ++i) {
                EXPECT_NEAR(one.origin[i], other.origin[i], tolerance) << x << ' ' << y;
                EXPECT_NEAR(one.direction[i], other.direction[i], tolerance) << x << ' ' << y;
            }
        }
    }
}

constexpr const char* from = "pinhole(fov = 60deg, px = -1, py = 2)";
constexpr const char* to = "fisheye(fov = 170deg, pz = 4, yaw = 20deg)";

std::string morph(const std::string& amount, const std::string& others = "") {
    return test::joined(
        {"camera m { ", others, " morph ", from, " .. ", to, ", amount = ", amount, " }"});
}

camera::Camera alone(const std::string& name, const std::vector<Override>& overrides) {
    return *make_camera(CameraSource(name), "", overrides);
}

const std::vector<Override> of_pinhole{{"fov", "60deg"}, {"px", "-1"}, {"py", "2"}};
const std::vector<Override> of_fisheye{{"fov", "170deg"}, {"pz", "4"}, {"yaw", "20deg"}};

}  // namespace

// --------------------------------------------------------------------------------------- by rays

TEST(MorphOfRays, IsEitherCameraAtItsEnds) {
    expect_same(made(morph("0")), alone("pinhole", of_pinhole));
    // The fisheye has an aspect of 1 and maps that adapt: it takes any.
    expect_same(made(morph("1")), alone("fisheye", of_fisheye));
    const camera::Camera film = made(morph("keys((1, 0), (3, 1), ease = smooth)"));
    expect_same(film, alone("pinhole", of_pinhole), 0.5);
    expect_same(film, alone("fisheye", of_fisheye), 3.0);
}

TEST(MorphOfRays, TurnsEachRayByAPartOfTheAngle) {
    const camera::Camera pinhole = alone("pinhole", of_pinhole);
    const camera::Camera fisheye = alone("fisheye", of_fisheye);
    for (const double amount : {0.25, 0.5, 0.9, -0.1, 1.2}) {
        const camera::Camera between = made(morph(std::to_string(amount)));
        for (const double x : {0.1, 0.5, 0.8}) {
            const test::Ray a = ray_at(pinhole, x, 0.3);
            const test::Ray b = ray_at(fisheye, x, 0.3);
            const test::Ray ray = ray_at(between, x, 0.3);
            ASSERT_TRUE(ray.valid);
            const double whole = angle(a.direction, b.direction);
            EXPECT_NEAR(angle(a.direction, ray.direction), std::fabs(amount) * whole, tolerance);
            EXPECT_NEAR(angle(ray.direction, b.direction), std::fabs(1.0 - amount) * whole,
                        tolerance);
            for (std::size_t i = 0; i < 3; ++i) {
                EXPECT_NEAR(ray.origin[i], std::lerp(a.origin[i], b.origin[i], amount), tolerance);
            }
        }
    }
}

TEST(MorphOfRays, MayDifferAcrossThePicture) {
    const camera::Camera across = made(morph("x"));
    const test::Ray left = ray_at(across, 0.0, 0.4);
    const test::Ray right = ray_at(across, 1.0, 0.4);
    EXPECT_NEAR(angle(left.direction, ray_at(alone("pinhole", of_pinhole), 0.0, 0.4).direction),
                0.0, tolerance);
    EXPECT_NEAR(angle(right.direction, ray_at(alone("fisheye", of_fisheye), 1.0, 0.4).direction),
                0.0, tolerance);
    EXPECT_NEAR(ray_at(across, 0.5, 0.4).origin[2], 2.0, tolerance);
}

// Where one camera has no ray, a morph has none, except where it is the other one.
TEST(MorphOfRays, HasARayWhereBothHaveOne) {
    const std::string halves =
        "camera left { place (0, 0) .. (0.6, 1)  map u = 1 .. -1, v = square  eye point  "
        "toward plane((1, 0, 0)) }\n"
        "camera right { place (0.4, 0) .. (1, 1)  map u = 1 .. -1, v = square  eye point  "
        "toward plane((1, 0, 0)) }\n";
    const auto valid = [&](const std::string& amount) {
        const camera::Camera camera =
            made(test::joined({halves, "camera m { morph left .. right, amount = ", amount, " }"}));
        return std::array{ray_at(camera, 0.2, 0.5).valid, ray_at(camera, 0.5, 0.5).valid,
                          ray_at(camera, 0.9, 0.5).valid};
    };
    EXPECT_EQ(valid("0"), (std::array{true, true, false}));
    EXPECT_EQ(valid("0.3"), (std::array{false, true, false}));
    EXPECT_EQ(valid("1"), (std::array{false, true, true}));
    // An amount that is no number is no ray.
    EXPECT_EQ(valid("0.3*sqrt(-1 - t)"), (std::array{false, false, false}));
}

TEST(MorphOfRays, HasNoRayBetweenOppositeDirections) {
    const camera::Camera camera =
        made("camera m { morph pinhole .. fisheye(yaw = 180deg), amount = 0.5 }");
    EXPECT_FALSE(ray_at(camera, 0.5, 0.5).valid);
    EXPECT_TRUE(ray_at(camera, 0.6, 0.5).valid);
}

TEST(MorphOfRays, ShowsACameraOfAnotherAspectAsALayerDoes) {
    const auto shown = [](const std::string& others, const std::string& fit) {
        return made(test::joined(
            {"camera m { ", others, " morph panorama .. pinhole, amount = 0", fit, " }"}));
    };
    // The panorama has an aspect of 2, which becomes that of the morph.
    EXPECT_EQ(shown("", "").fixed_aspect(), 2.0);
    // In a picture of 16:9, it leaves a border at the top.
    const camera::Camera fitted = shown("aspect 16/9", "");
    EXPECT_FALSE(ray_at(fitted, 0.5, 0.03).valid);
    EXPECT_NEAR(ray_at(fitted, 0.5, 0.06).direction[2],
                std::sin(pi / 2 * (0.5 - 0.06) * 2 * 2 / (16.0 / 9.0)), tolerance);
    const camera::Camera filled = shown("aspect 16/9", ", aspect = fill");
    EXPECT_NEAR(ray_at(filled, 0.5, 0.06).direction[2], std::sin(pi / 2 * (0.5 - 0.06) * 2),
                tolerance);
    EXPECT_NEAR(ray_at(filled, 0.0, 0.5).direction[0], std::cos(pi * (16.0 / 9.0) / 2.0),
                tolerance);
    const camera::Camera stretched = shown("aspect 16/9", ", aspect = stretch");
    EXPECT_NEAR(ray_at(stretched, 0.0, 0.5).direction[0], -1.0, tolerance);
    EXPECT_NEAR(ray_at(stretched, 0.5, 0.06).direction[2], std::sin(pi / 2 * (0.5 - 0.06) * 2),
                tolerance);
    // Two cameras that adapt to any aspect give one that does.
    EXPECT_EQ(made(morph("0.5")).fixed_aspect(), std::nullopt);
}

TEST(MorphOfRays, BringsBothToItsAxes) {
    const std::string cameras =
        "camera a { map u = 1 .. -1, v = square  eye point(1, 2, 3)  toward plane((2, 2, 3)) }\n"
        "camera b { axes y_up  map u = 1 .. -1, v = square  eye point(1, 3, -2)  "
        "toward plane((2, 3, -2), along_u = (0, 0, -1), along_v = (0, 1, 0)) }\n";
    // b is a in axes with y up, so nothing changes between them.
    for (const char* axes : {"", "axes z_up"}) {
        const camera::Camera camera =
            made(test::joined({cameras, "camera m { ", axes, " morph a .. b, amount = 0.4 }"}));
        EXPECT_EQ(camera.parts().axes, Axes::z_up);
        expect_same(camera, made(cameras.substr(0, cameras.find('\n'))));
    }
    const camera::Camera turned =
        made(cameras + "camera m { axes y_up morph a .. b, amount = 0.4 }");
    EXPECT_EQ(turned.parts().axes, Axes::y_up);
    expect_same(turned, made(cameras.substr(cameras.find('\n'))));
}

TEST(MorphOfRays, MovesAsOneCamera) {
    const std::string move = "move rotate(z, 30deg), translate(5, 0, 1)";
    const camera::Camera moved = made(morph("0.5", move));
    const camera::Camera still = made(morph("0.5"));
    const double c = std::cos(pi / 6.0);
    const double s = std::sin(pi / 6.0);
    const test::Ray a = ray_at(still, 0.7, 0.2);
    const test::Ray b = ray_at(moved, 0.7, 0.2);
    const auto turned = [&](const Vector& v) {
        return Vector{c * v[0] - s * v[1], s * v[0] + c * v[1], v[2]};
    };
    const Vector origin = turned(a.origin);
    EXPECT_NEAR(b.origin[0], origin[0] + 5.0, tolerance);
    EXPECT_NEAR(b.origin[1], origin[1], tolerance);
    EXPECT_NEAR(b.origin[2], origin[2] + 1.0, tolerance);
    EXPECT_NEAR(angle(b.direction, turned(a.direction)), 0.0, tolerance);
}

TEST(MorphOfRays, MayHaveALensATimeAndAPlace) {
    const camera::Camera camera =
        made(morph("keys((0, 0), (1, 1))",
                   "place (0, 0) .. (0.5, 0.5)  lens(radius = 0.1, focus = 5)  time = t + y"));
    EXPECT_TRUE(camera.parts().lens);
    EXPECT_FALSE(ray_at(camera, 0.7, 0.2).valid);
    // At the bottom of its place, the time is t + 1.
    EXPECT_NEAR(ray_at(camera, 0.2, 0.5).origin[2], 4.0, tolerance);
    EXPECT_NEAR(ray_at(camera, 0.2, 0.0).origin[2], 0.0, tolerance);
}

TEST(MorphOfRays, MayBeOfMorphs) {
    const camera::Camera nested = made(
        "camera one { morph pinhole(px = 4) .. fisheye(px = 8), amount = 0.5 }\n"
        "camera two(w = 0) { morph one .. panorama(px = 2), amount = w, aspect = stretch }",
        {{"w", "0.75"}});
    EXPECT_NEAR(ray_at(nested, 0.4, 0.4).origin[0], 0.25 * 6.0 + 0.75 * 2.0, tolerance);
}

TEST(MorphOfRays, MayBeALayerWithItsOwnParameters) {
    const auto picture = make_picture(
        std::make_shared<const SourceText>(
            "test.cam",
            "camera m(w = 0, fov = 40deg) { morph pinhole(fov = fov) .. fisheye, amount = w }\n"
            "picture p { layer m(w = 0.5) layer m(w = keys((0, 0), (1, 1)), fov = 20deg) }"),
        "");
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    const camera::Camera narrow =
        made("camera m(w = 0, fov = 40deg) { morph pinhole(fov = fov) .. fisheye, amount = w }",
             {{"fov", "20deg"}});
    expect_same(narrow, alone("pinhole", {{"fov", "20deg"}}));
}

// --------------------------------------------------------------------------------- by parameters

TEST(MorphOfParameters, IsTheCameraWithTheParametersBetween) {
    const camera::Camera camera = made(
        "camera m { morph pinhole(fov = 20deg, px = 3) .. pinhole(fov = 80deg, roll = 180deg), "
        "amount = keys((0, 0), (4, 1)) }");
    expect_same(camera, alone("pinhole", {{"fov", "35deg"}, {"px", "2.25"}, {"roll", "45deg"}}),
                1.0);
    expect_same(camera, alone("pinhole", {{"fov", "80deg"}, {"roll", "180deg"}}), 4.0);
}

TEST(MorphOfParameters, IsChosenForOneCameraUnlessRaysAre) {
    const std::string calls = "pinhole(roll = 0deg) .. pinhole(roll = 90deg), amount = 0.5";
    const camera::Camera turned = made(test::joined({"camera m { morph ", calls, " }"}));
    expect_same(turned, alone("pinhole", {{"roll", "45deg"}}));
    const camera::Camera rays = made(test::joined({"camera m { morph ", calls, ", by = rays }"}));
    EXPECT_GT(angle(ray_at(rays, 0.9, 0.5).direction, ray_at(turned, 0.9, 0.5).direction), 0.05);
}

TEST(MorphOfParameters, TakesTuplesAndLists) {
    const std::string way =
        "camera way(at = (0, 0, 0), path = [(-3, 0), (0, 1), (3, 0)]) { map u = 0 .. 1, v = -1 .. "
        "1 "
        "eye { object catmull_rom(path) move translate(at) } toward { object surface(u, v) = "
        "[5*u - 2.5, 5, v] move translate(at) } }\n";
    const camera::Camera camera =
        made(way + "camera m { morph way .. way(at = (4, 0, 8)), amount = 0.25 }");
    expect_same(camera, made(way, {{"at", "(1, 0, 2)"}}));
    const camera::Camera bent = made(
        way + "camera m { morph way .. way(path = [(-3, 0), (0, 5), (3, 0)]), amount = 0.25 }");
    expect_same(bent, made(way, {{"path", "[(-3, 0), (0, 2), (3, 0)]"}}));
}

TEST(MorphOfParameters, KeepsLensAndTimeOfTheCamera) {
    const camera::Camera camera = made(
        "camera c(r = 1) { map u = 1 .. -1, v = square  eye point(t, 0, 0)  toward plane((100, 0, "
        "0))  lens(radius = r, focus = 5)  time = t + y }\n"
        "camera m { morph c(r = 1) .. c(r = 3), amount = 0.5  move translate(0, 1, 0) }");
    const auto lens = std::dynamic_pointer_cast<const camera::ThinLens>(camera.parts().lens);
    ASSERT_TRUE(lens);
    EXPECT_EQ(lens->radius().constant(), 2.0);
    EXPECT_NEAR(ray_at(camera, 0.5, 1.0).origin[0], 1.0, tolerance);
    EXPECT_NEAR(ray_at(camera, 0.5, 1.0).origin[1], 1.0, tolerance);
}

// --------------------------------------------------------------------------------------- mistakes

TEST(Morph, HasOtherStatementsOnly) {
    EXPECT_EQ(message_of("camera m { eye sphere(1) morph pinhole .. fisheye, amount = 0 }"),
              "a camera that morphs has no 'eye' of its own");
}

TEST(Morph, IsNotBetweenPicturesOrItself) {
    EXPECT_EQ(message_of("picture p { layer pinhole }\n"
                         "camera m { morph p .. pinhole, amount = 0 }"),
              "'p' is a picture, but a morph is between cameras");
    EXPECT_EQ(message_of("camera a { morph b .. pinhole, amount = 0 }\n"
                         "camera b { morph a .. pinhole, amount = 0 }"),
              "the camera 'b' is part of its own morph");
    std::string deep = "camera c0 { morph pinhole .. fisheye, amount = 0 }\n";
    for (int i = 1; i < 30; ++i) {
        deep += test::joined({"camera c", std::to_string(i), " { morph c", std::to_string(i - 1),
                              " .. fisheye, amount = 0 }\n"});
    }
    const auto made = test::make(deep);
    EXPECT_FALSE(made);
}

TEST(Morph, IsExplained) {
    const auto explained = Workspace().explain(CameraSource(std::make_shared<const SourceText>(
        "test.cam", morph("keys((0, 0), (1, 1))", "move translate(0, 0, 1)"))));
    ASSERT_TRUE(explained) << to_text(explained.diagnostics);
    std::vector<std::string> statements;
    for (const Explanation::Step& step : explained->explanation.steps) {
        statements.push_back(std::string(2 * step.depth, ' ') + step.statement);
    }
    EXPECT_EQ(statements.front(), "morph");
    EXPECT_EQ(statements[1], "  from");
    EXPECT_NE(std::find(statements.begin(), statements.end(), "  to"), statements.end());
    EXPECT_EQ(statements.back(), "move");
}

}  // namespace balcony::lang::morph_test
