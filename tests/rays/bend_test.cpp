// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Bent rays: curves by formulas, paths in fields against their closed forms, chains of pinholes;
// the straight parts, their lengths, tolerances and derivatives.

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::rays::test::bend_test {
namespace {

const std::string pinhole =
    "map u = 0.8 .. -0.8, v = square  eye point  toward plane((1, 0, 0))  "
    "move translate(1, 2, 3)  ";

std::string with(const std::string& bend, const std::string& camera = pinhole) {
    return "camera a { " + camera + bend + " }";
}

// The rays of a camera with their parts.
class BentRays {
public:
    explicit BentRays(const std::string& text, CompileOptions options = {})
        : program_(compiled(text, options)) {}

    const RayBatch& at(const V2d& point) {
        program_.run(Points{{&point.x, 1}, {&point.y, 1}, 0.0}, scratch_, batch_);
        return batch_;
    }

    // Origin, knots.
    std::vector<V3d> knots(const V2d& point) {
        at(point);
        std::vector<V3d> found;
        for (std::size_t k = 0; k < batch_.part_count(); ++k) {
            found.push_back(batch_.part(0, k).origin);
        }
        return found;
    }
    V3d last_direction(const V2d& point) {
        at(point);
        return batch_.part(0, batch_.part_count() - 1).direction;
    }

private:
    static RayProgram compiled(const std::string& text, CompileOptions options) {
        options.points = true;
        options.bends = true;
        Result<RayProgram> made = compile(camera_of(text), width, height, options);
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return std::move(*made);
    }

    RayProgram program_;
    Scratch scratch_;
    RayBatch batch_;
};

Ray straight(const V2d& point, const std::string& camera = pinhole) {
    return BentRays(with("", camera)).at(point)[0];
}

double distance_from(const std::vector<V3d>& polyline, const V3d& p) {
    double nearest = 1e300;
    for (std::size_t i = 0; i + 1 < polyline.size(); ++i) {
        const V3d way = polyline[i + 1] - polyline[i];
        const double part = std::clamp((p - polyline[i]).dot(way) / way.length2(), 0.0, 1.0);
        nearest = std::min(nearest, (p - polyline[i] - part * way).length());
    }
    return nearest;
}

std::string messages_of(const std::string& text) {
    const auto made = lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "");
    return to_text(made.diagnostics);
}

}  // namespace

// --------------------------------------------------------------------------------------- curves

TEST(Bend, AStraightCurveIsTheRay) {
    BentRays rays(
        with("bend curve(point(s, x, y, z, dx, dy, dz) = "
             "[x + 5*s*dx, y + 5*s*dy, z + 5*s*dz])"));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point);
        const RayBatch& bent = rays.at(point);
        ASSERT_EQ(bent.part_count(), 2U);
        ASSERT_TRUE(bent.valid(0));
        EXPECT_LT((bent.part(0, 0).origin - exact.origin).length(), rounding);
        EXPECT_LT((bent.part(0, 0).direction - exact.direction).length(), rounding);
        EXPECT_NEAR(bent.part(0, 0).length, 5.0, rounding);
        EXPECT_LT((bent.part(0, 1).origin - exact.origin - 5.0 * exact.direction).length(),
                  rounding);
        EXPECT_LT((bent.part(0, 1).direction - exact.direction).length(), rounding);
        EXPECT_TRUE(std::isinf(bent.part(0, 1).length));
    });
}

// All that a formula can depend on arrives at its place.
TEST(Bend, AFormulaKnowsTheRayAndThePicture) {
    BentRays rays(
        with("bend curve(point(s, x, y, z, dx, dy, dz, u, v, px, py) = "
             "[x + s*u, y + s*v + s*px, z + s*py + s*dx], parts = 1)"));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point);
        const V3d end(exact.parameters.x, exact.parameters.y + point.x / width,
                      point.y / height + exact.direction.x);
        EXPECT_LT((rays.knots(point)[1] - exact.origin - end).length(), rounding);
    });
}

