// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where the values of operations lie, and programs that leave out what no point of a tile needs.

#include <atomic>
#include <memory>

#include <gtest/gtest.h>

#include "../expr/random_intervals.hpp"
#include "program/tape.hpp"
#include "random_expressions.hpp"
#include "support.hpp"

namespace balcony::program::shortening_test {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Op;
using expr::RandomInterval;
using expr::Range;

// All runners' values of an operation at numbers of three intervals are in its range, and are those
// of an argument where it says so.
void expect_sound(Op op, Random& random) {
    constexpr std::size_t side = 8;
    const RandomInterval columns(random, expr::special_numbers, side);
    const RandomInterval rows(random, expr::special_numbers, side);
    const RandomInterval uniform(random, expr::special_numbers, 2);
    const double third = uniform.numbers.front();
    const std::array ranges{columns.range, rows.range, Range{third, third, false}};
    const Range expected = expr::range_of(op, ranges.data());
    const std::optional<std::size_t> chosen = expr::chosen_argument(op, ranges.data());

    Graph graph;
    const std::array arguments{graph.input("column"), graph.input("row"), graph.input("uniform")};
    const auto arity = static_cast<std::size_t>(expr::operation(op).arity);
    const Expr root = graph.apply(op, std::span(arguments).first(arity));
    // What is not simplified is not shortened.
    const Interface interface {
        Sampling::grid, {{"column", Rate::column}, {"row", Rate::row}, {"uniform", Rate::uniform}},
            false
    };
    const auto program = Program::make(std::span(&root, 1), interface);
    ASSERT_TRUE(program);
    const std::array<std::span<const double>, 3> inputs{columns.numbers, rows.numbers,
                                                        std::span(&third, 1)};
    const Tile tile{.width = side, .height = side, .inputs = inputs};
    Scratch scratch;
    for (std::size_t set = 0; set < instruction_sets().size(); ++set) {
        const Results results(*program, tile);
        run_on(set, *program, tile, scratch, results.pointers());
        for (std::size_t i = 0; i < side * side; ++i) {
            const double value = results[0][i];
            const std::array given{columns.numbers[i % side], rows.numbers[i / side], third};
            ASSERT_TRUE(std::isnan(value) ? expected.may_be_nan
                                          : expected.least <= value && value <= expected.most)
                << instruction_sets()[set].name << ": " << expr::operation(op).name << "("
                << given[0] << ", " << given[1] << ", " << given[2] << ") is " << value
                << ", not in " << expected.least << " .. " << expected.most;
            ASSERT_TRUE(!chosen || identical(value, given[*chosen]));
        }
    }
}

// A function of one number that counts the points at which it is computed.
class Counted final : public expr::Native {
public:
    [[nodiscard]] std::string_view name() const override { return "counted"; }
    [[nodiscard]] std::size_t argument_count() const override { return 1; }
    [[nodiscard]] std::size_t result_count() const override { return 1; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        points_ += count;
        std::copy_n(arguments[0], count, results[0]);
    }
    [[nodiscard]] Expr derivative(std::size_t, std::size_t, std::span<const Expr>,
                                  std::span<const Expr>) const override {
        return {};
    }
    [[nodiscard]] std::size_t points() const { return points_; }

private:
    mutable std::atomic<std::size_t> points_ = 0;
};

// Whether a program computes a function for a tile from (x, y) on of 16 x 16 points. Its values are
// those of the whole program.
template <class Formula>
bool computes(const Formula& formula, double x, double y) {
    Graph graph;
    const auto counted = std::make_shared<const Counted>();
    const Expr sum = graph.picture_x() + graph.picture_y();
    const Expr costly = graph.call(counted, std::span(&sum, 1)).front();
    const std::vector<Expr> roots{formula(graph, costly)};
    const Program program(roots);
    const Tile tile{.x = x, .y = y, .width = 16, .height = 16};
    const Results expected(program, tile);
    run_reference(program, tile, expected.pointers());
    const std::size_t by_reference = counted->points();
    const Results results(program, tile);
    Scratch scratch;
    run(program, tile, scratch, results.pointers());
    for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
        EXPECT_TRUE(identical(results[0][i], expected[0][i]));
    }
    return counted->points() > by_reference;
}

// One of two numbers, whatever the function gives.
Expr either(Expr costly, double a, double b) {
    Graph& graph = costly.graph();
    return select(costly < 5.0, graph.constant(a), graph.constant(b));
}

}  // namespace

