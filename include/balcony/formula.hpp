// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a stage is made of: numbers and functions that may change with time.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "balcony/expr.hpp"

namespace balcony::camera {

using expr::Expr;
using expr::Graph;

/// What a number counts. Angles are written with deg or rad and are radians inside.
enum class Unit : std::uint8_t {
    number,  ///< A length in scene units, a ratio, ...; where it is wanted, an angle is an error.
    angle,   ///< Where it is wanted, a plain number other than 0 is an error.
    either,  ///< Depends on the object, as a coordinate of parameter space, or on a formula's user.
};

/// A separate formula: results as functions of parameters and time. Immutable, cheap to copy.
class Formula {
public:
    /// `parameters` are variables of `graph`, the only ones that `results` may use. Results without
    /// units fit any use.
    Formula(std::shared_ptr<Graph> graph, std::vector<Expr> parameters, std::vector<Expr> results,
            std::vector<Unit> units = {});

    [[nodiscard]] std::size_t parameter_count() const { return parameters_.size(); }
    [[nodiscard]] std::size_t result_count() const { return results_.size(); }
    /// The results in another graph, with arguments substituted for the parameters.
    [[nodiscard]] std::vector<Expr> emit(Graph& graph, std::span<const Expr> arguments) const;
    /// What result i counts.
    [[nodiscard]] Unit unit(std::size_t i) const {
        return i < units_.size() ? units_[i] : Unit::either;
    }
    /// The value of result i if it is constant.
    [[nodiscard]] std::optional<double> constant(std::size_t i) const;
    /// The same with every result held between two numbers.
    [[nodiscard]] Formula clamped(double minimum, double maximum) const;

private:
    std::shared_ptr<Graph> graph_;
    std::vector<Expr> parameters_;
    std::vector<Expr> results_;
    std::vector<Unit> units_;
};

/// A number argument of a stage: a constant or a formula in time, with its unit. 0 has every unit.
class Scalar {
public:
    Scalar(double value = 0.0, Unit unit = Unit::number) : value_(value), unit_(unit) {}
    /// A formula without parameters and with one result.
    Scalar(Formula formula, Unit unit = Unit::number);

    [[nodiscard]] Unit unit() const { return unit_; }
    [[nodiscard]] std::optional<double> constant() const;
    /// The same number, held between two others.
    [[nodiscard]] Scalar clamped(double minimum, double maximum) const;
    [[nodiscard]] Expr emit(Graph& graph) const;

private:
    std::variant<double, Formula> value_;
    Unit unit_;
};

/// A value of an input of the graph.
struct KnownInput {
    std::string name;
    double value = 0.0;
};

}  // namespace balcony::camera
