// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/stages.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::ParameterType;
using camera::Scalar;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

// The statements that stages of a kind belong to.
std::string_view statement_for(StageKind kind) {
    switch (kind) {
        case StageKind::picture_arranger: return "place";
        case StageKind::picture_mapper: return "map";
        case StageKind::parameter_transformer: return "warp";
        case StageKind::object_generator: return "eye', 'toward' and 'object";
        case StageKind::object_transformer: return "move";
        case StageKind::direction_rule: return "look";
        case StageKind::clip_shape: return "clip";
    }
    return {};
}

std::string_view article(StageKind kind) {
    return camera::name_of(kind).starts_with('o') ? "an" : "a";
}

std::vector<std::string> names_of_kind(StageKind kind) {
    std::vector<std::string> names;
    for (const StageEntry& row : camera::catalogue()) {
        if (row.kind == kind) {
            names.emplace_back(row.name);
        }
    }
    return names;
}

std::string formula_signature(const StageEntry& row) {
    static constexpr std::array<std::string_view, 3> space = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 2> parameter = {"u", "v"};
    std::string names;
    for (std::size_t i = 0; i < row.formula->parameters; ++i) {
        const bool in_space = row.formula->parameters > parameter.size();
        names += fmt::format("{}{}", i == 0 ? "" : ", ",
                             in_space ? space[std::min(i, space.size() - 1)] : parameter[i]);
    }
    static constexpr std::array<std::string_view, 4> forms = {"[]", "[a]", "[a, b]", "[a, b, c]"};
    const auto form = [](std::size_t count) { return forms[std::min(count, forms.size() - 1)]; };
    std::string text =
        fmt::format("{}({}) = {}", row.name, names, form(row.formula->results_least));
    if (row.formula->results_most > row.formula->results_least) {
        text += fmt::format(" or {}", form(row.formula->results_most));
    }
    return text;
}

}  // namespace

std::string signature(const StageEntry& row) {
    if (row.formula) {
        return formula_signature(row);
    }
    std::string text = fmt::format("{}(", row.name);
    for (const StageParameter& parameter : row.parameters) {
        text +=
            fmt::format("{}{}", &parameter == &row.parameters.front() ? "" : ", ", parameter.name);
    }
    return text + ")";
}

// ------------------------------------------------------------------------------- the whole stage

StageBuilder::Stage StageBuilder::make_stage(StageKind kind, ExpressionId call) {
    const Expression& node = tree_[call];
    const StageEntry* row = find_row(kind, node.name);
    if (row == nullptr) {
        return nullptr;
    }
    Arguments arguments;
    if (row->formula) {
        std::optional<camera::Formula> made = formula(*row, node);
        if (!made) {
            return nullptr;
        }
        arguments.set_formula(std::move(*made));
        return make_from_row(*row, arguments, node.name.span);
    }
    if (node.kind == ExpressionKind::formula) {
        error(node.span, fmt::format("'{}' is not made from a formula", row->name),
              fmt::format("it is written {}", signature(*row)));
        return nullptr;
    }
    std::vector<ExpressionId> given(row->parameters.size());
    bool good = assign(*row, node, given);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const StageParameter& parameter = row->parameters[i];
        if (given[i].valid()) {
            good = set_argument(*row, parameter, given[i], arguments) && good;
        } else if (good) {
            good = set_default(*row, parameter, node.name.span, arguments);
        }
    }
    return good ? make_from_row(*row, arguments, node.span) : nullptr;
}

StageBuilder::Stage StageBuilder::make_from_row(const StageEntry& row, const Arguments& arguments,
                                                Span span) {
    Result<Stage> made = row.make(arguments);
    for (Diagnostic& diagnostic : made.diagnostics) {
        if (!diagnostic.span.source) {
            diagnostic.span = tree_.at(span);
        }
        reporter_.add(std::move(diagnostic));
    }
    return made ? *made : nullptr;
}

const StageEntry* StageBuilder::find_row(StageKind kind, const Identifier& name) {
    if (const StageEntry* row = camera::find_stage(kind, name.text)) {
        return row;
    }
    for (const StageEntry& row : camera::catalogue()) {
        if (row.name == name.text) {
            error(name.span,
                  fmt::format("'{}' is {} {}, but this is the place of {} {}", name.text,
                              article(row.kind), camera::name_of(row.kind), article(kind),
                              camera::name_of(kind)),
                  fmt::format("{}s belong to '{}'", camera::name_of(row.kind),
                              statement_for(row.kind)));
            return nullptr;
        }
    }
    error(name.span, fmt::format("there is no {} named '{}'", camera::name_of(kind), name.text),
          suggestion(name.text, names_of_kind(kind), "there are"));
    return nullptr;
}

// --------------------------------------------------------------------------------- its arguments

