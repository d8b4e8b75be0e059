// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What of a camera is drawn, in which order and colours, and how areas are filled.

#include <algorithm>
#include <cmath>

#include <gtest/gtest.h>

#include "analyse/draw/camera_geometry.hpp"
#include "analyse/draw/drawing_items.hpp"
#include "analyse/draw/drawing_viewer.hpp"
#include "support.hpp"

namespace balcony::analyse::drawing_items_test {
namespace {

const char* const between_planes = R"(camera c {
    map    u = 1 .. -1, v = -1 .. 1
    eye    plane((-5, 0, 0))
    toward plane((5, 0, 0))
})";

const char* const ball = R"(camera ball {
    map  u = 180deg .. -180deg, v = -80deg .. 80deg
    eye  sphere(2)
    look normal
})";

// From x, with y to the right and z up.
constexpr DrawingView from_x{.azimuth = 0.0, .elevation = 0.0};

std::vector<DrawingItem> items_of(const std::string& text, const Depiction& depiction = {}) {
    const auto geometry = measure_geometry(camera::Picture(test::camera_of(text)), depiction);
    EXPECT_TRUE(geometry) << to_text(geometry.diagnostics);
    return drawing_items(geometry->cameras.front().geometry, 0, geometry->extent(), depiction,
                         DrawingViewer(from_x, geometry->bounds));
}

template <class Test>
std::size_t count(const std::vector<DrawingItem>& items, DrawingPart part, const Test& test) {
    return static_cast<std::size_t>(
        std::count_if(items.begin(), items.end(),
                      [&](const DrawingItem& item) { return item.part == part && test(item); }));
}

bool is_area(const DrawingItem& item) { return item.line_width == 0.0; }
bool is_any(const DrawingItem&) { return true; }

TEST(DrawingItems, OnlyTheScreenHasAFrameOnAllItsSides) {
    // 24 x 14 cells and the mark of a corner.
    EXPECT_EQ(count(items_of(between_planes), DrawingPart::frame, is_any), 2U * (24U + 14U) + 1U);
}

TEST(DrawingItems, AreTheRequestedOnes) {
    const auto items = items_of(between_planes, {.toward = false});
    EXPECT_EQ(count(items, DrawingPart::toward, is_any), 0U);
    EXPECT_GT(count(items, DrawingPart::eye, is_any), 0U);
}

TEST(DrawingItems, LinesLieOnTheAreasBesideThem) {
    for (const char* camera : {between_planes, ball}) {
        const auto items = items_of(camera, {.rays = 0, .frame = false});
        for (const DrawingItem& line : items) {
            for (const DrawingItem& area : items) {
                const auto is_corner = [&area](const V3d& point) {
                    return std::find(area.points.begin(), area.points.end(), point) !=
                           area.points.end();
                };
                if (!is_area(line) && is_area(area) && is_corner(line.points.front()) &&
                    is_corner(line.points.back())) {
                    ASSERT_LT(line.distance, area.distance);
                }
            }
        }
    }
}

TEST(DrawingItems, AreLightWhereTheyFaceTheLight) {
    // It comes from above the left shoulder of who looks along -x: from (1, -0.6, 0.7).
    const auto lit = items_of(R"(camera lit {
        map u = 1 .. -1, v = -1 .. 1
        eye surface(u, v) = [0.6*u - 0.7*v, u, v]
        look normal
    })");
    for (const DrawingItem& item : lit) {
        if (item.part == DrawingPart::eye && is_area(item)) {
            ASSERT_EQ(item.color, (DrawingColor{226, 241, 251}));
        }
    }
}

TEST(DrawingItems, AreasAreDividedTowardsGaps) {
    const auto items = items_of(R"(camera half {
        aspect 1
        map  u = 1 .. -1, v = -1 .. 1
        eye  surface(u, v) = [v, u, sqrt(u - 0.03)]
        look normal
    })");
    // Of 18 x 18 cells those of 8 columns are whole.
    EXPECT_GT(count(items, DrawingPart::eye, is_area), 8U * 18U);
}

TEST(DrawingItems, ArrowsEndAtTheirTips) {
    const auto items = items_of(ball, {.rays = 8, .length = 1.0});
    EXPECT_EQ(count(items, DrawingPart::ray, is_area), 8U * 5U);
    for (const DrawingItem& item : items) {
        for (const V3d& point : item.points) {
            ASSERT_LE(point.length(), 3.0 + 1e-9);
        }
    }
}

TEST(Drawing, OfAPointIsADot) {
    const auto drawing =
        draw(test::camera_of("camera p { map u = 1 .. -1, v = -1 .. 1 eye point(0, 0, 0)\n"
                             "toward plane((1, 0, 0)) }"),
             {.rays = 0, .toward = false, .frame = false, .axes = false});
    ASSERT_TRUE(drawing);
    ASSERT_EQ(drawing->shapes.size(), 1U);
    EXPECT_EQ(drawing->shapes[0].points.size(), 1U);
}

