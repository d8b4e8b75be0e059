// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/build/statements.hpp"

#include <fmt/format.h>

#include "lang/syntax/keywords.hpp"

namespace balcony::lang {

namespace {

// A statement that may occur only once in a camera or a block.
bool stands_once(StatementKind kind) {
    return kind != StatementKind::let && kind != StatementKind::warp &&
           kind != StatementKind::move && kind != StatementKind::place &&
           kind != StatementKind::arrange && kind != StatementKind::layer &&
           kind != StatementKind::leader && kind != StatementKind::unknown;
}

}  // namespace

Statements::Statements(const SyntaxTree& tree, const std::vector<Statement>& all,
                       Reporter& reporter)
    : all_(all) {
    for (const Statement& statement : all) {
        const auto [earlier, is_first] = first_.emplace(statement.kind, &statement);
        if (!is_first && stands_once(statement.kind)) {
            const std::string_view word = keyword(statement.kind);
            Diagnostic diagnostic = error(fmt::format("'{}' occurs a second time", word),
                                          tree.at(statement.keyword), "remove one of them");
            diagnostic.notes.push_back(
                {tree.at(earlier->second->keyword), fmt::format("the first '{}'", word)});
            reporter.add(std::move(diagnostic));
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
            calls.insert(calls.end(), statement.stages.begin(), statement.stages.end());
        }
    }
    return calls;
}

std::vector<camera::PictureArrangerPointer> make_arrangers(const std::vector<Statement>& statements,
                                                           StageBuilder& stages) {
    std::vector<camera::PictureArrangerPointer> made;
    for (const Statement& statement : statements) {
        if (statement.broken) {
            continue;
        }
        if (statement.kind == StatementKind::place) {
            made.push_back(stages.make_place(statement.ranges.front()));
        } else if (statement.kind == StatementKind::arrange) {
            for (const ExpressionId call : statement.stages) {
                made.push_back(stages.make<camera::PictureArranger>(
                    camera::StageKind::picture_arranger, call));
            }
        }
    }
    return made;
}

}  // namespace balcony::lang