// The straight parts are within the tolerance of the parabola, and their number is about the least:
// with half of it the chords are farther away, L g / (8 n²) here.
TEST(Bend, PartsAreWithinTheirTolerance) {
    const std::string parabola =
        "bend curve(point(s, x, y, z, dx, dy, dz) = "
        "[x + 10*s*dx, y + 10*s*dy, z + 10*s*dz - 3*s^2], tolerance = {})";
    for (const double tolerance : {0.1, 0.01, 0.0001}) {
        BentRays rays(with(fmt::format(fmt::runtime(parabola), tolerance)));
        at_pixels([&](const V2d& point) {
            const Ray exact = straight(point);
            const std::vector<V3d> knots = rays.knots(point);
            for (int i = 0; i <= 1000; ++i) {
                const double s = i / 1000.0;
                const V3d p = exact.origin + 10.0 * s * exact.direction - V3d(0, 0, 3.0 * s * s);
                EXPECT_LT(distance_from(knots, p), tolerance);
            }
            const auto parts = static_cast<double>(knots.size() - 1);
            EXPECT_LT(parts, 2.0 * std::ceil(std::sqrt(6.0 / (8.0 * tolerance))));
            const V3d tangent = 10.0 * exact.direction - V3d(0.0, 0.0, 6.0);
            EXPECT_LT((rays.last_direction(point) - tangent.normalized()).length(), rounding);
        });
    }
}

// Sampled at too few places, this curve looks straight.
TEST(Bend, ACurveToAndFroIsNoticed) {
    BentRays rays(with("bend curve(point(s, x, y, z) = [x + 4*s, y + sin(360deg*s), z])"));
    EXPECT_GT(rays.knots({80.0, 45.0}).size(), 16U);
}

// The derivatives of a part are those of its origin and its unit direction.
TEST(Bend, PartsHaveFootprints) {
    for (const std::string& bend :
         {std::string("bend curve(point(s, x, y, z, dx, dy, dz, u) = "
                      "[x + 10*s*dx, y + 10*s*dy, z + 10*s*dz - 3*s^2*u], parts = 3)"),
          std::string("bend field(at(x, y, z) = [1 + 0.3*exp(-((x-3)^2 + (y-2)^2 + z^2))], "
                      "length = 8, parts = 8)"),
          std::string("bend pinholes([(6, 2, 3), (6, 9, 3), (0, 9, 5)], rounding = 1, "
                      "tolerance = 0.05)")}) {
        BentRays rays(with(bend), {.footprints = true});
        const V2d point(63.0, 38.0);
        constexpr double step = 1e-4;
        const std::size_t count = rays.at(point).part_count();
        for (std::size_t k = 0; k < count; ++k) {
            const Ray exact = rays.at(point).ray_of_part(0, k);
            if (rays.at(point).part(0, k).length < 1e-9) {
                continue;
            }
            const auto slope = [&](const V2d& way, auto member) {
                const auto after = member(rays.at(point + step * way).part(0, k));
                return (after - member(rays.at(point - step * way).part(0, k))) / (2.0 * step);
            };
            const auto origin = [](const RayBatch::Part& part) { return part.origin; };
            const auto direction = [](const RayBatch::Part& part) { return part.direction; };
            // Differences lose the square of the step, and roundings divided by it.
            EXPECT_LT((slope({1, 0}, origin) - exact.origin_by_x).length(), 1e-7) << bend << k;
            EXPECT_LT((slope({0, 1}, origin) - exact.origin_by_y).length(), 1e-7) << bend << k;
            EXPECT_LT((slope({1, 0}, direction) - exact.direction_by_x).length(), 1e-7) << bend;
            EXPECT_LT((slope({0, 1}, direction) - exact.direction_by_y).length(), 1e-7) << bend;
            EXPECT_GT(exact.direction_by_x.length() + exact.origin_by_x.length(), 1e-4);
        }
    }
}

// --------------------------------------------------------------------------------------- fields

// Runge-Kutta's method is exact for a constant acceleration, and so is the cubic between its steps.
TEST(BendField, GravityMakesParabolas) {
    BentRays rays(with("bend field(at(x, y, z) = [0, 0, -0.06], length = 10, parts = 8)"));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point);
        const std::vector<V3d> knots = rays.knots(point);
        for (std::size_t i = 0; i < knots.size(); ++i) {
            const double s = 10.0 * static_cast<double>(i) / 8.0;
            const V3d p = exact.origin + s * exact.direction - V3d(0.0, 0.0, 0.03 * s * s);
            EXPECT_LT((knots[i] - p).length(), rounding);
        }
    });
}

// Where the index is 1/z, rays are arcs of circles around points of the plane z = 0.
TEST(BendField, AnIndexOfOneByHeightMakesCircles) {
    const std::string camera =
        "map u = 0.4 .. -0.4, v = square  eye point  toward plane((1, 0, 0))  "
        "move translate(0, 0, 2)  ";
    BentRays rays(
        with("bend field(at(x, y, z) = [1/z], length = 1.5, tolerance = 0.00001)", camera));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point, camera);
        // In the upright plane of the ray, the centre is at the foot of the normal of the ray.
        const V3d level = V3d(exact.direction.x, exact.direction.y, 0.0).normalized();
        const double rise = exact.direction.z / exact.direction.dot(level);
        const V3d centre = V3d(exact.origin.x, exact.origin.y, 0.0) + 2.0 * rise * level;
        const double radius = (exact.origin - centre).length();
        for (const V3d& knot : rays.knots(point)) {
            EXPECT_NEAR((knot - centre).length(), radius, 1e-5);
        }
    });
}

