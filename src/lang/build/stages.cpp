// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/stages.hpp"
#include "lang/syntax/keywords.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::ParameterType;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

// A stage that has the word as a choice, with the word: "normal outward" for outward.
std::optional<std::string> stage_with_choice(StageKind kind, std::string_view word) {
    for (const StageEntry& row : camera::catalogue()) {
        for (const StageParameter& parameter : row.parameters) {
            const auto& choices = parameter.choices;
            if (row.kind == kind &&
                std::find(choices.begin(), choices.end(), word) != choices.end()) {
                return kind == StageKind::direction_rule
                           ? fmt::format("{} {}", row.name, word)
                           : fmt::format("{}({} = {})", row.name, parameter.name, word);
            }
        }
    }
    return std::nullopt;
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

// If a name has several kinds, a picture arranger is the least likely.
const StageEntry* find_of_any_kind(std::string_view name) {
    const StageEntry* found = nullptr;
    for (const StageEntry& row : camera::catalogue()) {
        if (row.name == name && (found == nullptr || found->kind == StageKind::picture_arranger)) {
            found = &row;
        }
    }
    return found;
}

}  // namespace

std::string with_article(std::string_view noun) {
    return fmt::format("{} {}", noun.starts_with('o') ? "an" : "a", noun);
}

std::string signature(std::string_view name, const camera::FormulaShape& shape) {
    static constexpr std::array<std::string_view, 3> space = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 2> parameter = {"u", "v"};
    std::string names;
    for (std::size_t i = 0; i < shape.parameters; ++i) {
        const bool in_space = shape.parameters > parameter.size();
        names += fmt::format("{}{}", i == 0 ? "" : ", ",
                             in_space ? space[std::min(i, space.size() - 1)] : parameter[i]);
    }
    static constexpr std::array<std::string_view, 4> forms = {"[]", "[a]", "[a, b]", "[a, b, c]"};
    const auto form = [](std::size_t count) { return forms[std::min(count, forms.size() - 1)]; };
    std::string text = fmt::format("{}({}) = {}", name, names, form(shape.min_results));
    if (shape.max_results > shape.min_results) {
        text += fmt::format(" or {}", form(shape.max_results));
    }
    return text;
}

std::string signature(const StageEntry& row) {
    if (row.formula) {
        return signature(row.name, *row.formula);
    }
    std::string text = fmt::format("{}(", row.name);
    for (const StageParameter& parameter : row.parameters) {
        text += &parameter == &row.parameters.front() ? "" : ", ";
        text += parameter.type == ParameterType::formula
                    ? signature(parameter.name, parameter.shape)
                    : std::string(parameter.name);
        text += parameter.type == ParameterType::stages ? ", ..." : "";
    }
    return text + ")";
}

// ---------------------------------------------------------------------------------- whole stages

StageBuilder::Stage StageBuilder::make_stage(StageKind kind, ExpressionId call) {
    const Expression& node = tree_[call];
    const StageEntry* row = find_row(kind, node.name);
    if (row == nullptr) {
        return nullptr;
    }
    const std::optional<Arguments> given = arguments(*row, node);
    return given ? make_from_row(*row, *given, row->formula ? node.name.span : node.span) : nullptr;
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
    if (const StageEntry* row = find_of_any_kind(name.text)) {
        error(name.span,
              fmt::format("'{}' is {}, but {} is needed here", name.text,
                          with_article(camera::name_of(row->kind)),
                          with_article(camera::name_of(kind))),
              fmt::format("{}s belong to {}", camera::name_of(row->kind),
                          all_of(statements_for(row->kind))));
        return nullptr;
    }
    auto nearest = stage_with_choice(kind, name.text);
    if (!nearest) {
        nearest = nearest_name(name.text, names_of_kind(kind));
    }
    error(name.span, fmt::format("there is no {} named '{}'", camera::name_of(kind), name.text),
          nearest ? fmt::format("did you mean '{}'?", *nearest)
                  : "run 'balcony list' for a list of all stages");
    return nullptr;
}

}  // namespace balcony::lang
