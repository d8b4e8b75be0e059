// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What a hand can move of a text, and what it writes.

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gtest/gtest.h>

#include <fmt/format.h>

#include "balcony/language_service.hpp"
#include "support.hpp"

namespace balcony::lang::handles_test {
namespace {

constexpr double degree = std::numbers::pi / 180.0;

std::shared_ptr<const SourceText> text_of(const std::string& written) {
    return std::make_shared<const SourceText>("test.cam", written);
}

// "warp zoom.at parameter_point 1, 2": what a handle is, with its numbers; ~ does not move.
std::string told(const Handle& handle) {
    std::string made = fmt::format("{} {}{}{}{} {}", handle.statement, handle.stage,
                                   handle.stage.empty() ? "" : ".", handle.parameter,
                                   handle.index > 0 ? fmt::format("[{}]", handle.index) : "",
                                   name_of(handle.kind));
    for (const HandleNumber& number : handle.numbers) {
        made += fmt::format(" {}{:g}{}{}", number.moves ? "" : "~",
                            number.is_angle ? number.value / degree : number.value,
                            number.is_angle ? "deg" : "",
                            number.parameter.empty() ? "" : ":" + number.parameter);
    }
    return made;
}

std::vector<std::string> all_told(const std::string& written, std::string_view camera = {}) {
    std::vector<std::string> made;
    for (const Handle& one : EditedText(text_of(written)).handles(camera)) {
        made.push_back(told(one));
    }
    return made;
}

const Handle* find(const std::vector<Handle>& all, std::string_view parameter) {
    const auto found = std::find_if(all.begin(), all.end(),
                                    [&](const Handle& one) { return one.parameter == parameter; });
    return found != all.end() ? &*found : nullptr;
}

// The text after the first handle of a parameter has moved; the message if it does not.
std::string moved(const std::string& written, std::string_view parameter,
                  const std::vector<HandleMove>& moves, std::string_view camera = {}) {
    const EditedText text(text_of(written));
    const std::vector<Handle> all = text.handles(camera);
    const Handle* const handle = find(all, parameter);
    if (handle == nullptr) {
        return "no handle";
    }
    const auto edits = text.moved(camera, *handle, moves);
    return edits ? test::edited(written, *edits) : edits.diagnostics.front().message;
}

const std::string zoomed = R"(// A zoom.
let close = 2
camera zoomed(fov = 60deg above 0 to 179deg, turn = 1/4, eye_x = 1) {
    let half = tan(fov/2)
    map    u = half .. -half, v = square
    warp   zoom((0.1, -0.2), radius = 0.5, strength = close)
    eye    point(eye_x, -2, t)
    toward plane(x)
    move   rotate(z, -turn*180deg), translate((1, 2, 3))
}
)";

}  // namespace

TEST(Handles, AreWhatTheTypesOfParametersSay) {
    EXPECT_EQ(all_told(zoomed),
              (std::vector<std::string>{
                  "map u interval 0.57735:fov -0.57735:fov",
                  "warp zoom.at parameter_point 0.1 -0.2", "warp zoom.radius size 0.5",
                  "warp zoom.strength size 2", "eye point.x space_point 1:eye_x -2 ~0",
                  "move rotate.angle angle -45deg:turn", "move translate.x space_point 1 2 3"}));
}

TEST(Handles, OfPicturesAreRegionsAndArguments) {
    EXPECT_EQ(all_told(R"(picture two {
    aspect 16/9
    layer panorama
    layer fisheye(fov = 120deg) {
        place (0.7, 0.1) .. (0.95, 0.5)
        show  (0.25, 0.25) .. (0.75, 0.75)
        clip  ellipse
        soft  0.1
        leader (0.4, 0.5) .. (0.5, 0.6)
    }
})"),
              (std::vector<std::string>{
                  "aspect  size 1.77778", "layer fisheye.fov angle 120deg",
                  "place place.from picture_point 0.7 0.1", "place place.to picture_point 0.95 0.5",
                  "show  picture_region 0.25 0.25 0.75 0.75", "soft  size 0.1",
                  "leader  picture_region 0.4 0.5 0.5 0.6"}));
}

