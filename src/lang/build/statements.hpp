// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <map>
#include <vector>

#include "lang/build/stages.hpp"
#include "lang/reporter.hpp"
#include "lang/syntax/syntax.hpp"

namespace balcony::lang {

/// The error of a statement that may occur only once.
[[nodiscard]] Diagnostic occurs_again(std::string_view word, const SyntaxTree& tree, Span again,
                                      Span first);

/// The statements of one block, by kind.
class Statements {
public:
    /// Reports statements that occur twice although only one is allowed.
    Statements(const SyntaxTree& tree, const std::vector<Statement>& all, Reporter& reporter);

    /// The first statement of a kind, unless it is broken; null if there is none.
    [[nodiscard]] const Statement* find(StatementKind kind) const;
    /// Whether there is none of a kind, not even a broken or unrecognised one.
    [[nodiscard]] bool lacks(StatementKind kind) const;
    /// The stages of all statements of a kind, in sequence.
    [[nodiscard]] std::vector<ExpressionId> stages(StatementKind kind) const;

private:
    const std::vector<Statement>& all_;
    std::map<StatementKind, const Statement*> first_;
};

/// The arrangers of all statements of some kinds, place or arrange, in sequence; null for one with
/// an error.
[[nodiscard]] std::vector<camera::PictureArrangerPointer> make_arrangers(
    const std::vector<Statement>& statements, std::initializer_list<StatementKind> kinds,
    StageBuilder& stages);

}  // namespace balcony::lang
