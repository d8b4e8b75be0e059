// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// keys(...): values between keyframes, wherever an expression may stand.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::keys_test {

namespace {

// The origin of the central ray of a camera whose eye is at a point.
std::array<double, 3> eye_at(const std::string& coordinates, double time,
                             const std::string& lets = "",
                             const std::vector<Override>& overrides = {}) {
    const auto camera =
        test::make(test::joined({lets, "\ncamera c(p = 0) { map u = 1 .. -1, v = square eye point(",
                                 coordinates, ") toward plane((1, 0, 0)) move translate(p) }"}),
                   overrides);
    EXPECT_TRUE(camera) << to_text(camera.diagnostics);
    return camera ? test::ray(*camera, 50.0, 50.0, 100.0, 100.0, time).origin
                  : std::array<double, 3>{};
}

double value_at(const std::string& expression, double time, const std::string& lets = "") {
    return eye_at(expression + ", 0, 0", time, lets)[0];
}

double smooth(double s) { return s * s * (3.0 - 2.0 * s); }

constexpr double rounding = 1e-14;

}  // namespace

TEST(Keys, GoFromKeyToKey) {
    EXPECT_EQ(value_at("keys((1, 10), (3, 20))", 0.0), 10.0);
    EXPECT_EQ(value_at("keys((1, 10), (3, 20))", 1.5), 12.5);
    EXPECT_EQ(value_at("keys((1, 10), (3, 20))", 9.0), 20.0);
    EXPECT_EQ(value_at("keys((0, 1), (2, 5), ease = smooth)", 0.5), 1.0 + 4.0 * smooth(0.25));
    EXPECT_EQ(value_at("keys((0, 1), (2, 5), ease = hold)", 1.9), 1.0);
    EXPECT_EQ(value_at("keys((2, 7))", 0.0), 7.0);
    EXPECT_EQ(value_at("keys((0, 0), (1, 1), beyond = repeat)", 3.25), 0.25);
    EXPECT_EQ(value_at("keys((0, 0), (1, 1), beyond = repeat)", -0.75), 0.25);
    EXPECT_EQ(value_at("keys((0, 0), (1, 1), beyond = mirror)", 3.25), 0.75);
    EXPECT_EQ(value_at("keys((0, 0), (1, 1), beyond = mirror)", -0.25), 0.25);
}

TEST(Keys, ArePartsOfExpressions) {
    EXPECT_EQ(value_at("1 + 2*keys((0, 0), (1, 1))^2", 0.5), 1.5);
    EXPECT_EQ(value_at("if(t < 1, keys((0, 5)), 1)", 0.5), 5.0);
    EXPECT_EQ(value_at("keys((0, t), (1, 10*t))", 0.5), 0.5 * (0.5 + 5.0));
    // Keys of keys: the outer ease bends the inner time.
    EXPECT_NEAR(value_at("keys((0, 0), (1, 8), at = keys((0, 0), (4, 1), ease = smooth))", 1.0),
                8.0 * smooth(0.25), rounding);
}

TEST(Keys, MayBeTuples) {
    const std::array middle{1.0, 2.0, 3.0};
    EXPECT_EQ(eye_at("keys((0, 0, 0, 0), (2, 2, 4, 6))", 1.0), middle);
    EXPECT_EQ(eye_at("keys((0, (0, 0, 0)), (2, (2, 4, 6)))", 1.0), middle);
    EXPECT_EQ(eye_at("keys((0, a), (2, 2*2/2, b))", 1.0, "let a = (0, 0, 0)  let b = (4, 6)"),
              middle);
    EXPECT_EQ(eye_at("keys((0, 0, 0, 0), (2, 2, 4, 6))[1], 0, 0", 1.0)[0], 2.0);
    // As a value of its own, and as one that a function gives.
    EXPECT_EQ(eye_at("spot", 1.0, "let spot = keys((0, 0, 0, 0), (2, 2, 4, 6))"), middle);
    EXPECT_EQ(eye_at("way(2)", 1.0, "let way(k) = keys((0, 0, 0, 0), (k, k, 2*k, 3*k))"), middle);
}