TEST(Handles, PointsOfListsAreNumbered) {
    EXPECT_EQ(
        all_told("camera bent { map u = 1 .. -1, v = square "
                 "warp thin_plate([(0, 0, 0.1, 0.2), (1, 1, 0.9, 1)]) "
                 "eye sphere(1) move coins([(1, 2, 3), (4, 5, 6)]) }"),
        (std::vector<std::string>{
            "map u interval 1 -1", "warp thin_plate.seeds parameter_point 0 0",
            "warp thin_plate.seeds[1] parameter_point 0.1 0.2",
            "warp thin_plate.seeds[2] parameter_point 1 1",
            "warp thin_plate.seeds[3] parameter_point 0.9 1", "eye sphere.radius size 1",
            "move coins.points space_point 1 2 3", "move coins.points[1] space_point 4 5 6"}));
}

TEST(Handles, AVectorOfAnyLengthIsADirection) {
    const std::string written =
        "camera a { map u = 1 .. -1, v = square eye sphere(1) "
        "move rotate((0, 1, 2), 10deg) }";
    EXPECT_EQ(all_told(written)[2], "move rotate.axis direction 0 1 2");
    EXPECT_EQ(moved(written, "axis", {{2, -3.0, 0.1}}),
              "camera a { map u = 1 .. -1, v = square eye sphere(1) "
              "move rotate((0, 1, -3), 10deg) }");
}

// What is made of another camera has the handles of that one, whose numbers are its parameters.
TEST(Handles, OfADerivedCameraAreThoseOfItsBase) {
    const std::string written = "camera wide = pinhole(fov = 100deg)\n";
    const std::vector<std::string> all = all_told(written);
    ASSERT_FALSE(all.empty());
    EXPECT_EQ(all.front().substr(0, 15), "map u interval ");
    EXPECT_NE(all.front().find(":fov"), std::string::npos);
    EXPECT_EQ(moved(written, "u", {{0, 1.0, 0.001}}), "camera wide = pinhole(fov = 90deg)\n");
    // One that has no literal in the text gets it.
    const EditedText text(text_of(written));
    const std::vector<Handle> handles = text.handles();
    const auto place = std::find_if(handles.begin(), handles.end(), [](const Handle& one) {
        return one.numbers.front().parameter == "px";
    });
    ASSERT_NE(place, handles.end());
    EXPECT_EQ(place->kind, HandleKind::space_point);
    EXPECT_EQ(place->begin, place->end);
    const auto edits = text.moved({}, *place, {{0, 2.5, 0.01}});
    ASSERT_TRUE(edits);
    EXPECT_EQ(test::edited(written, *edits), "camera wide = pinhole(fov = 100deg, px = 2.5)\n");
}

TEST(Handles, AHandWritesTheLiteralThatANumberIsMadeOf) {
    const auto replaced = [](const std::string& old, const std::string& by) {
        std::string text = zoomed;
        return text.replace(text.find(old), old.size(), by);
    };
    EXPECT_EQ(moved(zoomed, "at", {{0, 0.30001, 0.001}, {1, -0.00001, 0.001}}),
              replaced("(0.1, -0.2)", "(0.3, 0)"));
    EXPECT_EQ(moved(zoomed, "strength", {{0, 3.0, 0.1}}), replaced("close = 2", "close = 3"));
    EXPECT_EQ(moved(zoomed, "u", {{0, 1.0, 0.001}, {1, -1.0, 0.001}}), replaced("60deg", "90deg"));
    EXPECT_EQ(moved(zoomed, "angle", {{0, -90 * degree, 0.1 * degree}}), replaced("1/4", "0.5"));
    EXPECT_EQ(moved(zoomed, "radius", {{0, 0.123456789, 0.0}}), replaced("0.5", "0.1235"));
}

TEST(Handles, KeepUnitsAndLimits) {
    const std::string turned =
        "camera a { map u = 1 .. -1, v = square eye sphere(1) "
        "move rotate(z, 0.5rad /* slightly */) }";
    EXPECT_EQ(moved(turned, "angle", {{0, 0.7501, 0.001}}),
              "camera a { map u = 1 .. -1, v = square eye sphere(1) "
              "move rotate(z, 0.75rad /* slightly */) }");
    EXPECT_EQ(moved(turned, "radius", {{0, -3.0, 0.01}}),
              "camera a { map u = 1 .. -1, v = square eye sphere(0.01) "
              "move rotate(z, 0.5rad /* slightly */) }");
}

