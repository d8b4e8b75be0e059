// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Lenses: the rays of a picture point meet where the focus is, fill the aperture evenly, and blur
// as a thin lens does; and times: what a camera does to t is differentiated with it.

#include <array>
#include <cmath>
#include <functional>
#include <numbers>
#include <string>

#include "support.hpp"

namespace balcony::rays::test::lens_test {
namespace {

using std::numbers::pi;

// A camera's rays at points of the picture and of the lens.
class LensProbe {
public:
    explicit LensProbe(const std::string& text, std::vector<Input> further = {})
        : lens_(compiled(text,
                         {{std::string(camera::lens_input_x), program::Rate::pixel},
                          {std::string(camera::lens_input_y), program::Rate::pixel}},
                         further)),
          central_(compiled(text, {}, {})) {}

    [[nodiscard]] const RayProgram& program() const { return lens_; }
    [[nodiscard]] Ray central(const V2d& point, double time = 0.0) const {
        return run(central_, point, time, {});
    }
    [[nodiscard]] Ray operator()(const V2d& point, const V2d& lens, double time = 0.0,
                                 double further = 0.0) const {
        const std::array<std::span<const double>, 3> inputs{
            std::span(&lens.x, 1), std::span(&lens.y, 1), std::span(&further, 1)};
        return run(lens_, point, time, std::span(inputs).first(lens_inputs_));
    }

private:
    RayProgram compiled(const std::string& text, std::vector<Input> inputs,
                        const std::vector<Input>& further) {
        inputs.insert(inputs.end(), further.begin(), further.end());
        lens_inputs_ = std::max(lens_inputs_, inputs.size());
        auto made = compile(camera_of(text), width, height,
                            {.footprints = true, .points = true, .inputs = inputs});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        return *made;
    }
    static Ray run(const RayProgram& program, const V2d& point, double time,
                   program::InputValues inputs) {
        Scratch scratch;
        RayBatch batch;
        program.run(Points{std::span(&point.x, 1), std::span(&point.y, 1), time, inputs}, scratch,
                    batch);
        return batch[0];
    }

