// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Ray footprints: exact derivatives, made only for scenes with textures.

#include <gtest/gtest.h>

#include <random>

#include "render/job/camera_rays.hpp"
#include "support.hpp"

namespace balcony::render {

namespace {

// A curved camera of random coefficients, in general position and without folds.
camera::Camera random_camera(std::mt19937& random) {
    std::uniform_real_distribution<double> coefficient(-0.3, 0.3);
    std::array<double, 6> c{};
    for (double& value : c) {
        value = coefficient(random);
    }
    const auto origin = [c](const camera::ParameterPoint& p, camera::Emitter&) {
        return camera::ObjectPoint{p.u + c[0] * p.v * p.v, p.v + c[1] * sin(p.u),
                                   c[2] * p.u * p.v + 1.0};
    };
    const auto direction = [c](const camera::ParameterPoint& p, camera::Emitter&) {
        return camera::ObjectVector{c[3] + p.u, c[4] * p.u * p.u + p.v, c[5] * p.v - 1.0};
    };
    return test::make_camera({origin, direction});
}

}  // namespace

TEST(Footprint, EqualsTheNeighbourDifference) {
    std::mt19937 random(7);
    constexpr double side = 32.0;
    for (int trial = 0; trial < 20; ++trial) {
        const auto program = rays::compile(random_camera(random), side, side, {.footprints = true});
        ASSERT_TRUE(program);
        // Central differences of a thousandth of a pixel err by its square.
        constexpr double step = 1e-3;
        rays::RayBatch grid;
        rays::Scratch scratch;
        program->run({10.5, 20.5, step, 3, 3, 0.0}, scratch, grid);
        const RayDifferentials exact = differentials(grid, 4, 1.0);
        const auto near = [&](const V3f& found, const V3d& after, const V3d& before) {
            const V3d difference = (after - before) / (2.0 * step);
            EXPECT_NEAR(found.x, difference.x, 1e-6);
            EXPECT_NEAR(found.y, difference.y, 1e-6);
            EXPECT_NEAR(found.z, difference.z, 1e-6);
        };
        near(exact.origin_x, grid.origin(5), grid.origin(3));
        near(exact.origin_y, grid.origin(7), grid.origin(1));
        near(exact.direction_x, grid.direction(5), grid.direction(3));
        near(exact.direction_y, grid.direction(7), grid.direction(1));
        EXPECT_GT(exact.direction_x.length(), 0.0F);
    }
}

TEST(Footprint, IsSharpWhereADerivativeIsNotFinite) {
    const auto origin = [](const camera::ParameterPoint& p, camera::Emitter& emit) {
        return camera::ObjectPoint{sqrt(abs(p.u)), p.v, emit(5.0)};
    };
    const auto direction = [](const camera::ParameterPoint&, camera::Emitter& emit) {
        return camera::ObjectVector{emit(0.0), emit(0.0), emit(-1.0)};
    };
    const auto program =
        rays::compile(test::make_camera({origin, direction}), 9.0, 9.0, {.footprints = true});
    ASSERT_TRUE(program);
    rays::RayBatch grid;
    rays::Scratch scratch;
    // u is 0 in the middle column.
    program->run({4.5, 2.5, 1.0, 1, 1, 0.0}, scratch, grid);
    const RayDifferentials d = differentials(grid, 0, 1.0);
    EXPECT_EQ(d.origin_x, V3f(0.0F));
    EXPECT_NE(d.origin_y, V3f(0.0F));
}

}  // namespace balcony::render
