// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Functions that are no formulas: calls with any number of arguments and results.

#include <array>
#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::call_test {

namespace {

/// Results scale x0^p0 x1^p1 ..., one for each list of powers, with a last one that says whether
/// the sum of the arguments is positive. Their derivatives are results of another such function.
class Monomials final : public Native {
public:
    using Powers = std::vector<int>;

    Monomials(double scale, std::vector<Powers> powers)
        : scale_(scale), powers_(std::move(powers)) {}

    std::string_view name() const override { return "monomials"; }
    std::size_t argument_count() const override { return powers_.front().size(); }
    std::size_t result_count() const override { return powers_.size() + 1; }
    std::optional<std::size_t> validity() const override { return powers_.size(); }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            double sum = 0.0;
            for (std::size_t k = 0; k < argument_count(); ++k) {
                sum += arguments[k][i];
            }
            for (std::size_t r = 0; r < powers_.size(); ++r) {
                double product = scale_;
                for (std::size_t k = 0; k < argument_count(); ++k) {
                    product *= std::pow(arguments[k][i], powers_[r][k]);
                }
                results[r][i] = product;
            }
            results[powers_.size()][i] = sum > 0.0 ? 1.0 : 0.0;
        }
    }
    // (d/dx_k) x^p = (p_k / x_k) x^p, with x^p / x_k from a function of lowered powers.
    Expr derivative(std::size_t result, std::size_t argument, std::span<const Expr> arguments,
                    std::span<const Expr>) const override {
        if (result == powers_.size() || powers_[result][argument] == 0) {
            return {};
        }
        Powers lowered = powers_[result];
        --lowered[argument];
        const auto slope = std::make_shared<const Monomials>(scale_ * powers_[result][argument],
                                                             std::vector<Powers>{lowered});
        return arguments[0].graph().call(slope, arguments)[0];
    }

private:
    double scale_;
    std::vector<Powers> powers_;
};

std::shared_ptr<const Native> monomials(std::vector<Monomials::Powers> powers) {
    return std::make_shared<const Monomials>(1.5, std::move(powers));
}

double value(Expr e, double x, double y = 0.0, double time = 0.0) {
    return evaluate(std::span(&e, 1), {x, y, time, {}})[0];
}

}  // namespace

TEST(Call, IsOneNodeAFunctionAndItsArguments) {
    Graph graph;
    const auto f = monomials({{1, 2}, {0, 1}});
    const std::array xy{graph.picture_x(), graph.picture_y()};
    const std::array yx{graph.picture_y(), graph.picture_x()};
    const std::vector<Expr> results = graph.call(f, xy);
    ASSERT_EQ(results.size(), 3U);
    const std::size_t size = graph.size();
    for (std::size_t r = 0; r < results.size(); ++r) {
        EXPECT_EQ(results[r].op(), Op::result);
        EXPECT_TRUE(results[r].argument(0).same(results[0].argument(0))) << "one call for all";
        EXPECT_TRUE(graph.call(f, xy)[r].same(results[r]));
        EXPECT_EQ(results[r].rate(), Rate::pixel);
    }
    EXPECT_EQ(graph.size(), size);
    EXPECT_FALSE(results[0].same(results[1]));
    EXPECT_FALSE(graph.call(f, yx)[0].same(results[0]));
    EXPECT_FALSE(graph.call(monomials({{1, 2}, {0, 1}}), xy)[0].same(results[0]));
    EXPECT_EQ(value(results[0], 2.0, 3.0), 27.0);
    EXPECT_EQ(value(results[1], 2.0, 3.0), 4.5);
    EXPECT_EQ(value(results[2], 2.0, 3.0), 1.0);
    EXPECT_EQ(value(results[2], -2.0, -3.0), 0.0);
}

TEST(Call, TakesAnyNumberOfArguments) {
    for (std::size_t count = 1; count <= 7; ++count) {
        Graph graph;
        std::vector<Expr> arguments;
        double product = 1.5;
        for (std::size_t k = 0; k < count; ++k) {
            const auto factor = static_cast<double>(k + 2);
            arguments.push_back(factor * graph.picture_x());
            product *= 2.0 * factor;
        }
        const auto f = monomials({Monomials::Powers(count, 1)});
        const Expr made = graph.call(f, arguments)[0];
        EXPECT_EQ(graph.arguments(made.argument(0).id()).size(), count);
        EXPECT_EQ(value(made, 2.0), product);
        // d/dx of c x^count at 2.
        EXPECT_NEAR(value(differentiate(made, graph.picture_x()), 2.0),
                    product * static_cast<double>(count) / 2.0, 1e-9 * product);
        // One argument that differs makes another call.
        std::vector<Expr> other = arguments;
        other.back() = graph.time();
        EXPECT_FALSE(graph.call(f, other)[0].same(made));
        EXPECT_TRUE(graph.call(f, arguments)[0].same(made));
    }
}

