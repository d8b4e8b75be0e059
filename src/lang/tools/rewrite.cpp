// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Puts values of parameters into the text of a camera file, where the others stand.

#include "lang/tools/rewrite.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <fmt/format.h>

#include "lang/names/definition_scope.hpp"
#include "lang/syntax/lexer.hpp"

namespace balcony::lang {

namespace {

// The unit of the first angle in a text; degrees if there is none.
NumberUnit unit_in(std::string_view text) {
    Reporter ignored;
    const auto source = std::make_shared<const SourceText>("", std::string(text));
    for (const Token& token : tokenize(source, ignored).tokens) {
        if (token.unit != NumberUnit::none) {
            return token.unit;
        }
    }
    return NumberUnit::degrees;
}

// The shortest of the numbers of degrees that are this angle, if there is one.
std::optional<std::string> degrees_of(double radians) {
    constexpr double infinite = std::numeric_limits<double>::infinity();
    const double nearest = radians / radians_per_degree;
    std::optional<std::string> shortest;
    for (const double degrees :
         {nearest, std::nextafter(nearest, infinite), std::nextafter(nearest, -infinite)}) {
        std::string digits = fmt::format("{}", degrees);
        if (degrees * radians_per_degree == radians &&
            (!shortest || digits.size() < shortest->size())) {
            shortest = std::move(digits);
        }
    }
    return shortest;
}

// name = value, name = value
std::string written_out(const std::vector<Override>& values) {
    std::string made;
    for (const Override& value : values) {
        made += fmt::format("{}{} = {}", made.empty() ? "" : ", ", value.name, value.expression);
    }
    return made;
}

// Of a definition with statements: its defaults.
std::vector<TextEdit> edits_of_defaults(const SyntaxTree& tree, const DefinitionSyntax& definition,
                                        const std::vector<Override>& values) {
    std::vector<TextEdit> edits;
    for (const DefinitionParameter& parameter : definition.parameters) {
        for (const Override& value : values) {
            if (parameter.name.text == value.name) {
                const Span span = tree[parameter.default_value].span;
                edits.push_back({span.begin, span.end, value.expression});
            }
        }
    }
    return edits;
}

// Of a definition that is made of another one: the arguments of its call, with further ones.
std::vector<TextEdit> edits_of_call(const SyntaxTree& tree, const Expression& call,
                                    const std::vector<Override>& values) {
    std::vector<TextEdit> edits;
    std::vector<Override> further;
    for (const Override& value : values) {
        const auto given = std::find_if(
            call.arguments.begin(), call.arguments.end(),
            [&](const Argument& one) { return one.name && one.name->text == value.name; });
        if (given != call.arguments.end()) {
            const Span span = tree[given->value].span;
            edits.push_back({span.begin, span.end, value.expression});
        } else {
            further.push_back(value);
        }
    }
    if (!further.empty() && !call.arguments.empty()) {
        const std::size_t end = tree[call.arguments.back().value].span.end;
        edits.push_back({end, end, fmt::format(", {}", written_out(further))});
    } else if (!further.empty()) {
        edits.push_back(
            {call.name.span.end, call.span.end, fmt::format("({})", written_out(further))});
    }
    return edits;
}

// From the end of the text, so that the other spans stay right; what is added behind a value comes
// before the value.
std::string edited(std::string text, std::vector<TextEdit> edits) {
    std::stable_sort(edits.begin(), edits.end(),
                     [](const TextEdit& a, const TextEdit& b) { return a.begin > b.begin; });
    for (const TextEdit& edit : edits) {
        text.replace(edit.begin, edit.end - edit.begin, edit.text);
    }
    return text;
}

}  // namespace

std::string literal(double value, bool is_angle, std::string_view instead_of) {
    const std::string radians = fmt::format("{}{}", value, is_angle ? "rad" : "");
    if (!is_angle || unit_in(instead_of) == NumberUnit::radians) {
        return radians;
    }
    const std::optional<std::string> degrees = degrees_of(value);
    return degrees ? *degrees + "deg" : radians;
}

double in_degrees(double radians) { return radians / radians_per_degree * radians_per_degree; }

std::string hand_literal(double value, bool is_angle, double step, std::string_view instead_of) {
    const bool is_in_degrees = is_angle && unit_in(instead_of) != NumberUnit::radians;
    const double unit = is_in_degrees ? radians_per_degree : 1.0;
    const double digits = -std::floor(std::log10(step / unit));
    constexpr double most_digits = 15.0;
    if (!(digits <= most_digits)) {
        return literal(value, is_angle, instead_of);
    }
    const double power = std::pow(10.0, std::max(-digits, 0.0));  // Of the last digit before 1.
    const double rounded = digits < 0.0 ? std::round(value / unit / power) * power : value / unit;
    std::string written = fmt::format("{:.{}f}", rounded, static_cast<int>(std::max(digits, 0.0)));
    if (written.find('.') != std::string::npos) {
        written.erase(written.find_last_not_of('0') + 1);
        written.erase(written.find_last_not_of('.') + 1);
    }
    written = written == "-0" ? "0" : written;
    return fmt::format("{}{}", written, !is_angle ? "" : is_in_degrees ? "deg" : "rad");
}

std::vector<TextEdit> edits_of_values(const Module& module, const LocatedDefinition& written,
                                      const std::vector<Override>& values) {
    const SyntaxTree& tree = module.tree;
    const DefinitionSyntax& definition = *written.camera;
    if (module.built_in || written.module != &module) {
        const std::string_view text = module.built_in ? std::string_view() : tree.source->text();
        const std::string_view name = definition.name.text;
        return {{text.size(), text.size(),
                 fmt::format("{}{} {} = {}{}{}{}\n",
                             text.empty()           ? ""
                             : text.ends_with('\n') ? "\n"
                                                    : "\n\n",
                             word_for(definition), name, name, values.empty() ? "" : "(",
                             written_out(values), values.empty() ? "" : ")")}};
    }
    return definition.base.valid() ? edits_of_call(tree, tree[definition.base], values)
                                   : edits_of_defaults(tree, definition, values);
}

std::string rewritten(const Module& module, const LocatedDefinition& written,
                      const std::vector<Override>& values) {
    return edited(module.built_in ? "" : std::string(module.tree.source->text()),
                  edits_of_values(module, written, values));
}

}  // namespace balcony::lang
