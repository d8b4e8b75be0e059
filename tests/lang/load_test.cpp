// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Files, imports, names of cameras and values from outside.

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../files/temporary_folder.hpp"
#include "support.hpp"

namespace balcony::lang::load_test {
namespace {

const std::string plain = "{ map u = 0 .. 1, v = square eye sphere(r) }\n";

std::string first_error(const Diagnostics& said) {
    return said.empty() ? "" : said.front().message;
}

double radius_of(const Result<camera::Camera>& made) {
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return made ? test::ray(*made, 0, 1, 2, 2).origin[0] : 0.0;
}

TEST(Load, AnEmptyNameSelectsTheLastCamera) {
    const std::string text = "camera a(r = 1) " + plain + "camera b(r = 2) " + plain;
    EXPECT_EQ(test::make(text)->name(), "b");
    EXPECT_EQ(test::make(text, {}, "a")->name(), "a");
    EXPECT_EQ(first_error(test::make(text, {}, "bb").diagnostics),
              "'test.cam' has no camera or picture 'bb'");
}

TEST(Load, ErrorsOfOtherCamerasDoNotMatter) {
    const std::string text = "camera a(r = nothing) " + plain + "camera b(r = 2) " + plain;
    EXPECT_TRUE(test::make(text));
    EXPECT_FALSE(test::make(text, {}, "a"));
}

TEST(Load, AnAspectIsAPlainNumberAbove0) {
    const auto error_of = [](const std::string& aspect) {
        return first_error(
            test::make("camera a { aspect " + aspect + " map u = 0 .. 1, v = square eye sphere }")
                .diagnostics);
    };
    EXPECT_EQ(error_of("1/100"), "");
    EXPECT_EQ(error_of("0"), "the aspect of a camera must be above 0, but is 0");
    EXPECT_EQ(error_of("90deg"),
              "the aspect of a camera must be a plain number, but this is an angle");
}

TEST(Load, OverridesReplaceDefaults) {
    const std::string text =
        "let k = 5 camera a(r = 1, s = 2*r) "
        "{ map u = 0 .. 1, v = square eye sphere(s) }";
    EXPECT_EQ(radius_of(test::make(text)), 2.0);
    EXPECT_EQ(radius_of(test::make(text, {{"r", "1/2"}})), 1.0);
    EXPECT_EQ(radius_of(test::make(text, {{"s", "r + k"}})), 6.0);
    EXPECT_EQ(radius_of(test::make(text, {{"r", "1"}, {"r", "3"}})), 6.0);
}

TEST(Load, WrongOverridesAreErrors) {
    const std::string text =
        "camera a(radius = 1, turn = 30deg, free = 0) "
        "{ map u = 0 .. 1, v = square eye sphere(radius) "
        "move rotate(z, turn), rotate(x, free) }";
    const auto error_of = [&text](const char* name, const char* value) {
        const Result<camera::Camera> made = test::make(text, {{name, value}});
        EXPECT_FALSE(made);
        EXPECT_EQ(made.diagnostics.size(), 1U) << to_text(made.diagnostics);
        return made ? "" : to_text(made.diagnostics);
    };
    EXPECT_EQ(error_of("raduis", "2"),
              "--set:1:1: error: the camera 'a' has no parameter 'raduis'\n"
              "    1 | raduis=2\n"
              "      | ^~~~~~\n"
              "  help: did you mean 'radius'?\n");
    EXPECT_EQ(error_of("turn", "30"),
              "--set:1:6: error: 'turn' must be an angle, but this is a plain number\n"
              "    1 | turn=30\n"
              "      |      ^~\n"
              "  help: append deg or rad: 30deg, 0.5rad\n");
    EXPECT_EQ(error_of("radius", "1deg"),
              "--set:1:8: error: 'radius' must be a plain number, but this is an angle\n"
              "    1 | radius=1deg\n"
              "      |        ^~~~\n"
              "  help: remove deg or rad\n");
    EXPECT_EQ(error_of("radius", "1/0"),
              "--set:1:10: error: division by 0\n"
              "    1 | radius=1/0\n"
              "      |          ^\n"
              "  help: change the divisor, or exclude 0 with if(condition, a, b)\n");
    EXPECT_EQ(
        error_of("radius", "2 3"),
        "--set:1:10: error: expected the end of the value, but found '3'\n"
        "    1 | radius=2 3\n"
        "      |          ^\n"
        "  help: combine its parts with operators; use a separate --set for each parameter\n");
    EXPECT_EQ(error_of("radius", ""),
              "--set:1:8: error: expected a number, a name or '(', but the text ends here\n"
              "    1 | radius=\n"
              "      |        ^\n"
              "  help: write a value after '='\n");
    EXPECT_TRUE(test::make(text, {{"free", "30deg"}}));
}

TEST(Load, ImportsBringLetsAndCameras) {
    const files::TemporaryFolder folder;
    folder.write("lengths.cam", "let k = 3");
    folder.write("more.cam", "import \"lengths.cam\" let m = k + 1 camera more(r = m) " + plain);
    const auto file = folder.write("main.cam",
                                   "import \"more.cam\" import \"lengths.cam\" "
                                   "import \"pinhole.cam\" camera a(r = k + m) " +
                                       plain);
    EXPECT_EQ(radius_of(make_camera(file, "")), 7.0);
    EXPECT_EQ(radius_of(make_camera(file, "more")), 4.0);
    EXPECT_TRUE(make_camera(file, "pinhole"));
    EXPECT_EQ(Workspace().describe(file)->size(), 1U);
}

TEST(Load, TextsFindImportsInTheirFolder) {
    const files::TemporaryFolder folder;
    folder.write("lengths.cam", "let k = 3");
    const auto source = std::make_shared<const SourceText>(
        "text", "import \"lengths.cam\" camera a(r = k) " + plain);
    EXPECT_EQ(radius_of(make_camera({source, folder.path()}, "")), 3.0);
    EXPECT_FALSE(make_camera(source, ""));
}

TEST(Load, AFileWithOnlyImportsSuggestsImportedCameras) {
    const Diagnostics said = test::make("import \"pinhole.cam\"").diagnostics;
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].remedy, "name one of its imported cameras: 'pinhole'");
}

