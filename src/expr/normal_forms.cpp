// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "expr/normal_forms.hpp"

#include <algorithm>
#include <optional>

namespace balcony::expr {

namespace {

bool comes_before(Expr a, Expr b) {
    return a.rate() != b.rate() ? a.rate() < b.rate() : a.id() < b.id();
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

// What factoring looks at in a term of a sum: coefficient * column * row, if it has that shape.
struct SeparatedTerm {
    Expr column;
    Expr row;
};

std::optional<SeparatedTerm> separate(Expr term) {
    if (term.op() != Op::multiply) {
        return std::nullopt;
    }
    const Expr a = term.argument(0);
    const Expr b = term.argument(1);
    if (a.rate() == Rate::column && b.rate() == Rate::row) {
        return SeparatedTerm{a, b};
    }
    if (a.rate() == Rate::row && b.rate() == Rate::column) {
        return SeparatedTerm{b, a};
    }
    return std::nullopt;
}

// coefficient * value, with the coefficient taken into the factor that is computed less often.
Expr scale(double coefficient, Expr value) {
    if (value.op() == Op::multiply && coefficient != 1.0 && coefficient != -1.0) {
        const Expr a = value.argument(0);
        const Expr b = value.argument(1);
        if (a.rate() < value.rate()) {
            return scale(coefficient, a) * b;
        }
        if (b.rate() < value.rate()) {
            return a * scale(coefficient, b);
        }
    }
    return coefficient * value;
}

// A running sum that writes a - b where it can.
class Sum {
public:
    explicit Sum(Graph& graph) : graph_(&graph) {}

    void add(double coefficient, Expr value) {
        if (!total_.valid()) {
            total_ = scale(coefficient, value);
        } else if (coefficient < 0.0) {
            total_ = total_ - scale(-coefficient, value);
        } else {
            total_ = total_ + scale(coefficient, value);
        }
    }
    [[nodiscard]] Expr plus(double constant) const {
        return total_.valid() ? total_ + constant : graph_->constant(constant);
    }

private:
    Graph* graph_;
    Expr total_;
};

}  // namespace

ProductForm::ProductForm(Expr factor) {
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
        factors_.push_back({factor, 1});
    }
}

ProductForm ProductForm::product(const ProductForm& a, const ProductForm& b) {
    ProductForm result = a;
    result.coefficient_ *= b.coefficient_;
    for (const Factor& factor : b.factors_) {
        const auto place = std::lower_bound(
            result.factors_.begin(), result.factors_.end(), factor,
            [](const Factor& left, const Factor& right) {
                return comes_before(left.base, right.base);
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
        column = column || factor.base.rate() == Rate::column;
        row = row || factor.base.rate() == Rate::row;
        pixel_factors += factor.base.rate() == Rate::pixel ? factor.times : 0;
    }
    const std::size_t operands = pixel_factors + (column ? 1 : 0) + (row ? 1 : 0);
    return operands > 0 && (pixel_factors > 0 || (column && row)) ? operands - 1 : 0;
}

Expr ProductForm::part(Graph& graph, Rate rate) const {
    Expr product;
    for (const Factor& factor : factors_) {
        if (factor.base.rate() == rate) {
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

LinearForm::LinearForm(Expr term) {
    if (term.is_constant()) {
        constant_ = term.node().value;
    } else {
        terms_.push_back({term, 1.0});
    }
}

LinearForm LinearForm::sum(const LinearForm& a, double factor, const LinearForm& b) {
    LinearForm result = a;
    result.constant_ += factor * b.constant_;
    for (const Term& term : b.terms_) {
        const auto place = std::lower_bound(
            result.terms_.begin(), result.terms_.end(), term,
            [](const Term& left, const Term& right) {
                return comes_before(left.value, right.value);
            });
        const double coefficient = factor * term.coefficient;
        if (place == result.terms_.end() || !place->value.same(term.value)) {
            result.terms_.insert(place, {term.value, coefficient});
        } else {
            place->coefficient += coefficient;
            if (place->coefficient == 0.0) {
                result.terms_.erase(place);
            }
        }
    }
    return result;
}

LinearForm LinearForm::scaled(double factor) const {
    return sum(LinearForm(), factor, *this);
}

// Terms c*C*R with one R are summed as (c*C + ...)*R, which leaves one product a point for any
// number of them; likewise for one C.
std::vector<LinearForm::Term> LinearForm::factored_terms(Graph& graph, bool by_row) const {
    std::vector<Term> rest = terms_;
    std::vector<Term> factored;
    for (std::size_t i = 0; i < rest.size();) {
        const auto first = separate(rest[i].value);
        const Expr common = !first ? Expr{} : by_row ? first->row : first->column;
        const auto shares = [&](const Term& term) {
            const auto parts = separate(term.value);
            return parts && common.same(by_row ? parts->row : parts->column);
        };
        if (!first || std::count_if(rest.begin(), rest.end(), shares) < 2) {
            ++i;
            continue;
        }
        Sum inner(graph);
        for (const Term& term : rest) {
            if (shares(term)) {
                const auto parts = separate(term.value);
                inner.add(term.coefficient, by_row ? parts->column : parts->row);
            }
        }
        std::erase_if(rest, shares);
        factored.push_back({inner.plus(0.0) * common, 1.0});
    }
    rest.insert(rest.end(), factored.begin(), factored.end());
    return rest;
}

Expr LinearForm::build(Graph& graph) const {
    LinearForm factored;
    factored.terms_ = factored_terms(graph, true);
    factored.terms_ = factored.factored_terms(graph, false);
    std::stable_sort(
        factored.terms_.begin(), factored.terms_.end(),
        [](const Term& a, const Term& b) { return a.value.rate() < b.value.rate(); });

    Sum total(graph);
    bool constant_added = constant_ == 0.0;
    Rate last_rate = Rate::pixel;
    for (const auto& [value, coefficient] : factored.terms_) {
        // The constant joins the group of the slowest rate, where it costs least.
        if (!constant_added && last_rate < value.rate()) {
            total.add(1.0, graph.constant(constant_));
            constant_added = true;
        }
        last_rate = value.rate();
        total.add(coefficient, value);
    }
    return total.plus(constant_added ? 0.0 : constant_);
}

}  // namespace balcony::expr
