// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "random_expressions.hpp"

#include <array>

namespace balcony::program {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Op;

class ProductAndOne final : public expr::Native {
public:
    [[nodiscard]] std::string_view name() const override { return "product_and_one"; }
    [[nodiscard]] std::size_t arity() const override { return 2; }
    void evaluate(std::size_t count, const double* const* arguments,
                  double* results) const override {
        for (std::size_t i = 0; i < count; ++i) {
            results[i] = arguments[0][i] * arguments[1][i] + 1.0;
        }
    }
    [[nodiscard]] std::shared_ptr<const Native> derivative(std::size_t) const override {
        return nullptr;
    }
};

}  // namespace

std::vector<Expr> random_expressions(Graph& graph, Random& random, std::size_t nodes,
                                     std::size_t roots, bool only_exact) {
    std::vector<Op> allowed;
    for (const expr::Operation& operation : expr::operations()) {
        if (operation.scalar != nullptr && (!only_exact || operation.max_ulp == 0.0)) {
            allowed.push_back(operation.op);
        }
    }
    const std::vector<double> values{1.0, -2.0, 0.5, 3.25};
    const std::vector<double> slopes{1.0, 0.0, -1.5, 2.0};
    const auto table =
        std::make_shared<const expr::Table>(expr::hermite_table(0.0, 30.0, values, slopes));
    const auto native = std::make_shared<const ProductAndOne>();
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    std::vector<Expr> made{graph.picture_x(), graph.picture_y(), graph.time(),
                           graph.constant(number(random))};
    const auto any = [&] { return made[random() % made.size()]; };
    while (made.size() < nodes) {
        if (random() % 16 == 0) {
            made.push_back(graph.constant(number(random)));
        } else if (random() % 16 == 0) {
            made.push_back(graph.lookup(table, any()));
        } else if (random() % 16 == 0) {
            made.push_back(graph.native(native, std::array{any(), any()}));
        } else {
            const Op op = allowed[random() % allowed.size()];
            const std::vector<Expr> arguments{any(), any(), any()};
            const auto arity = static_cast<std::size_t>(expr::operation(op).arity);
            made.push_back(graph.apply(op, std::span(arguments).first(arity)));
        }
    }
    std::vector<Expr> chosen;
    for (std::size_t i = 0; i < roots; ++i) {
        chosen.push_back(any());
    }
    return chosen;
}

}  // namespace balcony::program