// Maxwell's fish-eye images each point of its unit sphere at the opposite one, along circles. The
// way from pole to pole along the circle with the centre at distance c is that of an arc of it.
double fish_eye_error(std::size_t parts, double angle) {
    const double tilt = std::tan(angle);  // The centre is at (0, -tilt) beside the axis.
    const double radius = std::hypot(1.0, tilt);
    const double length = 2.0 * radius * std::atan2(1.0, tilt);
    const std::string camera = fmt::format(
        "map u = -1 .. 1, v = -1 .. 1  eye point  "
        "toward surface(u, v) = [{:.17g}, {:.17g}, 0.0001*u + 0.0001*v]  move translate(-1, 0, 0) "
        " ",
        std::sin(angle), std::cos(angle));
    BentRays rays(with(fmt::format("bend field(at(x, y, z) = [2/(1 + x^2 + y^2 + z^2)], "
                                   "length = {:.17g}, parts = {})",
                                   length, parts),
                       camera));
    return (rays.knots({0.5 * width, 0.5 * height}).back() - V3d(1.0, 0.0, 0.0)).length();
}

TEST(BendField, TheFishEyeOfMaxwellImagesAPointAtTheOppositeOne) {
    for (const double angle : {0.4, 0.8, 1.2}) {
        // Four parts a step; the order of the method is 4.
        const double coarse = fish_eye_error(64, angle);
        const double fine = fish_eye_error(128, angle);
        EXPECT_LT(fine, 2e-6) << angle;
        EXPECT_NEAR(std::log2(coarse / fine), 4.0, 0.4) << angle << ": " << coarse << ", " << fine;
    }
}

// Luneburg's lens: parallel rays that enter the unit sphere meet at the point of it behind.
TEST(BendField, TheLensOfLuneburgFocusesParallelRays) {
    const std::string camera =
        "map u = -0.7 .. 0.7, v = -0.5 .. 0.5  eye surface(u, v) = [-2, u, v]  "
        "look along((1, 0, 0))  ";
    const auto miss = [&](std::size_t parts) {
        BentRays rays(with(fmt::format("bend field(at(x, y, z) = "
                                       "[sqrt(max(2 - x^2 - y^2 - z^2, 1))], length = 5, "
                                       "parts = {})",
                                       parts),
                           camera));
        double farthest = 0.0;
        at_pixels([&](const V2d& point) {
            farthest = std::max(farthest, distance_from(rays.knots(point), V3d(1.0, 0.0, 0.0)));
        });
        return farthest;
    };
    // A step h across the sphere, where the gradient jumps by up to 1, is wrong by up to h²/2, and
    // the focus is up to 2 units behind it. Four parts are a step.
    const double step = 5.0 / 32.0;
    EXPECT_LT(miss(128), step * step);
}

// ------------------------------------------------------------------------------------- pinholes

// Behind a corner, rays come from the next pinhole; both meet in the plane that halves the angle.
TEST(BendPinholes, RaysTurnInTheMitrePlane) {
    const std::string camera =
        "map u = 0.3 .. -0.3, v = square  eye point  toward plane((1, 0, 0))  "
        "move translate(1, 2, 3)  ";
    BentRays rays(
        with("bend pinholes([(7, 2, 3), (7, 12, 3), (-2, 12, 3)], distance = 2)", camera));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point, camera);
        const RayBatch& bent = rays.at(point);
        ASSERT_EQ(bent.part_count(), 3U);
        EXPECT_LT((bent.part(0, 0).direction - exact.direction).length(), rounding);
        const V3d first = bent.part(0, 1).origin;
        EXPECT_NEAR((first - V3d(7, 2, 3)).dot(V3d(1, 1, 0)), 0.0, rounding);
        const V3d second_pinhole(7.0, 2.0 - 2.0 * 6.0, 3.0);
        EXPECT_LT((bent.part(0, 1).direction - (first - second_pinhole).normalized()).length(),
                  rounding);
        const V3d second = bent.part(0, 2).origin;
        EXPECT_NEAR((second - V3d(7, 12, 3)).dot(V3d(-1, 1, 0)), 0.0, 4.0 * rounding);
        const V3d third_pinhole(7.0 + 2.0 * (12.0 - second_pinhole.y), 12.0, 3.0);
        EXPECT_LT((bent.part(0, 2).direction - (second - third_pinhole).normalized()).length(),
                  rounding);
    });
}

