// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a hand moves when it moves a number of a stage.

#include <optional>
#include <string>
#include <string_view>

#include "balcony/handles.hpp"
#include "lang/names/definition_scope.hpp"
#include "lang/service/known_text.hpp"

namespace balcony::lang {

/// The one literal or parameter that a number is made of.
struct HandLeaf {
    std::string parameter;  ///< Of the camera; empty if it is a literal of the text.
    Span literal;           ///< With the signs and operators of numbers around it.
    double value = 0.0;
    bool is_angle = false;

    [[nodiscard]] bool operator==(const HandLeaf& other) const {
        return parameter == other.parameter && literal.begin == other.literal.begin &&
               literal.end == other.literal.end;
    }
};

/// A number of a handle with what moves it.
struct HandNumber {
    HandleNumber number;
    std::optional<HandLeaf> leaf{};
    /// The number as a formula of the input hand_input().
    expr::Expr formula{};
};
[[nodiscard]] std::string_view hand_input();

/// The value of its leaf with which a number has a value; nothing if there is none.
[[nodiscard]] std::optional<double> leaf_for(const HandNumber& number, double value);

/// Numbers in the stages of a camera or a picture.
class HandNumbers {
public:
    /// A definition that is visible in a text, and the one with statements that it is made of. All
    /// of these must outlive it.
    HandNumbers(const KnownText& text, const LocatedDefinition& written,
                const LocatedDefinition& place, DefinitionScope& scope);

    [[nodiscard]] const SyntaxTree& tree() const { return tree_; }
    /// Whether the statements are those of the text itself.
    [[nodiscard]] bool is_of_text() const { return &tree_ == &text_.tree(); }
    /// Nothing for what is not a number.
    [[nodiscard]] std::optional<HandNumber> read(ExpressionId id, const camera::Range& limits);
    /// What the text says of the value of a parameter: its default, or in the call of what is made
    /// of it; none if the text says nothing.
    [[nodiscard]] ExpressionId written_value(std::size_t parameter) const;
    /// The literal of a parameter that is a constant number.
    [[nodiscard]] HandLeaf parameter_leaf(std::size_t parameter) const;
    /// What a name of a tuple or a list stands for.
    [[nodiscard]] ExpressionId named_by(ExpressionId id) const;

private:
    struct Reading;
    [[nodiscard]] expr::Expr formula(ExpressionId id, bool is_whole, Reading& reading);
    [[nodiscard]] expr::Expr of_name(const Expression& node, Reading& reading);
    [[nodiscard]] expr::Expr of_leaf(HandLeaf leaf, Reading& reading);
    [[nodiscard]] bool has_names(ExpressionId id) const;
    [[nodiscard]] const LetSyntax* let_named(std::string_view name) const;

    const KnownText& text_;
    const LocatedDefinition& written_;
    const LocatedDefinition& place_;
    const SyntaxTree& tree_;
    DefinitionScope& scope_;
    const std::vector<Value> parameters_;
};

}  // namespace balcony::lang
