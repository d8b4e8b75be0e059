// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Parameters that stay open are inputs of the camera's formulas.

#include <gtest/gtest.h>

#include <array>

#include "balcony/lang.hpp"
#include "balcony/progress.hpp"
#include "lang/tools/open_camera.hpp"

namespace balcony::lang::open_parameters_test {
namespace {

CameraSource source(const char* text) {
    return {std::make_shared<const SourceText>("test.cam", text)};
}

std::vector<double> ray(const camera::Camera& camera, std::vector<expr::InputValue> inputs = {}) {
    expr::Graph graph;
    const camera::RayExpressions r = camera.emit(graph, 64, 36);
    const std::array roots{r.origin.x,    r.origin.y,    r.origin.z, r.direction.x,
                           r.direction.y, r.direction.z, r.valid};
    return expr::evaluate(roots, {.x = 20.5, .y = 9.5, .inputs = inputs});
}

constexpr const char* tower = R"(
    camera tower(radius = 3, turn = 30deg, from = (1, 2, 3), count = 4) {
        map   u = -1rad .. 1rad, v = -1 .. 1
        eye   cylinder(radius)
        move  repeat(count, rotate(z, turn)), translate(from)
    })";

TEST(OpenParameters, AreInputsWithTheSameRaysAsTheNumbers) {
    const auto open = Workspace().make_open_camera(source(tower), "", {});
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_EQ(open->open.size(), 2U);
    EXPECT_EQ(open->open[0].name, "radius");
    EXPECT_EQ(open->open[0].written, "3");
    EXPECT_FALSE(open->open[0].is_angle);
    EXPECT_EQ(open->open[1].name, "turn");
    EXPECT_TRUE(open->open[1].is_angle);
    EXPECT_EQ(open->closed, (std::vector<std::string>{"from", "count"}));

    const std::string radius = parameter_input("radius");
    const std::string turn = parameter_input("turn");
    for (const double r : {3.0, 5.5}) {
        const auto closed = Workspace().make_camera(
            source(tower), "", {{"radius", std::to_string(r)}, {"turn", "0.25rad"}});
        const auto a = ray(open->camera, {{radius, r}, {turn, 0.25}});
        const auto b = ray(*closed);
        for (std::size_t i = 0; i < a.size(); ++i) {
            EXPECT_NEAR(a[i], b[i], 1e-13) << i;
        }
    }
}

TEST(OpenParameters, HaveTheValuesThatAreSet) {
    const auto open =
        Workspace().make_open_camera(source(tower), "", {{"radius", "2 + 2"}}, {{"radius"}});
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_EQ(open->open.size(), 1U);
    EXPECT_EQ(open->open[0].written, "2 + 2");
    EXPECT_EQ(open->open[0].value, 4.0);
}

TEST(OpenParameters, OfAnUnknownNameAreAnError) {
    const auto open = Workspace().make_open_camera(source(tower), "", {}, {{"radus"}});
    EXPECT_FALSE(open);
    EXPECT_NE(to_text(open.diagnostics).find("has no parameter 'radus'"), std::string::npos);
    EXPECT_NE(to_text(open.diagnostics).find("did you mean 'radius'"), std::string::npos);
}

// A stage that looks at the ray to choose its formula chooses the same one.
TEST(OpenParameters, AreNotClosedByAStop) {
    const auto picture = Workspace().make_picture(source(tower), "", {});
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto make = [&](const std::vector<std::string>& open) -> Result<OpenAttempt> {
        if (!open.empty()) {
            return stopped();
        }
        return OpenAttempt{*picture, {{"radius", "3", 3.0, false, {}}}, {}};
    };
    EXPECT_EQ(kind_of_errors(open_picture(make, {}).diagnostics), Kind::interrupted);
}

TEST(OpenParameters, AreKnownToStagesThatTryTheirFormula) {
    const char* text = R"(
        camera room(a = 4) {
            map  u = -180deg .. 180deg, v = -70deg .. 70deg
            eye  superellipsoid(a, 2, 3, 1/4, 1/4)
            look normal outward
        })";
    const auto open = Workspace().make_open_camera(source(text), "", {});
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_EQ(open->open.size(), 1U);
    const auto closed = Workspace().make_camera(source(text), "");
    EXPECT_NEAR(ray(open->camera, {{parameter_input("a"), 4.0}})[3], ray(*closed)[3], 1e-12);
}

// A picture passes its parameters on to its layers.
TEST(OpenParameters, OfAPictureAreInputsOfItsLayers) {
    const std::string text = std::string(tower) + R"(
        picture two(width = 2, count = 3) {
            layer tower(radius = width, count = count)
            layer tower
        })";
    const auto open = Workspace().make_open_picture(source(text.c_str()), "two");
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_EQ(open->open.size(), 1U);
    EXPECT_EQ(open->open[0].name, "width");
    EXPECT_EQ(open->closed, (std::vector<std::string>{"count"}));
    const auto cameras = camera::shown_cameras(open->picture);
    ASSERT_EQ(cameras.size(), 2U);
    const auto closed =
        Workspace().make_camera(source(tower), "", {{"radius", "5.5"}, {"count", "3"}});
    const auto moved = ray(cameras[0].camera, {{parameter_input("width"), 5.5}});
    const auto known = ray(*closed);
    for (std::size_t i = 0; i < moved.size(); ++i) {
        EXPECT_NEAR(moved[i], known[i], 1e-13) << i;
    }
    const auto unknown = Workspace().make_open_picture(source(text.c_str()), "two", {}, {{"wdth"}});
    EXPECT_NE(to_text(unknown.diagnostics).find("the picture 'two' has no parameter 'wdth'"),
              std::string::npos);
}

// What each stage computes is part of the ray: the last ones are its origin and its direction.
TEST(StageValues, LeadToTheRay) {
    const auto camera = Workspace().make_camera(source(tower), "");
    expr::Graph graph;
    const camera::PicturePoint point{{graph.picture_x(), graph.picture_y()},
                                     {graph.constant(64), graph.constant(36)}};
    const camera::RayExpressions r = camera->emit(point);
    const std::vector<camera::StageValues> stages = camera->emit_stages(point);
    ASSERT_EQ(stages.size(), 5U);
    const auto written = [&](std::size_t i) { return camera->parts().written.at(stages[i].stage); };
    EXPECT_EQ(written(0), "map u = -1rad .. 1rad, v = -1 .. 1");
    EXPECT_EQ(written(1), "cylinder(radius)");
    EXPECT_EQ(written(3), "translate(from)");
    EXPECT_EQ(stages[4].owner, camera::StageValues::Owner::look);
    EXPECT_TRUE(stages[0].values[1].same(r.parameters.v));
    EXPECT_TRUE(stages[3].values[0].same(r.origin.x));
}

}  // namespace
}  // namespace balcony::lang::open_parameters_test
