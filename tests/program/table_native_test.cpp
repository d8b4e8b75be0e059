// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tables in several variables and native functions on every instruction set against their
// definitions, with arguments of every rate.

#include <algorithm>
#include <random>

#include <gtest/gtest.h>

#include "program/tape.hpp"
#include "support.hpp"

namespace balcony::program {

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

/// Depends on the order and number of its arguments, and is odd enough to betray a wrong one.
class Mixture final : public expr::Native {
public:
    explicit Mixture(std::size_t arity) : arity_(arity) {}
    std::string_view name() const override { return "mixture"; }
    std::size_t arity() const override { return arity_; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            double sum = 1.0;
            for (std::size_t k = 0; k < arity_; ++k) {
                sum = 3.0 * sum + std::floor(arguments[k][i]) * arguments[k][i];
            }
            results[i] = sum;
        }
    }
    std::shared_ptr<const Native> derivative(std::size_t) const override { return nullptr; }

private:
    std::size_t arity_;
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

// The roots are the arguments, then the node under test; what the tile gives must be what the
// definition makes of the arguments that the tile gives.
template <class Definition>
void expect_as_defined(const std::vector<Expr>& roots, expr::Op op, const Definition& definition) {
    const Program program(roots);
    const auto made_by = [&](const Instruction& made) { return made.op == op; };
    EXPECT_TRUE(std::any_of(
        program.tape().sections.begin(), program.tape().sections.end(),
        [&](const auto& section) { return std::any_of(section.begin(), section.end(), made_by); }));
    const std::size_t arity = roots.size() - 1;
    for (std::size_t set = 0; set <= instruction_sets().size(); ++set) {
        for (const std::size_t width : {std::size_t{64}, std::size_t{13}}) {
            const Tile tile{.width = width, .height = 7, .time = 0.75};
            const Results results(program, tile);
            Scratch scratch;
            if (set < instruction_sets().size()) {
                run_on(set, program, tile, scratch, results.pointers());
            } else {
                run_reference(program, tile, results.pointers());
            }
            for (std::size_t i = 0; i < tile.width * tile.height; ++i) {
                std::array<double, 3> arguments{};
                for (std::size_t k = 0; k < arity; ++k) {
                    arguments[k] = results[k][i];
                }
                ASSERT_TRUE(identical(results[arity][i], definition(arguments)))
                    << "set " << set << ", point " << i << ": " << results[arity][i] << " for ("
                    << arguments[0] << ", " << arguments[1] << ", " << arguments[2] << "), not "
                    << definition(arguments);
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
            const Expr made = graph.lookup(table, roots);
            roots.push_back(made);
            expect_as_defined(roots, made.op(), [&](const std::array<double, 3>& at) {
                return (*table)(std::span(at).first(GetParam()));
            });
        }
    }
}

TEST_P(OfArity, ANativeIsCalledWithArgumentsOfEveryRate) {
    Random random(10 + GetParam());
    for (const std::vector<Rate>& rates : all_rates(GetParam())) {
        Graph graph;
        const auto function = std::make_shared<const Mixture>(GetParam());
        std::vector<Expr> roots;
        for (const Rate rate : rates) {
            roots.push_back(of_rate(graph, rate, random));
        }
        const Expr made = graph.native(function, roots);
        roots.push_back(made);
        expect_as_defined(roots, made.op(), [&](const std::array<double, 3>& at) {
            const std::array<const double*, 3> arguments{&at[0], &at[1], &at[2]};
            double result = 0.0;
            function->evaluate(1, arguments.data(), &result);
            return result;
        });
    }
}

TEST_P(OfArity, ANativeHasTheRateOfItsArguments) {
    Graph graph;
    const std::vector<Expr> columns(GetParam(), graph.picture_x());
    const std::vector<Expr> uniforms(GetParam(), graph.time());
    const auto function = std::make_shared<const Mixture>(GetParam());
    const std::vector<Expr> roots{graph.native(function, columns),
                                  graph.native(function, uniforms)};
    const Program program(roots);
    EXPECT_EQ(program.rate(0), Rate::column);
    EXPECT_EQ(program.rate(1), Rate::uniform);
    EXPECT_EQ(program.instruction_count(Rate::pixel), 0U);
}

INSTANTIATE_TEST_SUITE_P(TableAndNative, OfArity, testing::Values(1U, 2U, 3U));

}  // namespace balcony::program
