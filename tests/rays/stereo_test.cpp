// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Stereo views: of a perspective camera they are two cameras with off-axis frusta, of a panorama
// they are omnidirectional stereo, and of any camera both views meet at the convergence.

#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::rays::test::stereo_test {
namespace {

using std::numbers::pi;

class Probe {
public:
    explicit Probe(const camera::Camera& camera) : rays_(compiled(camera)) {}
    explicit Probe(const std::string& statements)
        : Probe(camera_of("camera a { " + statements + " }")) {}

    [[nodiscard]] Ray operator()(const V2d& point, double time = 0.0) const {
        Scratch scratch;
        RayBatch batch;
        rays_.run(Points{std::span(&point.x, 1), std::span(&point.y, 1), time, {}}, scratch, batch);
        return batch[0];
    }

private:
    static RayProgram compiled(const camera::Camera& camera) {
        auto made = compile(camera, width, height, {.footprints = true, .points = true});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return *made;
    }
    RayProgram rays_;
};

std::string stereo(const std::string& arguments, double side) {
    return fmt::format("stereo({}{}side = {})", arguments, arguments.empty() ? "" : ", ", side);
}

void expect_near(const V3d& a, const V3d& b, double tolerance, const std::string& what) {
    EXPECT_LE((a - b).length(), tolerance) << what << ": " << a.x << ' ' << a.y << ' ' << a.z
                                           << " and " << b.x << ' ' << b.y << ' ' << b.z;
}

// The axes of a camera after rotations about x (roll), y (pitch) and z (yaw).
struct Rig {
    V3d forward{1.0, 0.0, 0.0}, right{0.0, -1.0, 0.0}, up{0.0, 0.0, 1.0}, position{0.0};
};

Rig turned_rig() {
    Rig rig;
    const auto turn = [](const V3d& v) {
        const auto rotated = [](double a, double b, double angle) {
            return std::array{a * std::cos(angle) - b * std::sin(angle),
                              a * std::sin(angle) + b * std::cos(angle)};
        };
        const auto [y, z] = rotated(v.y, v.z, 0.2);
        const auto [z2, x] = rotated(z, v.x, -0.3);
        const auto [x2, y2] = rotated(x, y, 0.9);
        return V3d(x2, y2, z2);
    };
    rig.forward = turn(rig.forward);
    rig.right = turn(rig.right);
    rig.up = turn(rig.up);
    rig.position = V3d(1.0, -2.0, 0.5);
    return rig;
}

const std::string turns =
    "move rotate(x, 0.2rad), rotate(y, -0.3rad), rotate(z, 0.9rad), translate(1, -2, 0.5) ";
const std::string perspective = "eye point  toward plane((1, 0, 0)) ";
const std::string pinhole = "map u = 0.8 .. -0.8, v = square " + perspective;
const std::string panorama =
    "map u = 180deg .. -180deg, v = -90deg .. 90deg  eye point  toward "
    "sphere(1) ";
const std::string rollout =
    "map u = 60deg .. -60deg, v = -1 .. 1  eye cylinder(3)  look "
    "normal(inward) ";

}  // namespace

// ---------------------------------------------------------------------------------- perspective

