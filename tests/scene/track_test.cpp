// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/motion.hpp"

namespace balcony::scene::testing::track_test {

namespace {

using std::numbers::pi;
// The values of tracks are floats, of the order of 1.
constexpr double float_rounding = 4e-7;

double value_at(const Track& track, double time) {
    double value = 0.0;
    evaluate(track, time, {&value, 1});
    return value;
}

/// The keys of a quarter turn about z, as quaternions.
std::vector<float> quarter_turn() {
    const auto half = static_cast<float>(std::sqrt(0.5));
    return {0, 0, 0, 1, 0, 0, half, half};
}

}  // namespace

TEST(Track, StepKeepsTheValueOfTheKeyBefore) {
    const Track track{Interpolation::step, 1, {1.0, 2.0, 4.0}, {10, 20, 40}};
    EXPECT_EQ(value_at(track, 0.0), 10.0) << "before the first key";
    EXPECT_EQ(value_at(track, 1.999), 10.0);
    EXPECT_EQ(value_at(track, 2.0), 20.0) << "at a key";
    EXPECT_EQ(value_at(track, 3.999), 20.0);
    EXPECT_EQ(value_at(track, 9.0), 40.0) << "after the last key";
}

TEST(Track, LinearIsTheLineBetweenKeys) {
    const Track track{Interpolation::linear, 2, {1.0, 2.0, 4.0}, {10, -1, 20, -2, 40, 0}};
    std::array<double, 2> numbers{};
    evaluate(track, 1.25, numbers);
    EXPECT_DOUBLE_EQ(numbers[0], 12.5);
    EXPECT_DOUBLE_EQ(numbers[1], -1.25);
    evaluate(track, 3.5, numbers);
    EXPECT_DOUBLE_EQ(numbers[0], 35.0);
    EXPECT_DOUBLE_EQ(numbers[1], -0.5);
    evaluate(track, -5.0, numbers);
    EXPECT_EQ(numbers[0], 10.0);
    evaluate(track, 4.0, numbers);
    EXPECT_EQ(numbers[1], 0.0);
}

// A cubic Hermite spline gives every cubic polynomial back.
TEST(Track, CubicSplineIsExactForCubics) {
    const auto cubic = [](double t) { return 2.0 * t * t * t - 3.0 * t * t + t + 5.0; };
    const auto slope = [](double t) { return 6.0 * t * t - 6.0 * t + 1.0; };
    Track track{Interpolation::cubic_spline, 1, {0.0, 0.5, 2.0}, {}};
    for (const double time : track.times) {
        const auto derivative = static_cast<float>(slope(time));
        track.values.insert(track.values.end(),
                            {derivative, static_cast<float>(cubic(time)), derivative});
    }
    for (int i = 0; i <= 40; ++i) {
        const double time = 0.05 * i;
        EXPECT_NEAR(value_at(track, time), cubic(time), 1e-12) << time;
    }
    EXPECT_EQ(value_at(track, 3.0), cubic(2.0)) << "no extrapolation";
}

TEST(Track, RotationsTurnEvenly) {
    const Track track{Interpolation::linear, 4, {0.0, 2.0}, quarter_turn()};
    for (int i = 0; i <= 20; ++i) {
        const double time = 0.1 * i;
        const Quatd turn = evaluate_rotation(track, time);
        EXPECT_NEAR(turn.length(), 1.0, 1e-12);
        EXPECT_NEAR(2.0 * std::atan2(turn.v.z, turn.r), pi / 4.0 * time, float_rounding) << time;
    }
}

TEST(Track, RotationsTakeTheShortWay) {
    std::vector<float> values = quarter_turn();
    for (std::size_t i = 4; i < 8; ++i) {
        values[i] = -values[i];  // The same rotation.
    }
    const Track track{Interpolation::linear, 4, {0.0, 1.0}, values};
    const Quatd turn = evaluate_rotation(track, 0.5);
    EXPECT_NEAR(std::abs(2.0 * std::atan2(turn.v.z, turn.r)), pi / 4.0, float_rounding);
}

}  // namespace balcony::scene::testing::track_test
