// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

#include "balcony/lang.hpp"
#include "lang/names/fitted_parameters.hpp"
#include "lang/names/session.hpp"

namespace balcony::lang {

/// "camera" or "picture".
[[nodiscard]] std::string_view word_for(const DefinitionSyntax& camera);

/// A value for a parameter of a layer.
struct ParameterValue {
    Identifier name;
    SourceSpan name_place;
    Value value;  ///< In the session's graph.
    SourceSpan value_place;
};

/// Values for parameters: texts from the command line, or values from a picture.
struct GivenParameters {
    std::vector<Override> overrides;
    std::vector<ParameterValue> values;
    std::vector<std::string> open{};  ///< Parameters that become inputs of the formulas.
};

/// The names of one camera or picture: its lets and its parameters, with given or default
/// values.
class DefinitionScope {
public:
    DefinitionScope(const LocatedDefinition& place, const GivenParameters& given, Session& session);

    [[nodiscard]] Scope& names() { return scope_; }
    /// The values of its parameters, in their order.
    [[nodiscard]] std::vector<Value> values();
    /// Warns about unused names. The definition must have no errors.
    void warn_of_unused();

private:
    struct Given {
        std::string_view name;
        const SyntaxTree* tree;
    };

    void read_overrides(const std::vector<Override>& overrides);
    void define_parameters();
    void define_parameter(const DefinitionParameter& parameter);
    [[nodiscard]] Value fitted(const Value& default_value, std::string_view name);
    [[nodiscard]] Value opened(const Value& value, std::string_view name);
    void check_names(const std::vector<ParameterValue>& values);
    [[nodiscard]] Value overridden(const Given& given, const Value& default_value,
                                   std::string_view name);
    [[nodiscard]] Value checked(const Value& value, const SourceSpan& span,
                                const Value& default_value, std::string_view name);
    [[nodiscard]] std::vector<std::string> parameter_names() const;

    const LocatedDefinition place_;
    const SyntaxTree& tree_;
    Session& session_;
    Scope scope_;
    FittedParameters fitted_;
    std::vector<Given> given_;
    const std::vector<ParameterValue> values_;
    const std::vector<std::string> open_;
};

}  // namespace balcony::lang
