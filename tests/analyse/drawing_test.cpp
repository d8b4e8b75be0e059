// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Drawings of cameras: the required contents of the page, independent of its design.

#include "balcony/drawing.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "../laws/built_in_cameras.hpp"
#include "analyse/draw/camera_geometry.hpp"
#include "support.hpp"

namespace balcony::analyse::drawing_test {
namespace {

const char* const ball = R"(camera ball {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  sphere(2)
    look normal
})";

// The left half of the picture lies 10 above the right half.
const char* const torn = R"(camera torn {
    aspect 1
    map  u = 1 .. -1, v = -1 .. 1
    eye  surface(u, v) = [v, u, if(u > 0.03, 10, 0)]
    look normal
})";

const char* const half = R"(camera half {
    aspect 1
    map  u = 1 .. -1, v = -1 .. 1
    eye  surface(u, v) = [v, u, sqrt(u - 0.03)]
    look normal
})";

Drawing drawn(const std::string& text, const Depiction& depiction = {},
              const DrawingView& view = {}) {
    auto drawing = draw(test::camera_of(text), depiction, view);
    EXPECT_TRUE(drawing) << to_text(drawing.diagnostics);
    return drawing ? std::move(*drawing) : Drawing{};
}

std::size_t count(const Drawing& drawing, DrawingPart part) {
    return static_cast<std::size_t>(
        std::count_if(drawing.shapes.begin(), drawing.shapes.end(),
                      [part](const DrawingShape& shape) { return shape.part == part; }));
}

TEST(Drawing, OfEveryBuiltInCameraIsOnThePage) {
    for (const std::string& name : laws::single_built_in_cameras()) {
        const auto drawing = draw(test::standard(name));
        ASSERT_TRUE(drawing) << name;
        EXPECT_GT(drawing->shapes.size(), 100U) << name;
        for (const DrawingShape& shape : drawing->shapes) {
            ASSERT_FALSE(shape.points.empty()) << name;
            for (const V2d& point : shape.points) {
                // Letters may reach into the margin, so the page itself is the bound.
                ASSERT_TRUE(point.x >= 0.0 && point.x <= 960.0 && point.y >= 0.0 &&
                            point.y <= 720.0)
                    << name << ' ' << point;
            }
        }
        // The limit of pictures in docs.
        EXPECT_LT(to_svg(*drawing).size(), 300'000U) << name;
    }
}

TEST(Drawing, FillsThePageInOneDirection) {
    double left = 1e9, right = -1e9, top = 1e9, bottom = -1e9;
    for (const DrawingShape& shape : drawn(ball, {.axes = false}).shapes) {
        for (const V2d& point : shape.points) {
            left = std::min(left, point.x);
            right = std::max(right, point.x);
            top = std::min(top, point.y);
            bottom = std::max(bottom, point.y);
        }
    }
    constexpr double margin = 26.0;
    // Thinned outlines may miss their extreme point by a tenth of a pixel.
    EXPECT_NEAR(std::max((right - left) / (960 - 2 * margin), (bottom - top) / (720 - 2 * margin)),
                1.0, 1e-3);
    EXPECT_NEAR(left + right, 960.0, 1.0);
    EXPECT_NEAR(top + bottom, 720.0, 1.0);
}

TEST(Drawing, ShowsTheRequestedParts) {
    const Drawing all = drawn(ball);
    EXPECT_EQ(count(all, DrawingPart::toward), 0U);
    // Three axes, each a line in six parts with a head, and the letters' six strokes.
    EXPECT_LE(count(all, DrawingPart::axis), 3U * 7U + 5U);
    EXPECT_GE(count(all, DrawingPart::axis), 3U * 2U + 5U);
    EXPECT_GT(count(all, DrawingPart::frame), 10U);
    EXPECT_EQ(count(drawn(ball, {.rays = 0}), DrawingPart::ray), 0U);
    EXPECT_EQ(count(drawn(ball, {.eye = false}), DrawingPart::eye), 0U);
    EXPECT_EQ(count(drawn(ball, {.frame = false}), DrawingPart::frame), 0U);
    EXPECT_EQ(count(drawn(ball, {.axes = false}), DrawingPart::axis), 0U);
}

TEST(Drawing, IsTheSameEachTime) {
    EXPECT_EQ(to_svg(drawn(ball)), to_svg(drawn(ball)));
    EXPECT_EQ(rasterise(drawn(ball)).samples, rasterise(drawn(ball)).samples);
}

// A ball that moves away and grows, beside axes that stay.
const char* const moving = R"(camera moving {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  sphere(1)
    move scale(1 + t), translate(6*t, 0, 0)
    look normal
})";