TEST(Keys, MayBeLists) {
    EXPECT_EQ(value_at("keys([(0, 1), (2, 5)])", 1.0), 3.0);
    EXPECT_EQ(value_at("keys(path, (4, 9), at = 3)", 0.0, "let path = [(0, 1), (2, 5)]"), 7.0);
    EXPECT_EQ(value_at("keys(first, (2, 5))", 1.0, "let first = (0, 1)"), 3.0);
}

TEST(Keys, MayBeInATable) {
    const files::TemporaryFolder folder;
    folder.write("path.csv", "time, x, y, z\n0, 0, 0, 1\n2, 4, 2, 1\n");
    folder.write("turn.csv", "0 0deg\n4 90deg\n");
    const auto file =
        folder.write("c.cam",
                     "camera c { map u = 1 .. -1, v = square eye point(keys(\"path.csv\")) "
                     "toward plane((1, 0, 0)) move rotate(z, keys(\"turn.csv\")) }");
    const auto camera = make_camera(file, "");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    const auto ray = test::ray(*camera, 50.0, 50.0, 100.0, 100.0, 2.0);
    const double half = std::numbers::sqrt2 / 2.0;
    EXPECT_NEAR(ray.origin[0], half * (4.0 - 2.0), rounding);
    EXPECT_NEAR(ray.origin[1], half * (4.0 + 2.0), rounding);
    Workspace workspace;
    ASSERT_TRUE(workspace.make_camera(file));
    const auto files = workspace.files();
    EXPECT_TRUE(std::any_of(files.begin(), files.end(), [](const std::filesystem::path& path) {
        return path.filename() == "path.csv";
    }));
}

TEST(Keys, HaveTheUnitOfTheirValues) {
    EXPECT_NEAR(value_at("keys((0, 60deg), (4, 20deg))/1deg", 2.0), 40.0, 1e-12);
    EXPECT_NEAR(value_at("keys((0, 0), (4, 20deg))/1deg", 2.0), 10.0, 1e-12);
    EXPECT_NEAR(value_at("keys((0deg, 1), (90deg, 3), at = t*10deg)", 4.5), 2.0, rounding);
}

TEST(Keys, MayStandForAnyOtherParameter) {
    const auto camera = test::make(
        "camera c { map u = 1 .. 0, v = square\n"
        "eye surface(u, v) = [keys((0, 0), (0.5, 1), (1, 5), at = u), v, 0] look normal }");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    EXPECT_NEAR(test::ray(*camera, 25.0, 50.0, 100.0, 100.0).origin[0], 3.0, rounding);
}

TEST(Keys, ComeFromTheCommandLine) {
    EXPECT_EQ(eye_at("0, 0, 0", 1.0, "", {{"p", "keys((0, 0), (2, 6))"}})[0], 3.0);
    const auto pinhole = make_camera(CameraSource("pinhole"), "",
                                     {{"fov", "keys((0, 60deg), (4, 20deg), ease = smooth)"}});
    ASSERT_TRUE(pinhole) << to_text(pinhole.diagnostics);
    const double fov = (60.0 - 40.0 * smooth(0.25)) * std::numbers::pi / 180.0;
    const auto edge = test::ray(*pinhole, 0.0, 50.0, 160.0, 100.0, 1.0).direction;
    EXPECT_NEAR(std::atan2(edge[1], edge[0]), fov / 2.0, rounding);
}

// A file's own function or value of that name hides the built-in one.
TEST(Keys, AreNoReservedWord) {
    EXPECT_EQ(value_at("keys(3)", 0.0, "let keys(x) = 2*x"), 6.0);
    EXPECT_EQ(value_at("keys", 0.0, "let keys = 4"), 4.0);
    EXPECT_EQ(value_at("keys((0, 1))", 0.0, "let smooth = 3  let ease = smooth"), 1.0);
}

TEST(Keys, KeepsAConstantConstant) {
    const auto camera = test::make(
        "camera c { aspect keys((0, 1), (1, 3), at = 0.5)  map u = 1 .. -1, v = square "
        "eye sphere(1) }");
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    EXPECT_EQ(camera->parts().aspect, 2.0);
}

}  // namespace balcony::lang::keys_test
