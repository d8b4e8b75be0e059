// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Layers in loops, and what layers show in which place.

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::lang::layers_test {

namespace {

constexpr const char* cameras = R"(
camera plain(width = 2) { map u = width/2 .. -width/2, v = square  eye plane }
camera strip { aspect 4  map u = 1 .. -1, v = -1 .. 1  eye sphere(1) }
)";

Result<camera::Picture> make(const std::string& picture,
                             const std::vector<Override>& overrides = {}) {
    return make_picture(
        std::make_shared<const SourceText>("test.cam", test::joined({cameras, picture})), "",
        overrides);
}

camera::Picture made(const std::string& picture, const std::vector<Override>& overrides = {}) {
    Result<camera::Picture> result = make(picture, overrides);
    EXPECT_TRUE(result) << to_text(result.diagnostics);
    EXPECT_TRUE(result.diagnostics.empty()) << to_text(result.diagnostics);
    return *result;
}

std::string names_of(const std::string& picture, const std::vector<Override>& overrides = {}) {
    std::string names;
    const camera::Picture whole = made(picture, overrides);
    for (const camera::Layer& layer : whole.parts().layers) {
        names += (names.empty() ? "" : " ") + layer.name;
    }
    return names;
}

std::string first_said(const std::string& picture) {
    const auto result = make(picture);
    return result.diagnostics.empty() ? "" : result.diagnostics.front().message;
}

// The size of the picture that a layer shows, in a picture of 400 x 100.
std::array<double, 2> shown_size(const camera::Picture& picture, std::size_t layer) {
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            if (use.index == layer) {
                return size_of(use, 400.0, 100.0);
            }
        }
    }
    return {};
}

}  // namespace

TEST(Loops, RepeatLayersFromTheFirstToTheLast) {
    EXPECT_EQ(names_of("picture p { for i in 0 .. 2 { layer plain(width = i + 1) } }"),
              "plain[0] plain[1] plain[2]");
    EXPECT_EQ(names_of("picture p { for i in 2 .. 1 { layer plain(width = i) } layer plain }"),
              "plain[2] plain[1] plain");
    EXPECT_EQ(names_of("picture p { for i in -1 .. -1 { layer plain(width = 2 - i) } }"),
              "plain[-1]");
}

TEST(Loops, MayCountToAParameter) {
    const std::string text = "picture p(n = 2) { for i in 1 .. n { layer plain(width = i) } }";
    EXPECT_EQ(names_of(text), "plain[1] plain[2]");
    EXPECT_EQ(names_of(text, {{"n", "3"}}), "plain[1] plain[2] plain[3]");
}

TEST(Loops, VisitTheElementsOfAList) {
    EXPECT_EQ(names_of("picture p { for w in [1, 4] { layer plain(width = w) } }"),
              "plain[0] plain[1]");
    const auto picture = made(
        "let corners = [(0, 0), (0.5, 0)]\n"
        "picture p { for at in corners { layer plain { place at .. (at[0] + 0.5, 1) } } }");
    EXPECT_EQ(shown_size(picture, 1), (std::array{200.0, 100.0}));
}

TEST(Loops, MayBeNestedWithLets) {
    EXPECT_EQ(names_of("picture p { for i in 0 .. 1 { let w = i + 1  for j in 1 .. 2 { "
                       "layer plain(width = w*j)  layer strip { alpha 0.5 } } } }"),
              "plain[0][1] strip[0][1] plain[0][2] strip[0][2] "
              "plain[1][1] strip[1][1] plain[1][2] strip[1][2]");
}

TEST(Loops, GiveTheirVariableToWhatIsInThem) {
    const auto picture = made(
        "picture p { for i in 0 .. 3 { layer plain { place (i/4, 0) .. ((i + 1)/4, 1 - i/8) } } }");
    EXPECT_EQ(shown_size(picture, 0), (std::array{100.0, 100.0}));
    EXPECT_EQ(shown_size(picture, 2), (std::array{100.0, 75.0}));
}

TEST(Loops, ReportErrorsWithTheirPass) {
    const auto result = make("picture p { for i in 0 .. 9 { layer plain(width = 1/(i - 3)) } }");
    ASSERT_EQ(result.diagnostics.size(), 1U) << to_text(result.diagnostics);
    EXPECT_EQ(result.diagnostics[0].message, "division by 0");
    ASSERT_EQ(result.diagnostics[0].notes.size(), 1U);
    EXPECT_EQ(result.diagnostics[0].notes[0].message, "in the pass of this loop with i = 3");
}

TEST(Loops, AreBounded) {
    EXPECT_EQ(first_said("picture p { for i in 1 .. 1e9 { layer plain(width = i) } }"),
              "this loop has 1e+09 passes; the maximum is 1000");
    EXPECT_EQ(first_said("picture p { for i in 1 .. 1000 { for j in 1 .. 1000 { "
                         "layer plain(width = i + j) } } }"),
              "the picture has more than 1000 layers");
    std::string deep = "picture p { ";
    for (int i = 0; i < 5000; ++i) {
        deep += "for i in 0 .. 0 { ";
    }
    EXPECT_EQ(first_said(deep), "loops are nested more than 8 levels deep");
}

TEST(Loops, CountInWholeNumbers) {
    EXPECT_EQ(first_said("picture p { for i in 0 .. 1.5 { layer plain(width = i) } }"),
              "the last value of a loop is a whole number, but this is 1.5");
    EXPECT_EQ(first_said("picture p { for i in t .. 2 { layer plain(width = i) } }"),
              "the first value of a loop cannot change with time");
    EXPECT_EQ(first_said("picture p { for i in 0 .. 90deg { layer plain(width = i) } }"),
              "the last value of a loop must be a plain number, but this is an angle");
    EXPECT_EQ(first_said("picture p { for i in 6 { layer plain(width = i) } }"),
              "expected a range or a list after 'in', but this is a number");
    EXPECT_EQ(first_said("picture p { for i in 0 .. 3 { let w = i } }"), "this loop has no layers");
    EXPECT_EQ(first_said("picture p { for i in [] { layer plain(width = i) } }"),
              "picture 'p' has no layers");
}

