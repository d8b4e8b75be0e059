// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The light of sets of lights, by samples, and the densities of the samples.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <gtest/gtest.h>

#include "directions.hpp"
#include "shading/lights/light_set.hpp"
#include "support.hpp"

namespace balcony::render::test::light_sampling_test {
namespace {

using std::numbers::pi;

// ------------------------------------------------------------------------------- sets of lights

constexpr LitPoint floor_point{{0.1F, 0.0F, 0.2F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};

struct Estimate {
    double mean = 0.0;
    double deviation = 0.0;  // Of one sample, relative to the mean.
};

// The irradiance at a point, by samples. Checks that each has the density that it says.
Estimate irradiance(const LightSet& lights, const LitPoint& at, int draws) {
    Random random(7);
    double first = 0.0;
    double second = 0.0;
    for (int draw = 0; draw < draws; ++draw) {
        const auto sample = lights.sample(at, random.numbers());
        if (!sample) {
            continue;
        }
        if (!sample->delta && std::isinf(sample->distance)) {
            EXPECT_NEAR(lights.pdf_of_distant(at, sample->to_light) / sample->pdf, 1.0F, 1e-3F);
        }
        const double light = double{sample->radiance.x} *
                             double{std::max(0.0F, at.normal.dot(sample->to_light))} /
                             double{sample->pdf};
        first += light / draws;
        second += light * light / draws;
    }
    return {first, std::sqrt(std::max(0.0, second - first * first)) / first};
}

// Lambert's formula for a polygon (1760), on a floor with normal y.
double irradiance_of_square(const V3d& at, const std::array<V3d, 4>& corners) {
    double total = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        const V3d a = (corners[i] - at).normalized();
        const V3d b = (corners[(i + 1) % 4] - at).normalized();
        total += std::acos(a.dot(b)) * a.cross(b).normalized().y;
    }
    return std::abs(0.5 * total);
}

scene::Material lamp(float emission) {
    scene::Material material;
    material.emission = Color3f(emission);
    return material;
}

// A square of 2 n² triangles above the floor, of side 2.
scene::Scene ceiling(int n, bool varied = false) {
    scene::Mesh mesh;
    const auto at = [n](int i) {
        return -1.0F + 2.0F * static_cast<float>(i) / static_cast<float>(n);
    };
    for (int j = 0; j <= n; ++j) {
        for (int i = 0; i <= n; ++i) {
            mesh.positions.emplace_back(at(i), 2.0F, at(j));
        }
    }
    const auto row = static_cast<std::uint32_t>(n + 1);
    for (std::uint32_t j = 0; j + 1 < row; ++j) {
        for (std::uint32_t i = 0; i + 1 < row; ++i) {
            const std::uint32_t a = j * row + i;
            mesh.triangles.push_back({a, a + 1, a + row + 1});
            mesh.triangles.push_back({a, a + row + 1, a + row});
        }
    }
    scene::Scene scene;
    scene::Material material = lamp(2.0F);
    material.alpha_mode = varied ? scene::AlphaMode::mask : scene::AlphaMode::opaque;
    add(scene, std::move(mesh), material);
    return scene;
}

double irradiance_of_ceiling(const LitPoint& at) {
    return 2.0 * irradiance_of_square(V3d(at.position), {V3d(-1.0, 2.0, -1.0), V3d(1.0, 2.0, -1.0),
                                                         V3d(1.0, 2.0, 1.0), V3d(-1.0, 2.0, 1.0)});
}

// The mean of n samples lies within four of its deviations.
void expect_near(const Estimate& found, double expected, int draws) {
    EXPECT_NEAR(found.mean, expected, 4.0 * found.deviation * found.mean / std::sqrt(draws) + 1e-5);
}

TEST(LightSampling, ACeilingGivesItsIrradiance) {
    constexpr int draws = 50'000;
    for (const int n : {1, 7}) {
        const scene::Scene scene = ceiling(n);
        for (const LitPoint& at :
             {floor_point, LitPoint{{0.3F, 1.9F, -0.2F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}},
              LitPoint{{9.0F, 0.0F, 4.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}}}) {
            expect_near(irradiance(LightSet(scene), at, draws), irradiance_of_ceiling(at), draws);
        }
    }
}

TEST(LightSampling, AThousandTrianglesErrAsLittleAsTen) {
    constexpr int draws = 50'000;
    const scene::Scene ten = ceiling(2);
    const scene::Scene thousand = ceiling(22);
    const double error_of_ten = irradiance(LightSet(ten), floor_point, draws).deviation;
    const double error_of_thousand = irradiance(LightSet(thousand), floor_point, draws).deviation;
    EXPECT_LT(error_of_thousand, 1.1 * error_of_ten);
}

// A closed mesh with outward normals is a light from outside only; a sphere of radiance L fills
// the irradiance pi L sin² of its radius seen from the point.
TEST(LightSampling, ASphereOfTrianglesGivesItsIrradiance) {
    constexpr int draws = 50'000;
    constexpr int bands = 40;
    constexpr int sectors = 80;
    scene::Mesh mesh;
    for (int i = 0; i <= bands; ++i) {
        for (int j = 0; j < sectors; ++j) {
            const double angle = pi * i / bands;
            const double turn = 2.0 * pi * j / sectors;
            mesh.positions.emplace_back(V3d(0.5 * std::sin(angle) * std::cos(turn),
                                            3.0 + 0.5 * std::cos(angle),
                                            0.5 * std::sin(angle) * std::sin(turn)));
        }
    }
    // Exactly closed at the poles.
    for (int j = 0; j < sectors; ++j) {
        mesh.positions[static_cast<std::size_t>(j)] = {0.0F, 3.5F, 0.0F};
        mesh.positions[static_cast<std::size_t>(bands * sectors + j)] = {0.0F, 2.5F, 0.0F};
    }
    for (std::uint32_t i = 0; i < bands; ++i) {
        for (std::uint32_t j = 0; j < sectors; ++j) {
            const std::uint32_t next = (j + 1) % sectors;
            const std::uint32_t a = i * sectors;
            const std::uint32_t b = a + sectors;
            mesh.triangles.push_back({a + j, b + next, b + j});
            mesh.triangles.push_back({a + j, a + next, b + next});
        }
    }
    scene::Scene scene;
    add(scene, std::move(mesh), lamp(1.0F));
    add(scene, wall(-50.0F, 50.0F), white());
    const LitPoint below{{0.0F, 0.0F, 0.0F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    const Estimate found = irradiance(LightSet(scene), below, draws);
    // The polyhedron is smaller than the sphere by less than a percent.
    EXPECT_NEAR(found.mean, pi / 36.0, 0.01 * pi / 36.0);
    // Nothing is spent on the far side.
    Random random(8);
    const LightSet lights(scene);
    for (int draw = 0; draw < 1000; ++draw) {
        const auto sample = lights.sample(below, random.numbers());
        EXPECT_TRUE(!sample || sample->distance < 3.0F);
    }
}

TEST(LightSampling, TheDensityOfAnEmitterIsThatOfItsSamples) {
    const scene::Scene scene = ceiling(5, true);
    const LightSet lights(scene);
    Random random(9);
    for (int draw = 0; draw < 2000; ++draw) {
        const auto sample = lights.sample(floor_point, random.numbers());
        ASSERT_TRUE(sample);
        ASSERT_TRUE(sample->emitter.any());
        EXPECT_EQ(sample->radiance, Color3f(1.0F)) << "the path looks up what is emitted";
        EXPECT_NEAR(lights.pdf_of_emitter(floor_point, sample->to_light, sample->distance,
                                          sample->emitter) /
                        sample->pdf,
                    1.0F, 1e-3F);
    }
}

// The densities of all triangles of a set that fills the sky around a point have the integral 1.
TEST(LightSampling, DensitiesOfEmittersIntegrateToOne) {
    const scene::Scene scene = ceiling(3);
    const LightSet lights(scene);
    const LitPoint close{{0.2F, 1.6F, 0.1F}, {0.0F, 1.0F, 0.0F}, {0.0F, 1.0F, 0.0F}};
    double total = 0.0;
    constexpr int steps = 300;
    for (std::uint32_t triangle = 0; triangle < scene.meshes[0]->triangles.size(); ++triangle) {
        const auto& corners = scene.meshes[0]->triangles[triangle];
        const V3f a = scene.meshes[0]->positions[corners[0]];
        const V3f e1 = scene.meshes[0]->positions[corners[1]] - a;
        const V3f e2 = scene.meshes[0]->positions[corners[2]] - a;
        for (int i = 0; i < steps * steps; ++i) {
            const float u = (static_cast<float>(i / steps) + 0.5F) / steps;
            const float v = (static_cast<float>(i % steps) + 0.5F) / steps;
            if (u + v >= 1.0F) {
                continue;
            }
            const V3f way = a + u * e1 + v * e2 - close.position;
            const float distance = way.length();
            const double solid_angle = double{e1.cross(e2).length() * std::abs(way.y)} /
                                       std::pow(double{distance}, 3.0) / (steps * steps);
            total += solid_angle * double{lights.pdf_of_emitter(close, way / distance, distance,
                                                                {0, triangle, u, v})};
        }
    }
    EXPECT_NEAR(total, 1.0, 0.02);
}

scene::Scene with_sun(float intensity, float angle) {
    scene::Scene scene;
    scene::Light sun;
    sun.kind = scene::LightKind::directional;
    sun.direction = V3d(0.0, -0.8, 0.6);
    sun.intensity = Color3f(intensity);
    sun.angle = angle;
    scene.lights.push_back(sun);
    return scene;
}

TEST(LightSampling, ASunOfAnySizeGivesItsIrradiance) {
    constexpr int draws = 20'000;
    // Discs above the horizon give the same on average over the disc: the cosine of the middle.
    for (const float angle : {0.0F, 9.3e-3F, 0.5F, 1.0F}) {
        const scene::Scene scene = with_sun(3.0F, angle);
        const LightSet lights(scene);
        EXPECT_EQ(lights.has_distant(), angle > 0.0F);
        EXPECT_FALSE(lights.has_environment());
        expect_near(irradiance(lights, floor_point, draws), 3.0 * 0.8, draws);
        const LightSet sharp = lights.with({}, 0.0);
        EXPECT_TRUE(sharp.sample(floor_point, V3f(0.5F))->delta);
    }
}

TEST(LightSampling, EnvironmentsGiveTheirIrradiance) {
    constexpr int draws = 200'000;
    const scene::Scene empty;
    EXPECT_NEAR(
        irradiance(LightSet(empty).with(Environment::constant(Color3f(1.0F))), floor_point, 1000)
            .mean,
        pi, 1e-4);
    const Result<Environment> sky = Environment::sky({});
    ASSERT_TRUE(sky);
    const scene::Scene sunny = with_sun(20'000.0F, 0.3F);
    for (const LightSet& lights :
         {LightSet(empty).with(Environment::dome()), LightSet(empty).with(*sky),
          LightSet(empty).with(sky->rotated(1.0).scaled(0.5F)), LightSet(sunny).with(*sky)}) {
        // The sun in the sky is too small for the quadrature, so look at the radiance around it.
        const auto reflected = [&](const V3f& d) {
            return double{std::min(lights.radiance_from(d).x, 1e6F)} * double{std::max(0.0F, d.y)};
        };
        const double rest = sum(SphereCells::integrals(reflected, 20));
        Random random(10);
        double found = 0.0;
        double squares = 0.0;
        for (int draw = 0; draw < draws; ++draw) {
            const auto sample = lights.sample(floor_point, random.numbers());
            if (sample && !sample->delta && sample->radiance.x < 1e6F) {
                const double light = reflected(sample->to_light) / double{sample->pdf};
                found += light / draws;
                squares += light * light / draws;
            }
        }
        const double error = std::sqrt(std::max(0.0, squares - found * found) / draws);
        EXPECT_NEAR(found, rest, 4.0 * error + 2e-3 * rest);
        (void)irradiance(lights, floor_point, 1000);
    }
}

TEST(LightSampling, DensitiesOfDistantLightsIntegrateToOne) {
    const Result<Environment> sky = Environment::sky({.elevation = 0.2});
    ASSERT_TRUE(sky);
    const scene::Scene sunny = with_sun(20'000.0F, 0.3F);
    const scene::Scene plain;
    for (const LightSet& lights : {LightSet(sunny).with(Environment::dome()),
                                   LightSet(sunny).with(Environment::constant(Color3f(3.0F))),
                                   LightSet(plain).with(Environment::dome().scaled(2.0F))}) {
        for (const V3f& normal : {V3f(0.0F), V3f(0.0F, 1.0F, 0.0F), V3f(0.6F, -0.8F, 0.0F)}) {
            const LitPoint at{V3f(0.0F), {0.0F, 1.0F, 0.0F}, normal};
            const auto density = [&](const V3f& d) { return double{lights.pdf_of_distant(at, d)}; };
            EXPECT_NEAR(sum(SphereCells::integrals(density, 30)), 1.0, 0.01);
        }
    }
}

// Lamps, triangles, a sun and a sky together: the sum of what each gives alone.
TEST(LightSampling, AllKindsOfLightAddUp) {
    constexpr int draws = 400'000;
    scene::Scene all = ceiling(3);
    scene::Light bulb;
    bulb.position = V3d(0.5, 1.0, 0.0);
    bulb.intensity = Color3f(0.7F);
    all.lights.push_back(bulb);
    scene::Light spot = bulb;
    spot.kind = scene::LightKind::spot;
    spot.position = V3d(-0.5, 3.0, 0.5);
    spot.direction = (V3d(floor_point.position) - spot.position).normalized();
    spot.inner_cone = spot.outer_cone = 0.3F;
    all.lights.push_back(spot);
    double expected = irradiance_of_ceiling(floor_point) + pi * 0.1 + 0.8 * 2.0;
    for (std::size_t i = 0; i < 2; ++i) {
        const Illumination one = LightSet(all).arriving(i, floor_point);
        expected += double{one.irradiance.x * one.to_light.y};
    }
    all.lights.push_back(with_sun(2.0F, 0.01F).lights.front());
    const LightSet lights = LightSet(all).with(Environment::constant(Color3f(0.1F)));
    expect_near(irradiance(lights, floor_point, draws), expected, draws);
}

TEST(LightSampling, BadEmittersGiveNoLight) {
    for (const float emission :
         {std::numeric_limits<float>::infinity(), std::numeric_limits<float>::quiet_NaN(), 0.0F}) {
        scene::Scene scene;
        add(scene, wall(1.0F, 1.0F), lamp(emission));
        EXPECT_FALSE(LightSet(scene).sample(floor_point, V3f(0.5F)));
        EXPECT_EQ(LightSet(scene).emissive_triangles(), 0U);
    }
    // Without an area.
    scene::Scene flat;
    add(flat, parallelogram({0.0F, 1.0F, 0.0F}, {1.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}),
        lamp(1.0F));
    EXPECT_FALSE(LightSet(flat).sample(floor_point, V3f(0.5F)));
    EXPECT_EQ(
        LightSet(flat).pdf_of_emitter(floor_point, {0.0F, 1.0F, 0.0F}, 1.0F, {0, 0, 0.2F, 0.2F}),
        0.0F);
    // A black environment.
    const scene::Scene nothing;
    const LightSet black = LightSet(nothing).with(Environment::constant(Color3f(0.0F)));
    EXPECT_FALSE(black.has_distant());
    EXPECT_FALSE(black.sample(floor_point, V3f(0.5F)));
}

}  // namespace
}  // namespace balcony::render::test::light_sampling_test
