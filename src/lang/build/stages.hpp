// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "balcony/catalogue.hpp"
#include "balcony/data.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// Makes stages from calls and checks them against the rows of the catalogue.
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
    [[nodiscard]] std::shared_ptr<const Port> make(camera::StageKind kind, ExpressionId call) {
        return std::static_pointer_cast<const Port>(make_stage(kind, call));
    }

    /// A picture mapper from the values of a map statement, in the order of the row.
    [[nodiscard]] camera::PictureMapperPointer make_mapper(std::string_view name,
                                                           std::span<const ExpressionId> values,
                                                           Span span);

    /// The arranger of a place statement; null after an error.
    [[nodiscard]] camera::PictureArrangerPointer make_place(const MapRange& corners);

    /// A direction rule with all its defaults, for a camera without `look`.
    [[nodiscard]] camera::DirectionRulePointer make_default_rule(std::string_view name, Span span);

    /// The arguments of a call, checked against a row; nothing after an error, which is reported.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             const Expression& call);

    /// The same from values for the row's first parameters, in their order.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             std::span<const ExpressionId> values);

    /// The same from a value for one parameter of the row.
    [[nodiscard]] std::optional<camera::Arguments> argument(const camera::StageEntry& row,
                                                            std::string_view parameter,
                                                            ExpressionId value);

    /// A number that must be known when the camera is made; nothing after an error.
    [[nodiscard]] std::optional<double> constant(ExpressionId id, std::string_view what);

    /// The same for an aspect, which must be above 0.
    [[nodiscard]] std::optional<double> aspect(ExpressionId id, std::string_view owner);

