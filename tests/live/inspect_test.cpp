// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What stands at a point of the picture, and where a point of space appears.

#include <cmath>
#include <fstream>
#include <numbers>
#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/inspect.hpp"

namespace balcony::live::test::inspect_test {
namespace {

using Imath::V2d;
using Imath::V3d;

// Looks along x at a wall of 4 by 4 at distance 2, of which it sees 2.4 by 1.8 in 64 by 48 pixels.
const std::string straight = R"(camera straight(slope = 0.6, side = 0) {
    aspect 4/3
    map    u = slope .. -slope, v = square
    eye    point(0, side, 0)
    toward surface(u, v) = [1, side + u, v]
}
)";

const std::string twice = straight + R"(camera small = straight
picture twice {
    aspect 4/3
    layer straight
    layer small {
        place (0, 0) .. (0.5, 0.5)
    }
}
)";

class InspectTest : public testing::Test {
protected:
    void SetUp() override {
        // The axes of the file have y upwards: its z is the camera's -y.
        std::ofstream(folder_ / "wall.mtl") << "newmtl red\nKd 0.8 0.1 0.1\n";
        std::ofstream(folder_ / "wall.obj")
            << "mtllib wall.mtl\no wall\nusemtl red\n"
               "v 2 -2 -2\nv 2 2 -2\nv 2 2 2\nv 2 -2 2\nf 1 2 3 4\n"
               "o post\nv 1 -0.1 -0.1\nv 1 0.1 -0.1\nv 1 0.1 0.1\nv 1 -0.1 0.1\nf 5 6 7 8\n";
        app::Request request;
        request.scene = (folder_ / "wall.obj").string();
        Result<app::PreparedScene> scene = app::PreparedScene::make(request);
        ASSERT_TRUE(scene) << to_text(scene.diagnostics);
        inspector_.emplace(std::move(*scene), folder_.path());
    }

    void show(const std::string& text, std::vector<Value> values = {}) {
        const Diagnostics found =
            inspector_->show({++change_, text, "", std::move(values), {64, 48}});
        EXPECT_FALSE(has_errors(found)) << to_text(found);
    }
    Sight seen(double x, double y) {
        const auto made = inspector_->at({x, y});
        EXPECT_TRUE(made && *made) << to_text(made.diagnostics);
        return made && *made ? **made : Sight();
    }

    const files::TemporaryFolder folder_;
    std::optional<Inspector> inspector_;
    std::uint64_t change_ = 0;
};

void expect_near(const V3d& one, const V3d& other, double tolerance) {
    EXPECT_NEAR((one - other).length(), 0.0, tolerance) << one << " and " << other;
}

}  // namespace

TEST_F(InspectTest, TellsWhatStandsAtAPoint) {
    show(straight);
    // The centre of pixel 48 is 16.5 pixels to the right of the middle: 0.6 are 32 of them.
    const double u = -0.6 * 16.5 / 32.0;
    const double v = 0.6 * 0.5 / 32.0;
    const Sight sight = seen(48.9, 23.1);
    EXPECT_EQ(sight.layer, "");
    expect_near(sight.origin, V3d(0.0), 1e-6);
    expect_near(sight.direction, V3d(1, v, -u).normalized(), 1e-6);
    EXPECT_NEAR(sight.parameters.x, u, 1e-6);
    EXPECT_NEAR(sight.parameters.y, v, 1e-6);
    ASSERT_TRUE(sight.hit);
    EXPECT_EQ(sight.hit->object, "wall");
    EXPECT_EQ(sight.hit->material, "red");
    expect_near(sight.hit->point, V3d(2, 2 * v, -2 * u), 1e-5);
    EXPECT_NEAR(sight.hit->distance, sight.hit->point.length(), 1e-5);
    expect_near(sight.hit->normal, V3d(-1, 0, 0), 1e-6);
    // Across the ray, a plane wall at distance d = 2 shows 32 / (0.6 d) pixels a unit in the
    // middle; at an angle a, areas are cos(a)^3 as large, where d is 2 / cos(a).
    const double cosine = 2.0 / sight.hit->distance;
    EXPECT_NEAR(sight.hit->magnification, 32.0 / 0.6 / 2.0 * std::pow(cosine, -0.5), 1e-3);
    EXPECT_EQ(seen(32, 24).hit->object, "post");
}

