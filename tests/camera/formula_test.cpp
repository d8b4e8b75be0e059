// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "support.hpp"

namespace balcony::camera::formula_test {

namespace {

template <class Build>
std::shared_ptr<const Stage> by_formula(StageKind kind, std::string_view name,
                                        std::size_t parameters, const Build& build) {
    Arguments arguments;
    arguments.set_formula(formula(parameters, build));
    return *catalogue().find(kind, name)->make(arguments);
}

using Expressions = std::vector<Expr>;

}  // namespace

TEST(Formula, TakesArgumentsFromAnotherGraph) {
    const Formula product = formula(2, [](Graph& graph, const Expressions& p) {
        return Expressions{p[0] * p[1] + graph.time(), p[0] - p[1]};
    });
    EXPECT_EQ(product.parameter_count(), 2U);
    EXPECT_EQ(product.result_count(), 2U);
    Graph graph;
    const std::array arguments{graph.picture_x() + 1.0, graph.picture_y()};
    const Expressions results = product.emit(graph, arguments);
    EXPECT_EQ(expr::evaluate(results, {2.0, 5.0, 0.5, {}}), (std::vector<double>{15.5, -2.0}));
    // The same formula again is the same nodes.
    EXPECT_TRUE(product.emit(graph, arguments)[0].same(results[0]));
}

TEST(Formula, KnowsWhichResultsAreConstant) {
    const Formula mixed = formula(0, [](Graph& graph, const Expressions&) {
        return Expressions{graph.constant(2.0) * 3.0, graph.time()};
    });
    EXPECT_EQ(mixed.constant(0), 6.0);
    EXPECT_EQ(mixed.constant(1), std::nullopt);
}

TEST(Scalar, IsAConstantOrAFormulaInTime) {
    EXPECT_EQ(Scalar(2.5).constant(), 2.5);
    const Scalar folded(formula(0, [](Graph& graph, const Expressions&) {
        return Expressions{sqrt(graph.constant(9.0))};
    }));
    EXPECT_EQ(folded.constant(), 3.0);
    const Scalar moving(formula(
        0, [](Graph& graph, const Expressions&) { return Expressions{2.0 * graph.time()}; }));
    EXPECT_EQ(moving.constant(), std::nullopt);
    Graph graph;
    EXPECT_EQ(expr::evaluate(std::array{moving.emit(graph)}, {0.0, 0.0, 4.0, {}})[0], 8.0);
}

TEST(Scalar, InTimeMovesAnObject) {
    Given radius;
    radius["radius"] = std::vector<Scalar>{Scalar(formula(
        0, [](Graph& graph, const Expressions&) { return Expressions{1.0 + graph.time()}; }))};
    const GeneratorProbe sphere(object("sphere", radius));
    EXPECT_NEAR(length(sphere(0.3, 0.4, 0.0).point), 1.0, 1e-15);
    EXPECT_NEAR(length(sphere(0.3, 0.4, 2.0).point), 3.0, 1e-15);
}

TEST(FormulaStages, AreTheirFormulas) {
    using enum StageKind;
    const GeneratorProbe curve(std::dynamic_pointer_cast<const ObjectGenerator>(
        by_formula(object_generator, "curve", 1, [](Graph&, const Expressions& p) {
            return Expressions{p[0], p[0] * p[0]};
        })));
    expect_near(curve(3.0).point, {3.0, 9.0, 0.0}, 0.0);
    const GeneratorProbe space_curve(std::dynamic_pointer_cast<const ObjectGenerator>(
        by_formula(object_generator, "curve", 1, [](Graph& graph, const Expressions& p) {
            return Expressions{p[0], p[0] * p[0], graph.constant(4.0)};
        })));
    expect_near(space_curve(3.0).point, {3.0, 9.0, 4.0}, 0.0);
    const GeneratorProbe surface(std::dynamic_pointer_cast<const ObjectGenerator>(
        by_formula(object_generator, "surface", 2, [](Graph&, const Expressions& p) {
            return Expressions{p[0], p[1], p[0] * p[1]};
        })));
    expect_near(surface(3.0, 5.0).point, {3.0, 5.0, 15.0}, 0.0);
    expect_near(surface(3.0, 5.0).along_u, {1.0, 0.0, 5.0}, 0.0);
    expect_near(surface(3.0, 5.0).along_v, {0.0, 1.0, 3.0}, 0.0);
    const auto warp_by = std::dynamic_pointer_cast<const ParameterTransformer>(
        by_formula(parameter_transformer, "formula", 2, [](Graph&, const Expressions& p) {
            return Expressions{p[1], 2.0 * p[0]};
        }));
    EXPECT_EQ(warped(warp_by, 3.0, 5.0), (std::array{5.0, 6.0}));
    const auto move_by = std::dynamic_pointer_cast<const ObjectTransformer>(
        by_formula(object_transformer, "formula", 3, [](Graph&, const Expressions& p) {
            return Expressions{p[2], p[0], p[1] * p[1]};
        }));
    expect_near(transformed(move_by, {1.0, 2.0, 3.0}), {3.0, 1.0, 4.0}, 0.0);
}

}  // namespace balcony::camera::formula_test