private:
    using Stage = std::shared_ptr<const camera::Stage>;

    Stage make_stage(camera::StageKind kind, ExpressionId call);
    Stage make_from_row(const camera::StageEntry& row, const camera::Arguments& arguments,
                        Span span);
    const camera::StageEntry* find_row(camera::StageKind kind, const Identifier& name);

    // ------------------------------------------------------- parameters of the arguments
    // The argument of a parameter: an expression; several, for a parameter that takes all remaining
    // ones; or one number of a tuple that is for several parameters.
    struct Given {
        std::vector<ExpressionId> expressions{};
        std::optional<Element> element{};

        [[nodiscard]] bool empty() const { return expressions.empty() && !element; }
    };

    bool tuple_is_spread(const camera::StageEntry& row, const Expression& call);
    bool assign(const camera::StageEntry& row, const Expression& call, std::vector<Given>& given);
    std::size_t assign_tuple(const camera::StageEntry& row, ExpressionId value,
                             std::span<const camera::StageParameter* const> positions,
                             std::vector<Given>& given);
    const camera::StageParameter* named_parameter(const camera::StageEntry& row,
                                                  const Identifier& name);
    const camera::StageParameter* parameter_of_word(const camera::StageEntry& row,
                                                    const Identifier& word);

    // ---------------------------------------------------------- values of the arguments
    bool set_argument(const camera::StageEntry& row, const camera::StageParameter& parameter,
                      std::span<const ExpressionId> given, camera::Arguments& arguments);
    bool set_default(const camera::StageEntry& row, const camera::StageParameter& parameter,
                     Span call, camera::Arguments& arguments);
    std::optional<std::string> choice(const camera::StageEntry& row,
                                      const camera::StageParameter& parameter, ExpressionId given);
    Stage nested_stage(const camera::StageEntry& row, const camera::StageParameter& parameter,
                       ExpressionId given);
    std::optional<std::vector<Stage>> nested_stages(const camera::StageEntry& row,
                                                    const camera::StageParameter& parameter,
                                                    std::span<const ExpressionId> given);
    Stage curve(const camera::StageEntry& row, const camera::StageParameter& parameter,
                ExpressionId given);

    // ------------------------------------------------------------------------------- numbers
    std::optional<std::vector<camera::Scalar>> numbers(const camera::StageEntry& row,
                                                       const camera::StageParameter& parameter,
                                                       ExpressionId given);
    std::optional<std::vector<double>> named_axis(const Expression& node);
    std::optional<camera::Scalar> number(const camera::StageEntry& row,
                                         const camera::StageParameter& parameter,
                                         const Value& value, const SourceSpan& place);
    bool fits(const camera::StageEntry& row, const camera::StageParameter& parameter,
              const Value& value, const SourceSpan& place);
    bool in_range(const camera::StageEntry& row, const camera::StageParameter& parameter,
                  double value, const SourceSpan& place);

    // -------------------------------------------------------------------------------- points
    std::optional<camera::PointList> points(const camera::StageEntry& row,
                                            const camera::StageParameter& parameter,
                                            ExpressionId given);
    bool enough_points(const camera::StageEntry& row, const camera::StageParameter& parameter,
                       std::size_t count, Span span);
    bool add_point(const camera::StageEntry& row, const camera::StageParameter& parameter,
                   const SourceSpan& place, std::span<const Element> coordinates,
                   camera::PointList& points);
    bool has_coordinates(const camera::StageEntry& row, const camera::StageParameter& parameter,
                         std::size_t count, const SourceSpan& place,
                         const camera::PointList& points);

    // --------------------------------------------------------------------------------- files
    std::optional<camera::PointList> table(const camera::StageEntry& row,
                                           const camera::StageParameter& parameter,
                                           ExpressionId given);
    std::shared_ptr<const camera::GreyImage> image(const camera::StageEntry& row,
                                                   const camera::StageParameter& parameter,
                                                   ExpressionId given);
    std::shared_ptr<const camera::TexturedMesh> mesh(const camera::StageEntry& row,
                                                     const camera::StageParameter& parameter,
                                                     ExpressionId given);
    std::optional<data::File> file(const camera::StageEntry& row,
                                   const camera::StageParameter& parameter, ExpressionId given,
                                   std::string_view what, std::string_view example);
    void report_file(Diagnostics diagnostics, Span named);
    template <class Data>
    std::shared_ptr<const Data> read_once(
        std::map<std::string, std::shared_ptr<const Data>>& known, const data::File& file,
        Result<std::shared_ptr<const Data>> (*read)(const data::File&), ExpressionId given);

    // ------------------------------------------------------------------------------ formulas
    /// The requirements on a formula and on its results.
    struct FormulaRules {
        std::string_view name;
        const camera::FormulaShape& shape;
        std::string written;
        std::function<bool(const Value& result, const SourceSpan& place)> fits;
    };
    std::optional<camera::Formula> stage_formula(const camera::StageEntry& row,
                                                 const Expression& node);
    std::optional<camera::Formula> formula_argument(const camera::StageEntry& row,
                                                    const camera::StageParameter& parameter,
                                                    ExpressionId given);
    std::optional<camera::Formula> formula(const FormulaRules& rules, const Expression& node);
    std::optional<std::vector<expr::Expr>> formula_results(const FormulaRules& rules,
                                                           const Expression& node, Scope& scope);

    void error(Span span, std::string message, std::string remedy = {}) {
        error(tree_.at(span), std::move(message), std::move(remedy));
    }
    /// Reports an error at a position in the camera file, or in a table or let that it names.
    void error(SourceSpan place, std::string message, std::string remedy = {});

    /// During its lifetime, errors in other places get a note that shows where they are named.
    class Naming {
    public:
        Naming(StageBuilder& stages, const Expression& node) : stages_(stages) {
            stages.named_ = node.span;
        }
        ~Naming() { stages_.named_.reset(); }
        Naming(const Naming&) = delete;
        Naming& operator=(const Naming&) = delete;

    private:
        StageBuilder& stages_;
    };

    const Module& module_;
    Session& session_;
    const SyntaxTree& tree_;
    Scope& scope_;
    std::shared_ptr<expr::Graph> graph_;
    Reporter& reporter_;
    std::optional<Span> named_;  // The position in the camera file that names the current value.
};

/// A description of an unexpected expression: a number, a list, a file name, ...
[[nodiscard]] std::string_view described(const Expression& node);
/// "a parameter transformer", "an object generator".
[[nodiscard]] std::string with_article(std::string_view noun);
/// The syntax of a stage: circle(radius), surface(u, v) = [x, y, z].
[[nodiscard]] std::string signature(const camera::StageEntry& row);
/// The syntax of a formula: weight(u, v) = [a].
[[nodiscard]] std::string signature(std::string_view name, const camera::FormulaShape& shape);

}  // namespace balcony::lang