// An off-axis frustum as graphics libraries take it: the window between left, right, bottom and top
// at the distance 1, seen from an eye beside the middle. All eyes share the window at the distance
// of convergence.
TEST(StereoOfPerspective, HasTheOffAxisFrustaOfTwoCameras) {
    constexpr double separation = 0.3;
    constexpr double convergence = 4.0;
    // Symmetric, and shifted as for a painter's two-point perspective.
    for (const auto& [left, right, bottom, top] :
         {std::array{-0.8, 0.8, -0.45, 0.45}, std::array{-0.3, 0.9, -0.7, 0.2}}) {
        for (const double side : {-1.0, 0.0, 1.0}) {
            const Rig rig = turned_rig();
            const Probe probe(fmt::format(
                "map u = {} .. {}, v = {} .. {} {} {} {}", -left, -right, bottom, top, perspective,
                turns, stereo(fmt::format("{}, {}", separation, convergence), side)));
            const double offset = 0.5 * side * separation;
            const double l = (left * convergence - offset) / convergence;
            const double r = (right * convergence - offset) / convergence;
            at_pixels([&](const V2d& at) {
                const Ray ray = probe(at);
                const double x = l + (r - l) * at.x / width;
                const double y = top + (bottom - top) * at.y / height;
                expect_near(ray.origin, rig.position + offset * rig.right, rounding, "origin");
                expect_near(ray.direction, (rig.forward + x * rig.right + y * rig.up).normalized(),
                            rounding, "direction");
            });
        }
    }
}

TEST(StereoOfPerspective, IsParallelWithoutConvergence) {
    const Probe one(pinhole + turns);
    const Probe left(pinhole + turns + stereo("separation = 0.5", -1.0));
    at_pixels([&](const V2d& at) {
        expect_near(left(at).direction, one(at).direction, rounding, "direction");
        expect_near(left(at).origin, one(at).origin - 0.25 * turned_rig().right, rounding,
                    "origin");
    });
}

// A point of the scene is in the plane of both eyes and each ray of its row.
TEST(StereoOfPerspective, HasNoVerticalDisparity) {
    const Probe one(pinhole + turns);
    for (const std::string baseline : {"fixed", "picture"}) {
        for (const double side : {-1.0, 1.0}) {
            const Probe eye(pinhole + turns + stereo("0.5, baseline = " + baseline, side));
            const V3d right = turned_rig().right;
            at_pixels([&](const V2d& at) {
                const V3d normal = right.cross(one(at).direction).normalized();
                EXPECT_NEAR(normal.dot(eye(at).direction), 0.0, rounding) << baseline;
                EXPECT_NEAR(normal.dot(eye(at).origin - one(at).origin), 0.0, rounding);
            });
        }
    }
}

// The disparity of a point at the depth z, measured on the window: separation (1 - c/z), crossed in
// front of the window. Infinity is one separation apart.
TEST(StereoOfPerspective, HasTheDisparityOfSimilarTriangles) {
    constexpr double convergence = 4.0;
    constexpr double separation = 0.3;
    constexpr double half_width = 0.8;
    const auto column = [&](double side, double depth) {
        const Probe eye("map u = 0.8 .. -0.8, v = square " + perspective + stereo("0.3, 4", side));
        // The column whose ray passes the middle axis at the depth; rays are linear in x.
        const auto passes = [&](double x) {
            const Ray ray = eye({x, 0.5 * height});
            return -(ray.origin.y + ray.direction.y / ray.direction.x * depth);
        };
        const double at_0 = passes(0.0);
        return width * at_0 / (at_0 - passes(width));
    };
    const double pixel = 2.0 * half_width * convergence / width;
    for (const double depth : {1.0, 4.0, 7.0, 1e9}) {
        const double disparity = (column(1.0, depth) - column(-1.0, depth)) * pixel;
        EXPECT_NEAR(disparity, separation * (1.0 - convergence / depth), 1e-9) << depth;
        // Nearer things are shifted to the right in the left eye's picture.
        EXPECT_EQ(column(-1.0, depth) > column(1.0, depth) + 1e-6, depth < convergence) << depth;
    }
}

// -------------------------------------------------------------------------------------- panorama

