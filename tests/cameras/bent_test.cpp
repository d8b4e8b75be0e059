// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The cameras whose rays are bent, against the ray equation.

#include <algorithm>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include "support.hpp"

namespace balcony::cameras::test::bent_test {

namespace {

/// The rays of a camera, at a point of its picture by fractions.
class RaysOf {
public:
    explicit RaysOf(const camera::Camera& camera) {
        const double aspect = camera::Picture(camera).aspect();
        auto made =
            rays::compile(camera, aspect, 1.0, {.tiles = false, .points = true, .bends = true});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        program_.emplace(*std::move(made.value));
        width_ = aspect;
    }
    const rays::RayBatch& at(double x, double y) {
        const double px = x * width_;
        rays::Points points;
        points.x = std::span(&px, 1);
        points.y = std::span(&y, 1);
        program_->run(points, scratch_, batch_);
        return batch_;
    }

private:
    std::optional<rays::RayProgram> program_;
    double width_ = 1.0;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
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

// The parts are within 0.004 distances of the path; over the core, which is 0.24 distances wide and
// where rays turn most, that is an angle of 2·0.004/0.24.
TEST(Gravity, RaysObeyTheRayEquation) {
    constexpr double distance = 4.0;
    constexpr double tolerance = 2.0 * 0.004 / 0.24;
    RaysOf rays(make("gravity", {{"distance", "4"}, {"mass", "0.03"}, {"px", "1"}, {"pz", "2"}}));
    const V3d eye(1.0, 0.0, 2.0);
    double most = 0.0;
    for (const double x : {0.03, 0.3, 0.45, 0.5, 0.62, 0.97}) {
        for (const double y : {0.1, 0.5, 0.64}) {
            const rays::RayBatch& batch = rays.at(x, y);
            ASSERT_TRUE(batch.valid(0));
            const V3d first = batch.part(0, 0).direction;
            const V3d last = batch.part(0, batch.part_count() - 1).direction;
            const V3d wanted = bent_by_star(eye, first, eye + V3d(distance, 0.0, 0.0),
                                            0.03 * distance, 0.12 * distance, 2.5 * distance);
            expect_near(last, wanted, tolerance);
            most = std::max(most, (last - first).length());
        }
    }
    EXPECT_GT(most, 0.4);
}

// A ray through the middle of the star goes straight on.
TEST(Gravity, TheStarIsInTheMiddle) {
    RaysOf rays(make("gravity", {{"yaw", "40deg"}, {"pitch", "-20deg"}}));
    const rays::RayBatch& batch = rays.at(0.5, 0.5);
    const V3d first = batch.part(0, 0).direction;
    expect_near(batch.part(0, batch.part_count() - 1).direction, first, 1e-12);
    const double pitch = -20.0 * degree;
    expect_near(first,
                {std::cos(pitch) * std::cos(40.0 * degree),
                 std::cos(pitch) * std::sin(40.0 * degree), std::sin(pitch)},
                1e-12);
}

}  // namespace balcony::cameras::test::bent_test