TEST(Ranges, HoldTheValuesOfEveryRunner) {
    Random random(11);
    for (const expr::Operation& operation : expr::operations()) {
        for (int trial = 0; operation.scalar != nullptr && trial < 4000; ++trial) {
            expect_sound(operation.op, random);
            if (HasFatalFailure()) {
                return;
            }
        }
    }
}

TEST(Shortening, ABranchThatNoPointTakesIsNotComputed) {
    const auto selects = [](Graph& graph, Expr costly) {
        return select(graph.picture_x() < 100.0, costly, graph.picture_y());
    };
    EXPECT_TRUE(computes(selects, 0.5, 0.5));
    EXPECT_TRUE(computes(selects, 90.5, 0.5));
    EXPECT_FALSE(computes(selects, 100.5, 0.5));
}

TEST(Shortening, WhatIsNeverSmallestOrLargestIsNotComputed) {
    const auto within_disc = [](Graph& graph, Expr costly) {
        const Expr x = graph.picture_x() / 50.0;
        const Expr y = graph.picture_y() / 50.0;
        return select(max(1.0 - (x * x + y * y), graph.constant(0.0)) <= 0.0, graph.picture_x(),
                      costly);
    };
    EXPECT_TRUE(computes(within_disc, -8.5, -8.5));
    EXPECT_TRUE(computes(within_disc, 30.5, 30.5));
    EXPECT_FALSE(computes(within_disc, 50.5, -8.5));
    EXPECT_FALSE(computes(within_disc, 40.5, 40.5));
    const auto smallest = [](Graph& graph, Expr costly) {
        return min(either(costly, 20.0, 25.0), graph.picture_x());
    };
    EXPECT_TRUE(computes(smallest, 10.5, 0.5));
    EXPECT_FALSE(computes(smallest, 0.5, 0.5));
}

TEST(Shortening, CombinedConditionsAreDecidedByOneOfThem) {
    const auto in_rectangle = [](Graph& graph, Expr costly) {
        const Expr inside = 10.0 < graph.picture_x() && graph.picture_y() <= 20.0;
        return select(inside && is_finite(costly), costly, graph.constant(-1.0));
    };
    EXPECT_TRUE(computes(in_rectangle, 10.5, 10.5));
    EXPECT_FALSE(computes(in_rectangle, -10.5, 10.5));
    EXPECT_FALSE(computes(in_rectangle, 10.5, 30.5));
}

TEST(Shortening, WhatNothingWrapsAroundToIsNotComputed) {
    const auto wrapped = [](Graph& graph, Expr costly) {
        return mod(graph.picture_x(), either(costly, 20.0, 25.0));
    };
    EXPECT_FALSE(computes(wrapped, 0.5, 0.5));
    EXPECT_TRUE(computes(wrapped, 10.5, 0.5));
    EXPECT_TRUE(computes(wrapped, -0.5, 0.5));
}

// More ways of deciding than a program keeps tapes for.
TEST(Shortening, MosaicsOfManyPartsHaveTheSameValues) {
    Graph graph;
    Expr mosaic = graph.picture_x() * graph.picture_y();
    for (int k = 1; k < 60; ++k) {
        mosaic = select(graph.picture_x() < 20.0 * k, mosaic, sqrt(mosaic * mosaic) + 1.0);
    }
    const std::vector<Expr> roots{mosaic};
    const Program program(roots);
    Scratch scratch;
    for (int k = 0; k < 80; ++k) {
        const Tile tile{.x = 20.0 * k + 0.5, .y = 3.5, .width = 16, .height = 16};
        const Results expected(program, tile);
        run_reference(program, tile, expected.pointers());
        const Results results(program, tile);
        run(program, tile, scratch, results.pointers());
        for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
            ASSERT_TRUE(identical(results[0][i], expected[0][i])) << k;
        }
    }
}

// Their formulas would take more memory than their tapes.
TEST(Shortening, IsLeftOutOfVeryLargePrograms) {
    const auto shortens = [](int links) {
        Graph graph;
        Expr chain = graph.picture_x();
        for (int i = 0; i < links; ++i) {
            chain = max(sqrt(chain * chain + graph.picture_y()), graph.picture_y());
        }
        return Program(std::vector<Expr>{chain}).tape().shortening != nullptr;
    };
    EXPECT_TRUE(shortens(100));
    EXPECT_FALSE(shortens(20'000));
}

}  // namespace balcony::program::shortening_test
