// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Ray footprints: exact derivatives, made only for scenes with textures.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "render/job/camera_rays.hpp"
#include "shading/materials/footprint.hpp"
#include "support.hpp"

namespace balcony::render::footprint_test {

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

V3d reflected(const V3d& d, const V3d& n) { return d - 2.0 * d.dot(n) * n; }

V3d refracted(const V3d& d, const V3d& n, double eta) {
    const double cosine = d.dot(n);
    const double other = std::sqrt(1.0 - eta * eta * (1.0 - cosine * cosine));
    return eta * d - (eta * cosine - std::copysign(other, cosine)) * n;
}

// A ray to a sphere around 0, as a function of picture x and y; and what leaves the sphere at its
// near side, by a law of the direction and the normal.
struct Bounce {
    struct Beam {
        V3d origin, direction;
    };

    explicit Bounce(std::mt19937& random) : radius(2.5 + 0.5 * unit(random)) {
        for (V3d* v : {&origin, &origin_x, &origin_y}) {
            *v = {0.3 * unit(random), 0.3 * unit(random), 0.3 * unit(random)};
        }
        origin.z += 6.0;
        aim = V3d(0.15 * unit(random), 0.15 * unit(random), -1.0);
        aim_x = {0.5 * unit(random), 0.2, 0.0};
        aim_y = {0.2, 0.5 * unit(random), 0.0};
    }

    [[nodiscard]] Beam arriving(double x, double y) const {
        return {origin + x * origin_x + y * origin_y, (aim + x * aim_x + y * aim_y).normalized()};
    }
    [[nodiscard]] V3d hit(double x, double y) const {
        const Beam ray = arriving(x, y);
        const double b = ray.origin.dot(ray.direction);
        return ray.origin +
               (-b - std::sqrt(b * b - ray.origin.length2() + radius * radius)) * ray.direction;
    }

    // What the functions under test are given, by central differences.
    static constexpr double step = 1e-4;
    template <class Function>
    [[nodiscard]] static V3f by_x(const Function& f) {
        return V3f((f(step, 0.0) - f(-step, 0.0)) / (2.0 * step));
    }
    template <class Function>
    [[nodiscard]] static V3f by_y(const Function& f) {
        return V3f((f(0.0, step) - f(0.0, -step)) / (2.0 * step));
    }
    [[nodiscard]] DifferentialRay ray() const {
        const auto origins = [this](double x, double y) { return arriving(x, y).origin; };
        const auto directions = [this](double x, double y) { return arriving(x, y).direction; };
        return {V3f(origin),
                V3f(arriving(0.0, 0.0).direction),
                {by_x(origins), by_y(origins), by_x(directions), by_y(directions)}};
    }
    [[nodiscard]] PositionDifferentials moved() const {
        const auto hits = [this](double x, double y) { return hit(x, y); };
        return {by_x(hits), by_y(hits)};
    }
    [[nodiscard]] NormalDifferentials turned() const {
        return {moved().along_x / static_cast<float>(radius),
                moved().along_y / static_cast<float>(radius)};
    }

    [[nodiscard]] static double unit(std::mt19937& random) {
        return std::uniform_real_distribution<double>(-1.0, 1.0)(random);
    }

    double radius;
    V3d origin, origin_x, origin_y, aim, aim_x, aim_y;
};

// Differences of float results, of numbers up to about 10, against those of doubles.
constexpr float bounce_rounding = 1e-4F;

void expect_near(const V3f& found, const V3f& expected) {
    for (unsigned axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(found[axis], expected[axis],
                    bounce_rounding * std::max(1.0F, expected.length()));
    }
}

}  // namespace

