// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tables in several variables and native functions on every instruction set against their
// definitions, with arguments of every rate.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "program/tape.hpp"
#include "support.hpp"

namespace balcony::program::calls_test {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Table;
using Random = std::mt19937_64;

constexpr double infinity = std::numeric_limits<double>::infinity();

std::shared_ptr<const Table> random_table(Random& random, std::size_t axes) {
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    auto table = std::make_shared<Table>();
    std::size_t count = 1;
    for (std::size_t axis = 0; axis < axes; ++axis) {
        const double first = number(random);
        const std::size_t cells = 1 + random() % 6;
        const std::size_t degree = random() % (Table::max_degree + 1);
        table->axes.push_back({first, first + 0.5 + std::fabs(number(random)), cells, degree});
        count *= cells * (degree + 1);
    }
    for (std::size_t i = 0; i < count; ++i) {
        table->coefficients.push_back(number(random));
    }
    return table;
}

/// Depends on the order and number of its arguments, and is odd enough to betray a wrong one; each
/// result differs.
class Mixture final : public expr::Native {
public:
    Mixture(std::size_t arguments, std::size_t results)
        : arguments_(arguments), results_(results) {}
    std::string_view name() const override { return "mixture"; }
    std::size_t argument_count() const override { return arguments_; }
    std::size_t result_count() const override { return results_; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        ++calls;
        for (std::size_t r = 0; r < results_; ++r) {
            for (std::size_t i = 0; i < count; ++i) {
                double sum = 1.0 + static_cast<double>(r);
                for (std::size_t k = 0; k < arguments_; ++k) {
                    sum = 3.0 * sum + std::floor(arguments[k][i]) * arguments[k][i];
                }
                results[r][i] = sum;
            }
        }
    }
    Expr derivative(std::size_t, std::size_t, std::span<const Expr>,
                    std::span<const Expr>) const override {
        return {};
    }

    mutable std::size_t calls = 0;

private:
    std::size_t arguments_, results_;
};

// A value of a rate; those of several values pass through NaN and infinities.
Expr of_rate(Graph& graph, Rate rate, Random& random) {
    std::uniform_real_distribution<double> number(-3.0, 3.0);
    const auto odd = [&](Expr place) {
        auto table = std::make_shared<Table>();
        table->axes = {{0.0, 64.0, 64, 0}};
        for (int i = 0; i < 64; ++i) {
            const auto kind = random() % 16;
            table->coefficients.push_back(kind == 0   ? std::nan("")
                                          : kind == 1 ? infinity
                                          : kind == 2 ? -infinity
                                          : kind == 3 ? 1e300
                                                      : number(random));
        }
        return graph.lookup(std::move(table), place);
    };
    switch (rate) {
        case Rate::uniform: return number(random) * graph.time();
        case Rate::column: return odd(graph.picture_x());
        case Rate::row: return odd(graph.picture_y());
        case Rate::pixel:
            return odd(mod(graph.picture_x() + 3.0 * graph.picture_y(), graph.constant(64.0)));
    }
    return {};
}

// The roots are so many arguments, then what is made of them; what the tile gives must be what the
// definition makes, for each such root, of the arguments that the tile gives.
template <class Definition>
void expect_as_defined(const std::vector<Expr>& roots, std::size_t arity,
                       const Definition& definition) {
    const Program program(roots);
    const auto made_by = [&](const Instruction& made) { return made.op == expr::Op::call; };
    EXPECT_TRUE(std::any_of(
        program.tape().sections.begin(), program.tape().sections.end(),
        [&](const auto& section) { return std::any_of(section.begin(), section.end(), made_by); }));
    for (std::size_t set = 0; set <= instruction_sets().size(); ++set) {
        for (const std::size_t width : {std::size_t{64}, std::size_t{13}, std::size_t{5}}) {
            const Tile tile{.width = width, .height = 7, .time = 0.75};
            const Results results(program, tile);
            Scratch scratch;
            if (set < instruction_sets().size()) {
                run_on(set, program, tile, scratch, results.pointers());
            } else {
                run_reference(program, tile, results.pointers());
            }
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                std::vector<double> arguments;
                for (std::size_t k = 0; k < arity; ++k) {
                    arguments.push_back(results[k][i]);
                }
                for (std::size_t r = arity; r < roots.size(); ++r) {
                    const double expected = definition(arguments, r - arity);
                    ASSERT_TRUE(identical(results[r][i], expected))
                        << "set " << set << ", point " << i << ", root " << r << ": "
                        << results[r][i] << ", not " << expected;
                }
            }
            EXPECT_TRUE(results.rim_intact());
        }
    }
}

