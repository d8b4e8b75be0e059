// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/names/function_calls.hpp"

#include <fmt/format.h>

#include "lang/built_in_cameras.hpp"
#include "lang/names/evaluate.hpp"
#include "lang/names/grey_calls.hpp"
#include "lang/names/key_calls.hpp"

namespace balcony::lang {

namespace {

// A name that has a value.
void report_value(const Identifier& name, const Value& value, const SyntaxTree& tree,
                  Reporter& reporter) {
    reporter.error(tree.at(name.span),
                   fmt::format("'{}' is {} and cannot be called", name.text, form_of(value)),
                   value.elements ? fmt::format("write {}[0] for its first element", name.text)
                                  : fmt::format("write {} * ( ... ) for a product", name.text));
}

void report_unknown(const SyntaxTree& tree, const Identifier& name, Scope& scope,
                    const Context& context) {
    for (const camera::StageEntry& row : context.catalogue) {
        if (row.name == name.text) {
            context.reporter.error(
                tree.at(name.span),
                fmt::format("expected a number, but '{}' is a stage ({})", name.text,
                            camera::name_of(row.kind)),
                fmt::format("write a number; run 'balcony list {}' to see how to use the stage",
                            name.text));
            return;
        }
    }
    if (const Definition* definition = scope.find(name.text)) {
        // One without a value has been reported.
        if (!definition->value.failed()) {
            report_value(name, definition->value, tree, context.reporter);
        }
        return;
    }
    if (find_built_in_camera(name.text) != nullptr) {
        context.reporter.error(
            tree.at(name.span), fmt::format("expected a number, but '{}' is a camera", name.text),
            fmt::format("write camera NAME = {}( ... ) for a camera with other values of its "
                        "parameters",
                        name.text));
        return;
    }
    if (scope.incomplete()) {
        return;
    }
    context.reporter.missing(name.text, tree.at(name.span),
                             fmt::format("unknown function '{}'", name.text), [&] {
                                 std::vector<std::string> names = scope.function_names();
                                 const std::vector<std::string> built_in = function_names();
                                 names.insert(names.end(), built_in.begin(), built_in.end());
                                 return suggestion(name.text, names, "the functions are");
                             });
}

}  // namespace

std::string call_of(std::string_view name, std::size_t arity) {
    std::string letters;
    for (std::size_t i = 0; i < arity; ++i) {
        letters += i == 0 ? "" : ", ";
        letters += static_cast<char>('a' + i % 26);
    }
    return fmt::format("{}({})", name, letters);
}

Callee find_callee(std::string_view name, Scope& scope) {
    Callee found;
    found.offered = scope.find_function(name);
    if (found.offered == nullptr) {
        Definition* definition = scope.find(name);
        found.let = definition != nullptr && definition->function ? definition : nullptr;
    }
    if (found.offered == nullptr && found.let == nullptr) {
        found.built_in = find_function(name);
        found.special = name == keys_function   ? evaluate_keys
                        : name == grey_function ? evaluate_grey
                                                : nullptr;
    }
    return found;
}

bool calls_let(const Expression& node, Scope& scope) {
    return node.kind == ExpressionKind::call && find_callee(node.name.text, scope).let != nullptr;
}

bool calls_count(const Expression& node, Scope& scope) {
    if (node.kind != ExpressionKind::call) {
        return false;
    }
    const Callee callee = find_callee(node.name.text, scope);
    return callee.built_in != nullptr && callee.built_in->takes_compound();
}

bool calls_special(const Expression& node, Scope& scope) {
    return node.kind == ExpressionKind::call &&
           find_callee(node.name.text, scope).special != nullptr;
}

bool check_call(const SyntaxTree& tree, const Expression& call, Scope& scope,
                const Context& context) {
    const std::string_view name = call.name.text;
    const auto [offered, let, built_in, special] = find_callee(name, scope);
    if (special != nullptr) {
        return true;
    }
    if (offered == nullptr && let == nullptr && built_in == nullptr) {
        report_unknown(tree, call.name, scope, context);
        return false;
    }
    for (const Argument& argument : call.arguments) {
        if (argument.name) {
            context.reporter.error(tree.at(argument.name->span),
                                   fmt::format("the function '{}' takes no named arguments", name),
                                   fmt::format("remove '{} ='", argument.name->text));
            return false;
        }
    }
    const std::size_t arity = offered != nullptr ? offered->native->argument_count()
                              : let != nullptr   ? let->function->let.parameters.size()
                                                 : built_in->arity;
    if (call.arguments.size() == arity) {
        return true;
    }
    const std::size_t given = call.arguments.size();
    context.reporter.error(
        tree.at(call.span),
        fmt::format("'{}' takes {} argument{}, but {} {} given", name, arity, arity == 1 ? "" : "s",
                    given, given == 1 ? "is" : "are"),
        fmt::format("the syntax is {}",
                    let != nullptr ? signature(*let->function) : call_of(name, arity)));
    return false;
}

bool check_function(const LetFunction& function, const Context& context) {
    Scope inner(&function.scope);
    for (const Identifier& parameter : function.let.parameters) {
        const SourceSpan place = function.tree.at(parameter.span);
        // Without a value, so that nothing that depends on it is reported.
        if (!inner.define(parameter.text, {{}, place, "parameter", true})) {
            report_duplicate(parameter, place, inner.find_here(parameter.text)->place,
                             context.reporter);
            return false;
        }
    }
    (void)evaluate_any(function.tree, function.let.value, inner, context);
    return true;
}

std::string signature(const LetFunction& function) {
    std::string names;
    for (const Identifier& parameter : function.let.parameters) {
        names += fmt::format("{}{}", names.empty() ? "" : ", ", parameter.text);
    }
    return fmt::format("{}({})", function.let.name.text, names);
}

}  // namespace balcony::lang