TEST(Load, UnknownFilesGetASuggestion) {
    const Diagnostics said = make_camera("pinhol", "").diagnostics;
    ASSERT_EQ(said.size(), 1U);
    EXPECT_EQ(said[0].message, "there is no file and no built-in camera named 'pinhol'");
    EXPECT_EQ(said[0].remedy, "did you mean 'pinhole'?");
}

TEST(Load, AWordOfADescriptionFindsItsCamera) {
    const auto remedy = [](const char* name) {
        return make_camera(name, "").diagnostics.at(0).remedy;
    };
    EXPECT_TRUE(remedy("equirectangular").starts_with("did you mean 'panorama'"))
        << remedy("equirectangular");
    EXPECT_EQ(remedy("nowhere_to_be_found"), "'balcony list cameras' shows the built-in cameras");
}

TEST(Load, WordsOfOthersLeadToACamera) {
    const auto first = [](std::string_view words) {
        const std::vector<CameraMatch> found = search_built_in_cameras(words);
        return found.empty() ? std::string("nothing") : found.front().name;
    };
    EXPECT_EQ(first("perspective"), "pinhole");
    EXPECT_EQ(first("360"), "panorama");
    EXPECT_EQ(first("equirectangular"), "panorama");
    EXPECT_EQ(first("top"), "orthographic");
    const std::vector<CameraMatch> flat = search_built_in_cameras("flatten a room");
    ASSERT_EQ(flat.size(), 2U);
    EXPECT_EQ(flat[0].name, "cylinder");
    EXPECT_EQ(flat[1].name, "superelliptic");
    EXPECT_EQ(first("unroll a vase"), "rollout");
    EXPECT_EQ(first("qwertyuiop"), "nothing");
    for (const auto& [word, family] :
         {std::pair("unwrap", "unroll"), std::pair("stereo", "stereo"), std::pair("vr", "panorama"),
          std::pair("cubemap", "panorama"), std::pair("dome", "dome")}) {
        EXPECT_EQ(family_of(first(word)), family) << word << " finds " << first(word);
    }
    // Both are in keywords, but a map comes after all others.
    const std::vector<CameraMatch> found = search_built_in_cameras("stereographic");
    const auto is_map = [](const CameraMatch& one) { return family_of(one.name) == "maps"; };
    EXPECT_TRUE(std::any_of(found.begin(), found.end(), is_map));
    EXPECT_TRUE(std::is_partitioned(found.begin(), found.end(),
                                    [&](const CameraMatch& one) { return !is_map(one); }));
}

