// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The syntax tree of a camera file, in the order of the file, without name
// resolution. Comments are kept separately with their positions, so that a file can be reprinted.

#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <variant>
#include <vector>

#include "balcony/base.hpp"
#include "lang/syntax/token.hpp"

namespace balcony::lang {

/// A name and its position in the source.
struct Identifier {
    std::string_view text;
    Span span;
};

using ExpressionId = StrongIndex<struct ExpressionTag>;

enum class ExpressionKind : std::uint8_t {
    number,
    name,
    operation,  ///< Unary or binary; `text` is the operator.
    call,       ///< name(arguments): a function or a stage.
    element,    ///< compound[index]
    tuple,      ///< (a, b) or (a, b, c).
    list,       ///< [a, b, ...], with expressions or tuples; may be empty.
    text,       ///< "seeds.csv"; `name` is the text in the quotes and their position.
    formula,    ///< name(parameters) = [results].
};

struct Argument {
    std::optional<Identifier> name;
    ExpressionId value;
};

/// One node. Operands precede the node in the file's list, so that the nodes [first, id] are
/// the whole expression in the order of evaluation, and a walk needs no recursion.
struct Expression {
    ExpressionKind kind = ExpressionKind::number;
    Span span;
    ExpressionId first;
    Identifier name;     ///< The name or operator and its position.
    double value = 0.0;  ///< The value of a number, without its unit.
    NumberUnit unit = NumberUnit::none;
    std::vector<Argument> arguments;  ///< Operands, arguments, elements, results.
    bool words = false;  ///< A call whose arguments are words after its name: normal outward.
    std::vector<Identifier> parameters;  ///< The parameters of a formula.
};

enum class StatementKind : std::uint8_t {
    let,
    aspect,
    axes,
    map,
    eye,
    toward,
    morph,
    object,
    warp,
    move,
    look,
    stereo,
    lens,
    bend,
    time,
    fitted,
    place,
    arrange,
    layer,
    loop,
    fit,
    fill,
    stretch,
    show,
    hide,
    clip,
    soft,
    alpha,
    channels,
    blend,
    frame,
    scale_bar,
    leader,
    unknown,
};

/// name = value or name(parameters) = value, of a let.
struct LetSyntax {
    Identifier name;
    ExpressionId value;                    ///< Invalid if it had a syntax error.
    std::vector<Identifier> parameters{};  ///< Of a function; none for a value.
};

/// u = first .. last, or u = square, for which both ends are invalid.
struct MapRange {
    Identifier coordinate;
    Span span;
    ExpressionId first, last;
};

/// name in first .. last or name in list, of a loop.
struct LoopSyntax {
    Identifier variable;
    ExpressionId first;
    ExpressionId last;  ///< Invalid for a list, which is then `first`.
};

/// name = value, or (name, name) = value, of a fit statement.
struct Assignment {
    std::vector<Identifier> names;  ///< Several are the elements of a tuple.
    bool is_tuple = false;
    ExpressionId value;
};

/// (a, b) .. (c, d), from the top left corner to the bottom right one.
struct Corners {
    Span span;
    ExpressionId first, last;
};

/// The content depends on the shape of the statement's kind (statement_rows.hpp). After a syntax
/// error part of it may be missing.
struct Statement {
    using Content =
        std::variant<std::monostate, LetSyntax, ExpressionId, Identifier, std::vector<MapRange>,
                     Corners, LoopSyntax, std::vector<Assignment>, std::vector<ExpressionId>>;

    StatementKind kind = StatementKind::unknown;
    Span keyword;
    Span span;
    bool broken = false;  ///< It had a syntax error, which is reported.
    Content content{};
    std::vector<Statement> block{};  ///< In braces: of a path, a layer or a loop.

    /// Without a name where a broken statement was taken for a let.
    [[nodiscard]] const LetSyntax& let() const {
        static const LetSyntax nameless;
        const auto* written = std::get_if<LetSyntax>(&content);
        return written != nullptr ? *written : nameless;
    }
    [[nodiscard]] ExpressionId value() const { return std::get<ExpressionId>(content); }
    [[nodiscard]] const Identifier& word() const { return std::get<Identifier>(content); }
    [[nodiscard]] const std::vector<MapRange>& ranges() const {
        return std::get<std::vector<MapRange>>(content);
    }
    /// Null where a statement may omit them and does.
    [[nodiscard]] const Corners* corners() const { return std::get_if<Corners>(&content); }
    [[nodiscard]] const LoopSyntax& loop() const { return std::get<LoopSyntax>(content); }
    [[nodiscard]] const std::vector<Assignment>& assignments() const {
        return std::get<std::vector<Assignment>>(content);
    }
    /// None if a block stands in their place.
    [[nodiscard]] std::span<const ExpressionId> stages() const {
        const auto* written = std::get_if<std::vector<ExpressionId>>(&content);
        return written != nullptr ? std::span(*written) : std::span<const ExpressionId>();
    }
};

struct Import {
    Span span;
    Identifier file;      ///< The text in the quotes, and their position.
    bool broken = false;  ///< It has a syntax error, which is reported.
};

/// name = value above minimum to maximum; either limit may be missing.
struct DefinitionParameter {
    Identifier name;
    ExpressionId default_value{};  ///< Invalid after a syntax error.
    ExpressionId minimum{};
    ExpressionId maximum{};
    bool excludes_minimum = false;  ///< `above` instead of `from`.
    Span limits{};                  ///< Of both, with their words.
};

/// A camera or a picture.
struct DefinitionSyntax {
    bool is_picture = false;
    Identifier name;
    Span span;
    bool broken = false;  ///< Its beginning had a syntax error: names in it may be unread.
    std::vector<DefinitionParameter> parameters;
    std::vector<ExpressionId> size;  ///< Width and height of a picture, if given.
    /// The call of the one that it is made of: camera wide = fisheye(fov = 200deg). It then has no
    /// parameters and no statements of its own.
    ExpressionId base{};
    std::vector<Statement> statements;
};

/// A file-level let is a Statement.
using Item = std::variant<Import, Statement, DefinitionSyntax>;

struct SyntaxTree {
    std::shared_ptr<const SourceText> source;
    std::vector<Expression> expressions;
    std::vector<Item> items;
    bool broken = false;  ///< A piece between the items was not read: names may be missing.
    std::vector<Span> comments;

    [[nodiscard]] const Expression& operator[](ExpressionId id) const {
        return expressions[id.value()];
    }
    [[nodiscard]] SourceSpan at(Span span) const { return {source, span.begin, span.end}; }
    [[nodiscard]] std::string_view text(Span span) const {
        return source->text().substr(span.begin, span.end - span.begin);
    }
};

}  // namespace balcony::lang
