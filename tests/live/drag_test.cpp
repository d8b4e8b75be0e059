// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a hand pulls is where the hand is, and what cannot follow says so.

#include <cmath>
#include <memory>
#include <numbers>

#include <gtest/gtest.h>

#include "balcony/drag.hpp"
#include "balcony/rays.hpp"

namespace balcony::live::test::drag_test {
namespace {

using Imath::V2d;
using Imath::V3d;

constexpr double degree = std::numbers::pi / 180.0;
constexpr std::array<std::size_t, 2> size{640, 360};

lang::OpenPicture opened(const lang::CameraSource& source, std::string_view name = "") {
    auto made = lang::Workspace().make_open_picture(source, name);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

lang::CameraSource text(const std::string& written) {
    return {std::make_shared<const SourceText>("test.cam", written)};
}

const std::string turning = R"(
camera turning(yaw = 0deg from -90deg to 90deg, pitch = 0deg, fov = 60deg from 20deg to 120deg) {
    let half = tan(fov/2)
    map    u = half .. -half, v = square
    eye    point(0, 0, 0)
    toward plane((1, 0, 0))
    move   rotate(y, -pitch), rotate(z, yaw)
})";

Dragger dragger(const lang::OpenPicture& picture, std::size_t layer = 0) {
    auto made = Dragger::make(picture, layer, size);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

double value_of(const Dragged& dragged, std::string_view parameter) {
    for (const Value& one : dragged.values) {
        if (one.parameter == parameter) {
            return one.value;
        }
    }
    ADD_FAILURE() << parameter << " is not among the values";
    return 0.0;
}

// Rays of the layer with values of the open parameters.
rays::Ray ray_at(const lang::OpenPicture& picture, std::size_t layer, const V2d& at,
                 const std::vector<Value>& values) {
    rays::CompileOptions options{.footprints = false, .tiles = false, .points = true};
    std::vector<double> numbers;
    std::vector<std::span<const double>> inputs;
    for (const lang::OpenParameter& one : picture.open) {
        options.inputs.push_back({lang::parameter_input(one.name)});
        numbers.push_back(one.value);
        for (const Value& value : values) {
            numbers.back() = value.parameter == one.name ? value.value : numbers.back();
        }
    }
    for (const double& number : numbers) {
        inputs.emplace_back(&number, 1);
    }
    const auto layers = rays::compile_layers(picture.picture, 640, 360, options);
    rays::Scratch scratch;
    rays::RayBatch batch;
    const std::array x{at.x};
    const std::array y{at.y};
    layers->layers()[layer].rays.run(rays::Points{x, y, 0.0, inputs}, scratch, batch);
    return batch[0];
}

}  // namespace

// A half of the picture is 320 pixels and shows tan(30deg) at distance 1.
TEST(Drag, APulledPointIsWhereTheHandIs) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    const double slope = 100.0 / 320.0 * std::tan(30 * degree);
    const Dragged dragged =
        hand.drag({{{{5, 0, 0}, false, {320, 180}, {420, 180}}}, {"yaw"}}, {}, Axes::z_up);
    ASSERT_EQ(dragged.values.size(), 1U);
    EXPECT_NEAR(value_of(dragged, "yaw"), std::atan(slope), 1e-9);
    ASSERT_EQ(dragged.points.size(), 1U);
    EXPECT_TRUE(dragged.points[0].follows);
    EXPECT_NEAR((*dragged.points[0].at - V2d(420, 180)).length(), 0.0, 1e-6);
    EXPECT_TRUE(dragged.diagnostics.empty());
}

TEST(Drag, APinHoldsWhatItPins) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    // The field of view alone keeps the middle and moves what is beside it.
    const V3d beside(5, -1, 0);
    const double at = 320.0 + 320.0 * 0.2 / std::tan(30 * degree);
    const Dragged dragged = hand.drag(
        {{{{5, 0, 0}, false, {320, 180}, {320, 180}}, {beside, false, {at, 180}, {at + 60, 180}}}},
        {}, Axes::z_up);
    EXPECT_NEAR(value_of(dragged, "yaw"), 0.0, 1e-6);
    EXPECT_NEAR(value_of(dragged, "pitch"), 0.0, 1e-6);
    EXPECT_NEAR(std::tan(value_of(dragged, "fov") / 2), 320.0 * 0.2 / (at + 60 - 320), 1e-6);
    EXPECT_TRUE(dragged.points[0].follows && dragged.points[1].follows);
}

TEST(Drag, WhatCannotFollowSaysHowFarItIs) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    // Yaw does not lift it.
    const Dragged lifted =
        hand.drag({{{{5, 0, 0}, false, {320, 180}, {320, 100}}}, {"yaw"}}, {}, Axes::z_up);
    EXPECT_FALSE(lifted.points[0].follows);
    EXPECT_NEAR(lifted.points[0].miss, 80.0, 0.1);
    // Two things at infinity cannot be farther apart with the field of view that they have.
    const Dragged apart = hand.drag({{{{1, 0.2, 0}, true, {209.1, 180}, {100, 180}},
                                      {{1, -0.2, 0}, true, {430.9, 180}, {430.9, 180}}},
                                     {"yaw", "pitch"}},
                                    {}, Axes::z_up);
    EXPECT_FALSE(apart.points[0].follows);
    EXPECT_FALSE(apart.points[1].follows);
    EXPECT_NEAR(apart.points[0].miss, 54.0, 6.0);
    // A limit ends it.
    const Dragged behind =
        hand.drag({{{{1, 0, 0}, true, {320, 180}, {320, -2000}}}, {"fov"}}, {}, Axes::z_up);
    EXPECT_FALSE(behind.points[0].follows);
}

