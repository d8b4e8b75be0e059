// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Whole programs on whole tiles: every runner against the reference, the reference against the
// graph.

#include <random>
#include <thread>

#include <gtest/gtest.h>

#include "random_expressions.hpp"
#include "support.hpp"

namespace balcony::program::tiles_test {

namespace {

using expr::Expr;
using expr::Graph;

Tile random_tile(Random& random) {
    std::uniform_real_distribution<double> place(-40.0, 40.0);
    std::uniform_real_distribution<double> step(0.01, 3.0);
    return {place(random),
            place(random),
            step(random),
            1 + random() % max_tile_width,
            1 + random() % max_tile_height,
            place(random)};
}

void expect_identical(const Results& a, const Results& b, const Program& program,
                      const Tile& tile) {
    for (std::size_t r = 0; r < program.root_count(); ++r) {
        for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
            ASSERT_TRUE(identical(a[r][i], b[r][i]))
                << "root " << r << " point " << i << " of " << tile.width << " x " << tile.height
                << ": " << a[r][i] << " and " << b[r][i];
        }
    }
}

void expect_runners_equal_reference(const Program& program, Tile tile) {
    Random random(tile.width + tile.height);
    const RandomInputs inputs(random, tile);
    tile.inputs = inputs.values().first(program.inputs().size());
    const Results expected(program, tile);
    run_reference(program, tile, expected.pointers());
    Scratch scratch;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        SCOPED_TRACE(instruction_sets()[set].name);
        const Results results(program, tile);
        run_on(set, program, tile, scratch, results.pointers());
        expect_identical(results, expected, program, tile);
        EXPECT_TRUE(results.rim_intact());
    }
}

void expect_reference_equals_graph(const Program& program, std::span<const Expr> roots, Tile tile) {
    const std::vector<Expr> simplified = simplify_random(roots);
    Random random(tile.width + tile.height);
    const RandomInputs inputs(random, tile);
    tile.inputs = inputs.values().first(program.inputs().size());
    const Results results(program, tile);
    run_reference(program, tile, results.pointers());
    for (std::size_t j = 0; j < tile.height; ++j) {
        for (std::size_t i = 0; i < tile.width; ++i) {
            const std::array values_here{
                expr::InputValue{"uniform", inputs.values()[0][0]},
                expr::InputValue{"column", inputs.values()[1][i]},
                expr::InputValue{"row", inputs.values()[2][j]},
                expr::InputValue{"pixel", inputs.values()[3][j * tile.width + i]}};
            const expr::Point point{tile.x + static_cast<double>(i) * tile.step,
                                    tile.y + static_cast<double>(j) * tile.step,
                                    tile.time,
                                    {},
                                    values_here};
            const std::vector<double> values = expr::evaluate(simplified, point);
            for (std::size_t r = 0; r < values.size(); ++r) {
                ASSERT_TRUE(identical(results[r][j * tile.width + i], values[r])) << "root " << r;
            }
        }
    }
}

}  // namespace

TEST(Tiles, RandomProgramsEqualTheReferenceBitForBit) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph graph;
        const auto roots =
            random_expressions(graph, random, 10 + random() % 150, 1 + random() % 20, true);
        const Program program = compile_random(roots);
        expect_runners_equal_reference(program, random_tile(random));
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST(Tiles, TheReferenceEqualsTheGraph) {
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph graph;
        const auto roots =
            random_expressions(graph, random, 10 + random() % 150, 1 + random() % 20, false);
        const Program program = compile_random(roots);
        Tile tile = random_tile(random);
        tile.width = 1 + tile.width % 9;
        tile.height = 1 + tile.height % 9;
        expect_reference_equals_graph(program, roots, tile);
        if (HasFatalFailure()) {
            return;
        }
    }
}

TEST(Tiles, EverySizeWorks) {
    Random random(7);
    Graph graph;
    std::vector<Expr> roots = random_expressions(graph, random, 60, 3, true);
    roots.push_back(graph.picture_x() * 2.0);
    roots.push_back(graph.picture_y());
    roots.push_back(graph.picture_x() * graph.picture_y());
    roots.push_back(graph.constant(-0.0));
    const Program program = compile_random(roots);
    const std::size_t sizes[]{0, 1, 2, 3, 4, 5, 7, 8, 9, 15, 16, 17, 31, 33, 63, 64};
    for (const std::size_t width : sizes) {
        for (const std::size_t height : sizes) {
            expect_runners_equal_reference(
                program, {.x = -3.5, .y = 8.25, .step = 0.5, .width = width, .height = height});
        }
    }
}

TEST(Tiles, PointsBeyondTheLimitsAreMovedOntoThem) {
    Graph graph;
    const std::vector<Expr> roots{graph.picture_x(), graph.picture_y(),
                                  graph.picture_x() * graph.picture_y()};
    const Program program(roots);
    const Tile tile{.x = -1.0,
                    .y = 2.0,
                    .width = 13,
                    .height = 5,
                    .x_limits = {0.5, 9.25},
                    .y_limits = {.maximum = 4.5}};
    expect_runners_equal_reference(program, tile);
    const Results results(program, tile);
    run_reference(program, tile, results.pointers());
    for (std::size_t j = 0; j < tile.height; ++j) {
        for (std::size_t i = 0; i < tile.width; ++i) {
            const double x = i < 2 ? 0.5 : i > 10 ? 9.25 : static_cast<double>(i) - 1.0;
            const double y = j > 2 ? 4.5 : static_cast<double>(j) + 2.0;
            EXPECT_EQ(results[0][j * tile.width + i], x);
            EXPECT_EQ(results[1][j * tile.width + i], y);
            EXPECT_EQ(results[2][j * tile.width + i], x * y);
        }
    }
}

