// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras whose rays are refracted or bent, against the lens equation and the ray equation.

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::cameras::test::bent_test {

namespace {

/// The rays of a camera, at a point of its picture by fractions.
class RaysOf {
public:
    RaysOf(const camera::Camera& camera, std::vector<rays::Input> inputs) {
        const double aspect = camera::Picture(camera).aspect();
        auto made = rays::compile(camera, aspect, 1.0,
                                  {.tiles = false,
                                   .points = true,
                                   .bends = camera.parts().bend != nullptr,
                                   .inputs = std::move(inputs)});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        program_.emplace(*std::move(made.value));
        width_ = aspect;
    }
    const rays::RayBatch& at(double x, double y, program::InputValues inputs = {}) {
        const double px = x * width_;
        rays::Points points;
        points.x = std::span(&px, 1);
        points.y = std::span(&y, 1);
        points.inputs = inputs;
        program_->run(points, scratch_, batch_);
        return batch_;
    }

private:
    std::optional<rays::RayProgram> program_;
    double width_ = 1.0;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
};

/// The rays of the built-in portrait lens, by the point of the picture and that of the lens.
class LensRaysOf {
public:
    explicit LensRaysOf(const std::vector<lang::Override>& overrides)
        : rays_(make("portrait_lens", overrides),
                {{std::string(camera::lens_input_x), program::Rate::pixel},
                 {std::string(camera::lens_input_y), program::Rate::pixel}}) {}
    Ray operator()(double x, double y, const V2d& lens) {
        const std::array inputs{std::span(&lens.x, 1), std::span(&lens.y, 1)};
        return rays_.at(x, y, inputs)[0];
    }

private:
    RaysOf rays_;
};

/// The last direction of a ray in the index 1 + 2 mass/√(r² + core²) about a star, by the ray
/// equation d/ds (n dp/ds) = ∇n in many steps of the midpoint rule.
V3d bent_by_star(V3d point, V3d direction, const V3d& star, double mass, double core,
                 double length) {
    constexpr int steps = 20000;
    const auto index = [&](const V3d& p) {
        return 1.0 + 2.0 * mass / std::sqrt((p - star).length2() + core * core);
    };
    const auto gradient = [&](const V3d& p) {
        return -2.0 * mass * std::pow((p - star).length2() + core * core, -1.5) * (p - star);
    };
    V3d motion = index(point) * direction;
    const double step = length / steps;
    for (int i = 0; i < steps; ++i) {
        const V3d half = point + 0.5 * step * motion.normalized();
        motion += step * gradient(half);
        point = half + 0.5 * step * motion.normalized();
    }
    return motion.normalized();
}

}  // namespace

// The parts are within 0.002 distances of the path; over the core, which is 0.24 distances wide and
// where rays turn most, that is an angle of 2·0.002/0.24.
TEST(Gravity, RaysObeyTheRayEquation) {
    constexpr double distance = 4.0;
    constexpr double tolerance = 2.0 * 0.002 / 0.24;
    RaysOf rays(make("gravity", {{"distance", "4"}, {"mass", "0.03"}, {"px", "1"}, {"pz", "2"}}),
                {});
    const V3d eye(1.0, 0.0, 2.0);
    double most = 0.0;
    for (const double x : {0.03, 0.3, 0.45, 0.5, 0.62, 0.97}) {
        for (const double y : {0.1, 0.5, 0.64}) {
            const rays::RayBatch& batch = rays.at(x, y);
            ASSERT_TRUE(batch.valid(0));
            const V3d first = batch.part(0, 0).direction;
            const V3d last = batch.part(0, batch.part_count() - 1).direction;
            const V3d wanted = bent_by_star(eye, first, eye + V3d(distance, 0.0, 0.0),
                                            0.03 * distance, 0.12 * distance, 3.0 * distance);
            expect_near(last, wanted, tolerance);
            most = std::max(most, (last - first).length());
        }
    }
    EXPECT_GT(most, 0.4);
}

// A ray through the middle of the star goes straight on.
TEST(Gravity, TheStarIsInTheMiddle) {
    RaysOf rays(make("gravity", {{"yaw", "40deg"}, {"pitch", "-20deg"}}), {});
    const rays::RayBatch& batch = rays.at(0.5, 0.5);
    const V3d first = batch.part(0, 0).direction;
    expect_near(batch.part(0, batch.part_count() - 1).direction, first, 1e-12);
    const double pitch = -20.0 * degree;
    expect_near(first,
                {std::cos(pitch) * std::cos(40.0 * degree),
                 std::cos(pitch) * std::sin(40.0 * degree), std::sin(pitch)},
                1e-12);
}

// Spherical aberration grows with the square of the aperture.
TEST(PortraitLens, IsSharpAtItsDistance) {
    LensRaysOf rays({lang::Override{"distance", "2.5"}});
    const auto miss = [&](double a) {
        const Ray ray = rays(0.5, 0.5, {0.0, a});
        return ray.origin.x - ray.origin.z / ray.direction.z * ray.direction.x - 2.5;
    };
    EXPECT_LT(std::abs(miss(0.02)), 1e-3);
    EXPECT_NEAR(miss(0.02) / miss(0.2), 0.01, 0.001);
}

// The outermost ray on the axis leaves at the focal length divided by twice the f-number, in
// metres; steps of the lens are 1 % of it, and the spherical aberration of the pupil wide open 3 %.
TEST(PortraitLens, HasItsFNumber) {
    for (const double f_number : {2.2, 4.0, 16.0}) {
        LensRaysOf rays(
            {lang::Override{"f_number", fmt::format("{}", f_number)}, {"distance", "1e6"}});
        double rim = 0.0;
        for (double a = 0.0; a < 1.0; a += 0.01) {
            const Ray ray = rays(0.5, 0.5, {0.0, a});
            rim = ray.valid ? ray.origin.z : rim;
        }
        const double wanted = 0.085 / (2.0 * f_number);
        EXPECT_NEAR(rim, wanted, 0.04 * wanted) << f_number;
    }
}

// 36 mm by 24 mm at 85 mm, but for the distortion of 1 %; and the mount darkens the corners.
TEST(PortraitLens, HasTheFieldAndTheVignettingOfItsLens) {
    LensRaysOf rays({lang::Override{"distance", "1e6"}});
    const Ray right = rays(1.0, 0.5, {0.0, 0.0});
    EXPECT_NEAR(-right.direction.y / right.direction.x, 18.0 / 85.0, 0.01 * 18.0 / 85.0);
    const Ray top = rays(0.5, 0.0, {0.0, 0.0});
    EXPECT_NEAR(top.direction.z / top.direction.x, 12.0 / 85.0, 0.01 * 12.0 / 85.0);
    for (const V2d& at : {V2d(0.9, 0.0), V2d(0.0, 0.9), V2d(-0.9, 0.0), V2d(0.0, -0.9)}) {
        EXPECT_TRUE(rays(0.5, 0.5, at).valid) << at;
    }
    int passed = 0;
    for (double a = -0.9; a < 1.0; a += 0.2) {
        for (double b = -0.9; b < 1.0; b += 0.2) {
            passed += rays(0.01, 0.01, {a, b}).valid ? 1 : 0;
        }
    }
    EXPECT_GT(passed, 10);
    EXPECT_LT(passed, 60);
}

}  // namespace balcony::cameras::test::bent_test