TEST_F(InspectTest, FollowsValuesAndTexts) {
    show(straight);
    const V3d before = seen(48, 24).hit->point;
    show(straight, {{"slope", 0.3}});
    const V3d moved = seen(48, 24).hit->point;
    EXPECT_NEAR(moved.z, before.z / 2, 1e-5);
    std::string written = straight;
    show(written.replace(written.find("0.6"), 3, "0.3"));
    expect_near(seen(48, 24).hit->point, moved, 1e-9);
    show(straight, {{"side", -1.0}});
    expect_near(seen(48, 24).origin, V3d(0, 0, 1), 1e-6);
}

TEST_F(InspectTest, WhereNothingIs) {
    // More than the wall, and nothing beyond the sphere that (u, v) has.
    show(
        "camera wide { aspect 4/3 map u = 2 .. -2, v = square eye point(0, 0, 0) "
        "toward surface(u, v) = [sqrt(3 - u^2), u, v] }");
    EXPECT_FALSE(*inspector_->at({0, 24}));
    EXPECT_FALSE(seen(6, 24).hit);
    EXPECT_TRUE(seen(32, 30).hit);
    for (const V2d& wrong : {V2d(-0.1, 3), V2d(64, 3), V2d(3, 48), V2d(std::nan(""), 3)}) {
        const auto made = inspector_->at(wrong);
        EXPECT_EQ(kind_of_errors(made.diagnostics), Kind::usage);
    }
}

void expect_same(const std::optional<Sight>& one, const std::optional<Sight>& other) {
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) {
        return;
    }
    EXPECT_EQ(one->layer, other->layer);
    EXPECT_EQ(one->origin, other->origin);
    EXPECT_EQ(one->direction, other->direction);
    EXPECT_EQ(one->parameters, other->parameters);
    ASSERT_EQ(one->hit.has_value(), other->hit.has_value());
    if (one->hit) {
        EXPECT_EQ(one->hit->object, other->hit->object);
        EXPECT_EQ(one->hit->material, other->hit->material);
        EXPECT_EQ(one->hit->distance, other->hit->distance);
        EXPECT_EQ(one->hit->point, other->hit->point);
        EXPECT_EQ(one->hit->normal, other->hit->normal);
        EXPECT_EQ(one->hit->magnification, other->hit->magnification);
    }
}

// Also where the middle of a cell is between two pixels, and for more cells than pixels.
TEST_F(InspectTest, AGridHasWhatStandsInTheMiddleOfEachCell) {
    const std::string wide =
        "camera wide { aspect 4/3 map u = 2 .. -2, v = square eye point(0, 0, 0) "
        "toward surface(u, v) = [sqrt(3 - u^2), u, v] }";
    for (const std::string& text : {straight, twice, wide}) {
        show(text);
        for (const auto& [columns, rows] :
             {std::pair<std::size_t, std::size_t>(7, 5), {64, 2}, {100, 1}}) {
            const auto grid = inspector_->grid(columns, rows);
            ASSERT_TRUE(grid) << to_text(grid.diagnostics);
            ASSERT_EQ(grid->size(), columns * rows);
            for (std::size_t i = 0; i < grid->size(); ++i) {
                const auto x = static_cast<double>(2 * (i % columns) + 1);
                const auto y = static_cast<double>(2 * (i / columns) + 1);
                const auto one = inspector_->at({x * 64 / static_cast<double>(2 * columns),
                                                 y * 48 / static_cast<double>(2 * rows)});
                ASSERT_TRUE(one);
                expect_same((*grid)[i], *one);
            }
        }
    }
}