// A ray that leaves the way before a corner stays straight.
TEST(BendPinholes, RaysThatMissACornerAreStraight) {
    const std::string camera =
        "map u = 250deg .. 150deg, v = -0.5 .. 0.5  eye point  toward cylinder(1)  ";
    BentRays rays(with("bend pinholes([(7, 0, 0), (7, 10, 0)], rounding = 2)", camera));
    at_pixels([&](const V2d& point) {
        const Ray exact = straight(point, camera);
        const RayBatch& bent = rays.at(point);
        for (std::size_t k = 0; k + 1 < bent.part_count(); ++k) {
            EXPECT_EQ(bent.part(0, k).length, 0.0);
        }
        const RayBatch::Part last = bent.part(0, bent.part_count() - 1);
        EXPECT_LT((last.origin - exact.origin).length(), rounding);
        EXPECT_LT((last.direction - exact.direction).length(), rounding);
    });
}

// Where the planes of two corners cross, in the left of this picture, and where rays begin to miss
// a plane, in the right: from pixel to pixel, all that is nearer than 60 moves by small steps,
// which are as much smaller as the pixels are.
TEST(BendPinholes, PicturesHaveNoCut) {
    BentRays rays(
        with("bend pinholes([(7, 2, 3), (7, 6, 3), (-9, 6, 3)], rounding = 1, "
             "tolerance = 0.1)",
             "map u = 1.6 .. -1.6, v = square  eye point  toward plane((1, 0, 0))  "
             "move translate(1, 2, 3)  "));
    const auto point_at = [&](double x, double length) {
        const RayBatch& bent = rays.at({x, 31.0});
        for (std::size_t k = 0;; ++k) {
            const RayBatch::Part part = bent.part(0, k);
            if (length <= part.length) {
                return part.length > 0.0 ? part.origin + length * part.direction : part.origin;
            }
            length -= part.length;
        }
    };
    for (const double step : {0.1, 0.01}) {
        double longest = 0.0;
        for (double x = 1.0; x < width - 1.0; x += step) {
            for (const double length : {3.0, 10.0, 30.0, 60.0}) {
                longest =
                    std::max(longest, (point_at(x + step, length) - point_at(x, length)).length());
            }
        }
        EXPECT_LT(longest, 25.0 * step);
    }
}

// Rounded corners begin and end at the same distance from the sharp one, whose directions they
// have there.
TEST(BendPinholes, RoundingIsTangentToBothWays) {
    const std::string corners = "[(7, 2, 3), (7, 12, 3)]";
    BentRays sharp(with("bend pinholes(" + corners + ")"));
    BentRays round(with("bend pinholes(" + corners + ", rounding = 1.5, tolerance = 0.001)"));
    at_pixels([&](const V2d& point) {
        const std::vector<V3d> straight = sharp.knots(point);
        const V3d in = sharp.at(point).part(0, 0).direction;
        const V3d out = sharp.last_direction(point);
        const std::vector<V3d> knots = round.knots(point);
        EXPECT_LT((knots[1] - (straight[1] - 1.5 * in)).length(), rounding);
        EXPECT_LT((knots.back() - (straight[1] + 1.5 * out)).length(), rounding);
        for (int i = 0; i <= 100; ++i) {
            const double t = i / 100.0;
            const V3d p = straight[1] - 1.5 * (1.0 - t) * (1.0 - t) * in + 1.5 * t * t * out;
            EXPECT_LT(distance_from(knots, p), 0.001);
        }
        const double turn = (knots.back() - knots[knots.size() - 2]).normalized().dot(out);
        EXPECT_GT(turn, 0.995);
    });
}

// ------------------------------------------------------------------------- with other statements

TEST(Bend, FollowsTheTimeOfItsRays) {
    const std::string falling =
        "bend curve(point(s, x, y, z) = [x + 4*s, y, z - t*s], parts = 1)  ";
    BentRays rays(with(falling + "time = 2*x"));
    const V2d point(40.0, 45.0);
    const std::vector<V3d> knots = rays.knots(point);
    EXPECT_NEAR(knots[1].z - knots[0].z, -2.0 * point.x / width, rounding);
}

