// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What holds for every built-in camera.

#include <algorithm>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <numeric>
#include <set>

#include <fmt/format.h>

#include "../laws/ray_laws.hpp"
#include "support.hpp"

namespace balcony::cameras::test::laws_test {

namespace {

namespace fs = std::filesystem;

class BuiltIn : public testing::TestWithParam<std::string> {};

fs::path file_of(const std::string& name) {
    return fs::path(BALCONY_SOURCE_DIR) / "cameras" / lang::family_of(name) / (name + ".cam");
}

std::string read(const fs::path& file) {
    std::ifstream stream(file, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

lang::Description description_of(const std::string& name) {
    const Result<std::vector<lang::Description>> described = lang::Workspace().describe(name);
    EXPECT_TRUE(described);
    const auto own = std::find_if(described->begin(), described->end(),
                                  [&](const lang::Description& one) { return one.name == name; });
    EXPECT_NE(own, described->end()) << name << ".cam has no camera of its name";
    return own != described->end() ? *own : lang::Description();
}

// Of a ray and its derivatives; nothing where there is none.
std::vector<std::uint64_t> bits(const rays::Ray& ray) {
    std::vector<std::uint64_t> found;
    for (const V3d& vector : {ray.origin, ray.direction, ray.origin_by_x, ray.origin_by_y,
                              ray.direction_by_x, ray.direction_by_y}) {
        for (int axis = 0; ray.valid && axis < 3; ++axis) {
            found.push_back(std::bit_cast<std::uint64_t>(vector[axis]));
        }
    }
    return found;
}

// A long hall beside the origin.
lang::SceneMeasures hall() {
    return {.min = {2.0, -3.0, 0.0},
            .max = {22.0, 5.0, 6.0},
            .inside = {11.0, 1.5, 1.6},
            .radius = 10.8,
            .profile = {{10.8, -3.0}, {10.8, 0.0}, {9.0, 3.0}}};
}

}  // namespace

TEST_P(BuiltIn, IsMadeWithoutDiagnostics) {
    const Result<camera::Picture> made = lang::make_picture(file_name(GetParam()), "");
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(to_text(made.diagnostics), "");
    EXPECT_EQ(made->name(), GetParam()) << "the last camera of a file has its name";
    EXPECT_EQ(laws::broken_law(*made), "");
}

TEST_P(BuiltIn, SaysInOneLineWhatItIsFor) {
    const std::string comment = description_of(GetParam()).comment;
    const std::size_t end = comment.find('.');
    ASSERT_NE(end, std::string::npos) << comment;
    EXPECT_GE(end, 20U) << comment;
    EXPECT_LE(end, 110U) << comment.substr(0, end);
}

TEST_P(BuiltIn, IsFormatted) {
    const auto text = std::make_shared<const SourceText>(GetParam(), read(file_of(GetParam())));
    const Result<std::string> formatted = lang::format(text);
    ASSERT_TRUE(formatted);
    EXPECT_EQ(*formatted, text->text());
}

// With --fit, it has rays in most of its picture, and they start near the scene.
TEST_P(BuiltIn, FitsAScene) {
    lang::Workspace workspace;
    workspace.fit_to(hall());
    const Result<camera::Picture> made = workspace.make_picture(file_name(GetParam()));
    ASSERT_TRUE(made) << to_text(made.diagnostics);
    EXPECT_EQ(to_text(made.diagnostics), "");
    EXPECT_FALSE(workspace.fitted().empty()) << "no fit statement";
    constexpr std::size_t side = 48;
    const auto width = static_cast<std::size_t>(std::lround(side * made->aspect()));
    const Result<rays::CompiledPicture> picture =
        rays::compile(*made, static_cast<double>(width), side, {.bends = true});
    ASSERT_TRUE(picture);
    std::size_t valid = 0;
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (const auto& layer : picture->layers()) {
        layer.rays.run({.width = width, .height = side}, scratch, batch);
        for (std::size_t i = 0; i < batch.size(); ++i) {
            if (batch.valid(i)) {
                ++valid;
                EXPECT_LE((batch.origin(i) - V3d(12.0, 1.0, 3.0)).length(), 400.0);
            }
        }
    }
    // The thinnest map, which is infinite, covers 0.317 of its picture.
    EXPECT_GE(valid, 3 * width * side / 10);
}

// Over tiles, programs leave out the branches that no point takes; at single points, they do not.
TEST_P(BuiltIn, HasTheSameRaysInTilesAsAtPoints) {
    const Result<camera::Picture> made = lang::make_picture(file_name(GetParam()), "");
    ASSERT_TRUE(made);
    constexpr std::size_t side = 160;
    const auto width = static_cast<std::size_t>(std::lround(side * made->aspect()));
    const Result<rays::CompiledPicture> picture =
        rays::compile(*made, static_cast<double>(width), side,
                      {.footprints = true, .points = true, .bends = true});
    ASSERT_TRUE(picture);
    rays::Scratch scratch;
    rays::RayBatch tile;
    rays::RayBatch points;
    std::vector<double> x(width);
    std::iota(x.begin(), x.end(), 0.5);
    for (const auto& layer : picture->layers()) {
        layer.rays.run({.width = width, .height = side}, scratch, tile);
        for (std::size_t row = 0; row < side; ++row) {
            const std::vector<double> y(width, 0.5 + static_cast<double>(row));
            layer.rays.run(rays::Points{x, y, 0.0}, scratch, points);
            for (std::size_t i = 0; i < width; ++i) {
                ASSERT_EQ(bits(tile[row * width + i]), bits(points[i])) << x[i] << ", " << y[i];
            }
        }
    }
}

TEST_P(BuiltIn, IsMadeAtTheLimitsOfItsParametersAndNotBeyond) {
    // What these may be depends on other parameters as well.
    const std::set<std::string_view> depends{"omnimax radius",
                                             "catadioptric_spherical distance",
                                             "pavement_anamorphosis far",
                                             "slide_curved radius",
                                             "slide_mesh throw",
                                             "ods merge_from",
                                             "ods merge_to",
                                             "ods_stereo merge_from",
                                             "ods_stereo merge_to",
                                             "portrait_lens distance",
                                             "vr180 merge_from",
                                             "vr180 merge_to"};
    for (const auto& parameter : description_of(GetParam()).parameters) {
        const bool is_angle = parameter.default_text.find("deg") != std::string::npos;
        const auto made = [&](double value) {
            return lang::make_picture(
                       file_name(GetParam()), "",
                       {{parameter.name, fmt::format("{:.17g}{}", value, is_angle ? "rad" : "")}})
                .value.has_value();
        };
        const auto& [minimum, maximum, excludes_minimum] = parameter.limits;
        const bool at_limits = !depends.contains(GetParam() + " " + parameter.name);
        if (std::isfinite(minimum)) {
            EXPECT_TRUE(!at_limits || made(excludes_minimum ? minimum + 0.01 : minimum))
                << parameter.name;
            EXPECT_FALSE(made(excludes_minimum ? minimum : minimum - 1e-6)) << parameter.name;
        }
        if (std::isfinite(maximum)) {
            EXPECT_TRUE(!at_limits || made(maximum)) << parameter.name;
            EXPECT_FALSE(made(maximum + 1e-6)) << parameter.name;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(All, BuiltIn, testing::ValuesIn(lang::built_in_cameras()),
                         [](const auto& name) { return name.param; });

// Names are found whatever their family, so no two families share one.
TEST(BuiltInCameras, HaveDifferentNames) {
    const std::vector<std::string>& names = lang::built_in_cameras();
    EXPECT_EQ(std::set(names.begin(), names.end()).size(), names.size());
}

// docs/coverage.md names the file and the test of every built-in camera.
TEST(BuiltInCameras, AreAllCovered) {
    const std::string coverage = read(fs::path(BALCONY_SOURCE_DIR) / "docs" / "coverage.md");
    for (const std::string& name : lang::built_in_cameras()) {
        EXPECT_NE(coverage.find('`' + name + '`'), std::string::npos) << name;
    }
}

}  // namespace balcony::cameras::test::laws_test
