// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cmath>
#include <optional>

#include "balcony/expr.hpp"
#include "expr/normal_forms.hpp"

namespace balcony::expr {

namespace {

// Longer sums and products are split, so that the work is linear in the size of the graph.
constexpr std::size_t max_sum = 16;
constexpr std::size_t max_product = 8;

/// One pass over the graph that rewrites every node with rewritten arguments.
class Pass {
public:
    Pass(Graph& graph, const Rates& rates, std::span<const Expr> roots)
        : graph_(graph),
          rates_(rates),
          nodes_(reachable(graph, roots)),
          made_(graph.size()),
          uses_(graph.size(), 0),
          linear_(graph.size()),
          built_from_(graph.size()),
          product_(graph.size()) {
        for (const NodeId id : nodes_) {
            for (const NodeId argument : graph.arguments(id)) {
                ++uses_[argument.value()];
            }
        }
        for (const Expr root : roots) {
            ++uses_[root.id().value()];
        }
    }

    std::vector<Expr> run(std::span<const Expr> roots) {
        for (const NodeId id : nodes_) {
            made_[id.value()] = rewrite(id);
        }
        std::vector<Expr> result;
        result.reserve(roots.size());
        for (const Expr root : roots) {
            result.push_back(made_[root.id().value()]);
        }
        return result;
    }

private:
    Expr rewrite(NodeId id) {
        const Node node = graph_[id];
        switch (node.op) {
            case Op::add: return rewrite_sum(id, node, 1.0);
            case Op::subtract: return rewrite_sum(id, node, -1.0);
            case Op::negate: return rewrite_multiple(id, node.operands[0], -1.0);
            case Op::multiply: return rewrite_product(id, node);
            case Op::divide: return rewrite_quotient(id, node);
            default: return rewrite_arguments(id, node);
        }
    }

    Expr rewrite_arguments(NodeId id, const Node& node) {
        std::vector<Expr> arguments;
        for (const NodeId argument : graph_.arguments(id)) {
            arguments.push_back(made(argument));
        }
        return graph_.remake(graph_, node, arguments);
    }

    // A sum may be merged into an enclosing sum: always if nothing else uses it, if shared
    // only if the merged sum is not longer than the sum that keeps it.
    Expr rewrite_sum(NodeId id, const Node& node, double sign) {
        const NodeId a = node.operands[0];
        const NodeId b = node.operands[1];
        const LinearForm kept = LinearForm::sum(linear_or_term(a), sign, linear_or_term(b));
        LinearForm dissolved = LinearForm::sum(linear(a), sign, linear(b));
        const bool dissolve = dissolved.term_count() <= kept.term_count();
        return keep_linear(id, dissolve ? std::move(dissolved) : kept);
    }

    Expr keep_linear(NodeId id, LinearForm form) {
        const Expr built = form.build(graph_, rates_);
        if (form.term_count() <= max_sum) {
            linear_[id.value()] = std::move(form);
        }
        return built;
    }

    // A multiple of a shared sum is built from that sum, but an enclosing sum may still merge
    // it. Coefficients that would overflow or lose precision stay separate here and in
    // products, so that no term vanishes.
    Expr rewrite_multiple(NodeId id, NodeId of, double factor) {
        LinearForm form = linear(of).scaled(factor);
        if (!form.has_normal_coefficients()) {
            return factor * made(of);
        }
        if (uses_[of.value()] == 1 || form.term_count() <= 1) {
            return keep_linear(id, std::move(form));
        }
        LinearForm kept = LinearForm(made(of), rates_).scaled(factor);
        const Expr built = kept.build(graph_, rates_);
        linear_[id.value()] = std::move(form);
        built_from_[id.value()] = std::move(kept);
        return built;
    }

    Expr rewrite_product(NodeId id, const Node& node) {
        const NodeId a = node.operands[0];
        const NodeId b = node.operands[1];
        for (const auto& [constant, other] : {std::pair(a, b), std::pair(b, a)}) {
            if (made(constant).is_constant()) {
                return rewrite_multiple(id, other, made(constant).node().value);
            }
        }
        const ProductForm kept =
            ProductForm::product(ProductForm(made(a), rates_), ProductForm(made(b), rates_));
        if (!std::isnormal(kept.coefficient())) {
            return made(a) * made(b);
        }
        ProductForm dissolved = ProductForm::product(product(a), product(b));
        const bool dissolve = std::isnormal(dissolved.coefficient()) &&
                              dissolved.factor_count() <= max_product &&
                              dissolved.pixel_cost() <= kept.pixel_cost();
        return keep_product(id, dissolve ? std::move(dissolved) : kept);
    }

    Expr keep_product(NodeId id, ProductForm form) {
        LinearForm term = LinearForm(form.build_factors(graph_), rates_).scaled(form.coefficient());
        product_[id.value()] = std::move(form);
        return keep_linear(id, std::move(term));
    }

    // If the divisor changes rarely, one division per row or column and a product are cheaper.
    Expr rewrite_quotient(NodeId id, const Node& node) {
        const Expr numerator = made(node.operands[0]);
        const Expr divisor = made(node.operands[1]);
        if (numerator.rate(rates_) != Rate::pixel || divisor.rate(rates_) == Rate::pixel) {
            return numerator / divisor;
        }
        ProductForm form =
            ProductForm::product(product(node.operands[0]), ProductForm(1.0 / divisor, rates_));
        return std::isnormal(form.coefficient()) ? keep_product(id, std::move(form))
                                                 : numerator / divisor;
    }

    Expr made(NodeId id) const { return made_[id.value()]; }

    LinearForm linear(NodeId id) const {
        const auto& form = linear_[id.value()];
        return form ? *form : LinearForm(made(id), rates_);
    }

    LinearForm linear_or_term(NodeId id) const {
        const auto& form = linear_[id.value()];
        if (form && form->term_count() <= 1) {
            return *form;
        }
        if (uses_[id.value()] > 1) {
            return LinearForm(made(id), rates_);
        }
        const auto& built_from = built_from_[id.value()];
        return built_from ? *built_from : linear(id);
    }

    ProductForm product(NodeId id) const {
        const auto& form = product_[id.value()];
        return form ? *form : ProductForm(made(id), rates_);
    }

    Graph& graph_;
    Rates rates_;
    std::vector<NodeId> nodes_;
    std::vector<Expr> made_;
    std::vector<std::uint32_t> uses_;
    std::vector<std::optional<LinearForm>> linear_;
    std::vector<std::optional<LinearForm>>
        built_from_;  ///< The node from which another node was built.
    std::vector<std::optional<ProductForm>> product_;
};

bool same_nodes(std::span<const Expr> a, std::span<const Expr> b) {
    for (std::size_t i = 0; i < a.size(); ++i) {
        if (!a[i].same(b[i])) {
            return false;
        }
    }
    return true;
}

}  // namespace

std::vector<Expr> simplify(std::span<const Expr> expressions, const Rates& rates) {
    std::vector<Expr> result(expressions.begin(), expressions.end());
    if (expressions.empty()) {
        return result;
    }
    // A rewriting can enable another; a few passes reach a fixed point.
    constexpr int max_passes = 8;
    for (int pass = 0; pass < max_passes; ++pass) {
        std::vector<Expr> next = Pass(expressions.front().graph(), rates, result).run(result);
        if (same_nodes(next, result)) {
            break;
        }
        result = std::move(next);
    }
    return result;
}

}  // namespace balcony::expr
