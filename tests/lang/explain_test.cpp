// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "balcony/catalogue.hpp"
#include "support.hpp"

namespace balcony::lang::explain_test {

namespace {

Result<Explanation> explanation_of(const CameraSource& source, std::string_view name,
                                   const std::vector<Override>& overrides = {}) {
    Result<ExplainedPicture> made = Workspace().explain(source, name, overrides);
    return made ? Result<Explanation>(std::move(made->explanation), std::move(made.diagnostics))
                : Result<Explanation>(std::move(made.diagnostics));
}

// A picture in a picture, and one camera with two values of its parameter.
const char* const nested_picture = R"(
camera room(turn = 0deg) {
    map u = turn .. turn + 90deg, v = square
    eye sphere(2)
}
picture inset(turn = 10deg) {
    aspect 2
    layer  room(turn = turn)
    layer  room(turn = 3*turn)
}
picture poster(tilt = 5deg, fade = 0.5) 400 x 300 {
    layer room
    layer inset(turn = 2*tilt) {
        clip    ellipse  // A comment.
        arrange rotate(tilt)
        place   (0, 0) .. (1/2, 1)
        blend   multiply
        alpha   fade
        soft    0.1
        frame(width = 0.01)
        leader  (0, 0) .. (1, 0.5)
    }
    layer room(turn = 30deg)
    layer inset
}
)";

std::vector<std::string> written(const std::vector<Explanation::Step>& steps) {
    std::vector<std::string> all;
    for (const Explanation::Step& step : steps) {
        all.push_back(std::string(step.depth, '.') + step.statement + " " + step.written);
    }
    return all;
}

}  // namespace

TEST(Explain, ListsStepsInTheOrderOfTheMachine) {
    const files::TemporaryFolder folder;
    const auto file = folder.write("a.cam",
                                   "camera a(r = 2, turn = 30deg) {\n"
                                   "    move rotate(z, turn)  // last but one\n"
                                   "    eye circle(r)\n"
                                   "    toward { object torus(r, /* thin */ 1) warp scale(2) }\n"
                                   "    map u = 0 .. 1,\n"
                                   "        v = square\n"
                                   "}\n");
    const auto made = explanation_of(file, "", {{"r", "3 + 1"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->name, "a");
    ASSERT_EQ(made->parameters.size(), 2U);
    EXPECT_EQ(made->parameters[0].value, "4");
    EXPECT_EQ(made->parameters[1].value, "30deg");
    const std::vector<std::string> wanted = {
        "map u = 0 .. 1, v = square", "eye circle(r)",        "toward ",      ".warp scale(2)",
        ".object torus(r, 1)",        "move rotate(z, turn)", "look relative"};
    EXPECT_EQ(written(made->steps), wanted);
    // The stage of the statement's own kind: rotate is a parameter transformer too.
    const auto* row = camera::catalogue().find(camera::StageKind::object_transformer, "rotate");
    EXPECT_EQ(made->steps[5].meanings, std::vector{"rotate: " + std::string(row->meaning)});
}

TEST(Explain, GivesDefinitions) {
    const files::TemporaryFolder folder;
    const auto made = explanation_of(folder.write("a.cam",
                                                  "let unused = 1\n"
                                                  "let base = 2\n"
                                                  "let double(x) = base*x  // Twice.\n"
                                                  "camera a(fov = 60deg) {\n"
                                                  "    let half = tan(fov/2)\n"
                                                  "    map u = half .. -half, v = square\n"
                                                  "    eye plane((double(1), 0, 0))\n"
                                                  "}\n"),
                                     "");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(made->definitions,
              (std::vector<std::string>{"base = 2", "double(x) = base*x", "half = tan(fov/2)"}));
}

TEST(Explain, DescribesLayers) {
    const files::TemporaryFolder folder;
    const auto made = explanation_of(folder.write("a.cam", nested_picture), "", {{"fade", "1/4"}});
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_TRUE(made->is_picture);
    EXPECT_EQ(made->summary, "A picture of 400 x 300 pixels in 4 layers.");
    EXPECT_EQ(made->parameters[1].value, "0.25");
    ASSERT_EQ(made->layers.size(), 4U);
    EXPECT_TRUE(made->layers[0].steps.empty());
    const Explanation::Layer& layer = made->layers[1];
    EXPECT_EQ(layer.written, "inset(turn = 2*tilt)");
    // Arrangers work as they are written, and before the clip, wherever that is written.
    const std::vector<std::string> wanted = {"arrange rotate(tilt)", "place (0, 0) .. (1/2, 1)",
                                             "clip ellipse",         "soft 0.1",
                                             "alpha fade",           "blend multiply",
                                             "frame (width = 0.01)", "leader (0, 0) .. (1, 0.5)"};
    EXPECT_EQ(written(layer.steps), wanted);
    const auto* row = camera::catalogue().find(camera::StageKind::clip_shape, "ellipse");
    EXPECT_EQ(layer.steps[2].meanings, std::vector{"ellipse: " + std::string(row->meaning)});
    EXPECT_EQ(layer.steps[5].meanings,
              std::vector{"multiply: " +
                          std::string(camera::blend_modes()[camera::BlendMode::multiply].meaning)});
    for (const Explanation::Step& step : layer.steps) {
        ASSERT_EQ(step.meanings.size(), 1U) << step.statement;
        EXPECT_FALSE(step.meanings[0].empty()) << step.statement;
    }
}

TEST(Explain, ExplainsACameraOnceForTheSameParameters) {
    const files::TemporaryFolder folder;
    const auto made = explanation_of(folder.write("a.cam", nested_picture), "poster");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    std::vector<std::string> shown;
    for (const Explanation& one : made->shown) {
        shown.push_back(one.name + " " + one.parameters[0].value);
    }
    // 2*tilt is inset's default of 10deg, 3*turn the third layer's 30deg.
    EXPECT_EQ(shown,
              (std::vector<std::string>{"room 0", "room 10deg", "room 30deg", "inset 10deg"}));
    EXPECT_EQ(made->layers[0].shows, 0U);
    EXPECT_EQ(made->layers[1].shows, 3U);
    EXPECT_EQ(made->layers[2].shows, 2U);
    EXPECT_EQ(made->layers[3].shows, 3U);
    const Explanation& inset = made->shown[3];
    EXPECT_EQ(inset.summary, "A picture in 2 layers, with an aspect ratio of 2.");
    EXPECT_EQ(inset.layers[0].shows, 1U);
    EXPECT_EQ(inset.layers[1].shows, 2U);
}

TEST(Explain, ReportsErrorsInsteadOfExplaining) {
    const auto made = explanation_of("nothing.cam", "");
    EXPECT_FALSE(made);
    EXPECT_TRUE(has_errors(made.diagnostics));
}

TEST(Explain, KnowsEveryStandardCamera) {
    for (const std::string& name : built_in_cameras()) {
        const auto made = explanation_of(name, "");
        ASSERT_TRUE(made) << name << to_text(made.diagnostics);
        for (const Explanation::Step& step : made->steps) {
            EXPECT_FALSE(step.meanings.empty() && !step.written.empty()) << name << step.statement;
        }
    }
}

}  // namespace balcony::lang::explain_test
