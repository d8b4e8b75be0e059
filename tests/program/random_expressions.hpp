// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <random>
#include <span>
#include <vector>

#include "balcony/program.hpp"

namespace balcony::program {

using Random = std::mt19937_64;

/// One further input of each rate, which random expressions depend on.
Interface random_interface(Sampling sampling);
Program compile_random(std::span<const expr::Expr> roots, Sampling sampling = Sampling::grid);
/// What simplification makes of expressions for that interface.
std::vector<expr::Expr> simplify_random(std::span<const expr::Expr> roots);

/// Values for these inputs over a tile or some points.
class RandomInputs {
public:
    RandomInputs(Random& random, const Tile& tile);
    RandomInputs(Random& random, std::size_t points);

    [[nodiscard]] InputValues values() const { return spans_; }

private:
    void fill(Random& random, const std::array<std::size_t, 4>& counts);

    std::array<std::vector<double>, 4> values_;
    std::array<std::span<const double>, 4> spans_;
};

/// Expressions over random operations, look-ups and natives on the inputs, all or only those that
/// every runner computes exactly.
std::vector<expr::Expr> random_expressions(expr::Graph& graph, Random& random, std::size_t nodes,
                                           std::size_t roots, bool only_exact);

}  // namespace balcony::program
