// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <string>

#include "balcony/catalogue.hpp"
#include "lang/scope.hpp"

namespace balcony::lang {

/// Makes stages from calls, by the catalogue: what a row says is what is checked.
class StageBuilder {
public:
    StageBuilder(const SyntaxTree& tree, Scope& scope, std::shared_ptr<expr::Graph> graph,
                 Reporter& reporter)
        : tree_(tree), scope_(scope), graph_(std::move(graph)), reporter_(reporter) {}

    /// The stage that a call describes; null if there is an error, which is reported.
    template <class Port>
    [[nodiscard]] std::shared_ptr<const Port> make(camera::StageKind kind, ExpressionId call) {
        return std::static_pointer_cast<const Port>(make_stage(kind, call));
    }

    /// A picture mapper from the values of a map statement, which the row takes in their order.
    [[nodiscard]] camera::PictureMapperPointer make_mapper(std::string_view name,
                                                           std::span<const ExpressionId> values,
                                                           Span span);

    /// A direction rule with all its defaults, as a camera without `look` has it.
    [[nodiscard]] camera::DirectionRulePointer make_default_rule(std::string_view name, Span span);

    /// A number that must be known when the camera is made; nothing if there is an error.
    [[nodiscard]] std::optional<double> constant(ExpressionId id, std::string_view what);

private:
    using Stage = std::shared_ptr<const camera::Stage>;

    Stage make_stage(camera::StageKind kind, ExpressionId call);
    Stage make_from_row(const camera::StageEntry& row, const camera::Arguments& arguments,
                        Span span);
    const camera::StageEntry* find_row(camera::StageKind kind, const Identifier& name);

    bool assign(const camera::StageEntry& row, const Expression& call,
                std::vector<ExpressionId>& given);
    const camera::StageParameter* named_parameter(const camera::StageEntry& row,
                                                  const Identifier& name);
    bool set_argument(const camera::StageEntry& row, const camera::StageParameter& parameter,
                      ExpressionId given, camera::Arguments& arguments);
    bool set_default(const camera::StageEntry& row, const camera::StageParameter& parameter,
                     Span call, camera::Arguments& arguments);
    std::optional<std::vector<camera::Scalar>> numbers(const camera::StageEntry& row,
                                                       const camera::StageParameter& parameter,
                                                       ExpressionId given);
    std::optional<std::vector<double>> named_axis(const Expression& node);
    std::optional<camera::Scalar> number(const camera::StageEntry& row,
                                         const camera::StageParameter& parameter,
                                         ExpressionId given);
    bool fits(const camera::StageEntry& row, const camera::StageParameter& parameter,
              const Value& value, Span span);
    std::optional<std::string> choice(const camera::StageEntry& row,
                                      const camera::StageParameter& parameter, ExpressionId given);
    camera::ObjectGeneratorPointer curve(const camera::StageEntry& row,
                                         const camera::StageParameter& parameter,
                                         ExpressionId given);
    std::optional<camera::Formula> formula(const camera::StageEntry& row, const Expression& node);
    std::optional<std::vector<expr::Expr>> formula_results(const camera::StageEntry& row,
                                                           const Expression& node, Scope& scope);

    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }

    const SyntaxTree& tree_;
    Scope& scope_;
    std::shared_ptr<expr::Graph> graph_;
    Reporter& reporter_;
};

/// How a stage is written: circle(radius), surface(u, v) = [x, y, z].
[[nodiscard]] std::string signature(const camera::StageEntry& row);

}  // namespace balcony::lang
