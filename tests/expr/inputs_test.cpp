// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Inputs: leaves that a graph knows by name.

#include <array>
#include <cmath>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::inputs_test {

namespace {

InputId id_of(Expr input) { return InputId(input.node().detail); }

}  // namespace

TEST(Input, IsOneNodeAName) {
    Graph graph;
    const Expr lens = graph.input("lens");
    EXPECT_TRUE(graph.input("lens").same(lens));
    EXPECT_FALSE(graph.input("shutter").same(lens));
    EXPECT_TRUE(graph.input("x").same(graph.picture_x()));
    EXPECT_TRUE(graph.input("y").same(graph.picture_y()));
    EXPECT_TRUE(graph.input("t").same(graph.time()));
    EXPECT_EQ(id_of(graph.time()), inputs::t);
    ASSERT_EQ(graph.input_names().size(), 5U);
    EXPECT_EQ(graph.input_names()[id_of(lens).value()], "lens");
}

TEST(Input, HasItsValueByName) {
    Graph graph;
    const std::array roots{graph.input("a") - 2.0 * graph.input("b") + graph.picture_x()};
    const std::array values{InputValue{"b", 3.0}, InputValue{"unknown", 9.0}, InputValue{"a", 1.0}};
    EXPECT_EQ(evaluate(roots, {.x = 0.5, .inputs = values})[0], -4.5);
    EXPECT_TRUE(std::isnan(evaluate(roots, {.x = 0.5, .inputs = std::span(values).first(1)})[0]));
    EXPECT_TRUE(std::isnan(evaluate(std::array{graph.variable(2)}, {})[0]));
}

TEST(Input, IsTheSameNameInAnotherGraph) {
    Graph source;
    const Expr formula = source.input("a") * sin(source.input("b")) + source.picture_y();
    Graph target;
    const Expr b = target.input("b");
    const Expr copy = substitute(target, std::span(&formula, 1), {}).front();
    EXPECT_TRUE(copy.same(target.input("a") * sin(b) + target.picture_y()));
    const std::array put{Substitution{source.input("b"), target.picture_x()}};
    EXPECT_TRUE(substitute(target, std::span(&formula, 1), put)
                    .front()
                    .same(target.input("a") * sin(target.picture_x()) + target.picture_y()));
}

TEST(Input, IsDifferentiatedBy) {
    Graph graph;
    const Expr lens = graph.input("lens");
    const Expr x = graph.picture_x();
    EXPECT_TRUE(differentiate(sin(lens) * x, lens).same(cos(lens) * x));
    EXPECT_TRUE(differentiate(sin(lens) * x, graph.input("shutter")).is_constant(0.0));
}

TEST(Input, IsPrintedByName) {
    Graph graph;
    const Expr lens = graph.input("lens_u");
    EXPECT_EQ(print(lens - graph.picture_x() / graph.time()), "f = lens_u - x / t\n");
}

TEST(Dependence, IsTheSetOfInputsBelow) {
    Graph graph;
    const Expr lens = graph.input("lens");
    const Dependence on_lens = Dependence::on(id_of(lens));
    EXPECT_TRUE(graph.constant(1.0).dependence().empty());
    EXPECT_EQ(sin(lens).dependence(), on_lens);
    EXPECT_EQ((sin(lens) * graph.time()).dependence(), on_lens | Dependence::on(inputs::t));
    EXPECT_FALSE((graph.picture_x() * graph.picture_y()).dependence().intersects(on_lens));
    EXPECT_TRUE((lens + graph.variable(0)).dependence().intersects(Dependence::on_variable()));
}

// Of a hundred inputs the last ones are not told apart, which may claim too much but nothing less.
TEST(Dependence, KnowsAnyNumberOfInputs) {
    Graph graph;
    std::vector<Expr> all;
    for (int i = 0; i < 100; ++i) {
        all.push_back(graph.input("input" + std::to_string(i)));
    }
    for (std::size_t i = 0; i < all.size(); ++i) {
        Rates rates;
        rates.declare(id_of(all[i]), Rate::row);
        EXPECT_EQ(sin(all[i]).rate(rates), Rate::row) << i;
        EXPECT_EQ((all[i] * graph.picture_x()).rate(rates), Rate::pixel) << i;
        EXPECT_FALSE(all[i].dependence().intersects(Dependence::on_variable())) << i;
    }
    EXPECT_EQ(all[20].rate(), Rate::uniform);
    Rates rates;
    rates.declare(id_of(all[20]), Rate::row);
    EXPECT_EQ(all[21].rate(rates), Rate::uniform);
}

TEST(Rates, FollowWhatIsDeclared) {
    Graph graph;
    Rates rates;
    for (const auto& [name, rate] : {std::pair("once", Rate::uniform),
                                     {"column", Rate::column},
                                     {"row", Rate::row},
                                     {"point", Rate::pixel}}) {
        const Expr input = graph.input(name);
        EXPECT_EQ(input.rate(), Rate::uniform);
        rates.declare(id_of(input), rate);
        EXPECT_EQ(input.rate(rates), rate);
        EXPECT_EQ((input + graph.time()).rate(rates), rate);
    }
    EXPECT_EQ((graph.input("column") * graph.picture_x()).rate(rates), Rate::column);
    EXPECT_EQ((graph.input("column") * graph.picture_y()).rate(rates), Rate::pixel);
    EXPECT_EQ((graph.input("row") * graph.picture_y()).rate(rates), Rate::row);
    EXPECT_EQ(graph.variable(0).rate(rates), Rate::pixel);
}

// What is multiplied once a column and once a row is so for declared inputs too.
TEST(Rates, DecideWhatSimplificationKeepsTogether) {
    Graph graph;
    const Expr a = graph.input("a");
    const Expr b = graph.input("b");
    const Expr product = sin(graph.picture_x()) * sin(b) * sin(a) * sin(graph.picture_y());
    Rates rates;
    rates.declare(id_of(a), Rate::column);
    rates.declare(id_of(b), Rate::row);
    const Expr simple = simplify(std::span(&product, 1), rates).front();
    ASSERT_EQ(simple.op(), Op::multiply);
    std::array factors{simple.argument(0).rate(rates), simple.argument(1).rate(rates)};
    std::sort(factors.begin(), factors.end());
    EXPECT_EQ(factors, (std::array{Rate::column, Rate::row}));
}

}  // namespace balcony::expr::inputs_test