// Google, "Rendering Omni-directional Stereo Content" (2015): an eye goes round a circle whose
// diameter is the separation, and each ray is a tangent in its own azimuth.
TEST(StereoOfPanorama, IsOmnidirectionalStereo) {
    for (const double side : {-1.0, 1.0}) {
        for (const std::string baseline : {"auto", "picture", "level"}) {
            const Probe eye(panorama + stereo("0.064, baseline = " + baseline, side));
            at_pixels([&](const V2d& at) {
                const double azimuth = pi * (1.0 - 2.0 * at.x / width);
                const double latitude = pi * (0.5 - at.y / height);
                const Ray ray = eye(at);
                expect_near(ray.origin,
                            0.032 * side * V3d(std::sin(azimuth), -std::cos(azimuth), 0.0),
                            rounding, "origin " + baseline);
                expect_near(ray.direction,
                            {std::cos(latitude) * std::cos(azimuth),
                             std::cos(latitude) * std::sin(azimuth), std::sin(latitude)},
                            rounding, "direction " + baseline);
            });
        }
    }
}

TEST(StereoOfPanorama, FadesBetweenTheAnglesOfMerge) {
    const Probe eye(panorama + stereo("2, merge = (40deg, 70deg)", 1.0));
    for (double y = 0.5; y < height; y += 1.0) {
        const double elevation = std::abs(90.0 - 180.0 * y / height);
        const double part = std::clamp((elevation - 40.0) / 30.0, 0.0, 1.0);
        EXPECT_NEAR(eye({30.5, y}).origin.length(), 0.5 + 0.5 * std::cos(pi * part), 1e-11) << y;
    }
    EXPECT_TRUE(eye({30.5, 0.0}).valid) << "the zenith";
}

TEST(StereoOfPanorama, FollowsTheMovesAndTheAxes) {
    const Probe level(panorama + turns + stereo("2, baseline = level", 1.0));
    const Probe scene_up(panorama + turns + stereo("2, baseline = level, up = z", 1.0));
    const Probe y_up("axes y_up " + panorama + "move rotate(x, -90deg) " +
                     stereo("2, baseline = level, merge = (10deg, 80deg)", 1.0));
    const Probe turned_back("axes y_up " + panorama + "move rotate(x, -90deg) " +
                            stereo("2, baseline = level, up = y, merge = (10deg, 80deg)", 1.0));
    const Rig rig = turned_rig();
    at_pixels([&](const V2d& at) {
        const V3d offset = level(at).origin - rig.position;
        EXPECT_NEAR(offset.length(), 1.0, rounding);
        EXPECT_NEAR(offset.dot(rig.up), 0.0, rounding);
        EXPECT_NEAR(offset.dot(level(at).direction), 0.0, rounding);
        EXPECT_NEAR((scene_up(at).origin - rig.position).z, 0.0, rounding);
        EXPECT_TRUE(y_up(at).valid && turned_back(at).valid);
    });
}

// ------------------------------------------------------------------------------------ any camera

TEST(StereoOfAnyCamera, MeetsAtTheConvergence) {
    for (const std::string& statements : {panorama, rollout + turns}) {
        const Probe one(statements);
        for (const double side : {-1.0, 0.3, 1.0}) {
            const Probe eye(statements + stereo("0.2, 2.5", side));
            at_pixels([&](const V2d& at) {
                const Ray middle = one(at);
                const Ray ray = eye(at);
                const V3d point = middle.origin + 2.5 * middle.direction;
                EXPECT_LE((point - ray.origin).cross(ray.direction).length(), rounding);
                EXPECT_NEAR((ray.origin - middle.origin).length(), 0.1 * std::abs(side), rounding);
                EXPECT_NEAR((ray.origin - middle.origin).dot(middle.direction), 0.0, rounding);
            });
        }
    }
}

// The eye on the right stands where what is seen moves to as the picture goes to the right, also
// in a picture that shows its scene mirrored.
TEST(StereoOfAnyCamera, HasItsRightEyeToTheRightInThePicture) {
    const std::array cameras{
        pinhole,
        std::string("map u = -0.8 .. 0.8, v = square " + perspective),
        panorama,
        std::string("map u = -180deg .. 180deg, v = -90deg .. 90deg eye point toward sphere(1) "),
        rollout,
        std::string(
            "map u = 4 .. -4, v = square  eye plane(along_u = (0, 1, 0), along_v = (0, 0, 1)) "
            "look absolute  toward point(1, 0, 0) ")};
    for (const std::string& statements : cameras) {
        const Probe one(statements);
        const Probe eye(statements + stereo("0.2, 2", 1.0));
        at_pixels([&](const V2d& at) {
            const V3d moves = one(at).origin_by_x + 2.0 * one(at).direction_by_x;
            EXPECT_GT((eye(at).origin - one(at).origin).dot(moves), 0.0) << statements;
        });
    }
}

