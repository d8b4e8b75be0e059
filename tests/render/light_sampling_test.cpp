// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Directions chosen towards triangles, suns and environments: their densities, and the light that
// they add up to.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <numbers>
#include <random>
#include <vector>

#include <gtest/gtest.h>

#include "render/lights/environment_map.hpp"
#include "render/lights/sun.hpp"
#include "render/lights/triangle_sampling.hpp"
#include "render/shading/lights.hpp"
#include "statistics.hpp"
#include "support.hpp"

namespace balcony::render::test {
namespace {

using Imath::V2f;

constexpr double pi = std::numbers::pi;

class Random {
public:
    explicit Random(unsigned seed) : generator_(seed) {}
    float number() { return static_cast<float>(generator_() >> 8U) * 0x1p-24F; }
    V3f numbers() { return {number(), number(), number()}; }
    V2f pair() { return {number(), number()}; }

private:
    std::mt19937 generator_;
};

// Cells of the sphere of equal solid angle.
constexpr std::size_t rows = 24;
constexpr std::size_t columns = 48;

std::size_t cell_of(const V3f& direction) {
    const double z = 0.5 * (1.0 - double{direction.z});
    const double turn = std::atan2(double{direction.y}, double{direction.x}) / (2.0 * pi) + 0.5;
    const auto row = std::min(static_cast<std::size_t>(z * rows), rows - 1);
    const auto column = std::min(static_cast<std::size_t>(turn * columns), columns - 1);
    return row * columns + column;
}

// The integral of a density over each cell.
std::vector<double> integrals(const std::function<double(const V3f&)>& density, int steps) {
    std::vector<double> found(rows * columns);
    const double weight = 4.0 * pi / (rows * columns) / (steps * steps);
    for (std::size_t cell = 0; cell < found.size(); ++cell) {
        for (int i = 0; i < steps * steps; ++i) {
            const double z =
                1.0 -
                2.0 * (static_cast<double>(cell / columns) + (i / steps + 0.5) / steps) / rows;
            const double turn =
                2.0 * pi *
                ((static_cast<double>(cell % columns) + (i % steps + 0.5) / steps) / columns - 0.5);
            const double across = std::sqrt(1.0 - z * z);
            found[cell] +=
                weight *
                density(V3f(Imath::V3d(across * std::cos(turn), across * std::sin(turn), z)));
        }
    }
    return found;
}

double sum(const std::vector<double>& values) {
    double total = 0.0;
    for (const double value : values) {
        total += value;
    }
    return total;
}

// -------------------------------------------------------------------------------- triangles

constexpr WorldTriangle slanted{{0.3F, -0.4F, 1.0F}, {1.1F, 0.2F, 0.3F}, {-0.2F, 0.9F, -0.1F}};

TEST(TriangleSampling, PassesChiSquare) {
    constexpr int draws = 200'000;
    // From close by, where sampling is by solid angle, and from afar, where it is by area.
    for (const V3f& from :
         {V3f(0.2F, 0.1F, 0.2F), V3f(0.0F, 0.0F, -8.0F), V3f(0.5F, 0.3F, 1.05F)}) {
        // In cells of the triangle itself, as from afar it lies within one cell of the sphere.
        constexpr std::size_t cells = 20;
        std::vector<double> counts(cells * cells);
        std::vector<double> expected(cells * cells);
        const auto cell = [](float u, float v) {
            const auto part = [](float x) {
                return std::min(static_cast<std::size_t>(x * cells), cells - 1);
            };
            return part(u) * cells + part(v);
        };
        Random random(1);
        for (int draw = 0; draw < draws; ++draw) {
            const auto sample = sample_triangle(slanted, from, random.pair());
            ASSERT_TRUE(sample);
            counts[cell(sample->u, sample->v)] += 1.0;
            const float again = pdf_of_triangle(slanted, from, sample->direction, sample->distance);
            ASSERT_NEAR(again / sample->pdf, 1.0F, 1e-4F);
        }
        constexpr int steps = 1200;
        const double area = 2.0 * double{slanted.area()} / (steps * steps);
        for (int i = 0; i < steps * steps; ++i) {
            const float u = (static_cast<float>(i / steps) + 0.5F) / steps;
            const float v = (static_cast<float>(i % steps) + 0.5F) / steps;
            if (u + v >= 1.0F) {
                continue;
            }
            const V3f way = slanted.corner + u * slanted.edge_1 + v * slanted.edge_2 - from;
            const float distance = way.length();
            const V3f direction = way / distance;
            const double solid_angle =
                area * double{std::abs(slanted.across().normalized().dot(direction))} /
                double{distance * distance};
            expected[cell(u, v)] +=
                draws * solid_angle * double{pdf_of_triangle(slanted, from, direction, distance)};
        }
        EXPECT_NEAR(sum(expected) / draws, 1.0, 2e-3);
        const double scale = draws / sum(expected);
        for (double& value : expected) {
            value *= scale;
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << from;
    }
}

TEST(TriangleSampling, HitsTheTriangleItself) {
    Random random(2);
    for (int trial = 0; trial < 20'000; ++trial) {
        const auto corner = [&] { return 2.0F * random.numbers() - V3f(1.0F); };
        const V3f a = corner();
        const WorldTriangle triangle{a, corner() - a, corner() - a};
        const V3f from = 2.0F * corner();
        const auto sample = sample_triangle(triangle, from, random.pair());
        if (!sample || triangle.area() < 0.01F) {
            continue;
        }
        const V3f point =
            triangle.corner + sample->u * triangle.edge_1 + sample->v * triangle.edge_2;
        const V3f way = point - from;
        // A triangle that is seen edge-on amplifies rounding.
        const float slant = std::abs(triangle.across().normalized().dot(sample->direction));
        EXPECT_NEAR(way.length(), sample->distance, 1e-5F / slant) << trial;
        EXPECT_NEAR(way.normalized().dot(sample->direction), 1.0F, 1e-5F / slant) << trial;
    }
}

TEST(TriangleSampling, IsSafeForDegenerateTriangles) {
    const WorldTriangle point{{0.0F, 0.0F, 1.0F}, V3f(0.0F), V3f(0.0F)};
    const WorldTriangle line{{0.0F, 0.0F, 1.0F}, {1.0F, 0.0F, 0.0F}, {2.0F, 0.0F, 0.0F}};
    const WorldTriangle tiny{{0.0F, 0.0F, 1.0F}, {1e-20F, 0.0F, 0.0F}, {0.0F, 1e-20F, 0.0F}};
    const WorldTriangle huge{{-1e18F, -1e18F, 1.0F}, {3e18F, 0.0F, 0.0F}, {0.0F, 3e18F, 0.0F}};
    Random random(3);
    for (const WorldTriangle& triangle : {point, line, tiny, huge, slanted}) {
        for (const V3f& from : {V3f(0.0F), V3f(0.0F, 0.0F, 1.0F), V3f(0.5F, 0.5F, 1.0F),
                                V3f(0.0F, 0.0F, 1.0F - 1e-7F), slanted.corner}) {
            for (int draw = 0; draw < 200; ++draw) {
                const auto sample = sample_triangle(triangle, from, random.pair());
                if (sample) {
                    EXPECT_TRUE(std::isfinite(sample->pdf) && sample->pdf > 0.0F);
                    EXPECT_NEAR(sample->direction.length(), 1.0F, 1e-5F);
                    EXPECT_TRUE(std::isfinite(sample->distance));
                }
            }
        }
    }
}

// ------------------------------------------------------------------------------ environments

// A dark picture with a bright pixel, a gradient and a black part.
EnvironmentMap spotted(std::size_t width, std::size_t height) {
    std::vector<Color3f> texels;
    for (std::size_t y = 0; y < height; ++y) {
        for (std::size_t x = 0; x < width; ++x) {
            const float value = x < width / 4 ? 0.0F
                                : x == width / 2 && y == height / 3
                                    ? 50.0F
                                    : 0.1F + static_cast<float>(y) / static_cast<float>(height);
            texels.emplace_back(value, 0.5F * value, 0.25F);
            texels.back().z = value;
        }
    }
    return {width, height, std::move(texels)};
}

TEST(EnvironmentMap, PassesChiSquare) {
    constexpr int draws = 400'000;
    for (const auto& [width, height] : {std::pair{16UL, 8UL}, {1UL, 1UL}, {3UL, 5UL}}) {
        const EnvironmentMap map = spotted(width, height);
        std::vector<double> expected =
            integrals([&](const V3f& d) { return double{map.pdf(d)}; }, 24);
        EXPECT_NEAR(sum(expected), 1.0, 5e-3);
        const double scale = draws / sum(expected);
        std::vector<double> counts(expected.size());
        Random random(4);
        for (int draw = 0; draw < draws; ++draw) {
            const EnvironmentMap::Sample sample = map.sample(random.pair());
            counts[cell_of(sample.direction)] += 1.0;
            // A direction may be rounded across the border of a cell.
            if (draw < 10'000) {
                EXPECT_NEAR(map.pdf(sample.direction.normalized()) / sample.pdf, 1.0F, 1e-4F)
                    << sample.direction;
            }
        }
        for (double& value : expected) {
            value *= scale;
        }
        EXPECT_GT(chi_square_probability(counts, expected), significance) << width;
    }
}

TEST(EnvironmentMap, IsNeverUnlikelyWhereThereIsLight) {
    for (const auto& [width, height] : {std::pair{16UL, 8UL}, {2100UL, 1030UL}}) {
        const EnvironmentMap map = spotted(width, height);
        Random random(5);
        for (int trial = 0; trial < 20'000; ++trial) {
            const float z = 2.0F * random.number() - 1.0F;
            const float turn = 6.2831853F * random.number();
            const float across = std::sqrt(1.0F - z * z);
            const V3f direction(across * std::cos(turn), across * std::sin(turn), z);
            if (map.radiance(direction).x > 0.0F) {
                EXPECT_GT(map.pdf(direction), 0.0F);
            }
        }
    }
}

TEST(EnvironmentMap, ShowsThePictureUprightAndNotMirrored) {
    // Four columns: back and left, left and front, front and right, right and back, seen from
    // inside along x; two rows.
    std::vector<Color3f> texels;
    for (int i = 0; i < 8; ++i) {
        texels.emplace_back(static_cast<float>(i));
    }
    const EnvironmentMap map(4, 2, std::move(texels));
    const auto at = [&](float x, float y, float z) {
        return map.radiance(V3f(x, y, z).normalized()).x;
    };
    const float high = std::sqrt(2.0F);  // 45 degrees up.
    EXPECT_NEAR(at(1.0F, 1.0F, high), 1.0F, 1e-4F);
    EXPECT_NEAR(at(1.0F, -1.0F, high), 2.0F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, 1.0F, -high), 4.0F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, -1.0F, -high), 7.0F, 1e-4F);
    EXPECT_NEAR(at(1.0F, 0.0F, 1.0F), 1.5F, 1e-4F);
    EXPECT_NEAR(at(-1.0F, 0.0F, 1.0F), 1.5F, 1e-4F);  // Column 0 follows column 3.
    EXPECT_NEAR(map.mean().x, 3.5F, 1e-4F);
}

// -------------------------------------------------------------------------------------- suns

TEST(Sun, PassesChiSquare) {
    constexpr int draws = 100'000;
    for (const double angle : {9.3e-3, 0.5, pi}) {
        const Sun sun(V3f(0.48F, 0.6F, 0.64F), Color3f(1.0F), angle);
        // Rings and sectors of equal solid angle.
        std::vector<double> counts(64);
        const std::vector<double> expected(64, draws / 64.0);
        const V3f side = sun.to_light().cross(V3f(0.0F, 0.0F, 1.0F)).normalized();
        const V3f up = sun.to_light().cross(side);
        Random random(6);
        int outside = 0;
        for (int draw = 0; draw < draws; ++draw) {
            const V3f direction = sun.sample(random.pair());
            outside += sun.covers(direction) ? 0 : 1;
            const double ring = double{(direction - sun.to_light()).length2()} /
                                (4.0 * std::sin(0.25 * angle) * std::sin(0.25 * angle));
            const double turn =
                std::atan2(double{direction.dot(up)}, double{direction.dot(side)}) / (2.0 * pi) +
                0.5;
            const auto part = [](double x) {
                return std::min(static_cast<std::size_t>(x * 8.0), std::size_t{7});
            };
            counts[part(ring) * 8 + part(turn)] += 1.0;
        }
        // Only rounding leads outside.
        EXPECT_LT(outside, draws / 1000);
        EXPECT_GT(chi_square_probability(counts, expected), significance) << angle;
        const double solid_angle = 4.0 * pi * std::sin(0.25 * angle) * std::sin(0.25 * angle);
        EXPECT_NEAR(double{sun.pdf()} * solid_angle, 1.0, 1e-5);
    }
}

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
        if (!sample->delta) {
            const float again = std::isinf(sample->distance)
                                    ? lights.pdf_of_distant(at, sample->to_light)
                                    : lights.pdf_of_emitter(at, sample->to_light, sample->distance,
                                                            sample->emitter);
            if (std::isinf(sample->distance) || sample->emitter.any()) {
                EXPECT_NEAR(again / sample->pdf, 1.0F, 1e-3F);
            }
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
    for (std::uint32_t triangle = 0; triangle < scene.meshes[0].triangles.size(); ++triangle) {
        const auto& corners = scene.meshes[0].triangles[triangle];
        const V3f a = scene.meshes[0].positions[corners[0]];
        const V3f e1 = scene.meshes[0].positions[corners[1]] - a;
        const V3f e2 = scene.meshes[0].positions[corners[2]] - a;
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
        const double rest = sum(integrals(reflected, 20));
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
            EXPECT_NEAR(sum(integrals(density, 30)), 1.0, 0.01);
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
}  // namespace balcony::render::test
