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
    if (std::optional<Diagnostic> fault = instead_of_stage(kind, call)) {
        error(node.name.span, std::move(fault->message), std::move(fault->remedy));
        return nullptr;
    }
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

// Calls that beginners write where a formula or a statement is meant, with what to write instead.
std::optional<Diagnostic> StageBuilder::instead_of_stage(StageKind kind, ExpressionId call) const {
    const Expression& node = tree_[call];
    if (node.kind != ExpressionKind::call || node.words || node.arguments.empty()) {
        return std::nullopt;
    }
    const auto text_of = [&](std::size_t first, std::size_t last) {
        return on_one_line(tree_.text({tree_[node.arguments[first].value].span.begin,
                                       tree_[node.arguments[last].value].span.end}));
    };
    const std::size_t count = node.arguments.size();
    const std::string all = text_of(0, count - 1);
    const bool is_object = kind == StageKind::object_generator;
    if (is_object && node.name.text == "point" && depends_on_coordinates(call)) {
        return balcony::error("a point does not depend on u or v", {},
                              instead_of_formula(kind, all, true));
    }
    const StageEntry* const row = session_.catalogue().find(kind, node.name.text);
    if (kind == StageKind::direction_rule && row != nullptr && row->parameters.empty() &&
        count == 3) {
        return balcony::error(
            fmt::format("'{}' takes no numbers: its directions are those of toward",
                        node.name.text),
            {}, fmt::format("write toward surface(u, v) = [{}] and look {}", all, node.name.text));
    }
    if (is_object && node.name.text == "lens") {
        return balcony::error(
            "'lens' is a statement, not an object", {},
            fmt::format(
                "write an object, such as point(0, 0, 0), and lens({}) on a line of its own", all));
    }
    if (is_object && node.name.text == "morph" && count >= 2) {
        return balcony::error(
            "'morph' is a statement between cameras, not an object", {},
            fmt::format("write a camera a with {}, a camera b with {}, and a third one with morph "
                        "a .. b, amount = {}",
                        text_of(0, 0), text_of(1, 1), count > 2 ? text_of(2, 2) : "0.5"));
    }
    return std::nullopt;
}

// Whether an expression has u or v, and these are no names of the file.
bool StageBuilder::depends_on_coordinates(ExpressionId expression) const {
    const auto nodes = std::span(tree_.expressions)
                           .subspan(tree_[expression].first.value(),
                                    expression.value() - tree_[expression].first.value());
    return std::any_of(nodes.begin(), nodes.end(), [this](const Expression& one) {
        return one.kind == ExpressionKind::name && (one.name.text == "u" || one.name.text == "v") &&
               scope_.find(one.name.text) == nullptr;
    });
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
