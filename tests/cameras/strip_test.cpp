// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Strip cameras against their published projections: every point of a ray is projected to the place
// in the picture that the ray belongs to.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <limits>
#include <random>
#include <string>
#include <vector>

#include "support.hpp"

namespace balcony::cameras::test::strip_test {

namespace {

constexpr double tolerance = 1e-9;

// Projects points of the rays; fractions from the top left corner.
void expect_projection(const Rays& rays, const std::function<V2d(const V3d&)>& project) {
    std::mt19937_64 random{5};
    std::uniform_real_distribution<double> place(0.0, 1.0);
    for (int i = 0; i < 100; ++i) {
        const V2d at(place(random), place(random));
        const Ray ray = rays.at(at.x, at.y);
        ASSERT_TRUE(ray.valid);
        for (const double distance : {2.0, 9.0}) {
            const V2d found = project(ray.origin + distance * ray.direction);
            EXPECT_NEAR(found.x, at.x, tolerance);
            EXPECT_NEAR(found.y, at.y, tolerance);
        }
    }
}

// How far what lies at a distance moves to the right from pixel to pixel.
double step_to_the_right(const Ray& ray, double distance) {
    const V3d right = ray.direction % V3d(0.0, 0.0, 1.0);
    return (ray.origin_by_x + distance * ray.direction_by_x) ^ right.normalized();
}

}  // namespace

// Orthographic along the street, perspective from the eye across it.
TEST(StreetStrip, IsParallelAlongTheStreetAndPerspectiveAcross) {
    const Rays rays("street_strip");  // length 20, distance 8, above 8, below 1.6
    EXPECT_NEAR(rays.width() / rays.height(), 20.0 / 9.6, tolerance);
    expect_projection(
        rays, [](const V3d& p) { return V2d(0.5 - p.y / 20.0, (8.0 - 8.0 * p.z / p.x) / 9.6); });
}

TEST(StreetStrip, ConvergesToAPinhole) {
    const Rays rays(make("street_strip", {{"converging", "1"}}));
    expect_projection(rays, [](const V3d& p) {
        return V2d(0.5 - 8.0 * p.y / p.x / 20.0, (8.0 - 8.0 * p.z / p.x) / 9.6);
    });
}

// Gupta and Hartley: one coordinate is the place of the scanner when its plane of view meets the
// point, the other the perspective projection in this plane.
TEST(Pushbroom, IsLinearAlongTheFlightAndPerspectiveAcross) {
    const Rays rays(make("pushbroom", {{"pz", "20"}, {"tilt", "10deg"}}));  // length 20, fov 30
    const double half_width = std::tan(15.0 * degree);
    EXPECT_NEAR(rays.width() / rays.height(), 2.0 * half_width, tolerance);
    expect_projection(rays, [&](const V3d& p) {
        const double depth = 20.0 - p.z;
        const double flown = p.x - depth * std::tan(10.0 * degree);
        return V2d(0.5 - p.y / depth / (2.0 * half_width), 0.5 - flown / 20.0);
    });
}

TEST(Pushbroom, ScansLaterWhatLiesAhead) {
    const Rays rays(make("pushbroom", {{"duration", "4"}}));
    EXPECT_NEAR(rays.at(0.5, 1.0, 10.0).time.value(), 10.0, tolerance);
    EXPECT_NEAR(rays.at(0.5, 0.25, 10.0).time.value(), 13.0, tolerance);
}

// Zomet et al., equation of parallel orthogonal slits: each coordinate is a perspective projection
// from its own slit, here to the plane at the depth 8.
TEST(CrossedSlits, ProjectsFromOneSlitInEachDirection) {
    for (const double behind : {0.0, 10.0, 1e4}) {
        const Rays rays(make("crossed_slits", {{"behind", std::to_string(behind)}}));
        const double height = 10.0 * rays.height() / rays.width();
        expect_projection(rays, [&](const V3d& p) {
            return V2d(0.5 - p.y * (8.0 + behind) / (p.x + behind) / 10.0,
                       0.5 - p.z * 8.0 / p.x / height);
        });
    }
}

// Along a straight path, this is the street strip to its side.
TEST(PathStrip, IsAStreetStripAlongAStraightPath) {
    for (const double side : {1.0, -1.0}) {
        const Rays rays(make("path_strip", {{"path", "[(0, 0), (3, 0), (10, 0)]"},
                                            {"length", "10"},
                                            {"side", std::to_string(side)}}));
        expect_projection(rays, [&](const V3d& p) {  // distance 4, above 4, below 2
            const double along = side > 0.0 ? p.x / 10.0 : 1.0 - p.x / 10.0;
            return V2d(along, (4.0 - 4.0 * p.z / (side * p.y)) / 6.0);
        });
    }
}

// On a bent path, rays start at even steps of its length, at right angles to it, and the picture is
// not mirrored on either side.
TEST(PathStrip, FollowsABentPath) {
    for (const std::string side : {"1", "-1"}) {
        const Rays rays(make("path_strip", {{"side", side}, {"distance", "1"}}));
        const double pixel = 25.8 / rays.width();
        for (double x = 0.05; x < 1.0; x += 0.1) {
            const Ray ray = rays.at(x, 4.0 / 6.0);
            EXPECT_NEAR(ray.direction.z, 0.0, tolerance);
            EXPECT_NEAR(ray.origin_by_x.length() / pixel, 1.0, 0.01);
            EXPECT_NEAR(ray.origin_by_x ^ ray.direction, 0.0, tolerance);
            EXPECT_GT(step_to_the_right(ray, 0.0), 0.0);
        }
    }
}

namespace {

/// Where rays of a camera along x are at a depth.
struct AtDepth {
    explicit AtDepth(const Rays& camera) {
        for (int i = 0; i < 25; ++i) {
            rays.push_back(camera.at(0.05 + 0.225 * (i % 5), 0.05 + 0.225 * (i / 5)));
            EXPECT_TRUE(rays.back().valid);
        }
    }
    [[nodiscard]] std::vector<V2d> operator()(double depth) const {
        std::vector<V2d> found;
        for (const Ray& ray : rays) {
            const V3d at = ray.origin + (depth - ray.origin.x) / ray.direction.x * ray.direction;
            found.emplace_back(at.y, at.z);
        }
        return found;
    }
    /// The characteristic equation of Yu and McMillan: twice the area of the triangle of three rays
    /// at a depth, as coefficients of 1, depth and its square.
    [[nodiscard]] std::array<double, 3> characteristic() const {
        const auto area = [this](double depth) {
            const std::vector<V2d> p = (*this)(depth);
            return (p[4] - p[0]) % (p[20] - p[0]);
        };
        return {area(0.0), 0.5 * (area(1.0) - area(-1.0)),
                0.5 * (area(1.0) + area(-1.0)) - area(0.0)};
    }
    std::vector<Ray> rays;
};

double extent(const std::vector<V2d>& points) {
    double most = 0.0;
    for (const V2d& point : points) {
        most = std::max(most, (point - points.front()).length());
    }
    return most;
}

// The largest triangle with the first point and the one that is farthest from it.
double width_across(const std::vector<V2d>& points) {
    const V2d far =
        *std::max_element(points.begin(), points.end(), [&](const V2d& a, const V2d& b) {
            return (a - points.front()).length() < (b - points.front()).length();
        });
    double most = 0.0;
    for (const V2d& point : points) {
        most = std::max(most, std::abs((far - points.front()) % (point - points.front())));
    }
    return most;
}

// The least distance between the lines of two of the rays.
double nearest(const std::vector<Ray>& rays) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < rays.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) {
            const V3d across = rays[i].direction % rays[k].direction;
            const double sine = across.length();
            least =
                sine < tolerance
                    ? least
                    : std::min(least, std::abs((rays[i].origin - rays[k].origin) ^ across) / sine);
        }
    }
    return least;
}

}  // namespace

