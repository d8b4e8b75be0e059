// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <bit>
#include <cmath>
#include <limits>
#include <random>
#include <stop_token>

#include <gtest/gtest.h>

#include "random_formula.hpp"

namespace balcony::expr::graph_test {

namespace {

using Arguments = std::array<double, 3>;

constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
constexpr double infinity = std::numeric_limits<double>::infinity();

struct Reference {
    Op op;
    double (*value)(const Arguments& a);
};

// What each operation is in the standard library or, where it has none, in the header's words.
const Reference references[] = {
    {Op::negate, [](const Arguments& a) { return -a[0]; }},
    {Op::add, [](const Arguments& a) { return a[0] + a[1]; }},
    {Op::subtract, [](const Arguments& a) { return a[0] - a[1]; }},
    {Op::multiply, [](const Arguments& a) { return a[0] * a[1]; }},
    {Op::divide, [](const Arguments& a) { return a[0] / a[1]; }},
    {Op::modulo, [](const Arguments& a) { return a[0] - a[1] * std::floor(a[0] / a[1]); }},
    {Op::minimum, [](const Arguments& a) { return std::min(a[0], a[1]); }},
    {Op::maximum, [](const Arguments& a) { return std::max(a[0], a[1]); }},
    {Op::absolute, [](const Arguments& a) { return std::abs(a[0]); }},
    {Op::sign,
     [](const Arguments& a) {
         return a[0] == 0.0 || std::isnan(a[0]) ? std::abs(a[0]) : std::copysign(1.0, a[0]);
     }},
    {Op::floor, [](const Arguments& a) { return std::floor(a[0]); }},
    {Op::square_root, [](const Arguments& a) { return std::sqrt(a[0]); }},
    {Op::power, [](const Arguments& a) { return std::pow(a[0], a[1]); }},
    {Op::exponential, [](const Arguments& a) { return std::exp(a[0]); }},
    {Op::logarithm, [](const Arguments& a) { return std::log(a[0]); }},
    {Op::sine, [](const Arguments& a) { return std::sin(a[0]); }},
    {Op::cosine, [](const Arguments& a) { return std::cos(a[0]); }},
    {Op::tangent, [](const Arguments& a) { return std::tan(a[0]); }},
    {Op::arcsine, [](const Arguments& a) { return std::asin(a[0]); }},
    {Op::arccosine, [](const Arguments& a) { return std::acos(a[0]); }},
    {Op::arctangent, [](const Arguments& a) { return std::atan(a[0]); }},
    {Op::arctangent2, [](const Arguments& a) { return std::atan2(a[0], a[1]); }},
    {Op::hyperbolic_sine, [](const Arguments& a) { return std::sinh(a[0]); }},
    {Op::hyperbolic_cosine, [](const Arguments& a) { return std::cosh(a[0]); }},
    {Op::hyperbolic_tangent, [](const Arguments& a) { return std::tanh(a[0]); }},
    {Op::inverse_hyperbolic_sine, [](const Arguments& a) { return std::asinh(a[0]); }},
    {Op::inverse_hyperbolic_cosine, [](const Arguments& a) { return std::acosh(a[0]); }},
    {Op::inverse_hyperbolic_tangent, [](const Arguments& a) { return std::atanh(a[0]); }},
    {Op::less, [](const Arguments& a) { return a[0] < a[1] ? 1.0 : 0.0; }},
    {Op::less_equal, [](const Arguments& a) { return a[0] <= a[1] ? 1.0 : 0.0; }},
    {Op::equal, [](const Arguments& a) { return a[0] == a[1] ? 1.0 : 0.0; }},
    {Op::logical_and, [](const Arguments& a) { return a[0] != 0.0 && a[1] != 0.0 ? 1.0 : 0.0; }},
    {Op::logical_or, [](const Arguments& a) { return a[0] != 0.0 || a[1] != 0.0 ? 1.0 : 0.0; }},
    {Op::logical_not, [](const Arguments& a) { return a[0] == 0.0 ? 1.0 : 0.0; }},
    {Op::is_finite, [](const Arguments& a) { return std::isfinite(a[0]) ? 1.0 : 0.0; }},
    {Op::select, [](const Arguments& a) { return a[0] != 0.0 ? a[1] : a[2]; }},
};

bool identical(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

std::vector<Arguments> odd_and_random_arguments() {
    const std::array odd{not_a_number, infinity, -infinity, 0.0, -0.0, 1.0, -1.0, 0.5, 2.5, -3.0};
    std::vector<Arguments> made;
    for (const double a : odd) {
        for (const double b : odd) {
            made.push_back({a, b, 7.0});
        }
    }
    std::mt19937_64 random(3);
    std::uniform_real_distribution<double> range(-4.0, 4.0);
    for (int i = 0; i < 200; ++i) {
        made.push_back({range(random), range(random), range(random)});
    }
    return made;
}

class EveryOperation : public testing::TestWithParam<Operation> {};

std::vector<Operation> operations_on_arguments() {
    std::vector<Operation> rows;
    for (const Operation& row : operations()) {
        if (row.scalar != nullptr) {
            rows.push_back(row);
        }
    }
    return rows;
}

std::string test_name(const testing::TestParamInfo<Operation>& info) {
    return std::string(info.param.name);
}

}  // namespace

TEST_P(EveryOperation, IsWhatTheStandardLibrarySays) {
    const auto reference = std::find_if(std::begin(references), std::end(references),
                                        [](const Reference& r) { return r.op == GetParam().op; });
    ASSERT_NE(reference, std::end(references)) << "a new operation needs its reference here";
    for (const Arguments& a : odd_and_random_arguments()) {
        EXPECT_TRUE(identical(GetParam().scalar(a.data()), reference->value(a)))
            << a[0] << ' ' << a[1];
    }
}

TEST_P(EveryOperation, FoldsConstantsToItsScalarValue) {
    for (const Arguments& a : odd_and_random_arguments()) {
        Graph graph;
        const std::array arguments{graph.constant(a[0]), graph.constant(a[1]),
                                   graph.constant(a[2])};
        const Expr folded = graph.apply(
            GetParam().op, std::span(arguments).first(static_cast<std::size_t>(GetParam().arity)));
        ASSERT_TRUE(folded.is_constant());
        EXPECT_TRUE(identical(folded.node().value, GetParam().scalar(a.data())))
            << a[0] << ' ' << a[1];
    }
}

TEST_P(EveryOperation, IsOneNodeHoweverOftenItIsWritten) {
    Graph graph;
    const std::array arguments{graph.picture_x(), graph.picture_y(), graph.time()};
    const auto used = std::span(arguments).first(static_cast<std::size_t>(GetParam().arity));
    const Expr first = graph.apply(GetParam().op, used);
    const std::size_t size = graph.size();
    EXPECT_TRUE(graph.apply(GetParam().op, used).same(first));
    if (GetParam().commutative) {
        EXPECT_TRUE(graph.apply(GetParam().op, std::array{arguments[1], arguments[0]}).same(first));
    }
    EXPECT_EQ(graph.size(), size);
    EXPECT_EQ(first.op(), GetParam().op);
}

TEST_P(EveryOperation, CommutesIfItSaysSo) {
    for (const Arguments& a : odd_and_random_arguments()) {
        if (GetParam().commutative) {
            const Arguments swapped{a[1], a[0], a[2]};
            EXPECT_TRUE(identical(GetParam().scalar(a.data()), GetParam().scalar(swapped.data())));
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Operations, EveryOperation, testing::ValuesIn(operations_on_arguments()),
                         test_name);

TEST(Operations, EachHasItsPlaceANameOfItsOwnAndAMeaning) {
    for (std::size_t i = 0; i < operation_count; ++i) {
        const Operation& row = operations()[i];
        EXPECT_EQ(static_cast<std::size_t>(row.op), i);
        EXPECT_FALSE(row.meaning.empty()) << row.name;
        for (std::size_t k = 0; k < i; ++k) {
            EXPECT_NE(operations()[k].name, row.name);
        }
    }
}

TEST(Graph, ConstantsAreTheSameIfTheirBitsAre) {
    Graph graph;
    EXPECT_TRUE(graph.constant(2.5).same(graph.constant(2.5)));
    EXPECT_TRUE(graph.constant(not_a_number).same(graph.constant(not_a_number)));
    EXPECT_FALSE(graph.constant(0.0).same(graph.constant(-0.0)));
}

TEST(Graph, NumbersAreConstantsOfFormulas) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr two = graph.constant(2.0);
    EXPECT_TRUE((x + 2.0).same(x + two) && (2.0 + x).same(two + x));
    EXPECT_TRUE((x - 2.0).same(x - two) && (2.0 - x).same(two - x));
    EXPECT_TRUE((x * 2.0).same(x * two) && (2.0 * x).same(two * x));
    EXPECT_TRUE((x / 2.0).same(x / two) && (2.0 / x).same(two / x));
    EXPECT_TRUE((x < 2.0).same(x < two) && (2.0 < x).same(two < x));
    EXPECT_TRUE((x <= 2.0).same(x <= two) && (2.0 <= x).same(two <= x));
}

// Arguments of a sum stand in the order in which they were made.
TEST(Graph, JoinsConstantsOnEitherSide) {
    Graph graph;
    const Expr one = graph.constant(1.0);
    const Expr x = graph.picture_x();
    const Expr two = graph.constant(2.0);
    EXPECT_TRUE(((one + x) + two).same(x + 3.0));
    EXPECT_TRUE(((x + two) + one).same(x + 3.0));
    EXPECT_TRUE(((two * x) * 3.0).same(6.0 * x));
}

// The arguments of a product stand in the order in which they were made.
TEST(Graph, JoinsFactorsWhicheverWasThereFirst) {
    Graph graph;
    const Expr constant = graph.constant(3.0);
    const Expr x = graph.picture_x();
    const Expr later = graph.constant(5.0);
    EXPECT_TRUE((2.0 * (constant * x)).same(6.0 * x));
    EXPECT_TRUE((2.0 * (x * later)).same(10.0 * x));
}

TEST(Graph, EqualFormulasAreOneNode) {
    std::mt19937_64 random(5);
    Graph graph;
    for (int i = 0; i < 200; ++i) {
        const Formula formula = random_formula(random, 20);
        const Expr first = build(graph, formula);
        const std::size_t size = graph.size();
        EXPECT_TRUE(build(graph, formula).same(first));
        EXPECT_EQ(graph.size(), size);
    }
}

TEST(Graph, ArgumentsStandBeforeTheNodeThatUsesThem) {
    std::mt19937_64 random(6);
    Graph graph;
    for (int i = 0; i < 200; ++i) {
        const Expr built = build(graph, random_formula(random, 20));
        (void)simplify(std::span(&built, 1));
    }
    for (std::size_t i = 0; i < graph.size(); ++i) {
        for (const NodeId argument : graph.arguments(NodeId(i))) {
            EXPECT_LT(argument.value(), i);
        }
    }
}

TEST(Graph, FreshVariablesHaveNotBeenUsed) {
    Graph graph;
    (void)graph.variable(7);
    EXPECT_EQ(graph.fresh_variable().node().detail, 8U);
    EXPECT_EQ(graph.fresh_variable().node().detail, 9U);
    EXPECT_TRUE(graph.variable(7).same(graph.variable(7)));
}

TEST(Graph, RateIsWhatTheValueChangesWith) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    EXPECT_EQ(graph.constant(1.0).rate(), Rate::uniform);
    EXPECT_EQ(sin(graph.time()).rate(), Rate::uniform);
    EXPECT_EQ((sin(x) + graph.time()).rate(), Rate::column);
    EXPECT_EQ((2.0 * y).rate(), Rate::row);
    EXPECT_EQ((x * y).rate(), Rate::pixel);
    EXPECT_EQ(graph.variable(0).rate(), Rate::pixel);
}

TEST(Graph, DividesByAConstantWhoseReciprocalIsNoNormalNumber) {
    Graph graph;
    for (const double divisor : {1e-310, 1.7e308, infinity, 0.0}) {
        const Expr quotient = graph.picture_x() / divisor;
        for (const double x : {1e-305, 3.0, 1e308}) {
            EXPECT_EQ(evaluate(std::span(&quotient, 1), {x, 0.0, 0.0, {}})[0], x / divisor);
        }
    }
}

// The promise that a camera's validity root rests on.
TEST(Graph, ASumOfSquaresIsNotFiniteWhereATermIsNot) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const Expr height = sqrt(1.0 - (x * x + y * y));
    const Expr sum = x * x + y * y + height * height;
    for (const Expr form : {sum, simplify(std::span(&sum, 1)).front()}) {
        EXPECT_FALSE(std::isfinite(evaluate(std::span(&form, 1), {2.0, 0.0, 0.0, {}})[0]));
        EXPECT_NEAR(evaluate(std::span(&form, 1), {0.5, 0.25, 0.0, {}})[0], 1.0, 1e-15);
    }
}

TEST(Graph, HasItsMostNodesAndEndsAtAStop) {
    Graph small({}, 3);
    const Expr sum = small.picture_x() + small.picture_y();
    EXPECT_EQ(small.size(), 3U);
    EXPECT_THROW(sin(sum), GraphTooLarge);
    std::stop_source stop;
    Graph graph(stop.get_token());
    const std::array roots{sin(graph.picture_x()) * graph.picture_y()};
    stop.request_stop();
    EXPECT_THROW(static_cast<void>(differentiate(roots, Expr(graph, NodeId(0)))), GraphStopped);
    EXPECT_THROW(static_cast<void>(simplify(roots)), GraphStopped);
}

TEST(Evaluate, GivesEveryRootAtThePoint) {
    Graph graph;
    const std::array roots{graph.picture_x(), graph.picture_y(), graph.time(), graph.variable(1),
                           graph.picture_x() * graph.variable(0)};
    const std::array variables{5.0, 7.0};
    EXPECT_EQ(evaluate(roots, {2.0, 3.0, 4.0, variables}),
              (std::vector<double>{2.0, 3.0, 4.0, 7.0, 10.0}));
    EXPECT_TRUE(evaluate({}, {}).empty());
}

}  // namespace balcony::expr::graph_test
