// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Further inputs of a program: what is declared, how often it is read, and what is refused.

#include <array>
#include <cmath>
#include <stdexcept>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::program::inputs_test {

namespace {

using expr::Expr;
using expr::Graph;

std::string refusal(std::span<const Expr> roots, const Interface& interface) {
    const Result<Program> made = Program::make(roots, interface);
    return made ? "" : made.diagnostics.front().message;
}

}  // namespace

TEST(Inputs, HaveTheRatesThatAreDeclared) {
    Graph graph;
    const Expr column = graph.input("column");
    const Expr row = graph.input("row");
    const std::array roots{
        sin(graph.input("uniform")),     sin(column),      sin(row), sin(graph.input("point")),
        sin(column + graph.picture_x()), sin(column + row)};
    const std::vector<Input> inputs{{"row", Rate::row},
                                    {"point", Rate::pixel},
                                    {"uniform", Rate::uniform},
                                    {"column", Rate::column}};
    const Result<Program> grid = Program::make(roots, {Sampling::grid, inputs});
    ASSERT_TRUE(grid);
    const std::array expected{Rate::uniform, Rate::column, Rate::row,
                              Rate::pixel,   Rate::column, Rate::pixel};
    for (std::size_t i = 0; i < roots.size(); ++i) {
        EXPECT_EQ(grid->rate(i), expected[i]) << i;
    }
    EXPECT_EQ(grid->instruction_count(Rate::uniform), 1U);
    EXPECT_EQ(grid->instruction_count(Rate::column), 3U);
    EXPECT_EQ(grid->inputs().size(), 4U);
    const Result<Program> points = Program::make(roots, {Sampling::points, inputs});
    ASSERT_TRUE(points);
    for (std::size_t i = 0; i < roots.size(); ++i) {
        EXPECT_EQ(points->rate(i), i == 0 ? Rate::uniform : Rate::pixel) << i;
    }
}

TEST(Inputs, AreReadInDeclaredOrder) {
    Graph graph;
    const std::array roots{graph.input("row"), graph.input("point"), graph.input("uniform"),
                           graph.input("column"), graph.input("row") * graph.input("column")};
    const Result<Program> program = Program::make(roots, {Sampling::grid,
                                                          {{"column", Rate::column},
                                                           {"ignored", Rate::pixel},
                                                           {"uniform", Rate::uniform},
                                                           {"row", Rate::row},
                                                           {"point", Rate::pixel}}});
    ASSERT_TRUE(program);
    const std::array columns{1.0, 2.0, 3.0};
    const std::array rows{10.0, 20.0};
    const std::array points{0.1, 0.2, 0.3, 0.4, 0.5, 0.6};
    const std::array one{7.0};
    const std::array<std::span<const double>, 5> values{columns, points, one, rows, points};
    const Tile tile{.width = 3, .height = 2, .inputs = values};
    Scratch scratch;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const Results results(*program, tile);
        run_on(set, *program, tile, scratch, results.pointers());
        for (std::size_t i = 0; i < 6; ++i) {
            EXPECT_EQ(results[0][i], rows[i / 3]);
            EXPECT_EQ(results[1][i], points[i]);
            EXPECT_EQ(results[2][i], 7.0);
            EXPECT_EQ(results[3][i], columns[i % 3]);
            EXPECT_EQ(results[4][i], rows[i / 3] * columns[i % 3]);
        }
        EXPECT_TRUE(results.rim_intact());
    }
}

namespace {

// A program that reads x, y and inputs of all rates, and the values of these over a picture that is
// larger than two tiles each way.
struct LargePicture {
    static constexpr std::size_t width = 2 * max_tile_width + 5;
    static constexpr std::size_t height = 2 * max_tile_height + 3;
    static constexpr double step = 0.25;

    LargePicture() {
        for (std::size_t i = 0; i < width * height; ++i) {
            points.push_back(std::sin(static_cast<double>(i)));
            x.push_back(0.5 + step * static_cast<double>(i % width));
            y.push_back(0.5 + step * static_cast<double>(i / width));
        }
    }

    [[nodiscard]] Program program(Sampling sampling) {
        Graph graph;
        const std::array roots{
            graph.picture_x() + 1e3 * graph.picture_y() + graph.time() * graph.input("point"),
            graph.input("column") - 7.0 * graph.input("row"), graph.input("uniform")};
        return *Program::make(roots, {sampling,
                                      {{"column", Rate::column},
                                       {"uniform", Rate::uniform},
                                       {"point", Rate::pixel},
                                       {"row", Rate::row}}});
    }

    [[nodiscard]] double expected(std::size_t root, std::size_t i) const {
        switch (root) {
            case 0: return x[i] + 1e3 * y[i] + 2.0 * points[i];
            case 1: return points[i % width] - 7.0 * points[i / width];
            default: return points[0];
        }
    }

    std::vector<double> x, y, points;
};

}  // namespace