TEST(Drawing, PaintsNearShapesLast) {
    for (const double azimuth : {0.0, 3.14}) {
        const auto drawing = draw(test::camera_of(between_planes), {.rays = 0},
                                  {.azimuth = azimuth, .elevation = 0.0});
        ASSERT_TRUE(drawing);
        std::size_t last_eye = 0;
        std::size_t last_toward = 0;
        for (std::size_t i = 0; i < drawing->shapes.size(); ++i) {
            last_eye = drawing->shapes[i].part == DrawingPart::eye ? i : last_eye;
            last_toward = drawing->shapes[i].part == DrawingPart::toward ? i : last_toward;
        }
        EXPECT_EQ(last_eye < last_toward, azimuth == 0.0);
    }
}

TEST(Drawing, HasAHeadOnEveryArrow) {
    const auto drawing = draw(test::camera_of(ball), {.rays = 8, .axes = false});
    ASSERT_TRUE(drawing);
    EXPECT_EQ(std::count_if(drawing->shapes.begin(), drawing->shapes.end(),
                            [](const DrawingShape& shape) {
                                return shape.part == DrawingPart::ray && shape.line_width == 0.0;
                            }),
              8 * 5);
}

TEST(DrawnAxes, AreBesideObjectsFarFromTheOrigin) {
    const auto geometry = measure_geometry(camera::Picture(test::camera_of(R"(camera far {
        map  u = 180deg .. -180deg, v = -80deg .. 80deg
        eye  sphere(2)
        look normal
        move translate(100, 100, 100)
    })")),
                                           {});
    ASSERT_TRUE(geometry);
    const Box3d& box = geometry->bounds;
    const V3d origin = drawn_axes(*geometry, DrawingViewer(from_x, box)).origin;
    // At the bottom, where it is seen farthest to the left.
    EXPECT_EQ(origin.y, box.min.y);
    EXPECT_EQ(origin.z, box.min.z);
    const DrawingView from_behind{.azimuth = 3.14, .elevation = 0.0};
    EXPECT_EQ(drawn_axes(*geometry, DrawingViewer(from_behind, box)).origin.y, box.max.y);

    const auto near = measure_geometry(camera::Picture(test::camera_of(ball)), {});
    ASSERT_TRUE(near);
    EXPECT_EQ(drawn_axes(*near, DrawingViewer(from_x, near->bounds)).origin, V3d(0.0));
}

TEST(DrawnAxes, AreThoseOfTheCamera) {
    const auto geometry = measure_geometry(
        camera::Picture(
            test::camera_of("camera y { axes y_up map u = 1 .. -1, v = -1 .. 1 eye sphere }")),
        {});
    ASSERT_TRUE(geometry);
    const DrawnAxes axes = drawn_axes(*geometry, DrawingViewer(from_x, geometry->bounds));
    EXPECT_GT(axes.tips[1].z, 0.1);
    EXPECT_NEAR(axes.tips[2].z, 0.0, 1e-12);
}

// The grey of a pixel in the middle of a picture of 16 x 16 pixels.
int grey(const std::vector<V2d>& outline, std::size_t x, double opacity = 1.0) {
    const Drawing drawing{"area", 16, 16, {{DrawingPart::eye, outline, {0, 0, 0}, 0.0, opacity}}};
    return rasterise(drawing).samples[(8 * 16 + x) * 3];
}

TEST(DrawingRaster, FillsByTheWindingRule) {
    // Two arms with nothing between them.
    const std::vector<V2d> arms{{2, 2}, {5, 2},  {5, 12},  {9, 12},
                                {9, 2}, {12, 2}, {12, 14}, {2, 14}};
    EXPECT_EQ(grey(arms, 3), 0);
    EXPECT_EQ(grey(arms, 7), 255);
    EXPECT_EQ(grey(arms, 10), 0);
    const std::vector<V2d> twice{{2, 2}, {12, 2}, {12, 14}, {2, 14},
                                 {2, 2}, {12, 2}, {12, 14}, {2, 14}};
    EXPECT_EQ(grey(twice, 7), 0);
}

TEST(DrawingRaster, TakesItsSamplesInTheMiddleOfTheirParts) {
    // Of the samples at 6.125, 6.375 and so on one lies to the left of 6.3.
    const std::vector<V2d> area{{2, 2}, {6.3, 2}, {6.3, 14}, {2, 14}};
    EXPECT_EQ(grey(area, 6), 191);
    EXPECT_EQ(grey(area, 4, 0.4), 153);
}

}  // namespace
}  // namespace balcony::analyse::drawing_items_test
