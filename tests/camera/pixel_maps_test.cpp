// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Maps of rays and positions: quadratic functions are reproduced exactly, with their derivatives,
// up to the borders of the map and of its holes.

#include <functional>

#include "transform_probe.hpp"

namespace balcony::camera::pixel_maps_test {

namespace {

constexpr std::size_t width = 9;
constexpr std::size_t height = 6;

using Function = std::function<double(double u, double v)>;

double centre(std::size_t i, std::size_t count) {
    return (static_cast<double>(i) + 0.5) / static_cast<double>(count);
}

std::shared_ptr<const PixelMap> sampled(const std::vector<Function>& functions) {
    PixelMap map{width, height, {}, std::vector<std::uint8_t>(width * height, 1)};
    for (const Function& function : functions) {
        std::vector<double>& channel = map.channels.emplace_back();
        for (std::size_t i = 0; i < width * height; ++i) {
            channel.push_back(function(centre(i % width, width), 1.0 - centre(i / width, height)));
        }
    }
    return std::make_shared<const PixelMap>(std::move(map));
}

std::shared_ptr<const PixelMap> without(const PixelMap& map, std::size_t column, std::size_t row) {
    PixelMap made = map;
    made.valid[row * width + column] = 0;
    for (std::vector<double>& channel : made.channels) {
        channel[row * width + column] = 1e9;
    }
    return std::make_shared<const PixelMap>(std::move(made));
}

// Origins and directions of second degree in u and v.
const std::vector<Function> quadratic{
    [](double u, double v) { return 1.0 + u * u - 3.0 * u * v; },
    [](double u, double v) { return v * v - 2.0 * u; },
    [](double u, double v) { return 0.3 * u - 0.7 * v + 4.0 * v * v; },
    [](double u, double) { return u * u; },
    [](double, double v) { return v + 2.0; },
    [](double u, double v) { return u * v; },
};

double by_u(const Function& f, double u, double v) {
    return (f(u + 0.5, v) - f(u - 0.5, v));  // Exact for second degree.
}

double by_v(const Function& f, double u, double v) { return f(u, v + 0.5) - f(u, v - 0.5); }

void expect_quadratic(const GeneratorProbe& probe, double u, double v) {
    const Sample at = probe(u, v);
    ASSERT_TRUE(at.valid) << u << ", " << v;
    for (std::size_t k = 0; k < 3; ++k) {
        EXPECT_NEAR(at.point[k], quadratic[k](u, v), 1e-13) << u << ", " << v;
        EXPECT_NEAR(at.along_u[k], by_u(quadratic[k], u, v), 1e-12) << u << ", " << v;
        EXPECT_NEAR(at.along_v[k], by_v(quadratic[k], u, v), 1e-12) << u << ", " << v;
    }
}

TEST(RayMap, ReproducesQuadraticRaysUpToTheBorder) {
    const GeneratorProbe probe(object("ray_map", {{"file", sampled(quadratic)}}));
    for (const double u : {0.0, 0.03, 0.4, 0.77, 1.0}) {
        for (const double v : {0.0, 0.08, 0.5, 0.99, 1.0}) {
            expect_quadratic(probe, u, v);
        }
    }
}

TEST(RayMap, IsValidInTheSquaresOfItsPixels) {
    const auto map = without(*without(*sampled(quadratic), 4, 2), 0, 0);
    const GeneratorProbe probe(object("ray_map", {{"file", map}}));
    const double left = 4.0 / double{width};
    const double right = 5.0 / double{width};
    const double middle = 1.0 - centre(2, height);
    EXPECT_FALSE(probe(left + 1e-6, middle).valid);
    EXPECT_FALSE(probe(right - 1e-6, middle).valid);
    EXPECT_FALSE(probe(0.01, 0.99).valid);
    EXPECT_FALSE(probe(-0.01, 0.5).valid);
    EXPECT_FALSE(probe(0.5, 1.01).valid);
    // Next to the hole, and in the corner of the map that is left.
    expect_quadratic(probe, left - 1e-6, middle);
    expect_quadratic(probe, right + 1e-6, middle);
    expect_quadratic(probe, left - 0.4 / double{width}, middle + 0.4 / double{height});
    expect_quadratic(probe, 1.0 / double{width} + 1e-6, 1.0);
}

TEST(RayMap, TargetsAreAUnitAlongTheRays) {
    const auto map = sampled(quadratic);
    const GeneratorProbe targets(
        object("ray_map", {{"file", map}, {"points", std::string("targets")}}));
    const GeneratorProbe directions(
        object("ray_map", {{"file", map}, {"points", std::string("directions")}}));
    const GeneratorProbe origins(object("ray_map", {{"file", map}}));
    expect_near(targets(0.3, 0.6).point - origins(0.3, 0.6).point, directions(0.3, 0.6).point,
                1e-13);
    EXPECT_NEAR(directions(0.3, 0.6).point[1], 2.6, 1e-13);
}

TEST(RayMap, HasContinuousDerivatives) {
    const auto wave = [](double u, double v) { return std::sin(7.0 * u + 3.0 * v); };
    const GeneratorProbe probe(
        object("ray_map", {{"file", sampled(std::vector<Function>(6, wave))}}));
    const double seam = centre(3, width);
    const Sample before = probe(seam - 1e-9, 0.4);
    const Sample after = probe(seam + 1e-9, 0.4);
    EXPECT_NEAR(before.along_u[0], after.along_u[0], 1e-5);
    EXPECT_NEAR(before.point[0], after.point[0], 1e-7);
}

TEST(RayMap, OfOnePixelIsConstant) {
    const auto map = std::make_shared<const PixelMap>(
        PixelMap{1, 1, {{1.0}, {2.0}, {3.0}, {0.0}, {0.0}, {1.0}}, {1}});
    expect_near(GeneratorProbe(object("ray_map", {{"file", map}}))(0.9, 0.1).point, {1, 2, 3},
                1e-15);
}

TEST(StMap, TakesPositionsInItsBox) {
    const auto half = sampled(
        {[](double s, double) { return 0.5 * s; }, [](double, double t) { return 1.0 - t * t; }});
    const WarpProbe probe(warp(
        "stmap", {{"file", half}, {"from", numbers({2.0, -1.0})}, {"to", numbers({-2.0, 1.0})}}));
    // u = 1 is s = 1/4, v = 0 is t = 1/2.
    const WarpSample at = probe(1.0, 0.0);
    ASSERT_TRUE(at.valid);
    EXPECT_NEAR(at.point[0], 2.0 - 4.0 * 0.125, 1e-13);
    EXPECT_NEAR(at.point[1], -1.0 + 2.0 * 0.75, 1e-13);
    EXPECT_NEAR(at.by_u[0], 0.5, 1e-12);
    EXPECT_NEAR(at.by_v[1], -2.0 * 0.5, 1e-12);
    EXPECT_FALSE(probe(2.1, 0.0).valid);
}

TEST(StMap, NeedsABox) {
    const auto made =
        try_stage(StageKind::parameter_transformer, "stmap",
                  {{"file", sampled({quadratic[0], quadratic[1]})}, {"to", numbers({1.0, 0.0})}});
    ASSERT_FALSE(made);
    EXPECT_EQ(made.diagnostics.front().message, "the box of this STMap has no extent");
}

}  // namespace

}  // namespace balcony::camera::pixel_maps_test
