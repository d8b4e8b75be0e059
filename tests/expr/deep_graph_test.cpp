// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Graphs up to a million nodes deep: nothing may recurse or grow faster than the graph.

#include <array>
#include <ctime>
#include <functional>

#include <gtest/gtest.h>

#include "balcony/expr.hpp"

namespace balcony::expr::deep_graph_test {

namespace {

struct Shape {
    const char* name;
    std::size_t nodes;
    Expr (*next)(Expr last, std::size_t i);
};

constexpr std::size_t million = 1000000;

// Chains of what the simplifier dissolves, what it leaves alone, and what it must cut into pieces
// (the dearest: a shorter chain overflows a stack as well).
const Shape shapes[] = {
    {"affine", million / 4,
     [](Expr e, std::size_t i) { return (e + 0.5) * (i % 2 == 0 ? 0.75 : 1.25); }},
    {"nested", million, [](Expr e, std::size_t) { return sin(e); }},
    {"sum", million / 4,
     [](Expr e, std::size_t i) { return e + sin(static_cast<double>(i) * e.graph().picture_x()); }},
    // Long enough that a quarter of it spends as many passes of the simplifier as the whole.
    {"product", million / 2,
     [](Expr e, std::size_t i) { return e * sin(static_cast<double>(i) * e.graph().picture_y()); }},
    {"shared", million / 4, [](Expr e, std::size_t) { return cos(e * e + e); }},
};

Expr chain(Graph& graph, const Shape& shape, std::size_t nodes) {
    Expr e = graph.picture_x() + graph.picture_y();
    for (std::size_t i = 1; graph.size() < nodes; ++i) {
        e = shape.next(e, i);
    }
    return e;
}

double processor_seconds(const std::function<void()>& work) {
    const std::clock_t begin = std::clock();
    work();
    return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

double seconds_for_all(const Shape& shape, std::size_t nodes) {
    return processor_seconds([&] {
        Graph graph;
        const Expr deep = chain(graph, shape, nodes);
        const std::array roots{deep};
        EXPECT_TRUE(differentiate(deep, graph.picture_x()).valid());
        EXPECT_TRUE(simplify(roots).front().valid());
        EXPECT_EQ(evaluate(roots, {0.5, 0.25, 0.0, {}}).size(), 1U);
        EXPECT_FALSE(print(deep).empty());
        Graph target;
        EXPECT_TRUE(substitute(target, roots, {}).front().valid());
    });
}

class DeepGraph : public testing::TestWithParam<Shape> {};

}  // namespace

TEST_P(DeepGraph, TakesNoStackAndTimeInProportion) {
    // 4 times the nodes: 4 if linear, 16 if quadratic. Between them caches miss more often. What
    // else runs on the machine spoils a measurement now and then, so it may be repeated.
    double ratio = 10.0;
    for (int attempt = 0; attempt < 3 && ratio >= 10.0; ++attempt) {
        const double quarter = seconds_for_all(GetParam(), GetParam().nodes / 4);
        ratio = seconds_for_all(GetParam(), GetParam().nodes) / quarter;
    }
    EXPECT_LT(ratio, 10.0);
}

INSTANTIATE_TEST_SUITE_P(Shapes, DeepGraph, testing::ValuesIn(shapes),
                         [](const auto& row) { return std::string(row.param.name); });

}  // namespace balcony::expr::deep_graph_test
