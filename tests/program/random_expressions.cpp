// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "random_expressions.hpp"

#include <array>

#include <gtest/gtest.h>

namespace balcony::program {

namespace {

using expr::Expr;
using expr::Graph;
using expr::Op;

constexpr std::array<std::pair<const char*, Rate>, 4> further_inputs{{{"uniform", Rate::uniform},
                                                                      {"column", Rate::column},
                                                                      {"row", Rate::row},
                                                                      {"pixel", Rate::pixel}}};

class Sums final : public expr::Native {
public:
    Sums(std::size_t arguments, std::size_t results) : arguments_(arguments), results_(results) {}
    [[nodiscard]] std::string_view name() const override { return "sums"; }
    [[nodiscard]] std::size_t argument_count() const override { return arguments_; }
    [[nodiscard]] std::size_t result_count() const override { return results_; }
    // Result by result, as a native may.
    void evaluate(std::size_t count, const double* const* arguments,
                  double* const* results) const override {
        for (std::size_t r = 0; r < results_; ++r) {
            for (std::size_t i = 0; i < count; ++i) {
                double sum = static_cast<double>(r);
                for (std::size_t k = 0; k < arguments_; ++k) {
                    sum = sum * 0.5 + arguments[k][i];
                }
                results[r][i] = sum;
            }
        }
    }
    [[nodiscard]] Expr derivative(std::size_t, std::size_t, std::span<const Expr>,
                                  std::span<const Expr>) const override {
        return {};
    }

private:
    std::size_t arguments_, results_;
};

}  // namespace

Interface random_interface(Sampling sampling) {
    Interface interface {
        sampling, {}
    };
    for (const auto& [name, rate] : further_inputs) {
        interface.inputs.push_back({name, rate});
    }
    return interface;
}

Program compile_random(std::span<const Expr> roots, Sampling sampling) {
    Result<Program> made = Program::make(roots, random_interface(sampling));
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *std::move(made).value;
}

std::vector<Expr> simplify_random(std::span<const Expr> roots) {
    Graph& graph = roots.front().graph();
    expr::Rates rates;
    for (const auto& [name, rate] : further_inputs) {
        rates.declare(expr::InputId(graph.input(name).node().detail), rate);
    }
    return expr::simplify(roots, rates);
}

void RandomInputs::fill(Random& random, const std::array<std::size_t, 4>& counts) {
    std::uniform_real_distribution<double> number(-20.0, 20.0);
    for (std::size_t i = 0; i < counts.size(); ++i) {
        for (std::size_t k = 0; k < counts[i]; ++k) {
            values_[i].push_back(number(random));
        }
        spans_[i] = values_[i];
    }
}

RandomInputs::RandomInputs(Random& random, const Tile& tile) {
    fill(random, {1, tile.width, tile.height, tile.width * tile.height});
}

RandomInputs::RandomInputs(Random& random, std::size_t points) {
    fill(random, {1, points, points, points});
}

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
    std::uniform_real_distribution<double> number(-2.0, 2.0);
    std::vector<Expr> made{graph.picture_x(), graph.picture_y(), graph.time(),
                           graph.constant(number(random))};
    for (const auto& [name, rate] : further_inputs) {
        made.push_back(graph.input(name));
    }
    const auto any = [&] { return made[random() % made.size()]; };
    while (made.size() < nodes) {
        if (random() % 16 == 0) {
            made.push_back(graph.constant(number(random)));
        } else if (random() % 16 == 0) {
            made.push_back(graph.lookup(table, any()));
        } else if (random() % 16 == 0) {
            const auto native = std::make_shared<const Sums>(1 + random() % 7, 1 + random() % 5);
            std::vector<Expr> arguments;
            for (std::size_t k = 0; k < native->argument_count(); ++k) {
                arguments.push_back(any());
            }
            // Some of the results, in any order.
            const std::vector<Expr> results = graph.call(native, arguments);
            for (std::size_t used = 0; used < 1 + random() % results.size(); ++used) {
                made.push_back(results[random() % results.size()]);
            }
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