TEST(StereoOfAnyCamera, HasExactFootprints) {
    const std::array cameras{
        std::string(pinhole + turns + stereo("0.5, 3", 1.0)),
        std::string(pinhole + turns + stereo("0.5, 3, baseline = picture", 1.0)),
        std::string(panorama + stereo("0.5, 3, merge = (20deg, 50deg)", -1.0)),
        std::string(panorama + turns + stereo("0.5, baseline = level", -1.0)),
        std::string(rollout + stereo("0.5, 2", -1.0)),
        std::string(rollout + "time = t + x  " + stereo("0.5 + 0.1*t, 2 + t", -1.0)),
        std::string(pinhole + stereo("0.5, 3", 1.0) + " lens(radius = 0.1, focus = 5)")};
    constexpr double step = 1e-4;
    for (const std::string& statements : cameras) {
        const Probe probe(statements);
        at_pixels([&](const V2d& at) {
            const Ray ray = probe(at);
            const Ray before = probe({at.x - step, at.y});
            const Ray after = probe({at.x + step, at.y});
            const Ray above = probe({at.x, at.y - step});
            const Ray below = probe({at.x, at.y + step});
            // Central differences err by the third derivatives times step²/6, below 1e-9.
            expect_near((after.origin - before.origin) / (2.0 * step), ray.origin_by_x, 1e-9,
                        statements);
            expect_near((after.direction - before.direction) / (2.0 * step), ray.direction_by_x,
                        1e-9, statements);
            expect_near((below.origin - above.origin) / (2.0 * step), ray.origin_by_y, 1e-9,
                        statements);
            expect_near((below.direction - above.direction) / (2.0 * step), ray.direction_by_y,
                        1e-9, statements);
        });
    }
}

TEST(StereoOfAnyCamera, ChoosesTheBaselineByTheRays) {
    const auto same = [](const std::string& statements, const std::string& baseline) {
        const Probe chosen(statements + stereo("0.2, 2", 1.0));
        const Probe given(statements + stereo("0.2, 2, baseline = " + baseline, 1.0));
        at_pixels([&](const V2d& at) {
            EXPECT_EQ(chosen(at).origin, given(at).origin) << statements << baseline;
            EXPECT_EQ(chosen(at).direction, given(at).direction) << statements << baseline;
        });
    };
    same(pinhole, "fixed");
    same("map u = 70deg .. -70deg, v = square  eye point  toward sphere(1) ", "fixed");
    same("map u = 80deg .. -80deg, v = square  eye point  toward sphere(1) ", "picture");
    same(panorama, "picture");
    same(rollout, "picture");
}

// A camera of a layer and the camera with the statement are the same.
TEST(StereoOfAnyCamera, IsThatOfTheStatement) {
    const camera::Camera one = camera_of("camera a { " + panorama + " }");
    const camera::Camera stated = camera_of("camera a { " + panorama + stereo("", -1.0) + " }");
    const auto added = one.with_stereo(stated.parts().stereo);
    ASSERT_TRUE(added);
    at_pixels(
        [&](const V2d& at) { EXPECT_EQ(Probe(*added)(at).origin, Probe(stated)(at).origin); });
    const auto twice = stated.with_stereo(stated.parts().stereo);
    ASSERT_FALSE(twice);
    EXPECT_EQ(twice.diagnostics.front().message, "camera 'a' is a view of a stereo pair already");
}

}  // namespace balcony::rays::test::stereo_test