// The plane across the ray has a pixel's steps by finite differences; their area is the
// magnification's. Also in a layer, and for values that the text does not have.
TEST_F(InspectTest, TellsHowLongStepsAcrossARayAre) {
    const std::string skew = R"(camera skew(slope = 0.6) {
    aspect 4/3
    map    u = slope .. -slope, v = square
    eye    point(0, 0, 0)
    toward surface(u, v) = [1, u + 0.7*v, v]
}
)";
    show(skew, {{"slope", 0.5}});
    const Sight sight = seen(20, 30);
    ASSERT_TRUE(sight.hit && sight.hit->metric);
    // The ray at the distance of the hit, as a function of (u, v).
    const auto point = [&](double u, double v) {
        return sight.hit->distance * V3d(1, u + 0.7 * v, v).normalized();
    };
    constexpr double h = 1e-6;
    const double step = 2.0 * 0.5 / 64.0;  // Of u and v from pixel to pixel.
    const double u = sight.parameters.x;
    const double v = sight.parameters.y;
    const V3d by_x = -step * (point(u + h, v) - point(u - h, v)) / (2.0 * h);
    const V3d by_y = -step * (point(u, v + h) - point(u, v - h)) / (2.0 * h);
    EXPECT_NEAR(sight.hit->metric->xx, by_x.length2(), 1e-8);
    EXPECT_NEAR(sight.hit->metric->xy, by_x.dot(by_y), 1e-8);
    EXPECT_NEAR(sight.hit->metric->yy, by_y.length2(), 1e-8);
    EXPECT_GT(std::abs(sight.hit->metric->xy), 1e-5);
    for (const std::string& text : {skew, twice}) {
        show(text);
        for (const V2d& place : {V2d(10, 10), V2d(25, 5), V2d(50, 40)}) {
            const Sight one = seen(place.x, place.y);
            ASSERT_TRUE(one.hit && one.hit->metric);
            const auto& [xx, xy, yy] = *one.hit->metric;
            // The film has single precision.
            EXPECT_NEAR(std::pow(xx * yy - xy * xy, -0.25) / one.hit->magnification, 1.0, 1e-5);
        }
    }
}

// A scene that was moved to a time, there and back, is one that was loaded at this time.
TEST(InspectedTime, IsThatOfTheSceneAndTheCamera) {
    const std::string text =
        "camera moving { axes y_up aspect 16/10 map u = 0.7 .. -0.7, v = square\n"
        "eye point(1.2 - t/4, 1.9, 11.5) toward surface(u, v) = [-u, v, -1] look relative }";
    const auto inspector_at = [](double time) {
        app::Request request;
        request.scene = BALCONY_SOURCE_DIR "/docs/pictures/windmill.gltf";
        request.settings.time = time;
        Result<app::PreparedScene> scene = app::PreparedScene::make(request);
        EXPECT_TRUE(scene) << to_text(scene.diagnostics);
        return Inspector(std::move(*scene));
    };
    const auto grid_at = [&](Inspector& inspector, double time) {
        static std::uint64_t change = 0;
        const Diagnostics found = inspector.show({++change, text, "", {}, {32, 20}, time});
        EXPECT_TRUE(found.empty()) << to_text(found);
        const auto grid = inspector.grid(32, 20);
        EXPECT_TRUE(grid) << to_text(grid.diagnostics);
        return *grid;
    };
    Inspector moved = inspector_at(0.0);
    const auto before = grid_at(moved, 0.0);
    const auto then = grid_at(moved, 0.7);
    const auto after = grid_at(moved, 0.0);
    Inspector loaded = inspector_at(0.7);
    const auto wanted = grid_at(loaded, 0.7);
    std::size_t other_objects = 0;
    for (std::size_t i = 0; i < then.size(); ++i) {
        expect_same(then[i], wanted[i]);
        expect_same(after[i], before[i]);
        const bool was_hit = before[i]->hit.has_value();
        const bool is_hit = then[i]->hit.has_value();
        other_objects +=
            was_hit != is_hit || (is_hit && before[i]->hit->object != then[i]->hit->object) ? 1 : 0;
    }
    EXPECT_GT(other_objects, 0U);
    EXPECT_NEAR(then[0]->origin.x, 1.2 - 0.7 / 4, 1e-6);
}