    std::size_t lens_inputs_ = 0;
    RayProgram lens_;
    RayProgram central_;
};

void at_lens(const std::function<void(const V2d& lens)>& check) {
    for (double x = -0.95; x < 1.0; x += 0.38) {
        for (double y = -0.9; y < 1.0; y += 0.45) {
            check({x, y});
        }
    }
}

// How far a line passes from a point.
double distance(const Ray& ray, const V3d& point) {
    return (point - ray.origin).cross(ray.direction).length();
}

const std::string pinhole = "map u = 0.8 .. -0.8, v = square  eye point  toward plane((1, 0, 0)) ";
const std::string normals = "map u = 60deg .. -60deg, v = -1 .. 1  eye cylinder(3) ";

std::string with(const std::string& statements, const std::string& lens) {
    return "camera a { " + statements + lens + " }";
}

}  // namespace

// ---------------------------------------------------------------------------------------- focus

// All rays of a picture point meet where the central ray meets the surface of focus.
TEST(Lens, RaysMeetInFocus) {
    struct Case {
        std::string camera;
        std::function<double(const Ray& central)> distance;
    };
    const V3d target(6.0, 1.0, -0.5);
    const std::vector<Case> cases{
        {with(pinhole, "lens(0.2, 0, 5)"), [](const Ray&) { return 5.0; }},
        {with(pinhole, "lens(0.2, 5, distance(5))"), [](const Ray&) { return 5.0; }},
        {with(normals, "lens(0.2, 6, 4)"), [](const Ray&) { return 4.0; }},
        {with(pinhole, "lens(0.2, 0, flat(5)) move translate(1, 2, 3)"),
         [](const Ray& ray) { return 5.0 / ray.direction.x; }},
        {with(normals, "lens(0.2, 0, at(6, 1, -0.5))"),
         [&](const Ray& ray) { return (target - ray.origin).length(); }},
        {with(pinhole, "lens(0.2, 0, plane((6, 1, -0.5), (1, 0.2, 0)))"),
         [&](const Ray& ray) {
             const V3d normal(1.0, 0.2, 0.0);
             return normal.dot(target - ray.origin) / normal.dot(ray.direction);
         }},
        {with(pinhole, "lens(0.2, 0, plane((6, 1, -0.5)))"),
         [](const Ray& ray) { return 6.0 / ray.direction.x; }},
        {with(normals, "lens(0.2, 0, formula(u, v) = [4 + v])"),
         [](const Ray& ray) { return 4.0 + ray.parameters.y; }},
        {with(pinhole, "lens(0.2, 0, by_direction(x, y, z) = [3/sqrt(x^2 + y^2)])"),
         [](const Ray& ray) { return 3.0 / std::hypot(ray.direction.x, ray.direction.y); }},
    };
    for (const Case& one : cases) {
        const LensProbe probe(one.camera);
        EXPECT_TRUE(probe.program().has_lens());
        at_pixels([&](const V2d& point) {
            const Ray central = probe.central(point);
            ASSERT_TRUE(central.valid) << one.camera;
            const V3d focus = central.origin + one.distance(central) * central.direction;
            at_lens([&](const V2d& lens) {
                const Ray ray = probe(point, lens);
                ASSERT_TRUE(ray.valid) << one.camera;
                EXPECT_LT(distance(ray, focus), rounding) << one.camera;
                EXPECT_NEAR(ray.direction.length(), 1.0, rounding);
                EXPECT_GT((ray.origin - central.origin).length(), 0.01);
                EXPECT_NEAR((ray.origin - central.origin).dot(central.direction), 0.0, rounding);
            });
        });
    }
}

TEST(Lens, FocusesOnAnObjectAtTheDistanceItIsTold) {
    const std::string object = camera::distance_input("Vase");
    const LensProbe probe(with(pinhole, "lens(0.2, 0, on(\"Vase\"))"),
                          {{object, program::Rate::uniform}});
    const V2d point(31.0, 20.0);
    const Ray central = probe.central(point);
    at_lens([&](const V2d& lens) {
        EXPECT_LT(distance(probe(point, lens, 0.0, 7.5), central.origin + 7.5 * central.direction),
                  rounding);
    });
}

TEST(Lens, FocusesAtInfinityWhereThereIsNoDistance) {
    for (const char* focus : {"plane((-5, 0, 0), x)", "formula(u, v) = [-1]",
                              "formula(u, v) = [sqrt(-1 - u^2)]", "formula(u, v) = [0*u]"}) {
        const LensProbe probe(with(pinhole, "lens(0.2, 0, " + std::string(focus) + ")"));
        at_pixels([&](const V2d& point) {
            at_lens([&](const V2d& lens) {
                const Ray ray = probe(point, lens);
                EXPECT_TRUE(ray.valid);
                EXPECT_LT((ray.direction - probe.central(point).direction).length(), rounding);
            });
        });
    }
}

// The thin lens equation: a point at the distance z in front of a lens of radius r that is focused
// at s is blurred to a disc with the radius r |1/s - 1/z| of the picture at distance 1.
TEST(Lens, BlursLikeAThinLens) {
    constexpr double radius = 0.2;
    constexpr double focus = 5.0;
    const LensProbe probe(with(pinhole, "lens(0.2, 0, flat(5))"));
    const V2d middle(0.5 * width, 0.5 * height);
    for (const double z : {2.0, 4.0, 5.0, 8.0, 50.0, 1e6}) {
        for (const V2d& edge : {V2d(1.0, 0.0), V2d(-1.0, -1.0), V2d(0.3, 1.0)}) {
            // At the distance z, the rays of the middle of the picture fill a disc. A ray that
            // starts at z and leaves in the middle of the lens sees it as large as the blur.
            const Ray ray = probe(middle, edge);
            const V3d there = ray.origin + z / ray.direction.x * ray.direction;
            EXPECT_NEAR(std::hypot(there.y, there.z) / z, radius * std::abs(1.0 / focus - 1.0 / z),
                        rounding)
                << z;
        }
    }
}

TEST(Lens, OfRadiusZeroIsAPinhole) {
    const LensProbe none(with(pinhole, ""));
    const LensProbe constant(with(pinhole, "lens(0, 6, 5)"));
    const LensProbe changing(with(pinhole, "lens(0.2*t, 6, 5)"));
    EXPECT_FALSE(constant.program().has_lens());
    EXPECT_EQ(constant.program().instruction_count(), none.program().instruction_count());
    at_pixels([&](const V2d& point) {
        const Ray wanted = none.central(point);
        EXPECT_EQ(constant({point}, {0.5, 0.5}).direction, wanted.direction);
        EXPECT_EQ(constant.central(point).direction_by_x, wanted.direction_by_x);
        EXPECT_EQ(changing.central(point).origin, wanted.origin);
        EXPECT_EQ(changing.central(point).direction, wanted.direction);
        EXPECT_EQ(changing(point, {0.5, 0.5}).origin, wanted.origin);
        EXPECT_LT((changing(point, {0.5, 0.5}).direction - wanted.direction).length(), rounding);
        EXPECT_GT((changing(point, {0.5, 0.5}, 1.0).direction - wanted.direction).length(), 1e-3);
    });
}

// Who declares no inputs of a lens sees the central rays, and pays nothing.
TEST(Lens, CostsNothingWithoutItsInputs) {
    const LensProbe probe(with(pinhole, "lens(0.2, 6, 5)"));
    const LensProbe none(with(pinhole, ""));
    const auto central = compile(camera_of(with(pinhole, "lens(0.2, 6, 5)")), width, height,
                                 {.footprints = true, .points = true});
    EXPECT_EQ(central->instruction_count(), none.program().instruction_count());
    EXPECT_FALSE(central->has_lens());
    at_pixels([&](const V2d& point) {
        EXPECT_EQ(probe.central(point).direction, none.central(point).direction);
        const Ray middle = probe(point, {0.0, 0.0});
        EXPECT_LT((middle.direction - none.central(point).direction).length(), rounding);
        EXPECT_LT((middle.origin - none.central(point).origin).length(), rounding);
    });
}

// ------------------------------------------------------------------------------------- aperture

// The point of the unit aperture, from the origins: the pinhole looks along x, so its right is -y.
V2d aperture_point(const LensProbe& probe, const V2d& lens) {
    const V2d middle(0.5 * width, 0.5 * height);
    const V3d offset = probe(middle, lens).origin - probe.central(middle).origin;
    return {-offset.y / 0.2, offset.z / 0.2};
}

TEST(Aperture, IsADiscOrAPolygonWithACornerAtTheTop) {
    for (const int blades : {0, 3, 5, 6, 64}) {
        const LensProbe probe(with(pinhole, "lens(0.2, " + std::to_string(blades) + ", 5)"));
        double largest = 0.0;
        double top = 0.0;
        for (double x = -1.0; x <= 1.0; x += 0.0625) {
            for (double y = -1.0; y <= 1.0; y += 0.0625) {
                const V2d p = aperture_point(probe, {x, y});
                largest = std::max(largest, p.length());
                top = std::max(top, p.y);
                EXPECT_LE(p.length(), 1.0 + rounding);
                for (int side = 0; side < blades; ++side) {
                    // The middle of a side is half a step from the corner at the top.
                    const double middle = pi / 2.0 + 2.0 * pi * (side + 0.5) / blades;
                    EXPECT_LE(p.x * std::cos(middle) + p.y * std::sin(middle),
                              std::cos(pi / blades) + rounding)
                        << blades;
                }
                // The border of the square is the border of the aperture.
                if (blades == 0 && std::max(std::abs(x), std::abs(y)) == 1.0) {
                    EXPECT_NEAR(p.length(), 1.0, rounding);
                }
            }
        }
        EXPECT_NEAR(top, 1.0, rounding) << blades;
        EXPECT_NEAR(largest, 1.0, rounding) << blades;
    }
}

TEST(Aperture, TurnsByItsRotation) {
    const LensProbe upright(with(pinhole, "lens(0.2, 3, 5)"));
    const LensProbe turned(with(pinhole, "lens(0.2, 3, 5, rotation = 30deg)"));
    at_lens([&](const V2d& lens) {
        const V2d p = aperture_point(upright, lens);
        const V2d q = aperture_point(turned, lens);
        EXPECT_NEAR(q.x, p.x * std::cos(pi / 6.0) - p.y * 0.5, rounding);
        EXPECT_NEAR(q.y, p.x * 0.5 + p.y * std::cos(pi / 6.0), rounding);
    });
}

// Parts of the square of equal area become parts of the aperture of equal area: a quarter of the
// area of the aperture for each unit.
TEST(Aperture, IsFilledEvenly) {
    for (const int blades : {0, 3, 6}) {
        const LensProbe probe(with(pinhole, "lens(0.2, " + std::to_string(blades) + ", 5)"));
        const double area = blades == 0 ? pi : 0.5 * blades * std::sin(2.0 * pi / blades);
        constexpr double step = 1e-4;
        for (double x = -0.93; x < 1.0; x += 0.113) {
            for (double y = -0.91; y < 1.0; y += 0.127) {
                const V2d by_x =
                    aperture_point(probe, {x + step, y}) - aperture_point(probe, {x - step, y});
                const V2d by_y =
                    aperture_point(probe, {x, y + step}) - aperture_point(probe, {x, y - step});
                // Second differences of a map with derivatives of a few units.
                EXPECT_NEAR(std::abs(by_x.x * by_y.y - by_x.y * by_y.x) / (4.0 * step * step),
                            area / 4.0, 100.0 * step)
                    << blades << ' ' << x << ' ' << y;
            }
        }
    }
}

// The aperture keeps its orientation in the picture: its x axis points along picture x, and its y
// axis upwards, in a panorama, with normals, and where only origins move.
TEST(Aperture, TurnsWithTheRay) {
    const std::vector<std::string> cameras{
        with("map u = 170deg .. -170deg, v = -60deg .. 60deg  eye point  toward sphere(1) ",
             "lens(0.2, 0, 5)"),
        with(normals, "lens(0.2, 0, 5)"),
        with("map u = 2 .. -2, v = square  eye plane  look along(x) ", "lens(0.2, 0, 5)")};
    for (const std::string& text : cameras) {
        const LensProbe probe(text);
        at_pixels([&](const V2d& point) {
            const Ray central = probe.central(point);
            const V3d right_edge = probe(point, {1.0, 0.0}).origin - central.origin;
            const V3d top_edge = probe(point, {0.0, 1.0}).origin - central.origin;
            const auto focus = [&](const V2d& p) {
                const Ray ray = probe.central(p);
                return ray.origin + 5.0 * ray.direction;
            };
            const V3d right = focus(point + V2d(0.01, 0.0)) - focus(point - V2d(0.01, 0.0));
            const V3d up = focus(point - V2d(0.0, 0.01)) - focus(point + V2d(0.0, 0.01));
            // The difference of neighbours turns the vector by its square.
            EXPECT_NEAR(right_edge.dot(right), 0.2 * right.length(), 1e-6) << text;
            EXPECT_NEAR(right_edge.dot(top_edge), 0.0, rounding) << text;
            EXPECT_GT(top_edge.dot(up), 0.19 * up.length()) << text;
        });
    }
}

TEST(Aperture, HasADirectionWhereTheRayDoesNotMove) {
    // At the pole of this sphere nothing moves along picture x.
    const LensProbe probe(
        with("map u = 180deg .. -180deg, v = -90deg .. 90deg  eye point  toward sphere(1) ",
             "lens(0.2, 0, 5)"));
    const Ray ray = probe({80.0, 0.0}, {1.0, 0.0});
    EXPECT_TRUE(ray.valid);
    EXPECT_NEAR((ray.origin - probe.central({80.0, 0.0}).origin).length(), 0.2, rounding);
}

// The footprint is that of the central ray in the sharp point, whichever point of the lens a ray
// passes through.
TEST(Lens, HasTheFootprintOfTheCentralRayInFocus) {
    for (const std::string& text :
         {with(pinhole, "lens(0.2, 0, flat(5))"), with(normals, "lens(0.2, 0, 4)")}) {
        const LensProbe probe(text);
        at_pixels([&](const V2d& point) {
            at_lens([&](const V2d& lens) {
                const Ray central = probe.central(point);
                const Ray ray = probe(point, lens);
                const double s =
                    text.find("flat") != std::string::npos ? 5.0 / central.direction.x : 4.0;
                const V3d focus = central.origin + s * central.direction;
                const double length = (focus - ray.origin).length();
                // Where the rays of the next pixel meet the sharp surface, without what is along
                // the ray.
                const auto across = [&](const V3d& a) {
                    return a - a.dot(ray.direction) * ray.direction;
                };
                const auto sharp = [&](const V2d& p) {
                    const Ray other = probe.central(p);
                    const double t =
                        text.find("flat") != std::string::npos ? 5.0 / other.direction.x : 4.0;
                    return other.origin + t * other.direction;
                };
                constexpr double step = 1e-3;
                const V3d wanted =
                    (sharp(point + V2d(step, 0.0)) - sharp(point - V2d(step, 0.0))) / (2.0 * step);
                EXPECT_LT((across(ray.origin_by_x + length * ray.direction_by_x) - across(wanted))
                              .length(),
                          1e-8)
                    << text;
            });
        });
    }
}

// ----------------------------------------------------------------------------------------- time

TEST(RayTime, ReplacesTInTheFormulasOfTheCamera) {
    const LensProbe probe(
        "camera a { map u = 0.8 .. -0.8, v = square  eye point(3*t, 0, 0) "
        "toward plane((1, 0, 0)) look absolute  time = t + 2*x - y/4 }");
    at_pixels([&](const V2d& point) {
        const double time = 7.0 + 2.0 * point.x / width - point.y / height / 4.0;
        const Ray ray = probe.central(point, 7.0);
        ASSERT_TRUE(ray.valid);
        ASSERT_TRUE(ray.time.has_value());
        EXPECT_NEAR(*ray.time, time, rounding);
        EXPECT_NEAR(ray.origin.x, 3.0 * time, rounding);
    });
}

// The chain rule: a pixel further, both the point of the picture and the time are others.
TEST(RayTime, IsDifferentiatedWithTheRay) {
    const LensProbe probe(
        "camera a { map u = 0.8 .. -0.8, v = square  eye point(sin(t), 0, 0) "
        "toward plane((1, 0, 0))  move rotate(z, 40deg*t)  time = t + x^2 + y }");
    constexpr double step = 1e-3;
    at_pixels([&](const V2d& point) {
        const Ray ray = probe.central(point, 1.0);
        const Ray right = probe.central(point + V2d(step, 0.0), 1.0);
        const Ray left = probe.central(point - V2d(step, 0.0), 1.0);
        const Ray below = probe.central(point + V2d(0.0, step), 1.0);
        const Ray above = probe.central(point - V2d(0.0, step), 1.0);
        // Central differences of derivatives per pixel of at most 0.1: step² 0.1³ / 6.
        EXPECT_LT((ray.origin_by_x - (right.origin - left.origin) / (2.0 * step)).length(), 1e-9);
        EXPECT_LT((ray.direction_by_x - (right.direction - left.direction) / (2.0 * step)).length(),
                  1e-9);
        EXPECT_LT((ray.origin_by_y - (below.origin - above.origin) / (2.0 * step)).length(), 1e-9);
        EXPECT_LT(
            (ray.direction_by_y - (below.direction - above.direction) / (2.0 * step)).length(),
            1e-9);
    });
}

TEST(RayTime, IsThatOfTheRunWithoutAFormula) {
    const LensProbe probe(with(pinhole, ""));
    EXPECT_FALSE(probe.central({10.5, 10.5}).time.has_value());
    EXPECT_FALSE(probe.program().has_times());
}

TEST(RayTime, CoversAnInterval) {
    const auto times = [](const std::string& text) {
        const auto found = ray_times(camera_of(text), {1.0, 1.5});
        EXPECT_TRUE(found) << to_text(found.diagnostics);
        return std::array{found->first, found->last};
    };
    EXPECT_EQ(times(with(pinhole, "")), (std::array{1.0, 1.5}));
    EXPECT_EQ(times(with(pinhole, "time = t + 8*x - 4*y")), (std::array{-3.0, 9.5}));
    EXPECT_EQ(times(with(pinhole, "time = 2 + x")), (std::array{1.0, 3.0}));
    EXPECT_NEAR(times(with(pinhole, "time = 1/x"))[1], 455.0, 1e-9);  // 455 pixels wide
}

TEST(RayTime, CoversAnIntervalWithOpenParameters) {
    const auto text = std::make_shared<const SourceText>(
        "text",
        "camera seen(duration = 2) {\n    map u = 1 .. -1, v = square\n    eye point(0, 0, 0)\n"
        "    toward plane((1, 0, 0))\n    time = t + x*duration\n}\n");
    const auto opened = lang::Workspace().make_open_picture(text, "seen");
    ASSERT_TRUE(opened) << to_text(opened.diagnostics);
    const auto found = ray_times(opened->picture, {1.0, 1.5});
    ASSERT_TRUE(found) << to_text(found.diagnostics);
    EXPECT_EQ((std::array{found->first, found->last}), (std::array{1.0, 3.5}));
}

TEST(RayTime, HasNoRayWhereItIsNotFinite) {
    const LensProbe probe(with(pinhole, "time = 1/(x - 0.5)"));
    EXPECT_FALSE(probe.central({0.5 * width, 10.5}).valid);
    EXPECT_TRUE(probe.central({0.25 * width, 10.5}).valid);
}

TEST(RayTime, KeepsTheRateOfItsPoint) {
    // Rows of a rolling shutter: what depends on t runs once in each row.
    const auto made = compile(
        camera_of("camera a { map u = 0.8 .. -0.8, v = square  eye point(sin(t), cos(t), exp(t)) "
                  "toward plane((1, 0, 0)) look absolute  time = t + 0.02*y }"),
        width, height, {});
    ASSERT_TRUE(made);
    Scratch scratch;
    RayBatch batch;
    made->run(Tile{0.5, 0.5, 1.0, 4, 3, 0.0}, scratch, batch);
    for (std::size_t row = 0; row < 3; ++row) {
        for (std::size_t i = 0; i < 4; ++i) {
            EXPECT_EQ(batch.time(4 * row + i), batch.time(4 * row));
            EXPECT_EQ(batch.origin(4 * row + i), batch.origin(4 * row));
        }
        EXPECT_NEAR(batch.time(4 * row), 0.02 * (static_cast<double>(row) + 0.5) / height,
                    rounding);
    }
}

}  // namespace balcony::rays::test::lens_test