TEST(Handles, WhatDoesNotMoveSaysSo) {
    EXPECT_EQ(moved(zoomed, "x", {{2, 1.0, 0.1}}), "number 3 of this handle does not move");
    EXPECT_EQ(moved(zoomed, "x", {{3, 1.0, 0.1}}), "number 4 of this handle does not move");
    const std::string root = "camera a(w = 1) { map u = 1 .. -1, v = square eye point(w^2, 0, 0) }";
    EXPECT_EQ(moved(root, "x", {{0, 4.0, 0.1}}),
              "camera a(w = 2) { map u = 1 .. -1, v = square eye point(w^2, 0, 0) }");
    EXPECT_EQ(moved(root, "x", {{0, -4.0, 0.1}}), "no value of 'w' makes this number -4");
    const std::string two =
        "camera a(w = 1, h = 2) { map u = 1 .. -1, v = square "
        "eye point(w + h, 0, 0) }";
    EXPECT_EQ(moved(two, "x", {{0, 4.0, 0.1}}), "number 1 of this handle does not move");
}

TEST(Handles, ParametersAreWrittenLikeSolvedOnes) {
    const EditedText text(text_of(zoomed));
    const auto edits =
        text.with_values("zoomed", {{"fov", 50 * degree, 0.0}, {"eye_x", 0.12345, 0.01}});
    ASSERT_TRUE(edits);
    Workspace workspace;
    const auto whole =
        workspace.with_values({text_of(zoomed)}, "zoomed", {{"fov", "50deg"}, {"eye_x", "0.12"}});
    ASSERT_TRUE(whole);
    EXPECT_EQ(test::edited(zoomed, *edits), *whole);
    EXPECT_EQ(text.with_values("zoomed", {{"fav", 1.0}}).diagnostics.front().message,
              "the camera 'zoomed' has no parameter 'fav'");
    EXPECT_FALSE(text.with_values("other", {{"fov", 1.0}}));
}

TEST(Handles, OfATextWithMistakesAreNone) {
    EXPECT_TRUE(all_told("").empty());
    EXPECT_TRUE(all_told("camera a { eye").empty());
    EXPECT_TRUE(all_told(zoomed, "other").empty());
}

// Every stage of the catalogue has handles for all numbers that its example gives it, and moving
// one of them changes what it says and no other number.
TEST(Handles, EveryExampleMoves) {
    std::size_t moves = 0;
    std::set<HandleKind> kinds;
    for (const camera::StageEntry& row : camera::catalogue()) {
        const std::string written(row.example);
        SCOPED_TRACE(fmt::format("{} {}", name_of(row.kind), row.name));
        const EditedText text(text_of(written));
        const std::vector<Handle> all = text.handles();
        for (std::size_t h = 0; h < all.size(); ++h) {
            kinds.insert(all[h].kind);
            for (std::size_t i = 0; i < all[h].numbers.size(); ++i) {
                const HandleNumber& number = all[h].numbers[i];
                if (!number.moves) {
                    continue;
                }
                SCOPED_TRACE(told(all[h]) + fmt::format(", number {}", i));
                const double step = 1e-6 * (1.0 + std::abs(number.value));
                const double by = number.value >= number.limits.maximum ? -0.01 : 0.01;
                const double wanted = all[h].kind == HandleKind::count
                                          ? number.value + 1.0
                                          : number.value + by * (1.0 + std::abs(number.value));
                const double allowed = std::min(wanted, number.limits.maximum);
                const auto edits = text.moved({}, all[h], {{i, allowed, step}});
                ASSERT_TRUE(edits) << to_text(edits.diagnostics);
                ASSERT_FALSE(edits->empty());
                const std::string after = test::edited(written, *edits);
                const std::vector<Handle> then = EditedText(text_of(after)).handles();
                ASSERT_EQ(then.size(), all.size()) << after;
                EXPECT_NEAR(then[h].numbers[i].value, allowed, 2.0 * step) << after;
                ++moves;
            }
        }
    }
    EXPECT_GT(moves, 500U);
    // Regions are of statements, and examples name their directions.
    for (const HandleKind kind :
         {HandleKind::number, HandleKind::size, HandleKind::count, HandleKind::angle,
          HandleKind::interval, HandleKind::parameter_point, HandleKind::picture_point,
          HandleKind::space_point}) {
        EXPECT_TRUE(kinds.contains(kind)) << name_of(kind);
    }
}

}  // namespace balcony::lang::handles_test