TEST_F(InspectTest, RemarksHaveTheirPlaces) {
    const std::string part =
        "camera part { aspect 4/3 map u = 0.6 .. -0.6, v = square eye point(0, 0, 0) "
        "toward surface(u, v) = [1 + sqrt(u + 0.3)/1e6, u, v] }";
    show(part);
    const auto remarks = inspector_->check();
    ASSERT_TRUE(remarks) << to_text(remarks.diagnostics);
    ASSERT_EQ(remarks->size(), 1U);
    const Remark& one = remarks->front();
    EXPECT_TRUE(one.defect);
    EXPECT_EQ(one.camera, "");
    EXPECT_EQ(one.name, "no ray");
    EXPECT_EQ(one.message, "25 % of the picture has no ray, in one region");
    ASSERT_EQ(one.areas.size(), 1U);
    EXPECT_EQ(one.areas[0], Imath::Box2d({48, 0}, {64, 48}));
    EXPECT_TRUE(one.areas[0].intersects(*one.example));
    // Values count, too: without the whole range, all have rays.
    show(straight, {{"slope", 0.01}});
    const auto others = inspector_->check();
    ASSERT_TRUE(others) << to_text(others.diagnostics);
    ASSERT_EQ(others->size(), 1U);
    EXPECT_EQ(others->front().name, "never seen");
    EXPECT_EQ(others->front().message, "1 object: wall");
    EXPECT_FALSE(others->front().defect);
    EXPECT_TRUE(others->front().areas.empty());
    // Places of a layer are those of its own picture, so none here.
    show(part + "picture both { aspect 4/3 layer part layer part { place (0, 0) .. (0.5, 0.5) } }");
    const auto layers = inspector_->check();
    ASSERT_TRUE(layers) << to_text(layers.diagnostics);
    ASSERT_EQ(layers->size(), 1U);
    EXPECT_EQ(layers->front().camera, "part, layer 1 of both, layer 2 of both");
    EXPECT_EQ(layers->front().message, one.message);
    EXPECT_TRUE(layers->front().areas.empty());
    EXPECT_FALSE(layers->front().example);
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(kind_of_errors(inspector_->check(source.get_token()).diagnostics), Kind::interrupted);
}

TEST_F(InspectTest, AGridIsStopped) {
    show(straight);
    std::stop_source source;
    source.request_stop();
    EXPECT_EQ(kind_of_errors(inspector_->grid(4, 3, source.get_token()).diagnostics),
              Kind::interrupted);
}

TEST_F(InspectTest, FindsAllPlacesOfAPoint) {
    show(twice);
    const V3d on_wall(2, 0.5, 1);
    const auto places = inspector_->places_of(on_wall);
    ASSERT_TRUE(places) << to_text(places.diagnostics);
    ASSERT_EQ(places->size(), 2U);
    // u = -0.5 and v = 0.25 are 26.7 and 13.3 pixels from the middle, and half as many in the
    // small picture in the corner.
    EXPECT_NEAR(((*places)[0].position - V2d(16 + 13.3333, 12 - 6.6667)).length(), 0.0, 1e-3);
    EXPECT_NEAR(((*places)[1].position - V2d(32 + 26.6667, 24 - 13.3333)).length(), 0.0, 1e-3);
    EXPECT_EQ((*places)[0].layer, "small");
    EXPECT_NEAR((*places)[1].distance, on_wall.length(), 1e-6);
    EXPECT_FALSE((*places)[1].hidden_by);
    EXPECT_EQ(seen((*places)[0].position.x, (*places)[0].position.y).layer, "small");
    const auto behind = inspector_->places_of({2, 0.1, 0.1});
    ASSERT_TRUE(behind && behind->size() == 2);
    EXPECT_EQ((*behind)[1].hidden_by, "post");
    EXPECT_TRUE(inspector_->places_of({-2, 0, 0})->empty());
}

// What at() says a pixel shows appears in this pixel, for other values than those of the text.
TEST_F(InspectTest, WhatAPixelShowsAppearsThere) {
    show(straight, {{"slope", 0.45}, {"side", -0.2}});
    const auto places = inspector_->places_of(seen(50, 10).hit->point);
    ASSERT_TRUE(places) << to_text(places.diagnostics);
    ASSERT_EQ(places->size(), 1U);
    EXPECT_NEAR(((*places)[0].position - V2d(50.5, 10.5)).length(), 0.0, 1e-3);
}

TEST_F(InspectTest, WithoutACameraThereAreNoAnswers) {
    EXPECT_EQ(kind_of_errors(inspector_->at({1, 1}).diagnostics), Kind::usage);
    show(straight);
    EXPECT_TRUE(has_errors(inspector_->show({++change_, "camera {", "", {}, {64, 48}})));
    EXPECT_FALSE(inspector_->at({1, 1}));
    EXPECT_FALSE(inspector_->grid(2, 2));
    EXPECT_FALSE(inspector_->check());
    EXPECT_FALSE(inspector_->places_of({1, 1, 1}));
    show(straight);
    EXPECT_TRUE(inspector_->at({1, 1}));
}

}  // namespace balcony::live::test::inspect_test
