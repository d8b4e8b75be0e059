// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/expr.hpp"

namespace balcony::expr {

/// A product sorted by the rate of its factors, so that everything that depends on the column
/// alone is multiplied once a column, and likewise for rows.
class ProductForm {
public:
    /// The product of one factor.
    explicit ProductForm(Expr factor);

    [[nodiscard]] static ProductForm product(const ProductForm& a, const ProductForm& b);
    [[nodiscard]] std::size_t factor_count() const;
    /// The multiplications that build() spends at every point.
    [[nodiscard]] std::size_t pixel_cost() const;

    /// The factors of one rate, multiplied; 1 if there are none.
    [[nodiscard]] Expr part(Graph& graph, Rate rate) const;
    [[nodiscard]] Expr build(Graph& graph) const;

private:
    struct Factor {
        Expr base;
        unsigned times;
    };
    ProductForm() = default;

    std::vector<Factor> factors_;  ///< By rate, then by index; each base once.
};

/// c0 + c1 t1 + c2 t2 + ...: what chains of affine maps collapse into.
class LinearForm {
public:
    /// The expression itself as the only term.
    explicit LinearForm(Expr term);
    explicit LinearForm(double constant) : constant_(constant) {}

    /// a + factor * b.
    [[nodiscard]] static LinearForm sum(const LinearForm& a, double factor, const LinearForm& b);
    [[nodiscard]] LinearForm scaled(double factor) const;
    [[nodiscard]] std::size_t term_count() const { return terms_.size(); }

    /// The sum, with common row and column factors of its terms taken out.
    [[nodiscard]] Expr build(Graph& graph) const;

private:
    struct Term {
        Expr value;
        double coefficient;
    };
    [[nodiscard]] std::vector<Term> factored_terms(Graph& graph, bool by_row) const;

    std::vector<Term> terms_;  ///< By index; each value once; no coefficient is 0.
    double constant_ = 0.0;
};

}  // namespace balcony::expr