TEST(Drawing, OfAFilmKeepsItsFrame) {
    const auto axes_at = [](double time, const std::optional<std::array<double, 2>>& film) {
        std::vector<V2d> points;
        for (const DrawingShape& shape : drawn(moving, {.time = time, .film = film}).shapes) {
            if (shape.part == DrawingPart::axis) {
                points.insert(points.end(), shape.points.begin(), shape.points.end());
            }
        }
        return points;
    };
    const std::array film{0.0, 1.0};
    const std::vector<V2d> first = axes_at(0.0, film);
    ASSERT_FALSE(first.empty());
    // 0.37 is not among the times at which the film is measured.
    EXPECT_EQ(axes_at(0.37, film), first);
    EXPECT_EQ(axes_at(1.0, film), first);
    EXPECT_NE(axes_at(1.0, {}), axes_at(0.0, {}));
    // Everything is on the page at both ends.
    for (const double time : {0.0, 1.0}) {
        for (const DrawingShape& shape : drawn(moving, {.time = time, .film = film}).shapes) {
            for (const V2d& point : shape.points) {
                ASSERT_TRUE(point.x >= 0.0 && point.x <= 960.0 && point.y >= 0.0 &&
                            point.y <= 720.0)
                    << time << ' ' << point;
            }
        }
    }
    // The arrows of a model have heads of one size.
    const auto extent_of_first_arrow = [&](double time) {
        const auto scene =
            model(test::camera_of(moving), {.length = 1.0, .time = time, .film = film});
        Imath::Box3f head;
        for (const auto& mesh : scene->meshes) {
            for (std::size_t i = 0; mesh->name == "rays" && i < 10; ++i) {
                head.extendBy(mesh->positions[i]);
            }
        }
        return head.size().length();
    };
    EXPECT_NEAR(extent_of_first_arrow(0.0), extent_of_first_arrow(1.0), 1e-5);
}

TEST(Drawing, LeavesRoomForNotes) {
    const DrawingView view{.notes = {"a long line of text, which takes much room", "short"}};
    const Drawing drawing = drawn(ball, {}, view);
    ASSERT_EQ(drawing.labels.size(), 2U);
    const DrawingLabel& first = drawing.labels.front();
    EXPECT_EQ(first.text, view.notes.front());
    EXPECT_LE(first.position.x + 6.0 / 7.0 * first.size * static_cast<double>(first.text.size()),
              960.0);
    for (const DrawingShape& shape : drawing.shapes) {
        for (const V2d& point : shape.points) {
            ASSERT_LE(point.x, first.position.x);
        }
    }
    EXPECT_NE(to_svg(drawing).find("monospace"), std::string::npos);
    // Hundreds of lines fit, too.
    const Drawing full =
        drawn(ball, {}, {.notes = std::vector<std::string>(300, std::string(80, 'x'))});
    EXPECT_LE(full.labels.back().position.y, 720.0);
}

TEST(Drawing, OfNothingIsAnError) {
    const auto camera = test::camera_of(R"(camera nowhere {
        map u = 1 .. -1, v = square
        eye surface(u, v) = [u, v, sqrt(-1 - u^2)]
    })");
    EXPECT_FALSE(draw(camera));
    EXPECT_FALSE(model(camera));
    EXPECT_FALSE(draw(test::camera_of(ball), {}, {.width = 8}));
}

TEST(ProjectionObject, LinesBreakAtSeamsAndGaps) {
    const auto object_of = [](const char* text) {
        const camera::Camera camera = test::camera_of(text);
        return ProjectionObject(camera.parts().eye, 1.0, Axes::z_up, 0.0);
    };
    constexpr double tolerance = 0.01;
    ProjectionObject jump = object_of(torn);
    const auto two = jump.trace({0.1, 0.5}, {0.9, 0.5}, tolerance).value();
    ASSERT_EQ(two.size(), 2U);
    for (const Polyline& piece : two) {
        for (const V3d& point : piece) {
            EXPECT_EQ(point.z, piece.front().z);
        }
    }
    // u = 0.03 is at 0.485 of the width; halving finds it to far less than this.
    EXPECT_NEAR(two[0].back().y, 0.03, 1e-8);
    EXPECT_NEAR(two[1].front().y, 0.03, 1e-8);
    EXPECT_FALSE(jump.joined({0.4, 0.5}, {0.6, 0.5}));
    EXPECT_TRUE(jump.joined({0.1, 0.5}, {0.4, 0.9}));

    ProjectionObject gap = object_of(half);
    const auto one = gap.trace({0.1, 0.5}, {0.9, 0.5}, tolerance).value();
    ASSERT_EQ(one.size(), 1U);
    EXPECT_NEAR(one[0].back().y, 0.03, 1e-8);
    EXPECT_FALSE(gap.joined({0.4, 0.5}, {0.6, 0.5}));
}

TEST(ProjectionObject, SteepIsNotTorn) {
    // An eighth root rises infinitely steeply at u = 0, without a jump.
    const camera::Camera camera = test::camera_of(R"(camera steep {
        aspect 1
        map u = 1 .. -1, v = -1 .. 1
        eye surface(u, v) = [v, u, spow(u, 1/8)]
    })");
    ProjectionObject object(camera.parts().eye, 1.0, Axes::z_up, 0.0);
    EXPECT_TRUE(object.joined({0.2, 0.5}, {0.9, 0.5}));
}

