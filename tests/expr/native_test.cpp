// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Native functions as nodes of a graph.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr {

namespace {

/// scale x^powers[0] y^powers[1] z^powers[2]; its derivatives are of the same kind.
class Monomial final : public Native {
public:
    Monomial(double scale, std::vector<int> powers) : scale_(scale), powers_(std::move(powers)) {}

    std::string_view name() const override { return "monomial"; }
    std::size_t arity() const override { return powers_.size(); }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            double product = scale_;
            for (std::size_t k = 0; k < powers_.size(); ++k) {
                product *= std::pow(arguments[k][i], powers_[k]);
            }
            results[i] = product;
        }
    }
    std::shared_ptr<const Native> derivative(std::size_t argument) const override {
        if (powers_[argument] == 0) {
            return nullptr;
        }
        std::vector<int> lowered = powers_;
        --lowered[argument];
        return std::make_shared<const Monomial>(scale_ * powers_[argument], lowered);
    }

private:
    double scale_;
    std::vector<int> powers_;
};

std::shared_ptr<const Native> monomial(std::vector<int> powers) {
    return std::make_shared<const Monomial>(1.5, std::move(powers));
}

double value(Expr e, double x, double y = 0.0, double time = 0.0) {
    return evaluate(std::span(&e, 1), {x, y, time, {}})[0];
}

}  // namespace

TEST(Native, IsOneNodeAFunctionAndItsArguments) {
    Graph graph;
    const auto f = monomial({1, 2});
    const std::array xy{graph.picture_x(), graph.picture_y()};
    const std::array yx{graph.picture_y(), graph.picture_x()};
    EXPECT_TRUE(graph.native(f, xy).same(graph.native(f, xy)));
    EXPECT_FALSE(graph.native(f, xy).same(graph.native(f, yx)));
    EXPECT_FALSE(graph.native(f, xy).same(graph.native(monomial({1, 2}), xy)));
    EXPECT_EQ(graph.native(f, xy).rate(), Rate::pixel);
    EXPECT_EQ(value(graph.native(f, xy), 2.0, 3.0), 27.0);
}

TEST(Native, OfConstantsIsAConstant) {
    Graph graph;
    const std::array constants{graph.constant(2.0), graph.constant(3.0), graph.constant(-1.0)};
    EXPECT_TRUE(graph.native(monomial({2}), std::span(constants).first(1)).is_constant(6.0));
    EXPECT_TRUE(graph.native(monomial({1, 2}), std::span(constants).first(2)).is_constant(27.0));
    EXPECT_TRUE(graph.native(monomial({1, 1, 3}), constants).is_constant(-9.0));
}

TEST(Native, HasTheDerivativesItNames) {
    Graph graph;
    const Expr x = graph.picture_x();
    const Expr y = graph.picture_y();
    const std::array inner{x * x, x + y, graph.time()};
    const Expr f = graph.native(monomial({2, 1, 0}), inner);  // 1.5 x^4 (x + y)
    const Expr by_x = differentiate(f, x);
    const Expr by_y = differentiate(f, y);
    for (const double at : {-1.2, 0.5, 2.0}) {
        const double x4 = std::pow(at, 4.0);
        // A few roundings of values of up to 150.
        EXPECT_NEAR(value(by_x, at, 0.3), 6.0 * std::pow(at, 3.0) * (at + 0.3) + 1.5 * x4, 1e-12);
        EXPECT_NEAR(value(by_y, at, 0.3), 1.5 * x4, 1e-12);
    }
    EXPECT_TRUE(differentiate(f, graph.time()).is_constant(0.0))
        << "null stands for a derivative of 0";
    const Expr twice = differentiate(by_x, y);
    EXPECT_NEAR(value(twice, 2.0, 0.3), 48.0, 1e-12);
}

TEST(Native, IsKeptBySimplificationAndSubstitution) {
    Graph source;
    const std::array free{source.variable(0), source.variable(1)};
    const auto f = monomial({1, 2});
    const std::array made{source.native(f, free) + 0.0 * free[0], 2.0 * source.native(f, free)};
    const std::vector<Expr> simple = simplify(made);
    EXPECT_EQ(simple[0].op(), Op::native_2);

    Graph target;
    const std::array put{Substitution{free[0], target.picture_x()},
                         Substitution{free[1], target.constant(3.0)}};
    const std::vector<Expr> there = substitute(target, simple, put);
    EXPECT_EQ(there[0].op(), Op::native_2);
    EXPECT_EQ(target.native(NativeId(there[0].node().detail)), f);
    EXPECT_EQ(value(there[0], 2.0), 27.0);
    EXPECT_EQ(value(there[1], 2.0), 54.0);

    const std::array constants{Substitution{free[0], target.constant(2.0)},
                               Substitution{free[1], target.constant(3.0)}};
    EXPECT_TRUE(substitute(target, simple, constants)[1].is_constant(54.0));
}

}  // namespace balcony::expr
