// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <gtest/gtest.h>

#include <cmath>

#include "bridge/text/unused_branches.hpp"
#include "examples.hpp"

namespace balcony::bridge::unused_branches_test {
namespace {

using expr::Graph;
using expr::NodeId;

// Formulas with a number and no condition.
template <typename Write>
CameraFormulas guarded_formulas(const Write& write) {
    CameraFormulas made;
    made.graph = std::make_unique<Graph>();
    made.roots = {write(made.graph->picture_x(), made.graph->picture_y())};
    made.condition = std::nullopt;
    Result<CameraFormulas> guarded = with_guarded_branches(std::move(made), "c");
    EXPECT_TRUE(guarded);
    return std::move(*guarded);
}

double value(const CameraFormulas& formulas, double x, double y) {
    return expr::evaluate(formulas.roots, {.x = x, .y = y}).front();
}

// What a program computes at a point that differentiates operation by operation and computes all
// branches: the derivative by x, in which 0 times infinity is not a number.
double derivative(const CameraFormulas& formulas, double x, double y) {
    const Graph& graph = *formulas.graph;
    std::vector<double> slopes(graph.size(), 0.0);
    const double small = 1e-6;
    for (const NodeId id : expr::reachable(graph, formulas.roots)) {
        const expr::Node& node = graph[id];
        if (node.op == Op::input) {
            slopes[id.value()] = id == formulas.graph->picture_x().id() ? 1.0 : 0.0;
            continue;
        }
        std::vector<double> at;
        const std::span<const NodeId> operands = graph.arguments(id);
        for (const NodeId operand : operands) {
            const Expr one(*formulas.graph, operand);
            at.push_back(expr::evaluate(std::span(&one, 1), {.x = x, .y = y}).front());
        }
        // The partial derivatives by central differences; a value without one beside it has none.
        const auto partial = [&](std::size_t i) {
            std::vector<double> high = at;
            std::vector<double> low = at;
            high[i] += small;
            low[i] -= small;
            const auto scalar = expr::operation(node.op).scalar;
            return (scalar(high.data()) - scalar(low.data())) / (2.0 * small);
        };
        double& slope = slopes[id.value()];
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const double by = slopes[operands[i].value()];
            if (node.op == Op::select) {
                slope += i == 0 ? 0.0 : (i == 1) == (at[0] != 0.0) ? by : 0.0 * by;
            } else if (!expr::operation(node.op).condition) {
                slope += partial(i) * by;
            }
        }
    }
    return slopes[formulas.roots.front().id().value()];
}

TEST(UnusedBranches, HaveFiniteDerivatives) {
    const auto f = guarded_formulas(
        [](Expr x, Expr y) { return select(x < 0.0, y * x, y * sqrt(x) + log(x) / x); });
    EXPECT_EQ(value(f, -2.0, 3.0), -6.0);
    EXPECT_NEAR(derivative(f, -2.0, 3.0), 3.0, 1e-6);
    EXPECT_EQ(value(f, 4.0, 3.0), 6.0 + std::log(4.0) / 4.0);
    EXPECT_NEAR(derivative(f, 4.0, 3.0), 0.75 + (1.0 - std::log(4.0)) / 16.0, 1e-6);
}

TEST(UnusedBranches, MayDependOnWhetherTheirValueIsThere) {
    const auto f = guarded_formulas([](Expr x, Expr) {
        const Expr root = sqrt(x) * x;
        return select(is_finite(root), root, 7.0 * x);
    });
    EXPECT_EQ(value(f, -1.0, 0.0), -7.0);
    EXPECT_NEAR(derivative(f, -1.0, 0.0), 7.0, 1e-6);
    EXPECT_EQ(value(f, 4.0, 0.0), 8.0);
}

TEST(UnusedBranches, AreTheOtherOperandsOfMinimaAndMaxima) {
    const auto f = guarded_formulas([](Expr x, Expr y) {
        Graph& graph = x.graph();
        const Expr inner = x * log(abs(x) + y);
        return min(max(inner, graph.constant(0.0)), graph.constant(1.0)) + x;
    });
    for (const double x : {-3.0, 0.1, 0.7, 3.0}) {
        const double inner = x * std::log(std::abs(x) + 0.5);
        EXPECT_EQ(value(f, x, 0.5), std::min(std::max(inner, 0.0), 1.0) + x);
    }
    const auto g =
        guarded_formulas([](Expr x, Expr) { return max(log(x), x.graph().constant(0.0)) + x; });
    EXPECT_NEAR(derivative(g, 0.0, 0.0), 1.0, 1e-6) << "log 0 is not taken";
}

TEST(UnusedBranches, StayAsTheyAreWhereAllOthersUseThem) {
    const auto f = guarded_formulas([](Expr x, Expr y) {
        const Expr root = sqrt(x);
        return root + select(y < 0.0, root, 2.0 * root) + select(y < 1.0, 1.0 / y, y);
    });
    std::size_t roots = 0;
    for (const NodeId id : expr::reachable(*f.graph, f.roots)) {
        if ((*f.graph)[id].op == Op::square_root) {
            ++roots;
            EXPECT_EQ((*f.graph)[f.graph->arguments(id)[0]].op, Op::input);
        }
    }
    EXPECT_EQ(roots, 1U);
}

// The rays of all cameras stay what they are, to the last bit.
TEST(UnusedBranches, ChangeNoRays) {
    std::size_t compared = 0;
    for (const test::Example& example : test::examples()) {
        Result<CameraFormulas> plain = formulas_of(example.camera, {.target = "c"});
        Result<CameraFormulas> formulas = formulas_of(example.camera, {.target = "c"});
        if (!plain || plain->graph->size() > 3000) {
            continue;
        }
        const Result<CameraFormulas> guarded =
            with_guarded_branches(std::move(*formulas), example.name);
        ASSERT_TRUE(guarded);
        for (const test::PicturePoint& at : test::points()) {
            const std::array inputs{expr::InputValue{width_input, test::width},
                                    expr::InputValue{height_input, test::height},
                                    expr::InputValue{"lens_x", 0.0},
                                    expr::InputValue{"lens_y", 0.0}};
            const expr::Point point{.x = at.x, .y = at.y, .inputs = inputs};
            const std::vector<double> before = expr::evaluate(plain->roots, point);
            const std::vector<double> after = expr::evaluate(guarded->roots, point);
            ASSERT_EQ(before[RayRoots::valid], after[RayRoots::valid]) << example.name;
            if (before[RayRoots::valid] == 1.0) {
                ASSERT_EQ(before, after) << example.name;
                ++compared;
            }
        }
    }
    EXPECT_GT(compared, 10'000U);
}

}  // namespace
}  // namespace balcony::bridge::unused_branches_test
