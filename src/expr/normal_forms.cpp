// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "expr/normal_forms.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace balcony::expr {

namespace {

bool comes_before(Rate rate_a, Expr a, Rate rate_b, Expr b) {
    return rate_a != rate_b ? rate_a < rate_b : a.id() < b.id();
}

Expr power_by_squaring(Expr base, unsigned times) {
    Expr product;
    for (Expr square = base; times != 0; times /= 2) {
        if (times % 2 == 1) {
            product = product.valid() ? product * square : square;
        }
        if (times > 1) {
            square = square * square;
        }
    }
    return product;
}

// A term of a sum as coefficient * column * row, if it has that form, for factoring.
struct SeparatedTerm {
    Expr column;
    Expr row;
};

std::optional<SeparatedTerm> separate(Expr term, const Rates& rates) {
    if (term.op() != Op::multiply) {
        return std::nullopt;
    }
    const Expr a = term.argument(0);
    const Expr b = term.argument(1);
    if (a.rate(rates) == Rate::column && b.rate(rates) == Rate::row) {
        return SeparatedTerm{a, b};
    }
    if (a.rate(rates) == Rate::row && b.rate(rates) == Rate::column) {
        return SeparatedTerm{b, a};
    }
    return std::nullopt;
}

Expr scale(double coefficient, Expr value, const Rates& rates);

// coefficient * value with the coefficient moved to a factor that is computed less often, if there
// is one among the factors or, that many levels down, among their factors.
Expr scaled_within(double coefficient, Expr value, const Rates& rates, int levels) {
    if (value.op() != Op::multiply || levels == 0) {
        return {};
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        if (value.argument(i).rate(rates) < value.rate(rates)) {
            return scale(coefficient, value.argument(i), rates) * value.argument(1 - i);
        }
    }
    for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
        const Expr inner = scaled_within(coefficient, value.argument(i), rates, levels - 1);
        if (inner.valid()) {
            return inner * value.argument(1 - i);
        }
    }
    return {};
}

Expr scale(double coefficient, Expr value, const Rates& rates) {
    constexpr int levels = 2;
    const Expr within =
        coefficient != 1.0 ? scaled_within(coefficient, value, rates, levels) : Expr{};
    return within.valid() ? within : coefficient * value;
}

constexpr std::size_t rate_count = static_cast<std::size_t>(Rate::pixel) + 1;

// A running sum that uses a - b where possible.
class Sum {
public:
    Sum(Graph& graph, const Rates& rates) : graph_(&graph), rates_(&rates) {}

    void add(double coefficient, Expr value) {
        if (!total_.valid()) {
            total_ = scale(coefficient, value, *rates_);
        } else if (coefficient < 0.0) {
            total_ = total_ - scale(-coefficient, value, *rates_);
        } else {
            total_ = total_ + scale(coefficient, value, *rates_);
        }
    }
    void add_constant(double constant) { total_ = value() + constant; }
    void join(const Sum& other) {
        if (other.total_.valid()) {
            total_ = total_.valid() ? total_ + other.total_ : other.total_;
        }
    }
    [[nodiscard]] Expr value() const { return total_.valid() ? total_ : graph_->constant(0.0); }

private:
    Graph* graph_;
    const Rates* rates_;
    Expr total_;
};

}  // namespace

ProductForm::ProductForm(Expr factor, const Rates& rates) {
    if (factor.op() == Op::negate) {
        coefficient_ = -1.0;
        factor = factor.argument(0);
    }
    if (factor.op() == Op::multiply) {
        for (const std::size_t i : {std::size_t{0}, std::size_t{1}}) {
            if (factor.argument(i).is_constant()) {
                coefficient_ *= factor.argument(i).node().value;
                factor = factor.argument(1 - i);
                break;
            }
        }
    }
    if (factor.is_constant()) {
        coefficient_ *= factor.node().value;
    } else {
        factors_.push_back({factor, factor.rate(rates), 1});
    }
}

ProductForm ProductForm::product(const ProductForm& a, const ProductForm& b) {
    ProductForm result = a;
    result.coefficient_ *= b.coefficient_;
    for (const Factor& factor : b.factors_) {
        const auto place =
            std::lower_bound(result.factors_.begin(), result.factors_.end(), factor,
                             [](const Factor& left, const Factor& right) {
                                 return comes_before(left.rate, left.base, right.rate, right.base);
                             });
        if (place != result.factors_.end() && place->base.same(factor.base)) {
            place->times += factor.times;
        } else {
            result.factors_.insert(place, factor);
        }
    }
    return result;
}

std::size_t ProductForm::factor_count() const {
    std::size_t count = 0;
    for (const Factor& factor : factors_) {
        count += factor.times;
    }
    return count;
}