TEST(Tiles, RootsOfEveryKindAreWritten) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const Expr product = x * y;
    const std::vector<Expr> roots{product, graph.constant(7.5), x, y, graph.time(), product, x < y,
                                  x + 1.0, graph.constant(7.5)};
    const Program program(roots);
    const Tile tile{.x = 2.0, .y = 3.0, .step = 0.25, .width = 13, .height = 5, .time = 11.0};
    Scratch scratch;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const Results results(program, tile);
        run_on(set, program, tile, scratch, results.pointers());
        for (std::size_t j = 0; j < tile.height; ++j) {
            for (std::size_t i = 0; i < tile.width; ++i) {
                const double at_x = 2.0 + 0.25 * static_cast<double>(i);
                const double at_y = 3.0 + 0.25 * static_cast<double>(j);
                const double expected[]{
                    at_x * at_y, 7.5, at_x, at_y, 11.0, at_x * at_y, at_x < at_y ? 1.0 : 0.0,
                    at_x + 1.0,  7.5};
                for (std::size_t r = 0; r < roots.size(); ++r) {
                    ASSERT_EQ(results[r][j * tile.width + i], expected[r]) << "root " << r;
                }
            }
        }
    }
}

// A sum frees the register of one of its terms; a constant that stands later must not get it, as it
// is there before the terms are.
TEST(Tiles, ConstantsOutliveUniformInstructions) {
    Graph graph;
    const std::vector<Expr> roots{sin(graph.time()) + cos(graph.time()), graph.constant(7.5)};
    const Program program(roots);
    const Tile tile{.width = 3, .height = 2, .time = 0.25};
    const Results results(program, tile);
    run_reference(program, tile, results.pointers());
    EXPECT_EQ(results[1][0], 7.5);
    expect_reference_equals_graph(program, roots, tile);
}

TEST(Tiles, AChainOfAHundredThousandNodesCompilesAndRuns) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    Expr chain = x;
    for (int i = 0; i < 50'000; ++i) {
        chain = max(sqrt(chain * chain), y);
    }
    const std::vector<Expr> roots{chain};
    const Program program = compile_random(roots);
    expect_runners_equal_reference(program, {.width = 3, .height = 2});
}

TEST(Tiles, OneScratchServesProgramsOfAnySize) {
    Scratch shared;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        Random random(seed);
        Graph graph;
        const auto roots = random_expressions(graph, random, 5 + random() % 300, 4, false);
        const Program program = compile_random(roots);
        Tile tile = random_tile(random);
        const RandomInputs inputs(random, tile);
        tile.inputs = inputs.values();
        const Results with_shared(program, tile);
        const Results with_own(program, tile);
        Scratch own;
        run(program, tile, shared, with_shared.pointers());
        run(program, tile, own, with_own.pointers());
        expect_identical(with_shared, with_own, program, tile);
    }
}

TEST(Tiles, ThreadsMakeTheSameBits) {
    Random random(3);
    Graph graph;
    const auto roots = random_expressions(graph, random, 200, 8, false);
    const Program program = compile_random(roots);
    Tile tile{.x = 0.5, .y = 0.5, .step = 1.0, .width = 61, .height = 64, .time = 0.25};
    const RandomInputs inputs(random, tile);
    tile.inputs = inputs.values();
    constexpr std::size_t threads = 4;
    std::vector<Results> results;
    for (std::size_t thread = 0; thread < threads; ++thread) {
        results.emplace_back(program, tile);
    }
    {
        std::vector<std::jthread> running;
        for (std::size_t thread = 0; thread < threads; ++thread) {
            running.emplace_back([&, thread] {
                Scratch scratch;
                for (int pass = 0; pass < 20; ++pass) {
                    run(program, tile, scratch, results[thread].pointers());
                }
            });
        }
    }
    for (std::size_t thread = 1; thread < threads; ++thread) {
        expect_identical(results[thread], results[0], program, tile);
    }
}

// SLEEF's deterministic variants: what one machine rendered, another one with AVX2 or AVX-512
// renders again.
TEST(FusedInstructionSets, MakeTheSameBits) {
    std::vector<std::size_t> fused;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        if (instruction_sets()[set].name.starts_with("avx")) {
            fused.push_back(set);
        }
    }
    if (fused.size() < 2) {
        GTEST_SKIP() << "this machine has only one of them";
    }
    Scratch scratch;
    for (std::uint64_t seed = 0; seed < 300; ++seed) {
        SCOPED_TRACE(seed);
        Random random(seed);
        Graph graph;
        const auto roots = random_expressions(graph, random, 100, 10, false);
        const Program program = compile_random(roots);
        Tile tile = random_tile(random);
        const RandomInputs inputs(random, tile);
        tile.inputs = inputs.values();
        const Results a(program, tile);
        const Results b(program, tile);
        run_on(fused[0], program, tile, scratch, a.pointers());
        run_on(fused[1], program, tile, scratch, b.pointers());
        expect_identical(a, b, program, tile);
        if (HasFatalFailure()) {
            return;
        }
    }
}

}  // namespace balcony::program::tiles_test
