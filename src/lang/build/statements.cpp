// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/statements.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

Diagnostic occurs_again(std::string_view word, const SyntaxTree& tree, Span again, Span first) {
    Diagnostic diagnostic =
        error(fmt::format("'{}' occurs a second time", word), tree.at(again), "remove one of them");
    diagnostic.notes.push_back({tree.at(first), fmt::format("the first '{}'", word)});
    return diagnostic;
}

Statements::Statements(const SyntaxTree& tree, const std::vector<Statement>& all,
                       Reporter& reporter)
    : all_(all) {
    // A keyword in a broken statement may be a piece of it.
    const bool whole =
        std::none_of(all.begin(), all.end(), [](const Statement& one) { return one.broken; });
    for (const Statement& statement : all) {
        const auto [earlier, is_first] = first_.emplace(statement.kind, &statement);
        const StatementRow* row = row_of(statement.kind);
        if (!is_first && whole && row != nullptr && row->once) {
            reporter.add(
                occurs_again(row->keyword, tree, statement.keyword, earlier->second->keyword));
        }
    }
}

const Statement* Statements::find(StatementKind kind) const {
    const auto found = first_.find(kind);
    return found == first_.end() || found->second->broken ? nullptr : found->second;
}

bool Statements::lacks(StatementKind kind) const {
    return !first_.contains(kind) && !first_.contains(StatementKind::unknown);
}

std::vector<ExpressionId> Statements::stages(StatementKind kind) const {
    std::vector<ExpressionId> calls;
    for (const Statement& statement : all_) {
        if (statement.kind == kind && !statement.broken) {
            const std::span<const ExpressionId> own = statement.stages();
            calls.insert(calls.end(), own.begin(), own.end());
        }
    }
    return calls;
}

std::vector<camera::PictureArrangerPointer> make_arrangers(
    const std::vector<Statement>& statements, std::initializer_list<StatementKind> kinds,
    StageBuilder& stages) {
    std::vector<camera::PictureArrangerPointer> made;
    for (const Statement& statement : statements) {
        if (!statement.broken &&
            std::find(kinds.begin(), kinds.end(), statement.kind) != kinds.end()) {
            for (const ExpressionId call : statement.stages()) {
                made.push_back(stages.make<camera::PictureArranger>(call));
            }
        }
    }
    return made;
}

}  // namespace balcony::lang
