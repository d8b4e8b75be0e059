// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// `fit` statements: parameters that follow from the measures of a scene.

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "support.hpp"

namespace balcony::lang::fit_test {

namespace {

SceneMeasures box() {
    return {.min = {1.0, 2.0, 3.0},
            .max = {5.0, 4.0, 9.0},
            .inside = {2.0, 3.0, 4.6},
            .radius = 2.5,
            .profile = {{2.0, -3.0}, {2.5, 3.0}}};
}

CameraSource text(std::string written) {
    return {std::make_shared<const SourceText>("test.cam", std::move(written))};
}

std::array<double, 3> origin_of(const CameraSource& source, std::optional<SceneMeasures> scene,
                                const std::vector<Override>& overrides = {}) {
    Workspace workspace;
    workspace.fit_to(std::move(scene));
    const Result<camera::Camera> made = workspace.make_camera(source, "", overrides);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(to_text(made.diagnostics), "");
    return test::ray(*made, 0.5, 0.5, 1.0, 1.0).origin;
}

// A camera whose origin is three parameters.
std::string at(const std::string& fit) {
    return "camera c(a = 10, b = 20, c = 30, profile = [(1, 0), (1, 1)]) {\n" + fit +
           "\n  map u = 1 .. -1, v = square\n  eye point(a, b, c + 0*profile[0][0])\n"
           "  toward plane((100, 0, 0))\n}\n";
}

using Point = std::array<double, 3>;

}  // namespace

TEST(Fit, ReplacesDefaultsInAScene) {
    const CameraSource source =
        text(at("fit (a, b) = (scene_inside[0], scene_min[1]), "
                "c = scene_radius*scene_size[2]"));
    EXPECT_EQ(origin_of(source, box()), (Point{2.0, 2.0, 15.0}));
    EXPECT_EQ(origin_of(source, std::nullopt), (Point{10.0, 20.0, 30.0}));
}

TEST(Fit, GivesWayToValuesFromTheCommandLine) {
    const CameraSource source = text(at("fit a = scene_max[0], b = scene_center[1]"));
    EXPECT_EQ(origin_of(source, box(), {{"a", "7"}}), (Point{7.0, 3.0, 30.0}));
}

TEST(Fit, UsesParametersBeforeIt) {
    const CameraSource source = text(at("fit b = a + scene_radius, c = scene_profile[1][0]"));
    EXPECT_EQ(origin_of(source, box(), {{"a", "1"}}), (Point{1.0, 3.5, 2.5}));
}

TEST(Fit, KnowsTheLengthOfTheProfile) {
    EXPECT_EQ(origin_of(text(at("fit c = scene_profile_length")), box()),
              (Point{10.0, 20.0, std::hypot(0.5, 6.0)}));
}

TEST(Fit, KnowsTheSurfaceOfRevolution) {
    SceneMeasures leaning = box();
    leaning.revolution = SceneMeasures::Revolution{.axis = {0.0, 0.6, 0.8},
                                                   .center = {1.5, 2.5, 3.5},
                                                   .length = 7.0,
                                                   .radius = 1.25,
                                                   .reach = 1.75,
                                                   .arc_middle = 0.5,
                                                   .arc = 2.0,
                                                   .profile = {{1.0, -3.0}, {1.0, 4.0}}};
    const auto fitted = [&](const std::string& fit) { return origin_of(text(at(fit)), leaning); };
    EXPECT_EQ(fitted("fit (a, b, c) = scene_axis"), (Point{0.0, 0.6, 0.8}));
    EXPECT_EQ(fitted("axes y_up fit (a, b, c) = scene_axis"), (Point{0.0, 0.8, -0.6}));
    EXPECT_EQ(fitted("fit (a, b, c) = scene_axis_center"), (Point{1.5, 2.5, 3.5}));
    EXPECT_EQ(fitted("fit (a, b, c) = (scene_axis_length, scene_axis_radius, scene_axis_reach)"),
              (Point{7.0, 1.25, 1.75}));
    EXPECT_EQ(fitted("fit a = scene_arc[0]/1rad, b = scene_arc[1]/1rad, "
                     "c = scene_axis_profile[1][1] + scene_axis_profile_length"),
              (Point{0.5, 2.0, 11.0}));
}

TEST(Fit, TakesAnUprightCylinderForTheSurfaceOfRevolutionIfThereIsNone) {
    const auto fitted = [&](const std::string& fit) { return origin_of(text(at(fit)), box()); };
    EXPECT_EQ(fitted("fit (a, b, c) = scene_axis"), (Point{0.0, 0.0, 1.0}));
    EXPECT_EQ(fitted("fit (a, b, c) = scene_axis_center"), (Point{3.0, 3.0, 6.0}));
    EXPECT_EQ(fitted("fit (a, b, c) = (scene_axis_length, scene_axis_radius, scene_axis_reach)"),
              (Point{6.0, 2.5, 2.5}));
    EXPECT_EQ(fitted("fit a = scene_arc[0]/180deg, b = scene_arc[1]/360deg, "
                     "c = scene_axis_profile[1][0]"),
              (Point{1.0, 1.0, 2.5}));
}

TEST(Fit, SetsLists) {
    const CameraSource source = text(
        "camera c(profile = [(1, 0), (1, 1)]) { fit profile = scene_profile  map u = 1 .. -1, v = "
        "square  eye point(profile[0][0], profile[0][1], profile[1][0])  toward plane((9, 0, 0)) "
        "}");
    EXPECT_EQ(origin_of(source, box()), (Point{2.0, -3.0, 2.5}));
}

// A camera with y up calls (x, z, -y) what one with z up calls (x, y, z).
TEST(Fit, FollowsTheAxesOfTheCamera) {
    const CameraSource source = text(at("axes y_up  fit (a, b, c) = scene_min"));
    EXPECT_EQ(origin_of(source, box()), (Point{1.0, 3.0, -4.0}));
    const CameraSource size = text(at("axes y_up  fit (a, b, c) = scene_size"));
    EXPECT_EQ(origin_of(size, box()), (Point{4.0, 6.0, 2.0}));
}

TEST(Fit, ReachesTheLayersOfAPicture) {
    Workspace workspace;
    workspace.fit_to(box());
    const Result<camera::Picture> made = workspace.make_picture(
        text(at("fit a = scene_min[0], b = scene_min[1]") + "picture p { layer c(b = 8) }"));
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    const auto& layer = std::get<camera::Camera>(made->parts().layers.front().content);
    EXPECT_EQ(test::ray(layer, 0.5, 0.5, 1.0, 1.0).origin, (Point{1.0, 8.0, 30.0}));
    ASSERT_EQ(workspace.fitted().size(), 2U);
    EXPECT_EQ(workspace.fitted().front().name, "a");
    EXPECT_EQ(workspace.fitted().front().value, 1.0);
}

// The standard camera stands at scene_inside, so that a look turns it; what is set remains.
TEST(Fit, ALookTurnsACameraThatStands) {
    const auto camera = [](const std::string& fit) {
        return text("camera c(px = 0, py = 0, pz = 0, yaw = 0deg, pitch = 0deg) {\n" + fit +
                    "\nmap u = 0 .. 1, v = 0 .. 1 eye point(0, 0, 0) toward point(1, 0, 0)\n"
                    "move rotate(y, -pitch), rotate(z, yaw), translate(px, py, pz) }");
    };
    const auto fitted = [](const CameraSource& source) {
        SceneMeasures scene = box();
        scene.look = SceneMeasures::Look{.yaw = 0.5, .pitch = -0.25};
        Workspace workspace;
        workspace.fit_to(scene);
        const auto made = workspace.make_picture(source, "");
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        std::map<std::string, double> values;
        for (const FittedParameter& one : workspace.fitted()) {
            values[one.name] = one.value.value_or(NAN);
        }
        return values;
    };
    using Values = std::map<std::string, double>;
    EXPECT_EQ(fitted(camera("fit (px, py, pz) = scene_inside, yaw = 90deg")),
              (Values{{"px", 2.0}, {"py", 3.0}, {"pz", 4.6}, {"yaw", 0.5}, {"pitch", -0.25}}));
    EXPECT_EQ(fitted(camera("fit (px, py, pz) = scene_center, yaw = 1rad")),
              (Values{{"px", 3.0}, {"py", 3.0}, {"pz", 6.0}, {"yaw", 1.0}}));
}

}  // namespace balcony::lang::fit_test
