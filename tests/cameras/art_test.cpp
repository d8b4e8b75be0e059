// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Cameras after works of art: each against the law that is published of the work, or that its
// method states.

#include <cmath>
#include <complex>
#include <vector>

#include "support.hpp"

namespace balcony::cameras::test::art_test {

namespace {

using std::numbers::pi;
using Complex = std::complex<double>;

const std::vector<double> fractions{0.03, 0.14, 0.27, 0.36, 0.46, 0.58, 0.71, 0.83, 0.98};

// The point of a ray from the origin in the plane x = 1: to the right, and up.
Complex in_plane(const Ray& ray) {
    return {-ray.direction.y / ray.direction.x, ray.direction.z / ray.direction.x};
}

// A point of a picture of the plane x = 1, `half` of which is half of its width.
Ray through(const Rays& rays, const Complex& point, double half, double time = 0.0) {
    const double half_height = half * rays.height() / rays.width();
    return rays.at(0.5 + point.real() / (2.0 * half), 0.5 - point.imag() / (2.0 * half_height),
                   time);
}

// A camera that a built-in picture is made of.
camera::Camera part_of(const std::string& picture, const std::string& name,
                       const std::vector<lang::Override>& overrides) {
    const Result<camera::Camera> made = lang::make_camera(picture, name, overrides);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

}  // namespace

// A cylinder about a horizontal axis, unrolled: the points of the vertical line at (x, y) are on
// the curve (y/x) cos(angle), which leads from the nadir to the zenith.
TEST(ArtLookAround, VerticalsCurveFromNadirToZenith) {
    const Rays rays("look_around", {{"px", "1"}, {"py", "-2"}, {"pz", "1.6"}});
    const double low = -105.0 * degree;
    const double high = 105.0 * degree;
    for (const double y : {-1.7, -0.4, 0.9, 1.9}) {
        for (const double height : {-30.0, -3.0, -1.0, 0.0, 0.5, 2.0, 40.0}) {
            const V3d point(2.0, y, height);
            const double angle = std::atan2(point.z, point.x);
            const double to_left = point.y / point.x * std::cos(angle);
            const Ray ray = rays.at(0.5 - to_left / 2.0, (high - angle) / (high - low));
            expect_near(ray.origin, V3d(1.0, -2.0, 1.6), 1e-12);
            expect_near(ray.direction, point.normalized(), 1e-12);
        }
    }
    expect_near(rays.at(0.5, 15.0 / 210.0).direction, V3d(0, 0, 1), 1e-12);
    expect_near(rays.at(0.5, 195.0 / 210.0).direction, V3d(0, 0, -1), 1e-12);
}

// B. de Smit and H. W. Lenstra, 2003: with a scale of 256, the picture is the same when it is
// turned by 157.6255960832 degrees and enlarged 22.5836845286 times.
TEST(ArtPrintGallery, ContainsItselfTurnedAndScaled) {
    const Rays rays("print_gallery", {{"scale", "256"}, {"fov", "90deg"}});
    const Complex period = std::polar(22.5836845286, 157.6255960832 * degree);
    int other = 0;
    for (const double x : fractions) {
        for (const double y : fractions) {
            // Escher's grows clockwise: in the picture, the turn and the growth are opposite.
            const Complex large(1.8 * (x - 0.5), 0.8 * (y - 0.5));
            const Complex seen = in_plane(through(rays, large, 1.0));
            for (const Complex& small : {large / period, large / std::conj(period)}) {
                other += std::abs(in_plane(through(rays, small, 1.0)) - seen) > 1e-8 ? 1 : 0;
            }
        }
    }
    // One sense of turning fits everywhere and the other one nowhere.
    EXPECT_EQ(other, 81);
}

TEST(ArtDroste, RepeatsSmallerAndZoomsInEndlessly) {
    const Rays rays("droste", {{"fov", "90deg"}});
    int repeated = 0;
    for (const double x : fractions) {
        for (const double y : fractions) {
            const Complex point(1.9 * (x - 0.5), 1.4 * (y - 0.5));
            const Complex seen = in_plane(through(rays, point, 1.0));
            EXPECT_LE(std::abs(in_plane(through(rays, point / 3.0, 1.0)) - seen), 1e-9);
            EXPECT_LE(std::abs(in_plane(through(rays, point, 1.0, 4.0)) - seen), 1e-9);
            // Half a period later, everything has grown by the square root of the scale.
            EXPECT_LE(std::abs(in_plane(through(rays, point, 1.0, 2.0)) -
                               in_plane(through(rays, point / std::sqrt(3.0), 1.0))),
                      1e-9);
            // Outside of the smaller picture, it is that of a pinhole.
            if (std::abs(point.real()) > 0.34 || std::abs(point.imag()) > 0.26) {
                ++repeated;
                EXPECT_LE(std::abs(seen - point), 1e-12);
            }
        }
    }
    EXPECT_GE(repeated, 40);
}

TEST(ArtKaleidoscope, HasTheSymmetryOfItsMirrors) {
    const Rays rays("kaleidoscope", {{"sectors", "10"}, {"at_yaw", "12deg"}});
    const double half = std::tan(50.0 * degree);
    const Complex turn = std::polar(1.0, 2.0 * pi / 5.0);
    for (const double x : fractions) {
        const Complex point = std::polar(0.9 * x * half, 7.0 * x);
        const Complex seen = in_plane(through(rays, point, half));
        EXPECT_LE(std::abs(in_plane(through(rays, point * turn, half)) - seen), 1e-12);
        EXPECT_LE(std::abs(in_plane(through(rays, std::conj(point), half)) - seen), 1e-12);
        // It is as far from the tip of the wedge as the point is from the middle.
        EXPECT_NEAR(std::abs(seen + std::tan(12.0 * degree)), std::abs(point), 1e-12);
    }
}

// The ground is a map with one scale, and each row of it is seen at its own angle from one
// distance.
TEST(ArtHereAndThere, ShowsTheGroundAsAMap) {
    const Rays rays("here_and_there", {{"px", "3"}, {"py", "1"}, {"ground", "0.5"}});
    for (const double x : fractions) {
        for (const double y : fractions) {
            const Ray ray = rays.at(x, y);
            const V3d on_ground(3.0 + 8.0 * (1.0 - y), 1.0 + 6.0 * (0.5 - x), 0.5);
            const double distance = (on_ground - ray.origin).length();
            expect_near(ray.origin + ray.direction * distance, on_ground, 1e-12);
            const Ray middle = rays.at(0.5, y);
            const double pitch = (15.0 + 75.0 * (1.0 - y)) * degree;
            EXPECT_NEAR(middle.direction.z, -std::sin(pitch), 1e-12);
            EXPECT_NEAR((middle.origin - V3d(on_ground.x, 1.0, 0.5)).length(), 6.0, 1e-12);
        }
    }
    expect_near(rays.at(0.5, 0.0).direction, V3d(0, 0, -1), 1e-12);
}

TEST(ArtHereAndThere, FoldsOverAndLooksBack) {
    const Rays rays("here_and_there", {{"fold", "180deg"}});
    expect_near(rays.at(0.5, 0.0).direction, V3d(-1, 0, 0), 1e-12);
}

// In the middle, all rays start on a sphere and converge on one point; at the edge they look
// outwards.
TEST(ArtEverySide, ConvergesOnTheObjectAndShowsTheWorldBehind) {
    const Rays rays("every_side", {{"far", "10"}, {"depth", "1"}, {"px", "2"}, {"pz", "3"}});
    for (int k = 0; k < 24; ++k) {
        const double angle = 2.0 * pi * k / 24;
        const auto at = [&](double s) {
            return rays.at(0.5 + 0.5 * s * std::cos(angle), 0.5 - 0.5 * s * std::sin(angle));
        };
        const V3d target(2.0, 0.0, 2.0);
        for (const double s : {0.1, 0.3, 0.4}) {
            const Ray ray = at(s);
            EXPECT_NEAR((ray.origin - target).length(), 10.0, 1e-3);
            expect_near(ray.direction, (target - ray.origin).normalized(), 1e-2);
            EXPECT_NEAR(std::asin((ray.origin - target).normalized().z) / degree, 90.0 - 118.0 * s,
                        0.05);
        }
        const Ray edge = at(0.97);
        const V3d outward = (edge.origin - V3d(2.0, 0.0, edge.origin.z)).normalized();
        EXPECT_GT(edge.direction.dot(outward), 0.9);
    }
}

// The distance from the feature becomes r ((r^2 + size^2)/(1 + size^2))^(exaggeration/2).
TEST(ArtCaricature, ExaggeratesAFeature) {
    const Rays rays(
        "caricature",
        {{"fov", "90deg"}, {"at_yaw", "-8deg"}, {"size", "0.3"}, {"exaggeration", "0.8"}});
    const Complex feature(std::tan(8.0 * degree), 0.0);
    for (const double time : {0.0, 0.5, 1.5}) {
        // Once every two seconds, by a half.
        const double power = 0.8 * (1.0 + 0.5 * std::sin(pi * time));
        for (const double r : {0.05, 0.2, 0.4}) {
            for (int k = 0; k < 8; ++k) {
                const Complex way = std::polar(1.0, 0.3 + k * pi / 4.0);
                const double seen = r * std::pow((r * r + 0.09) / 1.09, power / 2.0);
                const Complex found = in_plane(through(rays, feature + r * way, 1.0, time));
                EXPECT_LE(std::abs(found - (feature + seen * way)), 1e-12) << time << ' ' << r;
            }
        }
    }
}

TEST(ArtSlitScan, GivesEachRowItsTime) {
    const Rays rays("slit_scan", {{"duration", "3"}, {"spin", "30deg"}});
    for (const double y : fractions) {
        const Ray ray = rays.at(0.5, y, 2.0);
        ASSERT_TRUE(ray.time);
        EXPECT_NEAR(*ray.time, 2.0 + 3.0 * y, 1e-12);
        const double yaw = std::atan2(ray.direction.y, ray.direction.x) / degree;
        EXPECT_NEAR(yaw, 30.0 * (*ray.time - 1.5), 1e-9);
    }
}

// Without sway and drift, the photographs are the parts of one picture.
TEST(ArtJoiner, IsMadeOfPartsOfOneView) {
    const std::string file =
        std::string(BALCONY_SOURCE_DIR) + "/cameras/art/joiner.cam:joiner_view";
    const double half = std::tan(50.0 * degree);
    for (int column = 0; column < 8; column += 3) {
        for (int row = 0; row < 5; row += 2) {
            const Rays part(part_of("joiner", "joiner_view",
                                    {{"column", std::to_string(column)},
                                     {"row", std::to_string(row)},
                                     {"overlap", "1"}}));
            for (const double x : fractions) {
                const double y = 1.0 - x;
                const Complex expected(half * (2.0 * (column + x) / 8.0 - 1.0),
                                       half / 8.0 * (5.0 - 2.0 * (row + y)));
                EXPECT_LE(std::abs(in_plane(part.at(x, y)) - expected), 1e-12);
            }
        }
    }
    const Result<rays::CompiledPicture> picture =
        rays::compile(make_picture("joiner"), 160, 100, {});
    ASSERT_TRUE(picture);
    EXPECT_EQ(picture->layers().size(), 40U);
}

// All facets see the object in the middle of the picture, from one distance and their own
// direction.
TEST(ArtCubist, SeesOneThingFromManySides) {
    const Result<rays::CompiledPicture> picture = rays::compile(
        make_picture("cubist", {{"facets", "12"}, {"px", "2"}, {"pz", "1"}}), 100, 120, {});
    ASSERT_TRUE(picture);
    ASSERT_EQ(picture->layers().size(), 13U);
    const std::string file =
        std::string(BALCONY_SOURCE_DIR) + "/cameras/art/cubist.cam:cubist_view";
    for (const char* angle : {"-80deg", "0deg", "35deg"}) {
        const double turn = std::stod(angle) * degree;
        const Ray ray =
            Rays(part_of("cubist", "cubist_view", {{"angle", angle}, {"px", "2"}, {"pz", "1"}}))
                .at(0.5, 0.5);
        const V3d way(std::cos(turn) * std::cos(15.0 * degree),
                      std::sin(turn) * std::cos(15.0 * degree), -std::sin(15.0 * degree));
        expect_near(ray.direction, way, 1e-12);
        expect_near(ray.origin, V3d(2.0, 0.0, 1.0) - way * 4.0, 1e-12);
    }
}

}  // namespace balcony::cameras::test::art_test