TEST(Call, OfConstantsIsConstants) {
    Graph graph;
    const std::array constants{graph.constant(2.0), graph.constant(3.0), graph.constant(-1.0)};
    const std::vector<Expr> made = graph.call(monomials({{1, 1, 3}, {1, 2, 0}}), constants);
    EXPECT_TRUE(made[0].is_constant(-9.0));
    EXPECT_TRUE(made[1].is_constant(27.0));
    EXPECT_TRUE(made[2].is_constant(1.0));
}

TEST(Call, HasTheDerivativesThatItsFunctionStates) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::array inner{x * x, x + y, graph.time()};
    const std::vector<Expr> f = graph.call(monomials({{2, 1, 0}, {0, 2, 0}}), inner);
    const Expr by_x = differentiate(f[0], x);  // f[0] is 1.5 x^4 (x + y)
    const Expr by_y = differentiate(f[0], y);
    const Expr other_by_y = differentiate(f[1], y);
    for (const double at : {-1.2, 0.5, 2.0}) {
        const double x4 = std::pow(at, 4.0);
        // A few roundings of values of up to 150.
        EXPECT_NEAR(value(by_x, at, 0.3), 6.0 * std::pow(at, 3.0) * (at + 0.3) + 1.5 * x4, 1e-12);
        EXPECT_NEAR(value(by_y, at, 0.3), 1.5 * x4, 1e-12);
        EXPECT_NEAR(value(other_by_y, at, 0.3), 3.0 * (at + 0.3), 1e-12);
    }
    EXPECT_TRUE(differentiate(f[0], graph.time()).is_constant(0.0))
        << "no node stands for a derivative of 0";
    EXPECT_TRUE(differentiate(f[2], x).is_constant(0.0)) << "of a condition";
    EXPECT_NEAR(value(differentiate(by_x, y), 2.0, 0.3), 48.0, 1e-12);
}

TEST(Call, IsKeptBySimplificationAndSubstitution) {
    Graph source;
    const std::array free{source.variable(0), source.variable(1)};
    const auto f = monomials({{1, 2}, {1, 0}});
    const std::vector<Expr> called = source.call(f, free);
    const std::array made{called[0] + 0.0 * free[0], 2.0 * called[1]};
    const std::vector<Expr> simple = simplify(made);
    EXPECT_EQ(simple[0].op(), Op::result);

    Graph target;
    const std::array put{Substitution{free[0], target.picture_x()},
                         Substitution{free[1], target.constant(3.0)}};
    const std::vector<Expr> there = substitute(target, simple, put);
    EXPECT_TRUE(
        there[0].same(target.call(f, std::array{put[0].replacement, put[1].replacement})[0]));
    EXPECT_EQ(value(there[0], 2.0), 27.0);
    EXPECT_EQ(value(there[1], 2.0), 6.0);

    const std::array constants{Substitution{free[0], target.constant(2.0)},
                               Substitution{free[1], target.constant(3.0)}};
    EXPECT_TRUE(substitute(target, simple, constants)[1].is_constant(6.0));
}

TEST(Call, IsPrintedOnceWithItsResultsByNumber) {
    Graph graph;
    const std::array xy{graph.picture_x(), graph.picture_y()};
    const std::vector<Expr> f = graph.call(monomials({{1, 2}, {0, 1}}), xy);
    const std::vector<Expr> g = graph.call(monomials({{1, 2}}), xy);
    const auto table = std::make_shared<const Table>(
        hermite_table(0.0, 1.0, std::array{0.0, 1.0}, std::array{1.0, 1.0}));
    const std::array roots{f[0] - f[1], g[0], graph.lookup(table, xy[0])};
    const std::array<std::string, 3> names{"a", "b", "c"};
    EXPECT_EQ(print(roots, names),
              "s1 = monomials(x, y)\n"
              "a = s1[0] - s1[1]\n"
              "b = monomials_2(x, y)[0]\n"
              "c = lookup(x)\n");
}

TEST(BatchEvaluator, GivesWhatEvaluationPointByPointGives) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr free = graph.variable(0);
    const std::vector<Expr> f = graph.call(monomials({{1, 2}, {2, 0}}), std::array{x, free});
    const std::vector<Expr> roots{f[1], sin(free) * f[0], graph.constant(2.5), f[2], x};
    const BatchEvaluator evaluator(roots);
    EXPECT_EQ(evaluator.leaves().size(), 2U);
    const std::array at{-1.0, 0.25, 2.0};
    const std::vector<double> values =
        evaluator(at.size(), [&](const Node& leaf, std::span<double> to) {
            for (std::size_t i = 0; i < at.size(); ++i) {
                to[i] = leaf.op == Op::input ? at[i] : 3.0 * at[i];
            }
        });
    for (std::size_t i = 0; i < at.size(); ++i) {
        const std::array variables{3.0 * at[i]};
        const std::vector<double> expected = evaluate(roots, {.x = at[i], .variables = variables});
        for (std::size_t r = 0; r < roots.size(); ++r) {
            EXPECT_EQ(values[r * at.size() + i], expected[r]) << r;
        }
    }
}

}  // namespace balcony::expr::call_test