TEST(Bend, TurnsWithItsCamera) {
    const camera::Camera camera =
        camera_of(with("bend pinholes([(7, 2, 3), (7, 12, 3)], rounding = 1)"));
    camera::Turn turn;
    turn.angle = camera::Scalar(0.5, camera::Unit::angle);
    const auto rays_of = [](const camera::Camera& one) {
        RayBatch batch;
        Scratch scratch;
        const auto program = compile(one, width, height, {.tiles = true, .bends = true});
        program->run(Tile{20.5, 30.5, 1.0, 1, 1}, scratch, batch);
        return batch;
    };
    const RayBatch before = rays_of(camera);
    const RayBatch after = rays_of(camera.with_turn(turn));
    const auto turned = [](const V3d& v) {
        const double c = std::cos(0.5);
        const double s = std::sin(0.5);
        return V3d(c * v.x - s * v.y, s * v.x + c * v.y, v.z);
    };
    ASSERT_GT(before.part_count(), 3U);
    for (std::size_t k = 0; k < before.part_count(); ++k) {
        EXPECT_LT((turned(before.part(0, k).origin) - after.part(0, k).origin).length(), 1e-11);
        EXPECT_LT((turned(before.part(0, k).direction) - after.part(0, k).direction).length(),
                  1e-11);
    }
}

TEST(Bend, ComesInTheRequestedAxes) {
    const std::string text = with("bend pinholes([(7, 2, 3), (7, 12, 4)])");
    BentRays own(text);
    BentRays other(text, {.axes = Axes::y_up});
    const V2d point(50.0, 20.0);
    const V3d knot = own.knots(point)[1];
    EXPECT_LT((other.knots(point)[1] - V3d(knot.x, knot.z, -knot.y)).length(), rounding);
    const V3d last = own.last_direction(point);
    EXPECT_LT((other.last_direction(point) - V3d(last.x, last.z, -last.y)).length(), rounding);
}

// ---------------------------------------------------------------------------------- bad cameras

TEST(Bend, IsAnErrorWhereOnlyStraightRaysAreTaken) {
    const auto made =
        compile(camera_of(with("bend pinholes([(7, 2, 3), (7, 12, 3)])")), width, height, {});
    ASSERT_FALSE(made);
    EXPECT_NE(to_text(made.diagnostics).find("the rays of camera 'a' are bent"), std::string::npos);
}

TEST(Bend, MistakesAreNamedAtTheirRow) {
    struct Case {
        std::string bend;
        std::string message;
    };
    const std::vector<Case> cases{
        {"bend curve(point(s, x, y, z) = [x + s, y, z + log(-1 - s)])", "no path for any ray"},
        {"bend curve(point(s, x, y, z) = [x, y, z])", "no path for any ray"},
        {"bend curve(point(s, x, y, z) = [x + s, y + sin(100000deg*s), z], tolerance = 0.0001)",
         "more than 256 straight parts"},
        {"bend curve(point() = [0, 0, 0])", "1 to 11 parameters"},
        {"bend field(at(x, y, z) = [x, y], length = 1)", "a field has 1 result"},
        {"bend field(at(x, y, z) = [-1], length = 1)", "is not positive"},
        {"bend field(at(x, y, z) = [log(-1 - x^2)], length = 1)", "no path for any ray"},
        // An orbit without end.
        {"bend field(at(x, y, z) = [-4*(x - 1), -4*(y - 3), -4*(z - 3)], length = 200)",
         "more than 256 straight parts"},
        {"bend field(at(x, y, z) = [1])", "length"},
        {"bend pinholes([(7, 2, 3)])", "2"},
        {"bend pinholes([(7, 2, 3), (7, 2, 3)])", "corner 1 of this bend has no direction"},
        {"bend pinholes([(7, 2, 3), (1, 2, 3)])", "turns straight back"},
        {"bend pinholes([(7, 2, 3), (7, 9, 3)], rounding = 1, tolerance = 0.000001)",
         "a bend has at most 256"},
        {"bend pinholes([(7, 2, 3), (7, 9, 3)])  lens(radius = 0.1, focus = 2)", "has a lens"},
    };
    for (const Case& one : cases) {
        const std::string text = messages_of(with(one.bend));
        EXPECT_NE(text.find(one.message), std::string::npos) << one.bend << "\n" << text;
        EXPECT_NE(text.find("bend "), std::string::npos) << one.bend << "\n" << text;
    }
}

TEST(Bend, AMorphOfRaysRefusesIt) {
    const std::string text = messages_of("camera a { " + pinhole +
                                         "bend pinholes([(7, 2, 3), (7, 12, 3)]) } camera b { " +
                                         pinhole + "} camera c { morph a .. b, amount = 0.5 }");
    EXPECT_NE(text.find("the rays of 'a' are bent"), std::string::npos) << text;
}

}  // namespace balcony::rays::test::bend_test