TEST(Footprint, AfterAMirrorAndARefractionEqualsTheNeighbourDifference) {
    std::mt19937 random(11);
    for (int trial = 0; trial < 50; ++trial) {
        const Bounce bounce(random);
        const auto normal = [&](double x, double y) { return bounce.hit(x, y).normalized(); };
        const double eta = 0.6 + 0.4 * (0.5 + 0.5 * Bounce::unit(random));
        const auto mirror = [&](double x, double y) {
            return reflected(bounce.arriving(x, y).direction, normal(x, y));
        };
        const auto glass = [&](double x, double y) {
            return refracted(bounce.arriving(x, y).direction, normal(x, y), eta);
        };
        // The normal of the surface, or its opposite.
        const float side = trial % 2 == 0 ? 1.0F : -1.0F;
        NormalDifferentials turned = bounce.turned();
        turned.along_x *= side;
        turned.along_y *= side;
        const RayDifferentials in_mirror =
            after_mirror(bounce.ray(), bounce.moved(), side * V3f(normal(0.0, 0.0)), turned);
        expect_near(in_mirror.origin_x, bounce.moved().along_x);
        expect_near(in_mirror.direction_x, Bounce::by_x(mirror));
        expect_near(in_mirror.direction_y, Bounce::by_y(mirror));
        const RayDifferentials in_glass =
            after_refraction(bounce.ray(), bounce.moved(), side * V3f(normal(0.0, 0.0)),
                             static_cast<float>(eta), turned);
        expect_near(in_glass.origin_y, bounce.moved().along_y);
        expect_near(in_glass.direction_x, Bounce::by_x(glass));
        expect_near(in_glass.direction_y, Bounce::by_y(glass));
    }
}

TEST(Footprint, AtTotalReflectionIsThatOfTheMirror) {
    DifferentialRay ray{{0.0F, 0.0F, 1.0F}, V3f(1.0F, 0.0F, -0.2F).normalized()};
    ray.differentials.direction_x = {0.0F, 0.3F, 0.0F};
    const V3f up(0.0F, 0.0F, 1.0F);
    EXPECT_EQ(after_refraction(ray, {}, up, 1.5F).direction_x,
              after_mirror(ray, {}, up).direction_x);
}

TEST(Footprint, AfterARoughBounceHasTheSolidAngleOfTheLobe) {
    DifferentialRay ray{{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, -1.0F}};
    const auto solid_angle = [](const RayDifferentials& d) {
        return d.direction_x.cross(d.direction_y).length();
    };
    for (const V3f& direction :
         {V3f(0.0F, 0.0F, 1.0F), V3f(1.0F, 0.0F, 0.0F), V3f(-0.6F, 0.0F, 0.8F)}) {
        ray.differentials = {};
        const RayDifferentials rough = after_rough(ray, {}, direction, 50.0F, 0.5F);
        EXPECT_NEAR(solid_angle(rough), 0.25F / 50.0F, 1e-7F);
        EXPECT_NEAR(rough.direction_x.dot(direction), 0.0F, 1e-7F);
        EXPECT_NEAR(rough.direction_y.dot(direction), 0.0F, 1e-7F);
        // A narrow lobe keeps the arriving beam; a wide one ends at a radian.
        ray.differentials.direction_x = {0.1F, 0.0F, 0.0F};
        ray.differentials.direction_y = {0.0F, 0.2F, 0.0F};
        EXPECT_NEAR(solid_angle(after_rough(ray, {}, direction, HUGE_VALF)), 0.02F, 1e-7F);
        EXPECT_NEAR(solid_angle(after_rough(ray, {}, direction, 1e-9F)), 1.0F, 1e-6F);
        EXPECT_NEAR(solid_angle(after_rough(ray, {}, direction, 0.0F)), 1.0F, 1e-6F);
    }
}

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
        const RayDifferentials exact = differentials(grid, 4, 0, 1.0);
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
    const RayDifferentials d = differentials(grid, 0, 0, 1.0);
    EXPECT_EQ(d.origin_x, V3f(0.0F));
    EXPECT_NE(d.origin_y, V3f(0.0F));
}

}  // namespace balcony::render::footprint_test
