// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/formula.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::camera {

Formula::Formula(std::shared_ptr<Graph> graph, std::vector<Expr> parameters,
                 std::vector<Expr> results, std::vector<Unit> units)
    : graph_(std::move(graph)),
      parameters_(std::move(parameters)),
      results_(std::move(results)),
      units_(std::move(units)) {
    assert(!results_.empty());
}

std::vector<Expr> Formula::emit(Graph& graph, std::span<const Expr> arguments) const {
    assert(arguments.size() == parameters_.size());
    std::vector<expr::Substitution> substitutions;
    substitutions.reserve(arguments.size());
    for (std::size_t i = 0; i < arguments.size(); ++i) {
        substitutions.push_back({parameters_[i], arguments[i]});
    }
    return expr::substitute(graph, results_, substitutions);
}

std::optional<double> Formula::constant(std::size_t i) const {
    return results_[i].is_constant() ? std::optional(results_[i].node().value) : std::nullopt;
}

Formula Formula::clamped(double minimum, double maximum) const {
    Formula made = *this;
    for (Expr& result : made.results_) {
        if (std::isfinite(minimum)) {
            result = max(result, graph_->constant(minimum));
        }
        if (std::isfinite(maximum)) {
            result = min(result, graph_->constant(maximum));
        }
    }
    return made;
}

Scalar::Scalar(Formula formula, Unit unit) : value_(std::move(formula)), unit_(unit) {
    const Formula& stored = std::get<Formula>(value_);
    assert(stored.parameter_count() == 0 && stored.result_count() == 1);
    if (const auto number = stored.constant(0)) {
        value_ = *number;
    }
}

std::optional<double> Scalar::constant() const {
    const double* number = std::get_if<double>(&value_);
    return number != nullptr ? std::optional(*number) : std::nullopt;
}

Scalar Scalar::clamped(double minimum, double maximum) const {
    if (const double* number = std::get_if<double>(&value_)) {
        return {std::min(std::max(*number, minimum), maximum), unit_};
    }
    return {std::get<Formula>(value_).clamped(minimum, maximum), unit_};
}

Expr Scalar::emit(Graph& graph) const {
    if (const double* number = std::get_if<double>(&value_)) {
        return graph.constant(*number);
    }
    return std::get<Formula>(value_).emit(graph, {}).front();
}

}  // namespace balcony::camera
