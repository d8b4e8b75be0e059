// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/editable_camera.hpp"

#include <gtest/gtest.h>

#include <numbers>

#include "balcony/ray_maps.hpp"

namespace balcony::app::editable_camera_test {
namespace {

using std::numbers::pi;

const std::string text = R"(// Looks around.
camera looking(fov = 90deg from 1deg to 170deg, at = (1, 2, 3)) {
    let half = tan(fov/2)
    map u = half .. -half, v = square
    eye point(0, 0, 0)
    toward plane((1, 0, 0))
    move translate(at)  // keeps its comment
})";

EditableCamera camera_of(const std::vector<lang::Override>& values) {
    auto made =
        EditableCamera::make({std::make_shared<const SourceText>("looking.cam", text)}, "", values);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::move(*made);
}

// The origin and the direction of the ray in the middle.
std::array<rays::V3d, 2> middle_of(const EditableCamera& camera) {
    const auto grid = bridge::RayGrid::make(camera.picture(), {.width = 4, .height = 2});
    rays::Scratch scratch;
    rays::RayBatch rays;
    const double x = 4.0;
    const double y = 1.0;
    grid->run_at(std::span(&x, 1), std::span(&y, 1), scratch, rays);
    return {rays.origin(0), rays.direction(0)};
}

TEST(EditableCamera, HasItsParametersAsTheyStand) {
    EditableCamera camera = camera_of({{"fov", "60deg"}});
    EXPECT_EQ(camera.name(), "looking");
    EXPECT_EQ(camera.comment(), "Looks around.");
    ASSERT_EQ(camera.parameters().size(), 2U);
    const EditableCamera::Parameter& fov = camera.parameters()[0];
    EXPECT_EQ(fov.name, "fov");
    EXPECT_EQ(fov.written, "60deg");
    EXPECT_NEAR(fov.value.value_or(0.0), pi / 3, 1e-15);
    EXPECT_TRUE(fov.is_angle);
    EXPECT_EQ(fov.limits.maximum, 170.0 * pi / 180.0);
    const EditableCamera::Parameter& at = camera.parameters()[1];
    EXPECT_EQ(at.written, "(1, 2, 3)");
    EXPECT_FALSE(at.value);
}

TEST(EditableCamera, IsMadeAnewWithOtherValues) {
    EditableCamera camera = camera_of({});
    const EditableCamera before = camera.copy();
    EXPECT_TRUE(camera.set({{"fov", "2*atan(2)"}, {"at", "(4, 5, 6)"}}).empty());
    // At the right border of a pinhole, the tangent is that of half the field of view.
    const auto [origin, direction] = middle_of(camera);
    EXPECT_EQ(origin, rays::V3d(4, 5, 6));
    EXPECT_NEAR(direction.y / direction.x, -2.0, 1e-14);
    EXPECT_NEAR(middle_of(before)[1].y / middle_of(before)[1].x, -1.0, 1e-14);
    EXPECT_EQ(camera.parameters()[1].written, "(4, 5, 6)");
    const auto written = camera.text();
    ASSERT_TRUE(written) << to_text(written.diagnostics);
    EXPECT_NE(written->find("fov = 2*atan(2) from 1deg"), std::string::npos) << *written;
    EXPECT_NE(written->find("// keeps its comment"), std::string::npos) << *written;
}

TEST(EditableCamera, StaysAsItIsAfterAnError) {
    EditableCamera camera = camera_of({{"fov", "60deg"}});
    const auto before = middle_of(camera);
    for (const lang::Override& wrong :
         {lang::Override{"fov", "0deg"}, {"fov", "60 apples"}, {"fvo", "30deg"}}) {
        EXPECT_TRUE(has_errors(camera.set({{"at", "(0, 0, 0)"}, wrong}))) << wrong.expression;
        EXPECT_EQ(middle_of(camera), before);
        EXPECT_EQ(camera.parameters()[0].written, "60deg");
    }
    EXPECT_FALSE(EditableCamera::make("no_such_camera", {}));
    EXPECT_FALSE(EditableCamera::make("pinhole", {{"fov", "x"}}));
    EXPECT_FALSE(EditableCamera::make("scene:front", {}));
}

TEST(EditableCamera, HasOpenParameters) {
    EditableCamera camera = camera_of({{"fov", "60deg"}});
    const auto opened = camera.open_picture(std::vector<std::string>{"fov"});
    ASSERT_TRUE(opened) << to_text(opened.diagnostics);
    ASSERT_EQ(opened->open.size(), 1U);
    EXPECT_NEAR(opened->open[0].value, pi / 3, 1e-15);
    EXPECT_FALSE(camera.open_picture(std::vector<std::string>{"nothing"}));
}

TEST(EditableCamera, IsExportedWithItsValues) {
    EditableCamera camera = camera_of({{"fov", "60deg"}});
    const bridge::ExportTarget* const numpy = bridge::find_export_target("numpy");
    ASSERT_NE(numpy, nullptr);
    const auto made = camera.export_camera({.target = numpy});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_NE(made->text.find("looking --set fov=60deg"), std::string::npos) << made->text;
    EXPECT_NE(made->text.find("Looks around."), std::string::npos) << made->text;
    const auto layers = EditableCamera::make(
        {std::make_shared<const SourceText>("two.cam", text + "picture two { layer looking {} }")},
        "", {});
    ASSERT_TRUE(layers) << to_text(layers.diagnostics);
    EXPECT_FALSE(layers->copy().export_camera({.target = numpy}));
}

}  // namespace
}  // namespace balcony::app::editable_camera_test