// Every combination of rates for a number of arguments; the uniform one may depend on time.
std::vector<std::vector<Rate>> all_rates(std::size_t arity) {
    std::vector<std::vector<Rate>> combinations{{}};
    for (std::size_t k = 0; k < arity; ++k) {
        std::vector<std::vector<Rate>> longer;
        for (const std::vector<Rate>& begun : combinations) {
            for (const Rate rate : {Rate::uniform, Rate::column, Rate::row, Rate::pixel}) {
                longer.push_back(begun);
                longer.back().push_back(rate);
            }
        }
        combinations = std::move(longer);
    }
    return combinations;
}

class OfArity : public testing::TestWithParam<std::size_t> {};

}  // namespace

TEST_P(OfArity, ALookupEqualsItsTableWithArgumentsOfEveryRate) {
    Random random(GetParam());
    for (int repeat = 0; repeat < 4; ++repeat) {
        for (const std::vector<Rate>& rates : all_rates(GetParam())) {
            Graph graph;
            const auto table = random_table(random, GetParam());
            std::vector<Expr> roots;
            for (const Rate rate : rates) {
                roots.push_back(of_rate(graph, rate, random));
            }
            roots.push_back(graph.lookup(table, roots));
            expect_as_defined(roots, GetParam(), [&](std::span<const double> at, std::size_t) {
                return (*table)(at);
            });
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Table, OfArity, testing::Values(1U, 2U, 3U));

class OfShape : public testing::TestWithParam<std::tuple<std::size_t, std::size_t>> {};

// All results, or every second one, so that the others are left unused.
TEST_P(OfShape, ANativeIsCalledWithArgumentsOfEveryRate) {
    const auto [arguments, results] = GetParam();
    Random random(10 * arguments + results);
    const Mixture definition(arguments, results);
    for (int repeat = 0; repeat < 12; ++repeat) {
        const std::size_t step = 1 + static_cast<std::size_t>(repeat % 2);
        Graph graph;
        std::vector<Expr> roots;
        for (std::size_t k = 0; k < arguments; ++k) {
            roots.push_back(of_rate(graph, static_cast<Rate>(random() % 4), random));
        }
        const std::vector<Expr> made =
            graph.call(std::make_shared<const Mixture>(arguments, results), roots);
        for (std::size_t r = step - 1; r < results; r += step) {
            roots.push_back(made[r]);
        }
        if (roots.size() == arguments) {
            continue;
        }
        expect_as_defined(roots, arguments, [&](std::span<const double> at, std::size_t root) {
            std::vector<const double*> given;
            for (const double& value : at) {
                given.push_back(&value);
            }
            std::vector<double> values(results);
            std::vector<double*> to;
            for (double& value : values) {
                to.push_back(&value);
            }
            definition.evaluate(1, given.data(), to.data());
            return values[step - 1 + root * step];
        });
    }
}

INSTANTIATE_TEST_SUITE_P(Native, OfShape,
                         testing::Combine(testing::Range<std::size_t>(1, 8),
                                          testing::Range<std::size_t>(1, 6)));

TEST(Native, RunsAsOftenAsItsArgumentsChange) {
    Graph graph;
    const auto function = std::make_shared<const Mixture>(2, 2);
    const std::vector<Expr> of_column =
        graph.call(function, std::array{graph.picture_x(), graph.time()});
    const std::vector<Expr> of_time = graph.call(function, std::array{graph.time(), graph.time()});
    const std::vector<Expr> roots{of_column[0], of_time[1]};
    const Program program(roots);
    EXPECT_EQ(program.rate(0), Rate::column);
    EXPECT_EQ(program.rate(1), Rate::uniform);
    EXPECT_EQ(program.instruction_count(Rate::pixel), 0U);
}

TEST(Native, IsCalledOnceForAllOfItsResults) {
    Graph graph;
    const auto function = std::make_shared<const Mixture>(2, 3);
    const std::vector<Expr> made =
        graph.call(function, std::array{graph.picture_x(), graph.picture_y()});
    const std::vector<Expr> roots{sin(made[2]) * made[0], made[0], made[0] + made[2]};
    const Program program(roots);
    const Tile tile{.width = 64, .height = 7};
    const Results results(program, tile);
    Scratch scratch;
    function->calls = 0;
    run(program, tile, scratch, results.pointers());
    EXPECT_EQ(function->calls, tile.height) << "once a row";
}

}  // namespace balcony::program::calls_test
