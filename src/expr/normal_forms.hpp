// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/expr.hpp"

namespace balcony::expr {

/// A coefficient times factors sorted by rate, so that everything that depends on the column alone
/// is multiplied once per column, and likewise for rows.
class ProductForm {
public:
    /// The product of one factor.
    ProductForm(Expr factor, const Rates& rates);

    [[nodiscard]] static ProductForm product(const ProductForm& a, const ProductForm& b);
    [[nodiscard]] std::size_t factor_count() const;
    /// The number of multiplications per point in the result of build().
    [[nodiscard]] std::size_t pixel_cost() const;

    [[nodiscard]] double coefficient() const { return coefficient_; }
    /// The product without its coefficient.
    [[nodiscard]] Expr build_factors(Graph& graph) const;

private:
    struct Factor {
        Expr base;
        Rate rate;
        unsigned times;
    };
    [[nodiscard]] Expr part(Graph& graph, Rate rate) const;

    std::vector<Factor> factors_;  ///< By rate, then by index; each base once, none constant.
    double coefficient_ = 1.0;
};

/// c0 + c1 t1 + c2 t2 + ...: the form to which chains of affine maps collapse.
class LinearForm {
public:
    LinearForm() = default;
    /// The expression itself as the only term, or as the constant if it is one.
    LinearForm(Expr term, const Rates& rates);

    /// a + factor * b.
    [[nodiscard]] static LinearForm sum(const LinearForm& a, double factor, const LinearForm& b);
    [[nodiscard]] LinearForm scaled(double factor) const;
    [[nodiscard]] std::size_t term_count() const { return terms_.size(); }
    /// Whether no coefficient is infinite, subnormal or, by underflow, 0.
    [[nodiscard]] bool has_normal_coefficients() const;

    /// The sum, with common row and column factors of its terms taken out.
    [[nodiscard]] Expr build(Graph& graph, const Rates& rates) const;

private:
    struct Term {
        Expr value;
        Rate rate;
        double coefficient;
    };
    [[nodiscard]] std::vector<Term> factored_terms(Graph& graph, const Rates& rates,
                                                   bool by_row) const;

    std::vector<Term> terms_;  ///< By index; each value once; no coefficient is 0.
    double constant_ = 0.0;
};

}  // namespace balcony::expr