TEST(Load, AMapIsNotTakenSilentlyForAnotherCamera) {
    const auto warned = [](const char* name) { return make_camera(name, "").diagnostics; };
    ASSERT_EQ(warned("ortho").size(), 1U);
    EXPECT_EQ(warned("ortho")[0].message, "'ortho' is the map projection of this name");
    EXPECT_TRUE(warned("ortho")[0].remedy.starts_with("did you mean 'orthographic'?"));
    EXPECT_TRUE(warned("ortho.cam").empty());
    EXPECT_TRUE(warned("robin").empty());
}

TEST(Load, KeywordsAreNoPartOfTheComment) {
    const files::TemporaryFolder folder;
    const auto file = folder.write(
        "a.cam",
        "// A use.\n//\n// Keywords: vr, 360.\ncamera a { map u = 0 .. 1, v = 0 .. 1 eye "
        "surface(u, v) = [u, v, 0] look normal }\n");
    const auto described = Workspace().describe(file);
    ASSERT_TRUE(described);
    EXPECT_EQ(described->front().comment, "A use.");
    EXPECT_EQ(described->front().keywords, "vr, 360.");
}

TEST(Load, DescribesCameras) {
    const files::TemporaryFolder folder;
    const auto file = folder.write("a.cam",
                                   "// Not this.\n\n// First line,\n// second line.\n"
                                   "camera a(r = 1 + 2, turn = 30deg) " +
                                       plain + "\ncamera b " + plain);
    const auto said = Workspace().describe(file);
    ASSERT_TRUE(said);
    ASSERT_EQ(said->size(), 2U);
    const Description& a = (*said)[0];
    EXPECT_EQ(a.comment, "First line,\nsecond line.");
    ASSERT_EQ(a.parameters.size(), 2U);
    EXPECT_EQ(a.parameters[0].default_text, "1 + 2");
    EXPECT_EQ(a.parameters[1].name, "turn");
    EXPECT_EQ((*said)[1].comment, "");
}

TEST(Load, AByteOrderMarkIsNoError) {
    EXPECT_TRUE(
        test::make("\xef\xbb\xbf"
                   "camera a(r = 1) " +
                   plain));
}

TEST(Load, WarningsComeWithTheCamera) {
    const Result<camera::Camera> made = test::make("camera a(r = 1, unused = 2) " + plain);
    ASSERT_TRUE(made);
    ASSERT_EQ(made.diagnostics.size(), 1U);
    EXPECT_EQ(made.diagnostics[0].severity, Severity::warning);
}

}  // namespace
// Few words can ask for more than fits: seeds times repetitions.
TEST(Limits, ACameraThatIsTooLargeIsReported) {
    std::string seeds;
    for (int i = 0; i < 200; ++i) {
        seeds += fmt::format("{}({}, {}, {}, {})", i == 0 ? "" : ", ", i % 20, i / 20, i % 20 + 0.1,
                             i / 20);
    }
    const auto made =
        test::make(fmt::format("camera large {{\n"
                               "    map  u = 0 .. 19, v = 0 .. 9\n"
                               "    warp repeat(64, repeat(8, inverse_distance([{}])))\n"
                               "    eye  plane\n"
                               "}}\n",
                               seeds));
    EXPECT_FALSE(made);
    EXPECT_NE(to_text(made.diagnostics).find("camera 'large' is too large"), std::string::npos)
        << to_text(made.diagnostics);
}

}  // namespace balcony::lang::load_test
