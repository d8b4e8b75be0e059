// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Pictures: what the language makes of them.

#include <gtest/gtest.h>

#include <cmath>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::pictures_test {

namespace {

Result<camera::Picture> make(std::string text, const std::vector<Override>& overrides = {},
                             std::string_view name = "") {
    return make_picture(std::make_shared<const SourceText>("test.cam", std::move(text)), name,
                        overrides);
}

camera::Picture made(const std::string& text, const std::vector<Override>& overrides = {},
                     std::string_view name = "") {
    Result<camera::Picture> picture = make(text, overrides, name);
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    EXPECT_TRUE(picture.diagnostics.empty()) << to_text(picture.diagnostics);
    return *picture;
}

constexpr const char* cameras = R"(
camera plain(width = 2) { map u = width/2 .. -width/2, v = square  eye plane }
camera round(radius = 1) { map u = 1 .. -1, v = square  eye sphere(radius) }
)";

// The coverage of an element at a point of a picture of 200 x 100 pixels.
double coverage(const camera::Picture& picture, std::size_t element, double x, double y,
                double time = 0.0) {
    expr::Graph graph;
    const auto all = picture.emit(graph, 200.0, 100.0);
    return expr::evaluate(std::span(&all.elements.at(element).coverage, 1), {x, y, time, {}})[0];
}

}  // namespace

TEST(Pictures, HaveLayersFromTheBackToTheFront) {
    const camera::Picture poster = made(test::joined(
        {cameras, "picture poster 400 x 100 { layer plain  layer round  layer pinhole }"}));
    EXPECT_EQ(poster.name(), "poster");
    EXPECT_EQ(poster.aspect(), 4.0);
    EXPECT_EQ((*poster.parts().size)[0], 400U);
    ASSERT_EQ(poster.parts().layers.size(), 3U);
    EXPECT_EQ(poster.parts().layers[0].name, "plain");
    EXPECT_EQ(poster.parts().layers[2].name, "pinhole");
}

TEST(Pictures, ACameraIsAPictureOfOneLayer) {
    const camera::Picture picture = made(cameras, {}, "plain");
    ASSERT_EQ(picture.parts().layers.size(), 1U);
    EXPECT_EQ(picture.name(), "plain");
    EXPECT_FALSE(picture.parts().size);
}

TEST(Pictures, GiveParametersToTheirLayers) {
    const std::string text = test::joined(
        {cameras, "picture p(r = 3) { aspect 2  let half = r/2  layer round(radius = half) }"});
    const auto radius = [](const camera::Picture& picture) {
        expr::Graph graph;
        const auto ray = *picture.emit(graph, 200.0, 100.0).elements.at(0).ray;
        const auto at = expr::evaluate(std::array{ray.origin.x, ray.origin.y, ray.origin.z},
                                       {100.0, 50.0, 0.0, {}});
        return std::hypot(at[0], at[1], at[2]);
    };
    EXPECT_NEAR(radius(made(text)), 1.5, 1e-12);
    EXPECT_NEAR(radius(made(text, {{"r", "8"}})), 4.0, 1e-12);
}