TEST(ProjectionObject, LinesKeepWithinTheTolerance) {
    const camera::Camera camera = test::camera_of(ball);
    ProjectionObject object(camera.parts().eye, 1.0, Axes::z_up, 0.0);
    constexpr double tolerance = 0.001;
    const auto pieces = object.trace({0.0, 0.5}, {1.0, 0.5}, tolerance).value();
    ASSERT_EQ(pieces.size(), 1U);
    const Polyline& equator = pieces.front();
    for (std::size_t i = 0; i + 1 < equator.size(); ++i) {
        const double apothem = (0.5 * (equator[i] + equator[i + 1])).length();
        EXPECT_GE(apothem, 2.0 - tolerance);
    }
    EXPECT_LT(equator.size(), 200U);
}

// Of the only camera.
CameraGeometry geometry_of(const camera::Camera& camera, const Depiction& depiction = {}) {
    auto measured = measure_geometry(camera::Picture(camera), depiction);
    EXPECT_TRUE(measured) << to_text(measured.diagnostics);
    return measured ? std::move(measured->cameras.front().geometry) : CameraGeometry{};
}

TEST(CameraGeometry, ArrowsAreRays) {
    const CameraGeometry outward = geometry_of(test::camera_of(ball), {.rays = 8, .length = 0.5});
    // 8 over the width of a picture of 16 by 9 and 5 (4.5, rounded) over its height.
    ASSERT_EQ(outward.rays.size(), 40U);
    for (const Arrow& ray : outward.rays) {
        EXPECT_NEAR(ray.from.length(), 2.0, 1e-12);
        EXPECT_NEAR(ray.to.length(), 2.5, 1e-12);
        EXPECT_NEAR(ray.to.cross(ray.from).length(), 0.0, 1e-12);
    }
}

TEST(CameraGeometry, ArrowsGoThroughTheDirectionObject) {
    const CameraGeometry pinhole = geometry_of(test::standard("pinhole"));
    ASSERT_EQ(pinhole.screen(), pinhole.toward.get());
    for (const Arrow& ray : pinhole.rays) {
        EXPECT_EQ(ray.from, V3d(0.0));
        EXPECT_NEAR(ray.to.x, 1.25, 1e-9);
    }
}

TEST(CameraGeometry, DrawsCamerasWithYUpStandingUpright) {
    const auto geometry = measure_geometry(test::camera_of(R"(camera upright {
        axes y_up
        map  u = -1 .. 1, v = -2 .. 2
        eye  surface(u, v) = [u, v, 0]
    })"),
                                           {.rays = 0});
    ASSERT_TRUE(geometry);
    EXPECT_NEAR(geometry->bounds.size().z, 4.0, 1e-9);
    EXPECT_NEAR(geometry->bounds.size().y, 0.0, 1e-9);
}

TEST(DrawingSvg, EscapesAndRounds) {
    const Drawing drawing{"a<b & c",
                          20,
                          10,
                          {{DrawingPart::eye, {{1.04, 2}, {3, 1.5}, {3, 8}}, {1, 2, 255}, 0.0, 0.5},
                           {DrawingPart::frame, {{4, 4}}, {0, 0, 0}, 2.0, 1.0}}};
    const std::string svg = to_svg(drawing);
    EXPECT_NE(svg.find("<title>a&lt;b &amp; c</title>"), std::string::npos);
    EXPECT_NE(svg.find("fill=\"#0102ff\" fill-opacity=\"0.5\" d=\"M1 2l2-0.5 0 6.5z\""),
              std::string::npos)
        << svg;
    EXPECT_NE(svg.find("stroke-width=\"2\" d=\"M4 4h0\""), std::string::npos) << svg;
}

TEST(DrawingRaster, CoversPixelsByTheirShare) {
    const Drawing drawing{
        "square",
        16,
        16,
        {{DrawingPart::eye, {{2, 2}, {6.5, 2}, {6.5, 6}, {2, 6}}, {0, 0, 0}, 0.0, 1.0}}};
    const Image image = rasterise(drawing);
    ASSERT_EQ(image.samples.size(), 16U * 16U * 3U);
    const auto grey = [&](std::size_t x, std::size_t y) {
        return static_cast<int>(image.samples[(y * 16 + x) * 3]);
    };
    EXPECT_EQ(grey(1, 3), 255);
    EXPECT_EQ(grey(2, 2), 0);
    EXPECT_EQ(grey(5, 5), 0);
    EXPECT_EQ(grey(6, 3), 128);
    EXPECT_EQ(grey(7, 3), 255);
    EXPECT_EQ(grey(3, 6), 255);
}

TEST(DrawingRaster, ADotHasItsArea) {
    const Drawing drawing{
        "dot", 64, 64, {{DrawingPart::eye, {{32.3, 31.1}}, {0, 0, 0}, 40.0, 1.0}}};
    double ink = 0.0;
    for (const std::uint8_t value : rasterise(drawing).samples) {
        ink += (255.0 - value) / (3.0 * 255.0);
    }
    // The polygon of 64 corners and the sampling of its edge make the difference.
    EXPECT_NEAR(ink / (std::numbers::pi * 400.0), 1.0, 0.01);
}

}  // namespace
}  // namespace balcony::analyse::drawing_test
