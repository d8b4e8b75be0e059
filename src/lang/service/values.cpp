// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The values of names, and an outline of a text.

#include <algorithm>

#include <fmt/format.h>

#include "lang/build/resolved_layer.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/names/unused_names.hpp"
#include "lang/names/value.hpp"
#include "lang/service/known_text.hpp"

namespace balcony::lang {

namespace {

// Whether an expression says its value by itself: it has numbers only.
bool is_plain(const SyntaxTree& tree, ExpressionId id) {
    for (std::size_t i = tree[id].first.value(); i <= id.value(); ++i) {
        const Expression& node = tree.expressions[i];
        const bool is_sign = node.kind == ExpressionKind::operation && node.arguments.size() == 1;
        if (!is_sign && node.kind != ExpressionKind::number && node.kind != ExpressionKind::tuple &&
            node.kind != ExpressionKind::list) {
            return false;
        }
    }
    return true;
}

bool is_constant(const Value& value) {
    return !value.failed() &&
           (value.elements ? std::all_of(value.elements->begin(), value.elements->end(),
                                         [](const Element& one) { return is_constant(one.value); })
                           : value.is_constant());
}

class ValueCollector {
public:
    explicit ValueCollector(const KnownText& text) : text_(text) {}

    std::vector<KnownValue> collect() {
        for (const Item& item : text_.tree().items) {
            if (const auto* let = std::get_if<Statement>(&item)) {
                add(let->let().name.text, let->let().value, *text_.module->scope);
            } else if (const auto* one = std::get_if<DefinitionSyntax>(&item)) {
                add_definition(*one);
            }
        }
        std::stable_sort(
            found_.begin(), found_.end(),
            [](const KnownValue& a, const KnownValue& b) { return a.offset < b.offset; });
        return std::move(found_);
    }

private:
    void add_definition(const DefinitionSyntax& one) {
        if (one.base.valid()) {
            return;
        }
        const GivenParameters given;
        try {
            DefinitionScope scope({text_.module, &one}, given, *text_.session);
            for (const DefinitionParameter& parameter : one.parameters) {
                add(parameter.name.text, parameter.default_value, scope.names());
            }
            for (const Statement& statement : one.statements) {
                if (statement.kind == StatementKind::let) {
                    add(statement.let().name.text, statement.let().value, scope.names());
                }
            }
        } catch (const expr::GraphTooLarge&) {
            // Said when the camera is made.
        }
    }

    void add(std::string_view name, ExpressionId written, Scope& scope) {
        constexpr std::size_t longest = 60;
        if (!written.valid() || is_plain(text_.tree(), written)) {
            return;
        }
        const Definition* known = scope.find_here(name);
        if (known == nullptr || known->function || !is_constant(known->value)) {
            return;
        }
        std::string value = value_text(known->value);
        if (value.size() > longest) {
            value = fmt::format("{} values", known->value.elements->size());
        }
        found_.push_back({text_.tree()[written].span.end, std::move(value)});
    }

    const KnownText& text_;
    std::vector<KnownValue> found_;
};

DeclaredName declared_by(const OwnName& own) {
    const bool is_function = own.let != nullptr && !own.let->parameters.empty();
    DeclaredName made;
    made.name = own.name.text;
    made.kind = own.kind == OwnKind::camera      ? WordKind::camera
                : own.kind == OwnKind::parameter ? WordKind::parameter
                : is_function                    ? WordKind::function
                                                 : WordKind::value;
    made.detail = own.kind == OwnKind::camera      ? word_for(*own.definition)
                  : own.kind == OwnKind::parameter ? "parameter"
                  : own.kind == OwnKind::variable  ? "variable"
                                                   : word_for(*own.let);
    made.begin = own.declaration.begin;
    made.end = std::max(own.declaration.end, own.name.span.end);
    made.name_begin = own.name.span.begin;
    made.name_end = own.name.span.end;
    return made;
}

}  // namespace

std::vector<KnownValue> values(const KnownText& text) { return ValueCollector(text).collect(); }

std::vector<DeclaredName> declared(const KnownText& text) {
    std::vector<DeclaredName> found;
    const DefinitionSyntax* around = nullptr;
    for (const OwnName& own : text.names) {
        if (own.kind == OwnKind::function_parameter) {
            continue;
        }
        const bool is_inside =
            own.kind != OwnKind::camera && own.definition != nullptr && own.definition == around;
        (is_inside ? found.back().inside : found).push_back(declared_by(own));
        around = own.kind == OwnKind::camera ? own.definition : is_inside ? around : nullptr;
    }
    return found;
}

}  // namespace balcony::lang
