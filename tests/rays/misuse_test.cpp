// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Compiling ends at a stop, and what rays are not compiled for is refused in all builds.

#include <array>
#include <cmath>
#include <memory>
#include <optional>
#include <stdexcept>
#include <stop_token>

#include "support.hpp"

namespace balcony::rays::misuse_test {

namespace {

constexpr const char* turning = R"(
    camera turning {
        map u = -1 .. 1, v = square
        eye sphere(1 + t)
        look normal
        time = x/10
    })";

std::stop_token stop_beforehand() {
    std::stop_source stop;
    stop.request_stop();
    return stop.get_token();
}

template <class Made>
std::optional<Kind> kind_of(const Result<Made>& made) {
    EXPECT_FALSE(made);
    EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
    return kind_of_errors(made.diagnostics);
}

}  // namespace

TEST(RayStops, EndTheMakingAndCompilingOfACamera) {
    const camera::Camera camera = test::camera_of(turning);
    const std::stop_token stop = stop_beforehand();
    EXPECT_EQ(kind_of(compile(camera, 80, 60, {}, stop)), Kind::interrupted);
    EXPECT_EQ(kind_of(compile(camera::Picture(camera), 80, 60, {}, stop)), Kind::interrupted);
    EXPECT_EQ(kind_of(compile_layers(camera, 80, 60, {.points = true}, stop)), Kind::interrupted);
    EXPECT_EQ(kind_of(ray_times(camera, {}, stop)), Kind::interrupted);
    lang::Workspace workspace;
    workspace.stop_with(stop);
    const auto text = std::make_shared<const SourceText>("test.cam", turning);
    EXPECT_EQ(kind_of(workspace.make_camera(text)), Kind::interrupted);
    workspace.stop_with({});
    EXPECT_TRUE(workspace.make_camera(text));
}

TEST(RayPreconditions, HoldInAllBuilds) {
    const camera::Camera camera = test::camera_of(turning);
    EXPECT_EQ(kind_of(compile(camera, 80, 60, {.tiles = false})), Kind::internal);
    for (const double side : {0.0, -1.0, std::nan(""), HUGE_VAL}) {
        EXPECT_EQ(kind_of(compile(camera, side, 60, {})), Kind::input) << side;
        EXPECT_EQ(kind_of(compile_layers(camera, 80, side, {.points = true})), Kind::input) << side;
    }
    Scratch scratch;
    RayBatch rays;
    const std::array at{1.0};
    const auto tiles = compile(camera, 80, 60, {});
    ASSERT_TRUE(tiles);
    EXPECT_THROW(tiles->run(Points{at, at}, scratch, rays), std::logic_error);
    const auto points = compile(camera, 80, 60, {.tiles = false, .points = true});
    ASSERT_TRUE(points);
    EXPECT_THROW(points->run(Tile{.width = 1, .height = 1}, scratch, rays), std::logic_error);
    const auto layers = compile_layers(camera, 80, 60, {.tiles = false, .points = true});
    ASSERT_TRUE(layers);
    EXPECT_THROW(layers->run_hidden(Points{at, at}, scratch, {}), std::logic_error);
}

}  // namespace balcony::rays::misuse_test