TEST(Drag, OtherParametersKeepTheirValues) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    const std::vector<Value> before{{"fov", 90 * degree}, {"yaw", 10 * degree}};
    // The direction of yaw is in the middle.
    const V3d middle(std::cos(10 * degree), std::sin(10 * degree), 0.0);
    const Dragged dragged =
        hand.drag({{{middle, true, {320, 180}, {480, 180}}}, {"yaw"}}, before, Axes::z_up);
    EXPECT_NEAR(value_of(dragged, "yaw"), 10 * degree + std::atan(0.5), 1e-9);
    // A drag with no pull leaves all as it was.
    const Dragged none = hand.drag({}, before, Axes::z_up);
    EXPECT_EQ(value_of(none, "fov"), 90 * degree);
}

TEST(Drag, PointsAreInTheAxesOfTheScene) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    const Drag up{{{{5, 1, 0}, false, {320, 180 - 64.0 / std::tan(30 * degree)}, {320, 180}}},
                  {"pitch"}};
    EXPECT_NEAR(value_of(hand.drag(up, {}, Axes::y_up), "pitch"), std::atan(0.2), 1e-9);
}

// The same pull has the same result, however the hand came there.
TEST(Drag, DoesNotDependOnItsWay) {
    const lang::OpenPicture picture = opened("panorama");
    Dragger hand = dragger(picture);
    const rays::Ray ray = ray_at(picture, 0, {200, 150}, {});
    const V3d point = ray.origin + 4.0 * ray.direction;
    const auto pulled = [&](const V2d& to) {
        return hand.drag({{{point, false, {200, 150}, to}}}, {}, Axes::z_up);
    };
    const Dragged first = pulled({260, 140});
    EXPECT_TRUE(first.points[0].follows);
    static_cast<void>(pulled({500, 300}));
    EXPECT_EQ(pulled({260, 140}).values, first.values);
}

// A pull at several points of cameras of many kinds: the values make rays that meet the point.
TEST(Drag, FollowsThroughCamerasOfManyKinds) {
    for (const char* const name :
         {"pinhole", "panorama", "fisheye", "little_planet", "pushbroom", "panini"}) {
        SCOPED_TRACE(name);
        const lang::OpenPicture picture = opened(name);
        Dragger hand = dragger(picture);
        std::size_t followed = 0;
        for (const V2d& from : {V2d(250, 160), V2d(400, 200), V2d(330, 120)}) {
            const rays::Ray ray = ray_at(picture, 0, from, {});
            if (!ray.valid) {
                continue;
            }
            // Where the layer has a place for it.
            const V2d to = from + V2d(12, -7);
            if (!ray_at(picture, 0, to, {}).valid) {
                continue;
            }
            const V3d point = ray.origin + 3.0 * ray.direction;
            const Dragged dragged = hand.drag({{{point, false, from, to}}}, {}, Axes::z_up);
            if (!dragged.points[0].follows) {
                continue;
            }
            ++followed;
            const rays::Ray now = ray_at(picture, 0, to, dragged.values);
            ASSERT_TRUE(now.valid);
            const V3d way = point - now.origin;
            const V3d miss = way - way.dot(now.direction) * now.direction;
            EXPECT_LT(miss.length(), 0.01);
        }
        EXPECT_GT(followed, 0U);
    }
}

TEST(Drag, PullsALayerOfAPicture) {
    const lang::OpenPicture picture = opened(text(turning + R"(
picture two(look = 0deg) {
    layer panorama
    layer turning(yaw = look) { place (0.5, 0) .. (1, 0.5) }
})"));
    Dragger hand = dragger(picture, 1);
    const Dragged dragged = hand.drag({{
                                           {{5, 0, 0}, false, {480, 90}, {530, 90}},
                                       },
                                       {},
                                       1},
                                      {}, Axes::z_up);
    ASSERT_TRUE(dragged.points[0].follows);
    // The layer is half as large.
    EXPECT_NEAR(value_of(dragged, "look"), std::atan(100.0 / 320.0 * std::tan(30 * degree)), 1e-9);
    EXPECT_FALSE(Dragger::make(picture, 2, size));
}

TEST(Drag, MistakesAreSaid) {
    const lang::OpenPicture picture = opened(text(turning));
    Dragger hand = dragger(picture);
    const Drag wrong{{{{5, 0, 0}, false, {320, 180}, {420, 180}}}, {"jaw"}};
    const Dragged dragged = hand.drag(wrong, {}, Axes::z_up);
    EXPECT_EQ(dragged.diagnostics.front().message, "the parameter 'jaw' cannot follow a hand");
    EXPECT_FALSE(dragged.points[0].follows);
    EXPECT_EQ(dragged.points[0].miss, 100.0);
    const Dragged behind =
        hand.drag({{{{-5, 0, 0}, false, {320, 180}, {420, 180}}}}, {}, Axes::z_up);
    EXPECT_FALSE(behind.points[0].follows);
}

}  // namespace balcony::live::test::drag_test
