// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/lang.hpp"
#include "lang/names/fitted_parameters.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// "camera" or "picture".
[[nodiscard]] std::string_view word_for(const DefinitionSyntax& camera);
[[nodiscard]] std::set<std::string_view> parameter_names(const DefinitionSyntax& camera);
/// The error of a name that is no parameter, and its remedy.
[[nodiscard]] std::string no_parameter(const LocatedDefinition& place, std::string_view name);
[[nodiscard]] std::string instead_of_parameter(const DefinitionSyntax& camera,
                                               std::string_view name);

/// A value for a parameter of a layer or of a base.
struct ParameterValue {
    Identifier name;
    SourceSpan name_place;
    Value value;  ///< In the session's graph.
    SourceSpan value_place;
};

/// Values for parameters: texts from the command line, or else values from files, of which the
/// first counts.
struct GivenParameters {
    std::vector<Override> overrides;
    std::vector<ParameterValue> values;
    std::vector<std::string> open{};  ///< Parameters that become inputs of the formulas.
};

/// The names of one camera or picture: its lets and its parameters, with given or default
/// values.
class DefinitionScope {
public:
    /// What is given must outlive it.
    DefinitionScope(const LocatedDefinition& place, const GivenParameters& given, Session& session);

    [[nodiscard]] Scope& names() { return scope_; }
    /// The values of its parameters, in their order.
    [[nodiscard]] std::vector<Value> values();
    /// Warns about unused names, but not of a base. The definition must have no errors.
    void warn_of_unused();

private:
    void read_overrides(const std::vector<Override>& overrides);
    void define_parameters();
    void define_parameter(const DefinitionParameter& parameter);
    [[nodiscard]] Value fitted(const Value& default_value, const DefinitionParameter& parameter);
    [[nodiscard]] Value opened(const Value& value, std::string_view name);
    void read_values(const std::vector<ParameterValue>& values);
    /// `tree` is that of the override, null if it has an error; `written` becomes its place.
    [[nodiscard]] Value overridden(const SyntaxTree* tree, const Value& default_value,
                                   std::string_view name, SourceSpan& written);
    [[nodiscard]] Value checked(const Value& value, const SourceSpan& span,
                                const Value& default_value, std::string_view name);

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    Session& session_;
    Scope scope_;
    FittedParameters fitted_;
    const std::set<std::string_view> parameters_;
    std::map<std::string_view, const SyntaxTree*> overrides_;  ///< The last one of each name.
    std::map<std::string_view, const ParameterValue*> values_;
    const std::set<std::string_view> open_;
};

}  // namespace balcony::lang
