// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Every example of the catalogue is a camera file that says nothing and gives rays.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "balcony/catalogue.hpp"
#include "support.hpp"

namespace balcony::lang::examples_test {
namespace {

using camera::StageEntry;

std::string test_name(const testing::TestParamInfo<StageEntry>& row) {
    std::string name = std::string(name_of(row.param.kind)) + "_" + std::string(row.param.name);
    std::replace(name.begin(), name.end(), ' ', '_');
    return name;
}

bool shows_a_picture(const StageEntry& row) {
    return row.example.starts_with("picture ") ||
           row.example.find("\npicture ") != std::string_view::npos;
}

std::vector<StageEntry> rows_with_a_picture() {
    std::vector<StageEntry> rows;
    for (const StageEntry& row : camera::catalogue()) {
        if (shows_a_picture(row)) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::vector<StageEntry> rows_with_a_camera() {
    std::vector<StageEntry> rows;
    for (const StageEntry& row : camera::catalogue()) {
        if (!shows_a_picture(row)) {
            rows.push_back(row);
        }
    }
    return rows;
}

class EveryExample : public testing::TestWithParam<StageEntry> {};

TEST_P(EveryExample, LoadsWithoutAWordAndGivesRays) {
    const Result<camera::Camera> camera = test::make(std::string(GetParam().example));
    ASSERT_TRUE(camera) << to_text(camera.diagnostics);
    EXPECT_EQ(to_text(camera.diagnostics), "");

    constexpr int rows = 12;
    const int columns = static_cast<int>(rows * camera->parts().aspect);
    expr::Graph graph;
    const camera::RayExpressions ray = camera->emit(graph, columns, rows);
    const std::array roots{ray.valid, ray.direction.x, ray.direction.y, ray.direction.z};
    int valid = 0;
    for (int x = 0; x < columns; ++x) {
        for (int y = 0; y < rows; ++y) {
            const std::vector<double> r = expr::evaluate(roots, {x + 0.5, y + 0.5, 0.0, {}});
            if (r[0] != 0.0) {
                EXPECT_NEAR(std::hypot(r[1], r[2], r[3]), 1.0, 1e-12);
                ++valid;
            }
        }
    }
    // The faces of an unfolded cube fill half of its picture; nothing shows less.
    EXPECT_GE(2 * valid, columns * rows);
}

// The example shows the stage itself. A map's rows have no name in the language.
TEST_P(EveryExample, UsesItsStage) {
    if (GetParam().kind != camera::StageKind::picture_mapper) {
        EXPECT_NE(GetParam().example.find(GetParam().name), std::string_view::npos);
    }
}

class EveryPictureExample : public testing::TestWithParam<StageEntry> {};

TEST_P(EveryPictureExample, LoadsWithoutAWordAndCoversAPart) {
    const Result<camera::Picture> picture = make_picture(
        std::make_shared<const SourceText>("example", std::string(GetParam().example)), "");
    ASSERT_TRUE(picture) << to_text(picture.diagnostics);
    EXPECT_EQ(to_text(picture.diagnostics), "");
    expr::Graph graph;
    const auto elements = picture->emit(graph, 40.0, 30.0).elements;
    const std::array roots{elements.front().coverage, elements.front().ray->valid};
    double covered = 0.0;
    for (int x = 0; x < 40; ++x) {
        for (int y = 0; y < 30; ++y) {
            const std::vector<double> r = expr::evaluate(roots, {x + 0.5, y + 0.5, 0.0, {}});
            EXPECT_EQ(r[1], 1.0);
            covered += r[0];
        }
    }
    EXPECT_GT(covered, 0.2 * 40 * 30);
    EXPECT_LT(covered, 0.95 * 40 * 30);
}

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryPictureExample, testing::ValuesIn(rows_with_a_picture()),
                         test_name);

INSTANTIATE_TEST_SUITE_P(Catalogue, EveryExample, testing::ValuesIn(rows_with_a_camera()),
                         test_name);

}  // namespace
}  // namespace balcony::lang::examples_test