// The kinds of the paper by the roots of the characteristic equation, and what all rays of each
// kind have in common. Its eighth kind, with all rays in one plane, has no picture.
TEST(GeneralLinear, HasTheKindsOfYuAndMcMillan) {
    enum class Common { lines, point, none };
    struct Kind {
        const char* name;
        const char *across, *up, *turn, *skew;
        int degree;  ///< Of the characteristic equation.
        std::vector<double> roots;
        Common common;
        bool parallel_to_plane, parallel;
    };
    const std::vector<Kind> kinds{
        {"cross-slit", "0.8", "0.5", "0", "0", 2, {-2.0, -1.25}, Common::lines, false, false},
        {"slanted", "0.8", "0.5", "0", "0.2", 2, {-2.5, -10.0 / 9.0}, Common::lines, false, false},
        {"pinhole", "0.8", "0.8", "0", "0", 2, {-1.25}, Common::point, false, false},
        {"pencil", "0.5", "0.5", "0.2", "0.2", 2, {-2.0}, Common::lines, false, false},
        {"pushbroom", "0", "0.8", "0", "0", 1, {-1.25}, Common::lines, true, false},
        {"orthographic", "0", "0", "0", "0", 0, {}, Common::none, true, true},
        {"twisted", "0", "0", "0.3", "0.3", 0, {}, Common::none, true, false},
        {"turned twisted", "0.4", "-0.4", "0.5", "0.3", 0, {}, Common::none, true, false},
        {"bilinear", "0.3", "0.3", "0.3", "0", 2, {}, Common::none, false, false}};
    for (const Kind& kind : kinds) {
        SCOPED_TRACE(kind.name);
        const AtDepth at(Rays(
            "general_linear",
            {{"across", kind.across}, {"up", kind.up}, {"turn", kind.turn}, {"skew", kind.skew}}));
        const auto [c, b, a] = at.characteristic();
        EXPECT_EQ(std::abs(a) > tolerance, kind.degree == 2);
        EXPECT_EQ(std::abs(b) > tolerance, kind.degree >= 1);
        for (const double root : kind.roots) {
            EXPECT_NEAR(c + root * (b + root * a), 0.0, tolerance);
            EXPECT_LT(width_across(at(root)), tolerance);
            EXPECT_EQ(extent(at(root)) < tolerance, kind.common == Common::point);
        }
        if (kind.degree == 2) {
            const double discriminant = b * b - 4.0 * a * c;
            EXPECT_EQ(discriminant > tolerance, kind.roots.size() == 2);
            EXPECT_EQ(discriminant < -tolerance, kind.roots.empty());
        }
        // The slopes of the rays are the change from one depth to the next.
        std::vector<V2d> slopes = at(1.0);
        const std::vector<V2d> before = at(0.0);
        for (std::size_t i = 0; i < slopes.size(); ++i) {
            slopes[i] -= before[i];
        }
        EXPECT_EQ(width_across(slopes) < tolerance, kind.parallel_to_plane);
        EXPECT_EQ(extent(slopes) < tolerance, kind.parallel);
        EXPECT_EQ(nearest(at.rays) > 0.01,
                  kind.degree == 0 || kind.name == std::string("bilinear"));
    }
}

// By `across` and `up`, the picture grows; by `turn`, it turns.
TEST(GeneralLinear, GrowsAndTurnsWithDepth) {
    const Rays rays("general_linear", {{"width", "2"}, {"turn", "0.5"}, {"across", "0.25"}});
    const double aspect = rays.width() / rays.height();
    expect_projection(rays, [&](const V3d& p) {
        const double s = p.x / 2.0;
        // y = (1 + s across) u - s turn v, z = s turn u + (1 + s up) v, with up = 0.3.
        const double m = 1.0 + 0.25 * s;
        const double n = 1.0 + 0.3 * s;
        const double turn = 0.5 * s;
        const double det = m * n + turn * turn;
        const double u = (n * p.y + turn * p.z) / det / 2.0;
        const double v = (m * p.z - turn * p.y) / det / 2.0;
        return V2d(0.5 - u, 0.5 - v * aspect);
    });
}

}  // namespace balcony::cameras::test::strip_test
