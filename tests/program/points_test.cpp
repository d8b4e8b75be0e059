// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Programs for points: at any points, in any order, what a program for grids gives there.

#include <array>
#include <random>

#include <gtest/gtest.h>

#include "program/tape.hpp"
#include "random_expressions.hpp"
#include "support.hpp"

namespace balcony::program::points_test {

namespace {

using expr::Expr;
using expr::Graph;

struct PointList {
    std::vector<double> x, y;
    double time = 0.0;

    [[nodiscard]] std::size_t size() const { return x.size(); }
};

PointList random_points(Random& random, std::size_t count) {
    std::uniform_real_distribution<double> place(-40.0, 40.0);
    PointList list;
    for (std::size_t i = 0; i < count; ++i) {
        list.x.push_back(place(random));
        list.y.push_back(place(random));
    }
    list.time = place(random);
    return list;
}

// Each point by itself, as a tile of one point of a program for grids on the same instruction set.
void expect_points_equal_grid(std::span<const Expr> roots, const PointList& list) {
    const Program for_grids = compile_random(roots);
    const Program for_points = compile_random(roots, Sampling::points);
    Random random(list.size());
    const RandomInputs inputs(random, list.size());
    const Points points{list.x, list.y, list.time, inputs.values()};
    const Results reference(for_points, list.size());
    run_reference(for_points, points, reference.pointers());
    Scratch scratch;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        SCOPED_TRACE(instruction_sets()[set].name);
        const bool scalar = instruction_sets()[set].name == "scalar";
        const Results results(for_points, list.size());
        run_on(set, for_points, points, scratch, results.pointers());
        EXPECT_TRUE(results.rim_intact());
        for (std::size_t i = 0; i < list.size(); ++i) {
            std::vector<std::span<const double>> here{inputs.values()[0]};
            for (const std::span<const double> values : inputs.values().subspan(1)) {
                here.push_back(values.subspan(i, 1));
            }
            const Tile tile{.x = list.x[i],
                            .y = list.y[i],
                            .width = 1,
                            .height = 1,
                            .time = list.time,
                            .inputs = here};
            const Results expected(for_grids, tile);
            run_on(set, for_grids, tile, scratch, expected.pointers());
            for (std::size_t r = 0; r < roots.size(); ++r) {
                ASSERT_TRUE(identical(results[r][i], expected[r][0]))
                    << "root " << r << " point " << i << " of " << list.size() << ": "
                    << results[r][i] << ", on a grid " << expected[r][0];
                ASSERT_TRUE(!scalar || identical(results[r][i], reference[r][i]))
                    << "root " << r << " point " << i << ": " << results[r][i] << ", by reference "
                    << reference[r][i];
            }
        }
    }
}

}  // namespace

TEST(PointPrograms, EqualProgramsForGridsBitForBit) {
    for (std::uint64_t seed = 0; seed < 100; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph graph;
        const auto roots =
            random_expressions(graph, random, 10 + random() % 150, 1 + random() % 20, false);
        expect_points_equal_grid(roots, random_points(random, 1 + random() % max_points));
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST(PointPrograms, EveryCountWorks) {
    Random random(5);
    Graph graph;
    std::vector<Expr> roots = random_expressions(graph, random, 60, 3, false);
    roots.push_back(graph.picture_x() * 2.0);
    roots.push_back(graph.picture_x() * graph.picture_y());
    for (std::size_t count = 0; count <= max_points; ++count) {
        expect_points_equal_grid(roots, random_points(random, count));
    }
}

TEST(PointPrograms, RootsOfEveryKindAreWritten) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::vector<Expr> roots{x,     y, graph.time(), graph.constant(7.5), x * y, x * y,
                                  x < y, y, sqrt(x * x)};
    Random random(11);
    for (const std::size_t count : {5UL, 8UL, 64UL}) {
        expect_points_equal_grid(roots, random_points(random, count));
        expect_points_equal_grid(std::array{x, y}, random_points(random, count));
    }
}

TEST(PointPrograms, NodesThatDependOnThePointRunOncePerPoint) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::vector<Expr> roots{sin(graph.time()), sin(x), exp(y), atan2(x, y)};
    const Program program(roots, Sampling::points);
    EXPECT_EQ(program.sampling(), Sampling::points);
    EXPECT_EQ(program.rate(0), Rate::uniform);
    EXPECT_EQ(program.rate(1), Rate::pixel);
    EXPECT_EQ(program.rate(2), Rate::pixel);
    EXPECT_EQ(program.instruction_count(Rate::uniform), 1U);
    EXPECT_EQ(program.instruction_count(Rate::column), 0U);
    EXPECT_EQ(program.instruction_count(Rate::row), 0U);
    EXPECT_EQ(program.instruction_count(Rate::pixel), 3U);
}

TEST(PointPrograms, WithoutSimplificationTheyComputeTheSameByMoreInstructions) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::vector<Expr> roots{2.0 * x + (y + 3.0 * x) - y, (x * y) / y * cos(x)};
    const auto made = [&](bool is_simplified) {
        return *Program::make(roots, {Sampling::points, {}, is_simplified});
    };
    const Program plain = made(false);
    const Program simplified = made(true);
    EXPECT_GT(plain.instruction_count(Rate::pixel), simplified.instruction_count(Rate::pixel));
    const std::array xs{0.5, 7.25, -3.0};
    const std::array ys{2.0, -0.125, 11.0};
    const Points points{xs, ys, 0.0, {}};
    Scratch scratch;
    ResultArrays one;
    ResultArrays other;
    run(plain, points, scratch, one.reserve(roots.size(), xs.size()));
    run(simplified, points, scratch, other.reserve(roots.size(), xs.size()));
    for (std::size_t root = 0; root < roots.size(); ++root) {
        for (std::size_t i = 0; i < xs.size(); ++i) {
            // Eight roundings of at most half a unit in the last place of numbers up to 50.
            EXPECT_NEAR(one[root][i], other[root][i], 8 * 0.5 * 0x1p-47) << root << ' ' << i;
        }
    }
}

}  // namespace balcony::program::points_test
