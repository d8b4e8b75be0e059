// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// camera wide = fisheye(fov = 200deg): a camera that is made of another one.

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::made_of_another_test {
namespace {

using Overrides = std::vector<Override>;

// Equal to the last bit at some points of the picture.
void expect_equal_rays(const Result<camera::Camera>& a, const Result<camera::Camera>& b,
                       double time = 0.0) {
    ASSERT_TRUE(a) << to_text(a.diagnostics);
    ASSERT_TRUE(b) << to_text(b.diagnostics);
    for (const double x : {1.0, 20.0, 36.5, 63.0}) {
        for (const double y : {0.5, 18.0, 40.0}) {
            const test::Ray ray_a = test::ray(*a, x, y, 64, 48, time);
            const test::Ray ray_b = test::ray(*b, x, y, 64, 48, time);
            EXPECT_EQ(ray_a.origin, ray_b.origin);
            EXPECT_EQ(ray_a.direction, ray_b.direction);
            EXPECT_EQ(ray_a.valid, ray_b.valid);
        }
    }
}

Result<camera::Camera> fisheye(const Overrides& overrides) {
    return make_camera("fisheye", "", overrides);
}

TEST(MadeOfAnother, HasItsRaysWithTheseValues) {
    const auto wide = test::make("camera wide = fisheye(fov = 200deg, yaw = 30deg)");
    expect_equal_rays(wide, fisheye({{"fov", "200deg"}, {"yaw", "30deg"}}));
    EXPECT_EQ(to_text(wide.diagnostics), "");
    EXPECT_EQ(wide->name(), "wide");
    expect_equal_rays(test::make("camera same = fisheye"), fisheye({}));
    // What the other one does not use is no fault of this one.
    const auto spare = test::make(
        "camera b(spare = 1) { map u = -1 .. 1, v = square eye sphere(1) }\ncamera a = b");
    ASSERT_TRUE(spare) << to_text(spare.diagnostics);
    EXPECT_EQ(to_text(spare.diagnostics), "");
}

TEST(MadeOfAnother, ItsParametersStayParameters) {
    const std::string text = "camera wide = fisheye(fov = 200deg)";
    expect_equal_rays(test::make(text, {{"fov", "100deg"}}), fisheye({{"fov", "100deg"}}));
    expect_equal_rays(test::make(text, {{"yaw", "fov/2"}}),
                      fisheye({{"fov", "200deg"}, {"yaw", "100deg"}}));
    const auto wrong = test::make(text, {{"fob", "1deg"}});
    ASSERT_FALSE(wrong);
    EXPECT_EQ(wrong.diagnostics.front().message, "the camera 'wide' has no parameter 'fob'");
    EXPECT_EQ(wrong.diagnostics.front().remedy, "did you mean 'fov'?");
}

TEST(MadeOfAnother, MayBeMadeOfOneThatIs) {
    const std::string text =
        "camera low = wide(pitch = -10deg, fov = 150deg)\n"
        "camera wide = fisheye(fov = 200deg, yaw = turn)\n"
        "let turn = 30deg\n";
    const auto low = test::make(text, {}, "low");
    expect_equal_rays(low, fisheye({{"fov", "150deg"}, {"yaw", "30deg"}, {"pitch", "-10deg"}}));
    EXPECT_EQ(low->name(), "low");
}

TEST(MadeOfAnother, OfItsOwnNameIsMadeOfTheOneElsewhere) {
    expect_equal_rays(test::make("camera fisheye = fisheye(fov = 200deg)"),
                      fisheye({{"fov", "200deg"}}));
    const files::TemporaryFolder folder;
    folder.write("lens.cam",
                 "camera fisheye(width = 1) { map u = width .. -width, v = square eye plane }");
    const auto file =
        folder.write("a.cam", "import \"lens.cam\"\ncamera fisheye = fisheye(width = 4)\n");
    expect_equal_rays(make_camera(file, "fisheye"),
                      make_camera(folder.path() / "lens.cam", "", {{"width", "4"}}));
}

TEST(MadeOfAnother, IsAPartOfPicturesAndMorphs) {
    const std::string wide = "camera wide = fisheye(fov = 200deg)\n";
    expect_equal_rays(
        test::make(wide + "camera a { morph wide .. fisheye(fov = 100deg), amount = 0.25 }"),
        fisheye({{"fov", "175deg"}}));
    const auto text = std::make_shared<const SourceText>(
        "test.cam", wide + "picture p { layer wide(yaw = 30deg) }");
    const auto picture = make_picture(text, "p");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    const auto& shown = std::get<camera::Camera>(picture->parts().layers.front().content);
    EXPECT_EQ(shown.name(), "wide");
    expect_equal_rays(Result<camera::Camera>(shown),
                      fisheye({{"fov", "200deg"}, {"yaw", "30deg"}}));
}

TEST(MadeOfAnother, APictureIsMadeOfAPicture) {
    const auto text = std::make_shared<const SourceText>(
        "test.cam", "picture small = joiner(rows = 1, columns = 3)");
    const auto made = make_picture(text, "");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->name(), "small");
    EXPECT_EQ(made->parts().layers.size(), 3U);
}

TEST(MadeOfAnother, WithTheSameValuesIsAnotherCamera) {
    const auto text =
        std::make_shared<const SourceText>("test.cam", "camera a = fisheye\ncamera b = fisheye\n");
    const auto all = Workspace().make_all(text);
    ASSERT_TRUE(all) << to_text(all.diagnostics);
    ASSERT_EQ(all->size(), 2U);
    EXPECT_EQ((*all)[0].name(), "a");
    EXPECT_EQ((*all)[1].name(), "b");
}

TEST(MadeOfAnother, ChangesWithTime) {
    const auto zoom =
        test::make("camera zoom = fisheye(fov = keys((0, 100deg), (2, 200deg), ease = smooth))");
    expect_equal_rays(zoom, fisheye({{"fov", "200deg"}}), 2.0);
    expect_equal_rays(zoom, fisheye({{"fov", "100deg"}}), -1.0);
}

TEST(MadeOfAnother, KeepsItsValuesInAScene) {
    Workspace workspace;
    workspace.fit_to(SceneMeasures{.inside = {3.0, 4.0, 5.0}});
    const auto text =
        std::make_shared<const SourceText>("test.cam", "camera here = fisheye(px = 7)");
    const auto made = workspace.make_camera(text);
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(test::ray(*made, 32, 24, 64, 48).origin, (std::array{7.0, 4.0, 5.0}));
}

TEST(MadeOfAnother, IsDescribedWithItsValues) {
    const files::TemporaryFolder folder;
    const auto file = folder.write("a.cam",
                                   "// A wide one.\ncamera wide = fisheye(fov = 2*100deg)\n"
                                   "camera less = wide(fov = 99deg)\n");
    const auto said = Workspace().describe(file);
    ASSERT_TRUE(said) << to_text(said.diagnostics);
    const Description& wide = said->front();
    EXPECT_EQ(wide.name, "wide");
    EXPECT_EQ(wide.comment, "A wide one.");
    ASSERT_EQ(wide.parameters.size(), 7U);
    EXPECT_EQ(wide.parameters[0].default_text, "2*100deg");
    EXPECT_EQ(wide.parameters[0].limits_text, "above 0 to 360deg");
    EXPECT_EQ(wide.parameters[1].default_text, "0");
    ASSERT_EQ(said->size(), 2U);
    EXPECT_EQ((*said)[1].parameters[0].default_text, "99deg");
    EXPECT_FALSE(Workspace().describe(folder.write("b.cam", "camera wide = fishye")));
}

TEST(MadeOfAnother, IsExplainedAndOpenUnderItsName) {
    const auto text =
        std::make_shared<const SourceText>("test.cam", "camera wide = fisheye(fov = 200deg)");
    const auto explained = Workspace().explain(text);
    ASSERT_TRUE(explained);
    EXPECT_EQ(explained->explanation.name, "wide");
    EXPECT_EQ(explained->explanation.parameters.front().value, "200deg");
    const auto open = Workspace().make_open_camera(text, "", {}, {{"fov"}});
    ASSERT_TRUE(open) << to_text(open.diagnostics);
    ASSERT_EQ(open->open.size(), 1U);
    EXPECT_EQ(open->open.front().written, "200deg");
    EXPECT_EQ(open->camera.name(), "wide");
}

TEST(MadeOfAnother, IsFormatted) {
    const auto text = std::make_shared<const SourceText>(
        "test.cam",
        "// One.\ncamera a=fisheye( fov=200deg )\ncamera b=a\n"
        "camera c(fov=60deg  above 0 to  -1deg+180deg){eye sphere(fov/1rad)}");
    const auto formatted = format(text);
    ASSERT_TRUE(formatted) << to_text(formatted.diagnostics);
    EXPECT_EQ(*formatted,
              "// One.\ncamera a = fisheye(fov = 200deg)\n\ncamera b = a\n\n"
              "camera c(fov = 60deg above 0 to -1deg + 180deg) {\n    eye sphere(fov/1rad)\n}\n");
}

}  // namespace
}  // namespace balcony::lang::made_of_another_test
