// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

namespace balcony::solve::derivatives_test {
namespace {

using test::degree;
using test::height;
using test::width;

const std::vector<std::string> parameters{"yaw", "fov", "px"};
const std::vector<double> values{20.0 * degree, 70.0 * degree, 0.5};

Solver solver_of(const lang::OpenCamera& camera) {
    std::vector<std::string> inputs;
    for (const lang::OpenParameter& parameter : camera.open) {
        inputs.push_back(lang::parameter_input(parameter.name));
    }
    auto made = Solver::make(camera::Picture(camera.camera), 0, width, height, inputs);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

TEST(Derivatives, OfRaysAreTheDifferencesOfRays) {
    const lang::OpenCamera camera = test::aimed_camera(parameters);
    ASSERT_EQ(camera.open[1].name, "fov");
    std::vector<V2d> points;
    for (int i = 0; i < 2000; ++i) {  // More than one part.
        points.emplace_back((i % 50 + 0.5) * width / 50, (i / 50 + 0.5) * height / 40);
    }
    const Derivatives found = solver_of(camera).ray_derivatives(points, values);
    ASSERT_EQ(found.values.size(), points.size() * 6 * 3);
    // The rounding of a difference is 1e-16 / step, its error of third order step^2: both 1e-10.
    constexpr double step = 1e-5;
    for (std::size_t j = 0; j < values.size(); ++j) {
        std::vector<double> less = values;
        std::vector<double> more = values;
        less[j] -= step;
        more[j] += step;
        const auto before = test::rays_of(camera, less, points);
        const auto after = test::rays_of(camera, more, points);
        for (std::size_t i = 0; i < points.size(); ++i) {
            ASSERT_EQ(found.valid[i], 1);
            const auto by = [&](int number) {
                return found.values[(i * 6 + static_cast<std::size_t>(number)) * 3 + j];
            };
            const V3d origin = (after[i].origin - before[i].origin) / (2.0 * step);
            const V3d direction = (after[i].direction - before[i].direction) / (2.0 * step);
            for (int axis = 0; axis < 3; ++axis) {
                ASSERT_NEAR(by(axis), origin[axis], 1e-9);
                ASSERT_NEAR(by(3 + axis), direction[axis], 1e-9);
            }
        }
    }
}

// With u = y / (x - px) after the turn, a point is at width / 2 * (1 - u / half) pixels.
TEST(Derivatives, OfPositionsAreThoseOfTheFormula) {
    const lang::OpenCamera camera = test::aimed_camera(parameters);
    const auto [yaw, fov, px] = std::array{values[0], values[1], values[2]};
    const double half = std::tan(fov / 2.0);
    std::vector<V3d> points;
    std::vector<V2d> seen;
    std::vector<std::array<double, 3>> wanted;
    for (const double angle : {-10.0, 5.0, 40.0}) {
        const double x = 4.0 * std::cos(angle * degree);
        const double y = 4.0 * std::sin(angle * degree);
        points.emplace_back(px + x, y, 0.0);
        const double u = std::tan(angle * degree - yaw);
        const double scale = width / 2.0 / half;
        seen.emplace_back(width / 2.0 - scale * u, height / 2.0);
        const double by_angle = 1.0 + u * u;
        wanted.push_back({scale * by_angle, scale * u * (1.0 + half * half) / (2.0 * half),
                          -scale * by_angle * y / (x * x + y * y)});
    }
    const Derivatives found = solver_of(camera).position_derivatives(points, seen, values);
    ASSERT_EQ(found.values.size(), points.size() * 2 * 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        EXPECT_EQ(found.valid[i], 1);
        for (std::size_t j = 0; j < 3; ++j) {
            EXPECT_NEAR(found.values[i * 6 + j], wanted[i][j], 1e-9) << i << ' ' << j;
            EXPECT_NEAR(found.values[i * 6 + 3 + j], 0.0, 1e-9);  // All are on the horizon.
        }
    }
}

TEST(Derivatives, AreZeroWithoutARay) {
    const lang::OpenCamera camera = test::open(std::make_shared<const SourceText>("half.cam", R"(
            camera half(turn = 0deg) {
                map u = 1 .. -1, v = square
                eye point(0, 0, 0)
                toward surface(u, v) = [1, u, sqrt(u)]
                move rotate(z, turn)
            })"),
                                               "", {"turn"});
    const std::vector<V2d> points{{160.0, 180.0}, {480.0, 180.0}};
    const Derivatives found = solver_of(camera).ray_derivatives(points, std::vector{0.1});
    EXPECT_EQ(found.valid, (std::vector<std::uint8_t>{1, 0}));
    EXPECT_NE(found.values[4], 0.0);
    EXPECT_EQ(std::vector(found.values.begin() + 6, found.values.end()),
              std::vector<double>(6, 0.0));
}

}  // namespace
}  // namespace balcony::solve::derivatives_test
