// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// General linear cameras against the classification of Yu and McMillan (ECCV 2004): the roots of
// the characteristic equation, and what rays of each kind meet.

#include <algorithm>
#include <cmath>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "support.hpp"

namespace balcony::camera::general_linear_test {

namespace {

using Point = std::array<double, 2>;

/// Three rays by their points in the planes x = 0 and x = 2.
struct Rays {
    std::array<Point, 3> near;
    std::array<Point, 3> far;
};

constexpr double distance = 2.0;

Camera camera_of(const Rays& rays) {
    const auto pair = [](const Point& p) { return numbers({p[0], p[1]}); };
    Camera::Parts parts;
    parts.name = "test";
    parts.eye.mapper = range(-1.0, 2.0, -1.5, 1.0);
    parts.eye.generator = object("general_linear", {{"a", pair(rays.near[0])},
                                                    {"b", pair(rays.near[1])},
                                                    {"c", pair(rays.near[2])},
                                                    {"to_a", pair(rays.far[0])},
                                                    {"to_b", pair(rays.far[1])},
                                                    {"to_c", pair(rays.far[2])},
                                                    {"distance", numbers({distance})}});
    parts.look = look("normal");
    return camera(std::move(parts));
}

std::vector<Ray> rays_of(const Rays& rays) {
    const CameraProbe probe(camera_of(rays), 300.0, 250.0);
    std::mt19937_64 random(11);
    std::uniform_real_distribution<double> x(0.0, 300.0);
    std::uniform_real_distribution<double> y(0.0, 250.0);
    std::vector<Ray> found;
    for (int i = 0; i < 40; ++i) {
        found.push_back(probe(x(random), y(random)));
        EXPECT_TRUE(found.back().valid);
    }
    return found;
}

// The characteristic equation: twice the area of the triangle of the three rays at a depth, as
// coefficients of 1, x and x^2. By interpolation of the determinant at three depths.
std::array<double, 3> characteristic(const Rays& rays) {
    const auto area = [&](double x) {
        std::array<Point, 3> p{};
        for (std::size_t i = 0; i < 3; ++i) {
            for (std::size_t k = 0; k < 2; ++k) {
                p[i][k] = rays.near[i][k] + x / distance * (rays.far[i][k] - rays.near[i][k]);
            }
        }
        return (p[1][0] - p[0][0]) * (p[2][1] - p[0][1]) -
               (p[1][1] - p[0][1]) * (p[2][0] - p[0][0]);
    };
    const double at_0 = area(0.0);
    const double sum = 0.5 * (area(1.0) + area(-1.0)) - at_0;
    return {at_0, 0.5 * (area(1.0) - area(-1.0)), sum};
}

// The depths where all rays meet a line.
std::vector<double> slits(const Rays& rays) {
    const auto [c, b, a] = characteristic(rays);
    constexpr double rounding = 1e-12;
    if (std::abs(a) < rounding) {
        return std::abs(b) < rounding ? std::vector<double>() : std::vector{-c / b};
    }
    const double discriminant = b * b - 4.0 * a * c;
    if (std::abs(discriminant) < rounding) {
        return {-b / (2.0 * a)};
    }
    if (discriminant < 0.0) {
        return {};
    }
    const double middle = -b / (2.0 * a);
    const double half = std::sqrt(discriminant) / (2.0 * std::abs(a));
    return {middle - half, middle + half};
}

std::vector<Point> points_at(const std::vector<Ray>& rays, double x) {
    std::vector<Point> points;
    for (const Ray& ray : rays) {
        const double way = (x - ray.origin[0]) / ray.direction[0];
        points.push_back(
            {ray.origin[1] + way * ray.direction[1], ray.origin[2] + way * ray.direction[2]});
    }
    return points;
}

// The root mean squares of points around their middle, along their longest and shortest axis.
std::array<double, 2> spread(const std::vector<Point>& points) {
    Point middle{};
    for (const Point& p : points) {
        middle[0] += p[0] / static_cast<double>(points.size());
        middle[1] += p[1] / static_cast<double>(points.size());
    }
    double xx = 0.0;
    double xy = 0.0;
    double yy = 0.0;
    for (const Point& p : points) {
        const double part = 1.0 / static_cast<double>(points.size());
        xx += part * (p[0] - middle[0]) * (p[0] - middle[0]);
        xy += part * (p[0] - middle[0]) * (p[1] - middle[1]);
        yy += part * (p[1] - middle[1]) * (p[1] - middle[1]);
    }
    const double half = 0.5 * (xx + yy);
    const double root = std::hypot(0.5 * (xx - yy), xy);
    return {std::sqrt(half + root), std::sqrt(std::max(0.0, half - root))};
}

// The roots of sums of 40 products of rounded numbers up to 10.
constexpr double tolerance = 1e-6;

void expect_line_at(const std::vector<Ray>& rays, double x) {
    const auto [along, across] = spread(points_at(rays, x));
    EXPECT_GT(along, 0.1) << x;
    EXPECT_LT(across, tolerance) << x;
}

// The distance between the lines of two rays, or nothing if they are parallel.
std::optional<double> distance_of(const Ray& a, const Ray& b) {
    const Vector across = cross(a.direction, b.direction);
    if (length(across) < 1e-9) {
        return std::nullopt;
    }
    return std::abs(dot(b.origin - a.origin, across)) / length(across);
}

bool are_parallel(const std::vector<Ray>& rays) {
    return std::all_of(rays.begin(), rays.end(), [&](const Ray& ray) {
        return length(cross(ray.direction, rays.front().direction)) < 1e-12;
    });
}

// Whether all directions are at right angles to one vector.
bool are_in_parallel_planes(const std::vector<Ray>& rays) {
    std::vector<Point> slopes;
    for (const Ray& ray : rays) {
        slopes.push_back(
            {ray.direction[1] / ray.direction[0], ray.direction[2] / ray.direction[0]});
    }
    return spread(slopes)[1] < tolerance;
}

}  // namespace

TEST(GeneralLinear, IsTheAffineCombinationOfItsRays) {
    const Rays rays{{{{1.0, -1.0}, {-1.5, -0.5}, {0.5, 2.0}}},
                    {{{3.0, -2.0}, {-2.0, 1.0}, {2.0, 4.0}}}};
    for (const Ray& ray : rays_of(rays)) {
        const double u = ray.parameters[0];
        const double v = ray.parameters[1];
        const std::vector<Point> near = points_at({ray}, 0.0);
        const std::vector<Point> far = points_at({ray}, distance);
        for (std::size_t k = 0; k < 2; ++k) {
            const auto between = [&](const std::array<Point, 3>& p) {
                return (1.0 - u - v) * p[0][k] + u * p[1][k] + v * p[2][k];
            };
            EXPECT_NEAR(near[0][k], between(rays.near), 1e-13);
            EXPECT_NEAR(far[0][k], between(rays.far), 1e-13);
        }
    }
}

TEST(GeneralLinear, CrossSlitsHaveTwoRootsWhereAllRaysMeetLines) {
    const Rays rays{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                    {{{2.0, -1.2}, {-2.0, -1.2}, {2.0, 1.2}}}};
    const std::vector<double> at = slits(rays);
    ASSERT_EQ(at.size(), 2U);
    EXPECT_NEAR(at[0], -10.0, 1e-9);
    EXPECT_NEAR(at[1], -2.0, 1e-9);
    const std::vector<Ray> all = rays_of(rays);
    expect_line_at(all, at[0]);
    expect_line_at(all, at[1]);
}

TEST(GeneralLinear, SlantedCrossSlitsToo) {
    const Rays rays{{{{1.0, -1.0}, {-1.0, -0.7}, {1.3, 1.0}}},
                    {{{2.0, -1.2}, {-2.0, -1.6}, {2.2, 1.2}}}};
    const std::vector<double> at = slits(rays);
    ASSERT_EQ(at.size(), 2U);
    const std::vector<Ray> all = rays_of(rays);
    expect_line_at(all, at[0]);
    expect_line_at(all, at[1]);
    EXPECT_GT(spread(points_at(all, at[0] + 0.1))[1], 100.0 * tolerance);
}

TEST(GeneralLinear, PinholesHaveOneRootWhereAllRaysMeetAPoint) {
    const Rays rays{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                    {{{1.5, -1.5}, {-1.5, -1.5}, {1.5, 1.5}}}};
    const std::vector<double> at = slits(rays);
    ASSERT_EQ(at.size(), 1U);
    EXPECT_NEAR(at[0], -4.0, 1e-9);
    EXPECT_LT(spread(points_at(rays_of(rays), at[0]))[0], tolerance);
}

TEST(GeneralLinear, PencilsHaveOneRootWhereAllRaysMeetALine) {
    // The pinhole above with rays that turn about the line z = 0 of its depth.
    const Rays rays{{{{1.0, -1.0}, {-1.0, -1.0}, {0.6, 1.0}}},
                    {{{1.5, -1.5}, {-1.5, -1.5}, {0.7, 1.5}}}};
    const auto [c, b, a] = characteristic(rays);
    EXPECT_GT(std::abs(a), 0.1);
    EXPECT_NEAR(b * b, 4.0 * a * c, 1e-12);
    const std::vector<double> at = slits(rays);
    ASSERT_EQ(at.size(), 1U);
    expect_line_at(rays_of(rays), at[0]);
}

TEST(GeneralLinear, PushbroomsMeetOneLineAndAreParallelToAPlane) {
    const Rays rays{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                    {{{1.0, -1.5}, {-1.0, -1.5}, {1.0, 1.5}}}};
    const auto [c, b, a] = characteristic(rays);
    EXPECT_NEAR(a, 0.0, 1e-12);
    EXPECT_GT(std::abs(b), 0.1);
    EXPECT_GT(std::abs(c), 0.1);
    const std::vector<Ray> all = rays_of(rays);
    expect_line_at(all, slits(rays).at(0));
    EXPECT_TRUE(are_in_parallel_planes(all));
    EXPECT_FALSE(are_parallel(all));
}

TEST(GeneralLinear, OrthographicOnesAreParallelAndTwistedOnesAreNot) {
    const Rays orthographic{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                            {{{1.5, -0.5}, {-0.5, -0.5}, {1.5, 1.5}}}};
    const Rays twisted{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                       {{{1.5, -0.5}, {-0.5, -0.5}, {2.5, 1.5}}}};
    for (const Rays& rays : {orthographic, twisted}) {
        const auto [c, b, a] = characteristic(rays);
        EXPECT_NEAR(a, 0.0, 1e-12);
        EXPECT_NEAR(b, 0.0, 1e-12);
        EXPECT_GT(std::abs(c), 0.1);
        EXPECT_TRUE(are_in_parallel_planes(rays_of(rays)));
    }
    EXPECT_TRUE(are_parallel(rays_of(orthographic)));
    const std::vector<Ray> all = rays_of(twisted);
    EXPECT_FALSE(are_parallel(all));
    for (std::size_t i = 1; i < all.size(); ++i) {
        const auto apart = distance_of(all[0], all[i]);
        EXPECT_TRUE(!apart || *apart > 1e-4) << i;
    }
}

TEST(GeneralLinear, BilinearOnesHaveNoRootAndNoTwoRaysThatMeet) {
    const Rays rays{{{{1.0, -1.0}, {-1.0, -1.0}, {1.0, 1.0}}},
                    {{{1.5, 0.0}, {-0.5, -2.0}, {-0.5, 2.0}}}};
    const auto [c, b, a] = characteristic(rays);
    EXPECT_LT(b * b - 4.0 * a * c, -0.1);
    const std::vector<Ray> all = rays_of(rays);
    for (std::size_t i = 0; i < all.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const auto apart = distance_of(all[i], all[k]);
            EXPECT_TRUE(apart && *apart > 1e-4) << i << ' ' << k;
        }
    }
}

TEST(GeneralLinear, RaysInLineAreAnError) {
    const auto made = try_stage(StageKind::object_generator, "general_linear",
                                {{"a", numbers({0.0, 0.0})},
                                 {"b", numbers({1.0, 0.0})},
                                 {"c", numbers({2.0, 0.0})},
                                 {"to_a", numbers({0.0, 0.0})},
                                 {"to_b", numbers({1.0, 1.0})},
                                 {"to_c", numbers({2.0, 2.0})}});
    ASSERT_FALSE(made);
    EXPECT_NE(to_text(made.diagnostics).find("between the others"), std::string::npos);
}

}  // namespace balcony::camera::general_linear_test