TEST(Pictures, LayersAreClippedPlacedAndMoved) {
    const camera::Picture picture = made(test::joined({cameras, R"(picture p {
        layer plain
        layer round {
            place   (0.5, 0) .. (1, 1)
            arrange mirror(x)
            clip    ellipse
            alpha   t/2
            blend   multiply
            frame(width = 0.02, color = (1, 0, 0))
            leader  (0.1, 0.1) .. (0.2, 0.2)
        }
    })"}));
    const camera::Layer& layer = picture.parts().layers[1];
    EXPECT_EQ(layer.blend, camera::BlendMode::multiply);
    EXPECT_EQ(layer.arrangers.size(), 1U);
    EXPECT_EQ(layer.inner_arrangers.size(), 1U);
    EXPECT_EQ(layer.leaders.size(), 1U);
    EXPECT_EQ(layer.frame->width.constant(), 0.02);
    // In the order of drawing: plain, the leader lines, round, its frame.
    EXPECT_EQ(coverage(picture, 0, 10.0, 10.0), 1.0);
    EXPECT_EQ(coverage(picture, 2, 150.0, 50.0, 1.0), 0.5);
    EXPECT_EQ(coverage(picture, 2, 50.0, 50.0, 1.0), 0.0);
    EXPECT_EQ(coverage(picture, 2, 101.0, 1.0, 1.0), 0.0) << "a corner of the ellipse";
    EXPECT_EQ(coverage(picture, 3, 101.0, 50.0), 1.0) << "the frame";
    EXPECT_EQ(coverage(picture, 3, 103.5, 50.0), 0.0);
    EXPECT_EQ(coverage(picture, 1, 19.0, 15.0), 1.0) << "the region's frame";
    EXPECT_EQ(coverage(picture, 1, 30.0, 15.0), 0.0);
}

TEST(Pictures, LayersMixTheirChannels) {
    const camera::Picture p = made(test::joined(
        {cameras, "picture p { layer plain  layer plain { channels(green = (0.5, 0, 2)) } }"}));
    EXPECT_FALSE(p.parts().layers[0].channels);
    const camera::ColorMatrix expected{{{1.0, 0.0, 0.0}, {0.5, 0.0, 2.0}, {0.0, 0.0, 1.0}}};
    EXPECT_EQ(p.parts().layers[1].channels, expected);
    expr::Graph graph;
    EXPECT_EQ(p.emit(graph, 200.0, 100.0).elements[1].channels, expected);
}

TEST(Pictures, LayersAreViewsOfAStereoPair) {
    const camera::Picture p =
        made(test::joined({cameras,
                           "picture two { layer round  layer round }"
                           "picture p { layer two { stereo(separation = 3, side = -1) }  layer "
                           "round { stereo(side = 1) } }"}));
    const auto& left =
        std::get<std::shared_ptr<const camera::Picture>>(p.parts().layers[0].content);
    const auto* back = std::get_if<camera::Camera>(&left->parts().layers[0].content);
    const auto* front = std::get_if<camera::Camera>(&left->parts().layers[1].content);
    ASSERT_TRUE(back != nullptr && front != nullptr);
    EXPECT_TRUE(back->parts().stereo);
    EXPECT_EQ(&back->parts(), &front->parts()) << "layers still share a camera";
    const auto& right = std::get<camera::Camera>(p.parts().layers[1].content);
    EXPECT_NE(right.parts().stereo, back->parts().stereo);
}

// The lines go from corner to corner; those two are drawn that cross neither rectangle.
TEST(Pictures, LeaderLinesEndAtTheCorners) {
    const camera::Picture picture = made(test::joined({cameras, R"(picture p {
        layer plain
        layer round { place (0.5, 0.1) .. (0.9, 0.9)  frame(width = 0.02)  leader (0.1, 0.4) .. (0.2, 0.6) }
    })"}));
    const auto line = [&](double x, double y) { return coverage(picture, 1, x, y); };
    EXPECT_EQ(line(60.0, 25.0), 1.0) << "top left to top left: (20, 40) to (100, 10)";
    EXPECT_EQ(line(60.0, 75.0), 1.0) << "bottom left to bottom left";
    EXPECT_EQ(line(110.0, 25.0), 0.0) << "nothing on the inset";
    EXPECT_EQ(line(70.0, 50.0), 0.0);
}

TEST(Pictures, CanBeNested) {
    const std::string text =
        test::joined({cameras,
                      "picture inner { layer plain }  picture outer { layer round  layer inner { "
                      "place (0, 0) .. (0.5, 0.5) } }"});
    const camera::Picture outer = made(text);
    EXPECT_EQ(outer.name(), "outer");
    expr::Graph graph;
    const auto all = outer.emit(graph, 200.0, 100.0);
    ASSERT_EQ(all.elements.size(), 2U);
    ASSERT_EQ(all.elements[1].group.size(), 1U);
    EXPECT_EQ(all.elements[1].group[0].name, "inner/plain");
}

TEST(Pictures, TheLastCameraOrPictureIsTheDefault) {
    const std::string text = test::joined({cameras, "picture p { layer plain }"});
    EXPECT_EQ(made(text).name(), "p");
    EXPECT_EQ(test::make(text)->name(), "round") << "the last camera, where a camera is wanted";
    const auto refused = test::make(text, {}, "p");
    ASSERT_FALSE(refused);
    EXPECT_EQ(refused.diagnostics[0].message, "'p' is a picture, but a camera is needed");
}

TEST(Pictures, AreDescribed) {
    const files::TemporaryFolder folder;
    const auto file = folder.write(
        "poster.cam",
        test::joined(
            {cameras, "// Two.\npicture p(a = 1) { layer plain(width = a)  layer round }"}));
    const auto described = Workspace().describe(file);
    ASSERT_TRUE(described) << to_text(described.diagnostics);
    ASSERT_EQ(described->size(), 3U);
    EXPECT_TRUE((*described)[2].is_picture);
    EXPECT_EQ((*described)[2].comment, "Two.");
    EXPECT_EQ((*described)[2].layers, (std::vector<std::string>{"plain", "round"}));
    EXPECT_TRUE(test::check(file).empty()) << to_text(test::check(file));
    EXPECT_EQ(make_picture(file, "")->name(), "p");
}

TEST(Pictures, AreBounded) {
    std::string text = test::joined({cameras, "picture p0 { layer plain }\n"});
    for (int i = 1; i < 20; ++i) {
        text += test::joined(
            {"picture p", std::to_string(i), " { layer p", std::to_string(i - 1), " }\n"});
    }
    const auto deep = make(text);
    ASSERT_FALSE(deep);
    EXPECT_EQ(deep.diagnostics[0].message, "pictures are nested more than 16 levels deep");

    std::string doubling = test::joined({cameras, "picture p0 { layer plain }\n"});
    for (int i = 1; i < 15; ++i) {
        const std::string below = test::joined({"layer p", std::to_string(i - 1)});
        doubling +=
            test::joined({"picture p", std::to_string(i), " { ", below, " ", below, " }\n"});
    }
    const auto wide = make(doubling);
    ASSERT_FALSE(wide);
    EXPECT_NE(wide.diagnostics[0].message.find("the maximum is 1000"), std::string::npos)
        << wide.diagnostics[0].message;
}

TEST(Pictures, LayersByWeightHaveTheirPartsOfTheSum) {
    const camera::Picture picture = made(test::joined({cameras, R"(picture p {
        aspect 2
        layer pinhole
        layer plain { blend by weight(x) }
        layer round { blend by weight(1 - 2*y) frame }
        layer plain { blend by weight(2 + t) }
    })"}));
    // The frame is drawn in front of its layer.
    constexpr std::array<std::size_t, 3> elements{1, 2, 4};
    for (const double x : {10.0, 90.0, 170.0}) {
        for (const double y : {5.0, 30.0, 80.0}) {
            const double time = 1.5;
            const std::array weights{x / 200.0, std::max(0.0, 1.0 - 2.0 * y / 100.0), 2.0 + time};
            const double sum = weights[0] + weights[1] + weights[2];
            double uncovered = 1.0;
            for (std::size_t i = 3; i-- > 0;) {
                const double part = coverage(picture, elements[i], x, y, time);
                EXPECT_NEAR(uncovered * part, weights[i] / sum, 1e-12) << x << ' ' << y << ' ' << i;
                uncovered *= 1.0 - part;
            }
            EXPECT_NEAR(uncovered, 0.0, 1e-12);
        }
    }
}

TEST(Pictures, LayersOfNoWeightShowWhatIsBehind) {
    const camera::Picture picture = made(test::joined({cameras, R"(picture p {
        aspect 2
        layer pinhole
        layer plain { blend by weight(x - 0.5) }
        layer round { blend by weight(log(x - 0.5)) }
    })"}));
    EXPECT_EQ(coverage(picture, 1, 20.0, 50.0), 0.0);
    EXPECT_EQ(coverage(picture, 2, 20.0, 50.0), 0.0);
    EXPECT_EQ(coverage(picture, 1, 180.0, 50.0), 1.0);
    EXPECT_EQ(coverage(picture, 2, 180.0, 50.0), 0.0);
}

}  // namespace balcony::lang::pictures_test