std::size_t ProductForm::pixel_cost() const {
    std::size_t pixel_factors = 0;
    bool column = false;
    bool row = false;
    for (const Factor& factor : factors_) {
        column = column || factor.rate == Rate::column;
        row = row || factor.rate == Rate::row;
        pixel_factors += factor.rate == Rate::pixel ? factor.times : 0;
    }
    const std::size_t operands = pixel_factors + (column ? 1 : 0) + (row ? 1 : 0);
    return operands > 0 && (pixel_factors > 0 || (column && row)) ? operands - 1 : 0;
}

Expr ProductForm::part(Graph& graph, Rate rate) const {
    Expr product;
    for (const Factor& factor : factors_) {
        if (factor.rate == rate) {
            const Expr power = power_by_squaring(factor.base, factor.times);
            product = product.valid() ? product * power : power;
        }
    }
    return product.valid() ? product : graph.constant(1.0);
}

Expr ProductForm::build_factors(Graph& graph) const {
    const Expr uniform = part(graph, Rate::uniform);
    const Expr column = part(graph, Rate::column);
    const Expr row = part(graph, Rate::row);
    const Expr pixel = part(graph, Rate::pixel);
    if (!column.is_constant()) {
        return ((uniform * column) * row) * pixel;
    }
    return (uniform * row) * pixel;
}

LinearForm::LinearForm(Expr term, const Rates& rates) {
    if (term.is_constant()) {
        constant_ = term.node().value;
    } else {
        terms_.push_back({term, term.rate(rates), 1.0});
    }
}

LinearForm LinearForm::sum(const LinearForm& a, double factor, const LinearForm& b) {
    LinearForm result = a;
    result.constant_ += factor * b.constant_;
    for (const Term& term : b.terms_) {
        const auto place = std::lower_bound(result.terms_.begin(), result.terms_.end(), term,
                                            [](const Term& left, const Term& right) {
                                                return comes_before(left.rate, left.value,
                                                                    right.rate, right.value);
                                            });
        const double coefficient = factor * term.coefficient;
        if (place == result.terms_.end() || !place->value.same(term.value)) {
            result.terms_.insert(place, {term.value, term.rate, coefficient});
        } else {
            place->coefficient += coefficient;
            if (place->coefficient == 0.0) {
                result.terms_.erase(place);
            }
        }
    }
    return result;
}

bool LinearForm::has_normal_coefficients() const {
    return std::all_of(terms_.begin(), terms_.end(),
                       [](const Term& term) { return std::isnormal(term.coefficient); });
}

LinearForm LinearForm::scaled(double factor) const { return sum(LinearForm(), factor, *this); }

// Terms c*C*R with the same R are summed as (c*C + ...)*R, which leaves one product per point for
// any number of them; likewise for one C.
std::vector<LinearForm::Term> LinearForm::factored_terms(Graph& graph, const Rates& rates,
                                                         bool by_row) const {
    std::vector<Term> rest = terms_;
    std::vector<Term> factored;
    for (std::size_t i = 0; i < rest.size();) {
        const auto first = separate(rest[i].value, rates);
        const Expr common = !first ? Expr{} : by_row ? first->row : first->column;
        const auto shares = [&](const Term& term) {
            const auto parts = separate(term.value, rates);
            return parts && common.same(by_row ? parts->row : parts->column);
        };
        if (!first || std::count_if(rest.begin(), rest.end(), shares) < 2) {
            ++i;
            continue;
        }
        Sum inner(graph, rates);
        for (const Term& term : rest) {
            if (shares(term)) {
                const auto parts = separate(term.value, rates);
                inner.add(term.coefficient, by_row ? parts->column : parts->row);
            }
        }
        std::erase_if(rest, shares);
        const Expr product = inner.value() * common;
        factored.push_back({product, product.rate(rates), 1.0});
    }
    rest.insert(rest.end(), factored.begin(), factored.end());
    return rest;
}

Expr LinearForm::build(Graph& graph, const Rates& rates) const {
    LinearForm factored;
    factored.terms_ = factored_terms(graph, rates, true);
    factored.terms_ = factored.factored_terms(graph, rates, false);
    // One sum per rate, with the constant in the slowest, where it is cheapest; then the sum of
    // these.
    const Sum none(graph, rates);
    std::array<Sum, rate_count> sums{none, none, none, none};
    std::size_t slowest = rate_count;
    for (const Term& term : factored.terms_) {
        const auto rate = static_cast<std::size_t>(term.rate);
        sums[rate].add(term.coefficient, term.value);
        slowest = std::min(slowest, rate);
    }
    if (slowest == rate_count) {
        return graph.constant(constant_);
    }
    sums[slowest].add_constant(constant_);
    Sum total = none;
    for (const Sum& sum : sums) {
        total.join(sum);
    }
    return total.value();
}

}  // namespace balcony::expr
