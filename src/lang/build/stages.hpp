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

/// Makes stages from calls, by the catalogue: what a row says is what is checked.
class StageBuilder {
public:
    StageBuilder(const Module& module, Scope& scope, Session& session)
        : module_(module),
          session_(session),
          tree_(module.tree),
          scope_(scope),
          graph_(session.graph()),
          reporter_(session.reporter()) {}

    /// The stage that a call describes; null if there is an error, which is reported.
    template <class Port>
    [[nodiscard]] std::shared_ptr<const Port> make(camera::StageKind kind, ExpressionId call) {
        return std::static_pointer_cast<const Port>(make_stage(kind, call));
    }

    /// A picture mapper from the values of a map statement, which the row takes in their order.
    [[nodiscard]] camera::PictureMapperPointer make_mapper(std::string_view name,
                                                           std::span<const ExpressionId> values,
                                                           Span span);

    /// The arranger that a place statement describes; null if there is an error.
    [[nodiscard]] camera::PictureArrangerPointer make_place(const MapRange& corners);

    /// A direction rule with all its defaults, as a camera without `look` has it.
    [[nodiscard]] camera::DirectionRulePointer make_default_rule(std::string_view name, Span span);

    /// The arguments of a call as a row has them; nothing if there is an error, which is reported.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             const Expression& call);

    /// The same from values for the row's first parameters, in their order; the rest is left out.
    [[nodiscard]] std::optional<camera::Arguments> arguments(const camera::StageEntry& row,
                                                             std::span<const ExpressionId> values);

    /// The same from a value for one of its parameters.
    [[nodiscard]] std::optional<camera::Arguments> argument(const camera::StageEntry& row,
                                                            std::string_view parameter,
                                                            ExpressionId value);

    /// A number that must be known when the camera is made; nothing if there is an error.
    [[nodiscard]] std::optional<double> constant(ExpressionId id, std::string_view what);

    /// The same of an aspect, which is above 0.
    [[nodiscard]] std::optional<double> aspect(ExpressionId id, std::string_view owner);

private:
    using Stage = std::shared_ptr<const camera::Stage>;

    Stage make_stage(camera::StageKind kind, ExpressionId call);
    Stage make_from_row(const camera::StageEntry& row, const camera::Arguments& arguments,
                        Span span);
    const camera::StageEntry* find_row(camera::StageKind kind, const Identifier& name);

    // ------------------------------------------------------ which parameter an argument is for
    // What is said of a parameter: an expression, or several for one that takes all the rest, or a
    // number out of a tuple that is for several parameters.
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

    // ------------------------------------------------------------------------- what it says
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
    void report_file(Diagnostics said, Span named);
    template <class Data>
    std::shared_ptr<const Data> read_once(
        std::map<std::string, std::shared_ptr<const Data>>& known, const data::File& file,
        Result<std::shared_ptr<const Data>> (*read)(const data::File&), ExpressionId given);

    // ------------------------------------------------------------------------------ formulas
    /// What a formula must be, and what may be said of its results.
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
    /// Of a place in the camera file, or in a table or a let that it names.
    void error(SourceSpan place, std::string message, std::string remedy = {});

    /// While it lives, errors that are elsewhere get a note of where they are named.
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
    std::optional<Span> named_;  // Where the camera file names what is being read.
};

/// What stands in the place of something else: a number, a list, a file's name, ...
[[nodiscard]] std::string_view described(const Expression& node);
/// A parameter transformer, an object generator.
[[nodiscard]] std::string with_article(std::string_view noun);
/// How a stage is written: circle(radius), surface(u, v) = [x, y, z].
[[nodiscard]] std::string signature(const camera::StageEntry& row);
/// How a formula is written: weight(u, v) = [a].
[[nodiscard]] std::string signature(std::string_view name, const camera::FormulaShape& shape);

}  // namespace balcony::lang