TEST(Loops, AreWarnedAboutIfTheirVariableIsUnused) {
    EXPECT_EQ(first_said("picture p { for i in 0 .. 1 { layer plain } }"),
              "the variable 'i' is unused");
    EXPECT_EQ(first_said("picture p { for i in 0 .. 1 { let w = 2  layer plain(width = i + 1) } }"),
              "the let 'w' is unused");
}

TEST(Loops, AreExplainedPassByPass) {
    const auto source = std::make_shared<const SourceText>(
        "test.cam",
        test::joined({cameras, "picture p { for i in 1 .. 2 { layer plain(width = i) } }"}));
    const auto explained = Workspace().explain(source);
    ASSERT_TRUE(explained) << to_text(explained.diagnostics);
    ASSERT_EQ(explained->explanation.layers.size(), 2U);
    EXPECT_EQ(explained->explanation.layers[1].written, "plain(width = i) (i = 2)");
    EXPECT_EQ((*Workspace().describe(source)).back().layers, std::vector<std::string>{"plain"});
}

// A strip of aspect 4 in a place of 100 x 100.
TEST(Places, KeepTheAspectOfACameraUnlessTold) {
    const auto size = [](const std::string& how) {
        return shown_size(made(test::joined({"picture p { layer strip { place (0, 0) .. (0.25, 1) ",
                                             how, " } }"})),
                          0);
    };
    EXPECT_EQ(size(""), (std::array{100.0, 25.0}));
    EXPECT_EQ(size("fit"), (std::array{100.0, 25.0}));
    EXPECT_EQ(size("fill"), (std::array{400.0, 100.0}));
    EXPECT_EQ(size("stretch"), (std::array{100.0, 100.0}));
    EXPECT_EQ(size("show (0, 0) .. (0.25, 1)"), (std::array{400.0, 100.0}));
}

TEST(Places, AreMovedByPlaceAndTheirContentsByArrange) {
    const auto picture = made(R"(picture p {
        layer plain {
            place   (0, 0) .. (0.5, 1), rotate(90deg)
            arrange mirror(x), rotate(5deg)
        }
    })");
    EXPECT_EQ(picture.parts().layers[0].arrangers.size(), 2U);
    EXPECT_EQ(picture.parts().layers[0].inner_arrangers.size(), 2U);
}

TEST(Places, TakeNamedCorners) {
    const auto picture = made(
        "let middle = (0.5, 0.5)\n"
        "let beside(i) = (0.5 + i/4, 1)\n"
        "picture p { layer plain { place middle .. beside(1) } }");
    EXPECT_EQ(shown_size(picture, 0), (std::array{100.0, 50.0}));
}

TEST(Places, GetALeaderToWhatIsShown) {
    const auto picture = made(R"(picture p {
        layer strip
        layer strip { place (0, 0) .. (0.2, 0.2)  show (0.5, 0.5) .. (0.6, 0.6)  leader }
    })");
    EXPECT_FALSE(picture.parts().layers[1].leaders[0].region);
    EXPECT_EQ(source_of(picture.parts(), 1), 0U);
    EXPECT_EQ(first_said("picture p { layer strip { leader } }"),
              "this leader has no corners, and its layer has no 'show'");
    EXPECT_EQ(first_said("picture p { layer plain  layer strip { "
                         "show (0, 0) .. (0.5, 0.5) leader } }"),
              "no layer below shows 'strip' with the same parameters, so this leader goes to the "
              "region of 'show' in the whole picture");
}

TEST(Places, ContradictNothing) {
    EXPECT_EQ(first_said("picture p { layer strip { fill  stretch } }"),
              "'stretch' contradicts 'fill'");
    EXPECT_EQ(first_said("picture p { layer strip { show (0.5, 0) .. (0.2, 1) } }"),
              "this region has no area");
}

TEST(Layers, ShowAndHideObjects) {
    const camera::Picture picture = made(R"(picture p {
        layer plain { hide objects("vase*", "bowl") }
        layer strip {
            show  (0.1, 0.2) .. (0.3, 0.4)
            show  objects("vase*")
            hide  objects("vase 3")
            blend by depth
        }
    })");
    const camera::Layer& behind = picture.parts().layers.at(0);
    ASSERT_EQ(behind.objects.size(), 1U);
    EXPECT_FALSE(behind.objects[0].shows);
    ASSERT_EQ(behind.objects[0].patterns.size(), 2U);
    EXPECT_EQ(behind.objects[0].patterns[1].text, "bowl");
    const SourceSpan& written = behind.objects[0].patterns[1].written;
    EXPECT_EQ(written.source->text().substr(written.begin, written.end - written.begin),
              "\"bowl\"");
    EXPECT_EQ(behind.compositing, camera::Compositing::order);
    const camera::Layer& front = picture.parts().layers.at(1);
    EXPECT_TRUE(front.show);
    ASSERT_EQ(front.objects.size(), 2U);
    EXPECT_TRUE(front.objects[0].shows);
    EXPECT_FALSE(front.objects[1].shows);
    EXPECT_EQ(front.compositing, camera::Compositing::depth);

    const std::vector<camera::ShownCamera> shown = shown_cameras(picture);
    ASSERT_EQ(shown.size(), 2U);
    EXPECT_EQ(shown[1].uses[0].objects.size(), 2U);
}

}  // namespace balcony::lang::layers_test
