// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cassert>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "balcony/data.hpp"
#include "balcony/make_stage.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// Makes stages from calls: assigns arguments to parameters and evaluates them. camera::bind checks
/// the values; its errors are reported where the values are written.
class StageBuilder {
public:
    StageBuilder(const Module& module, Scope& scope, Session& session)
        : module_(module),
          session_(session),
          tree_(module.tree),
          scope_(scope),
          graph_(session.graph()),
          reporter_(session.reporter()) {}

    /// The stage of a call; null after an error, which is reported.
    template <class Port>
    [[nodiscard]] std::shared_ptr<const Port> make(ExpressionId call) {
        return std::static_pointer_cast<const Port>(make_stage(camera::kind_of<Port>(), call));
    }

    /// A built-in stage from values for its first parameters, in order; `span` is the text that
    /// stands for it. Null after an error.
    template <class Port>
    [[nodiscard]] std::shared_ptr<const Port> make(std::string_view name,
                                                   std::span<const ExpressionId> values,
                                                   Span span) {
        const camera::StageEntry* row = camera::catalogue().find(camera::kind_of<Port>(), name);
        assert(row != nullptr);
        const std::optional<camera::Arguments> given = arguments(*row, values, span);
        return given ? std::static_pointer_cast<const Port>(
                           make_from_row(*row, *given, span, values.empty() ? Span{} : span))
                     : nullptr;
    }

    /// How the file writes the stages made so far, each on one line.
    [[nodiscard]] const std::map<const camera::Stage*, std::string>& written() const {
        return written_;
    }

    /// The arguments of a call, checked against a row; nothing after an error, which is reported.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             const Expression& call);

    /// The same from values for the row's first parameters, in their order. An invalid one is not
    /// given.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             std::span<const ExpressionId> values,
                                                             Span span);

    /// The value of an expression without errors, if it is a number that does not change with time.
    [[nodiscard]] std::optional<double> known_number(ExpressionId id);

    /// A number that must be known when the camera is made; nothing after an error.
    [[nodiscard]] std::optional<double> constant(ExpressionId id, std::string_view what);

    /// A ratio above 0, or the width and height of a picture in scene units.
    struct Aspect {
        double ratio = 0.0;
        std::optional<std::array<double, 2>> sides{};
    };
    [[nodiscard]] std::optional<Aspect> aspect(ExpressionId id, std::string_view owner);

    /// A plain number as a formula of the point of the picture, which its expression calls x and y.
    /// Nothing after an error.
    [[nodiscard]] std::optional<camera::Formula> formula_of_picture(ExpressionId id,
                                                                    std::string_view what);

private:
    using Stage = std::shared_ptr<const camera::Stage>;

    Stage make_stage(camera::StageKind kind, ExpressionId call);
    /// Problems are reported at `named`. `whole` is what the file writes, nothing if it is implied.
    Stage make_from_row(const camera::StageEntry& row, const camera::Arguments& arguments,
                        Span named, Span whole);
    [[nodiscard]] std::optional<Diagnostic> instead_of_stage(camera::StageKind kind,
                                                             ExpressionId call) const;
    [[nodiscard]] bool depends_on_coordinates(ExpressionId expression) const;
    const camera::StageEntry* find_row(camera::StageKind kind, const Identifier& name);

    // ------------------------------------------------------ which parameter an argument is for
    // A parameter's name and the text assigned to it: an expression, several for a parameter that
    // takes all remaining ones, or one number of a tuple that is for several parameters.
    struct Assigned {
        std::string_view name{};
        const camera::StageParameter* parameter = nullptr;  // Null: none has the name.
        Span name_span{};
        std::vector<ExpressionId> expressions{};
        std::optional<Element> element{};
    };

    std::vector<Assigned> assign(const camera::StageEntry& row, const Expression& call);
    bool tuple_is_spread(const camera::StageEntry& row, const Expression& call);
    std::optional<Value> tuple_for(ExpressionId value,
                                   std::span<const camera::StageParameter* const> positions);
    const camera::StageParameter* parameter_of_word(const camera::StageEntry& row,
                                                    const Identifier& word);

    // ------------------------------------------------------------------------ what is given
    /// Where a value is written, and where its parts are.
    struct Written {
        SourceSpan span{};
        std::vector<Written> parts{};
    };
    struct Located {
        camera::ArgumentValue value;
        Written place;
    };
    /// A value for a parameter, with what in the camera file stands for it.
    struct Given {
        camera::NamedValue named;
        Written place;
        Span name{};
        Span expression{};
    };

    std::optional<camera::Arguments> bind(const camera::StageEntry& row,
                                          const std::vector<Given>& given, Span whole);
    Given given(const Assigned& assigned);
    Located value(const camera::StageParameter& parameter, std::span<const ExpressionId> given);
    [[nodiscard]] Located located(const Value& value, const SourceSpan& span) const;
    Located number(ExpressionId given);
    Located numbers(ExpressionId given, bool one_for_all, bool names_axes);
    Located word(ExpressionId given);
    Located quoted(ExpressionId given);
    Located points(const camera::PointsParameter& type, ExpressionId given);
    Located stages(const camera::NestedStageParameter& type, std::span<const ExpressionId> given);
    [[nodiscard]] bool is_number(camera::StageKind kind, const Expression& node);
    Located unsuitable(ExpressionId given);
    [[nodiscard]] camera::Scalar scalar(const Value& value) const;
    [[nodiscard]] camera::Tuple tuple(const Value& value) const;
    [[nodiscard]] static Written place_of(const Value& value, const SourceSpan& span);
    std::optional<std::string> named_axis(const Expression& node);

    // --------------------------------------------------------------------------------- files
    Located table(const camera::PointsParameter& type, ExpressionId given);
    std::optional<data::File> file(const Expression& node);
    /// What a function of data reads from a file.
    template <auto read>
    Located contents(ExpressionId given) {
        const Expression& node = tree_[given];
        if (node.kind != ExpressionKind::text) {
            return unsuitable(given);
        }
        Located made{camera::Failed{}, {tree_.at(node.span)}};
        if (const auto found = file(node)) {
            const auto& data = session_.files().contents<read>(*found);
            report(data.diagnostics, node.span);
            if (data) {
                made.value = *data;
            }
        }
        return made;
    }

    // ------------------------------------------------------------------------------ formulas
    Located formula(std::string_view name, const camera::FormulaShape& shape,
                    const Expression& node);
    bool define_formula_parameters(const Expression& node, Scope& scope,
                                   std::vector<expr::Expr>& variables);

    void error(Span span, std::string message, std::string remedy = {}) {
        reporter_.error(tree_.at(span), std::move(message), std::move(remedy));
    }
    /// Reports errors without a place at the name in the camera file; those in other files get a
    /// note with the place of use.
    void report(Diagnostics found, Span named) { reporter_.add(std::move(found), tree_.at(named)); }

    const Module& module_;
    Session& session_;
    const SyntaxTree& tree_;
    Scope& scope_;
    std::shared_ptr<expr::Graph> graph_;
    Reporter& reporter_;
    std::map<const camera::Stage*, std::string> written_;
};

}  // namespace balcony::lang
