// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Every operation on every instruction set against its scalar definition.

#include <algorithm>
#include <array>
#include <numbers>
#include <random>
#include <string>

#include <gtest/gtest.h>

#include "program/tape.hpp"
#include "support.hpp"

namespace balcony::program::operations_test {

namespace {

using expr::Expr;
using expr::Op;
using expr::Operation;
using Arguments = std::array<double, 3>;

constexpr double infinity = std::numeric_limits<double>::infinity();
using std::numbers::pi;

// Values at which an operation changes its ways: signs of zero, the ends of the range, poles,
// halves, the ends of the domains and their neighbours.
const std::vector<double>& odd_values() {
    static const std::vector<double> values = [] {
        std::vector<double> made{std::numeric_limits<double>::quiet_NaN()};
        const double next_to_one = std::nextafter(1.0, 2.0);
        for (const double magnitude : {0.0,
                                       5e-324,
                                       1e-310,
                                       std::numeric_limits<double>::min(),
                                       1e-300,
                                       1e-17,
                                       1e-9,
                                       0.25,
                                       0.5,
                                       std::nextafter(1.0, 0.0),
                                       1.0,
                                       next_to_one,
                                       1.5,
                                       2.0,
                                       2.5,
                                       3.0,
                                       pi / 4.0,
                                       pi / 2.0,
                                       pi,
                                       2.0 * pi,
                                       22.0,
                                       708.5,
                                       709.5,
                                       709.9,
                                       710.3,
                                       745.5,
                                       1000.5,
                                       1e7,
                                       1e15,
                                       4503599627370497.5,
                                       9007199254740993.0,
                                       1e22,
                                       1e150,
                                       2e154,
                                       1e300,
                                       std::numeric_limits<double>::max(),
                                       infinity}) {
            made.push_back(magnitude);
            made.push_back(-magnitude);
        }
        return made;
    }();
    return values;
}

std::vector<Arguments> all_combinations(const Operation& operation) {
    std::vector<double> values = odd_values();
    if (operation.arity == 3) {
        values = {std::nan(""), 0.0, -0.0, 1.0, -1.0, 0.5, 5e-324, 1e300, infinity, -infinity};
    }
    const std::vector<double> unused{0.0};
    std::vector<Arguments> combinations;
    for (const double a : values) {
        for (const double b : operation.arity > 1 ? values : unused) {
            for (const double c : operation.arity > 2 ? values : unused) {
                combinations.push_back({a, b, c});
            }
        }
    }
    return combinations;
}

// Values of everyday size, within [-1, 1], and of any size.
std::vector<Arguments> random_arguments(std::size_t count) {
    std::mt19937_64 random(20);
    std::uniform_real_distribution<double> everyday(-10.0, 10.0);
    std::uniform_real_distribution<double> unit(-1.0, 1.0);
    std::uniform_real_distribution<double> exponent(-300.0, 300.0);
    std::vector<Arguments> arguments(count);
    for (Arguments& point : arguments) {
        const auto kind = random() % 8;
        for (double& value : point) {
            value = kind < 4   ? everyday(random)
                    : kind < 7 ? unit(random)
                               : std::copysign(std::pow(10.0, exponent(random)), unit(random));
        }
    }
    return arguments;
}

// Hands any list of values to a program: a table with one constant cell for each, looked up by the
// number of the point.
Expr feed(expr::Graph& graph, const std::vector<Arguments>& arguments, std::size_t which) {
    auto table = std::make_shared<expr::Table>();
    table->axes = {{0.0, static_cast<double>(arguments.size()), arguments.size(), 0}};
    for (const Arguments& point : arguments) {
        table->coefficients.push_back(point[which]);
    }
    constexpr auto width = static_cast<double>(max_tile_width);
    const Expr number = graph.picture_x() + width * graph.picture_y() - 0.5 * width;
    return graph.lookup(std::move(table), number);
}

// Runs an operation on a list of arguments and compares each value with the definition.
void expect_conforms(std::size_t set, const Operation& operation,
                     const std::vector<Arguments>& arguments) {
    expr::Graph graph;
    std::vector<Expr> fed;
    for (std::size_t i = 0; i < static_cast<std::size_t>(operation.arity); ++i) {
        fed.push_back(feed(graph, arguments, i));
    }
    std::vector<Expr> roots = fed;
    roots.push_back(graph.apply(operation.op, fed));
    const Program program(roots);
    const std::vector<Instruction>& instructions = program.tape().section(Rate::pixel);
    ASSERT_TRUE(std::any_of(instructions.begin(), instructions.end(), [&](const auto& made) {
        return made.op == operation.op;
    })) << "the program must contain the operation";

    Scratch scratch;
    constexpr std::size_t per_tile = max_tile_width * max_tile_height;
    for (std::size_t first = 0; first < arguments.size(); first += per_tile) {
        Tile tile{.width = max_tile_width, .height = max_tile_height};
        tile.y = 0.5 + static_cast<double>(first / max_tile_width);
        const Results results(program, tile);
        run_on(set, program, tile, scratch, results.pointers());
        for (std::size_t i = 0; i < std::min(per_tile, arguments.size() - first); ++i) {
            const Arguments& a = arguments[first + i];
            for (std::size_t k = 0; k < fed.size(); ++k) {
                ASSERT_TRUE(identical(results[k][i], a[k])) << "argument " << k << " is " << a[k];
            }
            const double value = results[fed.size()][i];
            const double defined = operation.scalar(a.data());
            ASSERT_LE(ulps_between(value, defined), operation.max_ulp)
                << operation.name << '(' << a[0] << ", " << a[1] << ", " << a[2] << ") = " << value
                << ", defined as " << defined;
            // SLEEF may lose the sign of a result that is no normal number.
            ASSERT_TRUE(std::isnan(defined) || std::fpclassify(defined) == FP_SUBNORMAL ||
                        std::signbit(value) == std::signbit(defined))
                << operation.name << '(' << a[0] << ", " << a[1] << ", " << a[2] << ") = " << value
                << ", defined as " << defined;
        }
    }
}

std::vector<const Operation*> defined_operations() {
    std::vector<const Operation*> rows;
    for (const Operation& operation : expr::operations()) {
        if (operation.scalar != nullptr) {
            rows.push_back(&operation);
        }
    }
    return rows;
}

class Conformance : public testing::TestWithParam<std::tuple<std::size_t, const Operation*>> {};

std::size_t set_count() { return instruction_sets().size(); }

std::string conformance_name(
    const testing::TestParamInfo<std::tuple<std::size_t, const Operation*>>& info) {
    return std::string(instruction_sets()[std::get<0>(info.param)].name) + "_" +
           std::string(std::get<1>(info.param)->name);
}

}  // namespace

TEST_P(Conformance, AtOddArguments) {
    const auto [set, operation] = GetParam();
    expect_conforms(set, *operation, all_combinations(*operation));
}

TEST_P(Conformance, AtRandomArguments) {
    const auto [set, operation] = GetParam();
    expect_conforms(set, *operation, random_arguments(100'000));
}

INSTANTIATE_TEST_SUITE_P(Operations, Conformance,
                         testing::Combine(testing::Range<std::size_t>(0, set_count()),
                                          testing::ValuesIn(defined_operations())),
                         conformance_name);

class Lookup : public testing::TestWithParam<std::size_t> {};

TEST_P(Lookup, EqualsTheTableInsideOutsideAndAtNan) {
    const std::vector<double> values{1.0, -2.0, 0.5, 4.0, 4.5};
    const std::vector<double> slopes{0.0, 3.0, -1.0, 0.25, 7.0};
    const auto table =
        std::make_shared<const expr::Table>(expr::hermite_table(-1.5, 2.5, values, slopes));
    std::vector<Arguments> arguments = random_arguments(20'000);
    for (const double x : odd_values()) {
        arguments.push_back({x, 0.0, 0.0});
    }
    for (double x = -2.0; x <= 3.0; x += 0.125) {
        arguments.push_back({x, 0.0, 0.0});
    }
    expr::Graph graph;
    const Expr x = feed(graph, arguments, 0);
    const std::vector<Expr> roots{graph.lookup(table, x)};
    const Program program(roots);
    Scratch scratch;
    for (std::size_t first = 0; first < arguments.size(); first += max_tile_width) {
        Tile tile{.width = std::min(max_tile_width, arguments.size() - first), .height = 1};
        tile.y = 0.5 + static_cast<double>(first / max_tile_width);
        const Results results(program, tile);
        run_on(GetParam(), program, tile, scratch, results.pointers());
        for (std::size_t i = 0; i < tile.width; ++i) {
            const double at = arguments[first + i][0];
            ASSERT_TRUE(identical(results[0][i], (*table)(at))) << "at " << at;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Sets, Lookup, testing::Range<std::size_t>(0, set_count()));

}  // namespace balcony::program::operations_test
