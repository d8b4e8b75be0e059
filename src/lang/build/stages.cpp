// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/stages.hpp"
#include "lang/syntax/meant_words.hpp"
#include "lang/syntax/statement_rows.hpp"

#include <algorithm>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

// The stage of a kind that a word is a choice of, with the word: "normal outward" for outward.
std::optional<std::string> stage_with_choice(const camera::Catalogue& catalogue, StageKind kind,
                                             std::string_view word) {
    for (const StageEntry& row : catalogue) {
        for (const StageParameter& parameter : row.parameters) {
            const auto* choice = parameter.as<camera::ChoiceParameter>();
            if (row.kind == kind && choice != nullptr &&
                std::find(choice->choices.begin(), choice->choices.end(), word) !=
                    choice->choices.end()) {
                return kind == StageKind::direction_rule
                           ? fmt::format("{} {}", row.name, word)
                           : fmt::format("{}({} = {})", row.name, parameter.name, word);
            }
        }
    }
    return std::nullopt;
}

std::vector<std::string> names_of_kind(const camera::Catalogue& catalogue, StageKind kind) {
    std::vector<std::string> names;
    for (const StageEntry& row : catalogue) {
        if (row.kind == kind) {
            names.emplace_back(row.name);
        }
    }
    return names;
}

// The stages of a kind that are formulas, with their syntax.
std::vector<std::string> formulas_of_kind(const camera::Catalogue& catalogue, StageKind kind) {
    std::vector<std::string> formulas;
    for (const StageEntry& row : catalogue) {
        if (row.kind == kind && row.shape) {
            formulas.push_back(camera::signature(row.name, *row.shape));
        }
    }
    return formulas;
}

// If several kinds have the name, a picture arranger is the least likely.
const StageEntry* find_of_any_kind(const camera::Catalogue& catalogue, std::string_view name) {
    const StageEntry* found = nullptr;
    for (const StageEntry& row : catalogue) {
        if (row.name == name && (found == nullptr || found->kind == StageKind::picture_arranger)) {
            found = &row;
        }
    }
    return found;
}

// A text with single spaces in the place of all white space.
std::string on_one_line(std::string_view text) {
    std::string line;
    for (const char c : text) {
        const bool space = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!space) {
            line += c;
        } else if (!line.empty() && line.back() != ' ') {
            line += ' ';
        }
    }
    return line;
}

}  // namespace

// ------------------------------------------------------------------------------- the whole stage

StageBuilder::Stage StageBuilder::make_stage(StageKind kind, ExpressionId call) {
    const Expression& node = tree_[call];
    const StageEntry* row = find_row(kind, node.name);
    if (row == nullptr) {
        return nullptr;
    }
    const std::optional<Arguments> given = arguments(*row, node);
    return given ? make_from_row(*row, *given, row->shape ? node.name.span : node.span, node.span)
                 : nullptr;
}

StageBuilder::Stage StageBuilder::make_from_row(const StageEntry& row, const Arguments& arguments,
                                                Span named, Span whole) {
    Result<Stage> made = camera::make_stage(row, arguments);
    report(std::move(made.diagnostics), named);
    if (!made) {
        return nullptr;
    }
    written_[made->get()] =
        whole.begin == whole.end ? std::string(row.name) : on_one_line(tree_.text(whole));
    return *made;
}

const StageEntry* StageBuilder::find_row(StageKind kind, const Identifier& name) {
    if (const StageEntry* row = session_.catalogue().find(kind, name.text)) {
        return row;
    }
    if (auto meant = stage_remedy(kind, name.text)) {
        error(name.span, fmt::format("there is no {} named '{}'", camera::name_of(kind), name.text),
              std::move(*meant));
        return nullptr;
    }
    if (const StageEntry* row = find_of_any_kind(session_.catalogue(), name.text)) {
        const std::vector<std::string> formulas = formulas_of_kind(session_.catalogue(), kind);
        error(name.span,
              fmt::format("'{}' is {}, but {} is needed here", name.text,
                          camera::with_article(camera::name_of(row->kind)),
                          camera::with_article(camera::name_of(kind))),
              row->shape && !formulas.empty()
                  ? fmt::format("a formula for {} is {}",
                                camera::with_article(camera::name_of(kind)), one_of(formulas))
                  : fmt::format("{} belong to {}", camera::plural_of(row->kind),
                                all_of(statements_for(row->kind))));
        return nullptr;
    }
    if (const Definition* definition = scope_.find(name.text)) {
        if (definition->function || !definition->value.failed()) {
            error(name.span,
                  fmt::format(
                      "'{}' is {}, but {} is needed here", name.text,
                      definition->function ? "a function of numbers" : form_of(definition->value),
                      camera::with_article(camera::name_of(kind))),
                  "give it to a stage as an argument, or use it in a stage's formula");
        }
        return nullptr;
    }
    const auto of_choice = stage_with_choice(session_.catalogue(), kind, name.text);
    error(name.span, fmt::format("there is no {} named '{}'", camera::name_of(kind), name.text),
          of_choice ? fmt::format("did you mean '{}'?", *of_choice)
                    : did_you_mean(name.text, names_of_kind(session_.catalogue(), kind),
                                   "run 'balcony list' for a list of all stages"));
    return nullptr;
}

}  // namespace balcony::lang