TEST(Inputs, ReachAllPartsOfALargeTile) {
    LargePicture picture;
    const Program program = picture.program(Sampling::grid);
    const std::span<const double> all(picture.points);
    const std::array<std::span<const double>, 4> values{all.first(picture.width), all.first(1), all,
                                                        all.first(picture.height)};
    const Tile tile{.step = picture.step,
                    .width = picture.width,
                    .height = picture.height,
                    .time = 2.0,
                    .inputs = values};
    const Results results(program, tile);
    Scratch scratch;
    run(program, tile, scratch, results.pointers());
    for (std::size_t root = 0; root < program.root_count(); ++root) {
        for (std::size_t i = 0; i < picture.x.size(); ++i) {
            ASSERT_EQ(results[root][i], picture.expected(root, i)) << root << ' ' << i;
        }
    }
    EXPECT_TRUE(results.rim_intact());
}

TEST(Inputs, ReachAllPartsOfALongList) {
    LargePicture picture;
    const Program program = picture.program(Sampling::points);
    std::vector<double> columns, rows;
    for (std::size_t i = 0; i < picture.x.size(); ++i) {
        columns.push_back(picture.points[i % picture.width]);
        rows.push_back(picture.points[i / picture.width]);
    }
    const std::array<std::span<const double>, 4> values{
        columns, std::span<const double>(picture.points).first(1), picture.points, rows};
    const Results results(program, picture.x.size());
    Scratch scratch;
    run(program, {picture.x, picture.y, 2.0, values}, scratch, results.pointers());
    for (std::size_t root = 0; root < program.root_count(); ++root) {
        for (std::size_t i = 0; i < picture.x.size(); ++i) {
            ASSERT_EQ(results[root][i], picture.expected(root, i)) << root << ' ' << i;
        }
    }
    EXPECT_TRUE(results.rim_intact());
}

TEST(Inputs, ThatAreNotDeclaredAreRefused) {
    Graph graph;
    const std::array roots{graph.picture_x(), sin(graph.input("lens_u") + graph.input("lens_v"))};
    EXPECT_EQ(refusal(roots, {Sampling::grid, {{"lens_u", Rate::uniform}}}),
              "a formula depends on the input 'lens_v', which is not declared");
    EXPECT_EQ(refusal(roots, {Sampling::grid, {{"lens_u", {}}, {"lens_v", {}}}}), "");
    EXPECT_EQ(refusal(std::span(roots).first(1), {}), "") << "the graph may know inputs";
}

TEST(Inputs, AreDeclaredOnce) {
    Graph graph;
    const std::array roots{graph.picture_x()};
    EXPECT_EQ(refusal(roots, {Sampling::grid, {{"a", {}}, {"b", {}}, {"a", {}}}}),
              "the input 'a' is declared twice");
    for (const char* const name : {"x", "y", "t"}) {
        EXPECT_NE(refusal(roots, {Sampling::points, {{name, Rate::pixel}}}), "") << name;
    }
}

TEST(Inputs, AFreeVariableIsNone) {
    Graph graph;
    EXPECT_EQ(refusal(std::array{sin(graph.fresh_variable())}, {}),
              "a formula with a free variable cannot be compiled");
}

TEST(Inputs, OfTheWrongKindOrNumberAreRefusedInAllBuilds) {
    Graph graph;
    Graph other;
    const std::array apart{graph.picture_x(), other.picture_x()};
    EXPECT_EQ(kind_of_errors(Program::make(apart).diagnostics), Kind::internal);
    EXPECT_THROW(Program{apart}, std::logic_error);
    EXPECT_THROW(Program{std::array{graph.input("lens_u")}}, std::logic_error);
    const std::array root{graph.picture_x() * graph.input("lens_u")};
    const Result<Program> program =
        Program::make(root, {Sampling::grid, {{"lens_u", Rate::column}}});
    ASSERT_TRUE(program);
    EXPECT_THROW(static_cast<void>(program->rate(1)), std::logic_error);
    std::array<double, 6> values{};
    const std::array results{values.data()};
    const std::array<double, 3> columns{1.0, 2.0, 3.0};
    const std::array<std::span<const double>, 1> inputs{columns};
    Scratch scratch;
    const Tile tile{.width = 3, .height = 2, .inputs = inputs};
    run(*program, tile, scratch, results);
    EXPECT_EQ(values[5], 2.5 * 3.0);
    EXPECT_THROW(run(*program, tile, scratch, {}), std::logic_error);
    EXPECT_THROW(run(*program, Tile{.width = 3, .height = 2}, scratch, results), std::logic_error);
    EXPECT_THROW(run(*program, Tile{.width = 200, .height = 2, .inputs = inputs}, scratch, results),
                 std::logic_error);
    EXPECT_THROW(run(*program, Points{columns, columns, 0.0, inputs}, scratch, results),
                 std::logic_error);
}

}  // namespace balcony::program::inputs_test