// Finds out which parameter each argument is for.
bool StageBuilder::assign(const StageEntry& row, const Expression& call,
                          std::vector<ExpressionId>& given) {
    bool good = true;
    bool named = false;
    std::size_t position = 0;
    for (const Argument& argument : call.arguments) {
        const Span span = tree_[argument.value].span;
        const StageParameter* parameter = nullptr;
        if (argument.name) {
            named = true;
            parameter = named_parameter(row, *argument.name);
        } else if (named) {
            error(span, "an argument without a name stands behind one with a name",
                  fmt::format("arguments come in the order of {}, or with their names",
                              signature(row)));
        } else if (position < row.parameters.size()) {
            parameter = &row.parameters[position++];
        } else {
            error(span,
                  fmt::format("'{}' takes {} argument{}, but is given {}", row.name,
                              row.parameters.size(), row.parameters.size() == 1 ? "" : "s",
                              call.arguments.size()),
                  fmt::format("it is written {}", signature(row)));
            return false;
        }
        if (parameter == nullptr) {
            good = false;
            continue;
        }
        ExpressionId& slot = given[static_cast<std::size_t>(parameter - row.parameters.data())];
        if (slot.valid()) {
            Diagnostic diagnostic =
                balcony::error(fmt::format("'{}' is given twice", parameter->name),
                               tree_.at(argument.name ? argument.name->span : span));
            diagnostic.notes.push_back({tree_.at(tree_[slot].span), "it is given here first"});
            reporter_.add(std::move(diagnostic));
            good = false;
        } else {
            slot = argument.value;
        }
    }
    return good;
}

const StageParameter* StageBuilder::named_parameter(const StageEntry& row, const Identifier& name) {
    std::vector<std::string> known;
    for (const StageParameter& parameter : row.parameters) {
        if (parameter.name == name.text) {
            return &parameter;
        }
        known.emplace_back(parameter.name);
    }
    error(name.span, fmt::format("'{}' has no argument '{}'", row.name, name.text),
          known.empty() ? fmt::format("'{}' takes no arguments", row.name)
                        : suggestion(name.text, known, "its arguments are"));
    return nullptr;
}

bool StageBuilder::set_argument(const StageEntry& row, const StageParameter& parameter,
                                ExpressionId given, Arguments& arguments) {
    if (parameter.type == ParameterType::choice) {
        std::optional<std::string> word = choice(row, parameter, given);
        if (word) {
            arguments.set(parameter.name, std::move(*word));
        }
        return word.has_value();
    }
    if (parameter.type == ParameterType::curve) {
        camera::ObjectGeneratorPointer made = curve(row, parameter, given);
        if (made) {
            arguments.set(parameter.name, made);
        }
        return made != nullptr;
    }
    std::optional<std::vector<Scalar>> values = numbers(row, parameter, given);
    if (values) {
        arguments.set(parameter.name, std::move(*values));
    }
    return values.has_value();
}

std::optional<std::string> StageBuilder::choice(const StageEntry& row,
                                                const StageParameter& parameter,
                                                ExpressionId given) {
    const Expression& node = tree_[given];
    const std::vector<std::string> words(parameter.choices.begin(), parameter.choices.end());
    if (node.kind != ExpressionKind::name) {
        error(node.span, fmt::format("'{}' of '{}' is a word", parameter.name, row.name),
              fmt::format("write {}", one_of(words)));
        return std::nullopt;
    }
    if (std::find(words.begin(), words.end(), node.name.text) == words.end()) {
        error(node.span,
              fmt::format("'{}' of '{}' cannot be '{}'", parameter.name, row.name, node.name.text),
              suggestion(node.name.text, words, "it is"));
        return std::nullopt;
    }
    return std::string(node.name.text);
}

camera::ObjectGeneratorPointer StageBuilder::curve(const StageEntry& row,
                                                   const StageParameter& parameter,
                                                   ExpressionId given) {
    const Expression& node = tree_[given];
    if (node.kind != ExpressionKind::name && node.kind != ExpressionKind::call &&
        node.kind != ExpressionKind::formula) {
        error(node.span,
              fmt::format("'{}' of '{}' is a curve, but this is {}", parameter.name, row.name,
                          node.kind == ExpressionKind::tuple ? "a tuple" : "a number"),
              "write a curve such as circle(1) or curve(u) = [cos(u), sin(u)]");
        return nullptr;
    }
    auto made = make<camera::ObjectGenerator>(StageKind::object_generator, given);
    if (made && made->dimension() != 1) {
        error(node.span,
              fmt::format("'{}' of '{}' is a curve, but '{}' is a {}", parameter.name, row.name,
                          node.name.text, made->dimension() == 0 ? "point" : "surface"));
        return nullptr;
    }
    return made;
}

}  // namespace balcony::lang
