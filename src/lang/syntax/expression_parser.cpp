// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/expression_parser.hpp"

#include <array>

#include <fmt/format.h>

#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

constexpr int deepest_nesting = 200;
// An element of a list is a tuple at most, whose elements are numbers.
constexpr int max_indices = 16;

struct BinaryOperator {
    std::string_view symbol;
    int precedence;
};

// Powers bind more tightly than a sign on their left and are parsed elsewhere.
constexpr std::array<BinaryOperator, 12> binary_operators = {{{"||", 1},
                                                              {"&&", 2},
                                                              {"==", 3},
                                                              {"!=", 3},
                                                              {"<", 3},
                                                              {"<=", 3},
                                                              {">", 3},
                                                              {">=", 3},
                                                              {"+", 4},
                                                              {"-", 4},
                                                              {"*", 5},
                                                              {"/", 5}}};
constexpr int comparison = 3;

const BinaryOperator* find_operator(const Token& token) {
    for (const BinaryOperator& row : binary_operators) {
        if (token.is(row.symbol)) {
            return &row;
        }
    }
    return nullptr;
}

// Counts the nesting depth of the parser.
class Deeper {
public:
    explicit Deeper(int& depth) : depth_(depth) { ++depth_; }
    Deeper(const Deeper&) = delete;
    Deeper& operator=(const Deeper&) = delete;
    ~Deeper() { --depth_; }

private:
    int& depth_;
};

}  // namespace

bool ExpressionParser::too_deep() {
    if (depth_ <= deepest_nesting) {
        return false;
    }
    tokens_.error(tokens_.peek().span,
                  fmt::format("this is nested more than {} levels deep", deepest_nesting),
                  "name parts of it with let");
    return true;
}

ExpressionId ExpressionParser::add(Expression node, std::size_t first) {
    node.first = ExpressionId(first);
    nodes_.push_back(std::move(node));
    return ExpressionId(nodes_.size() - 1);
}

std::optional<ExpressionId> ExpressionParser::add_operation(const Token& symbol, std::size_t first,
                                                            std::vector<ExpressionId> operands) {
    Expression node;
    node.kind = ExpressionKind::operation;
    node.name = {symbol.text, symbol.span};
    node.span = symbol.span;
    for (const ExpressionId operand : operands) {
        const Span span = nodes_[operand.value()].span;
        node.span = {std::min(node.span.begin, span.begin), std::max(node.span.end, span.end)};
        node.arguments.push_back({std::nullopt, operand});
    }
    return add(std::move(node), first);
}

std::optional<ExpressionId> ExpressionParser::expression() { return binary(1); }

// Precedence climbing: operators of one level are left-associative.
std::optional<ExpressionId> ExpressionParser::binary(int min_precedence) {
    const std::size_t first = nodes_.size();
    std::optional<ExpressionId> left = unary();
    bool compared = false;
    while (left) {
        const BinaryOperator* row = find_operator(tokens_.peek());
        if (row == nullptr || row->precedence < min_precedence) {
            return left;
        }
        if (row->precedence == comparison && compared) {
            tokens_.error(tokens_.peek().span, "comparisons cannot be chained",
                          "combine two with '&&': a < b && b < c");
            return std::nullopt;
        }
        compared = row->precedence == comparison;
        const Token symbol = tokens_.next();
        const std::optional<ExpressionId> right = binary(row->precedence + 1);
        left = right ? add_operation(symbol, first, {*left, *right}) : std::nullopt;
    }
    return std::nullopt;
}

std::optional<ExpressionId> ExpressionParser::unary() {
    const Deeper deeper(depth_);
    if (too_deep()) {
        return std::nullopt;
    }
    const std::size_t first = nodes_.size();
    if (!tokens_.peek().is("-") && !tokens_.peek().is("!")) {
        return power();
    }
    const Token symbol = tokens_.next();
    const std::optional<ExpressionId> operand = unary();
    return operand ? add_operation(symbol, first, {*operand}) : std::nullopt;
}

// a^b^c is a^(b^c); the exponent may have a sign.
std::optional<ExpressionId> ExpressionParser::power() {
    const std::size_t first = nodes_.size();
    const std::optional<ExpressionId> base = element();
    if (!base || !tokens_.peek().is("^")) {
        return base;
    }
    const Token symbol = tokens_.next();
    const std::optional<ExpressionId> exponent = unary();
    return exponent ? add_operation(symbol, first, {*base, *exponent}) : std::nullopt;
}

// points[2], points[2][0]
std::optional<ExpressionId> ExpressionParser::element() {
    const std::size_t first = nodes_.size();
    std::optional<ExpressionId> read = primary();
    int indices = 0;
    while (read && tokens_.peek().is("[") && !tokens_.at_new_line() &&
           nodes_[read->value()].kind != ExpressionKind::number) {
        if (++indices > max_indices) {
            tokens_.error(tokens_.peek().span,
                          fmt::format("a value has more than {} indices", max_indices),
                          "an element of a list has at most one more: points[2][0]");
            return std::nullopt;
        }
        const Span opening = tokens_.next().span;
        const std::optional<ExpressionId> index = expression();
        const Expression& compound = nodes_[read->value()];
        if (index && tokens_.peek().is(",") && compound.kind == ExpressionKind::call) {
            tokens_.error(opening, "expected '= [' and the results of a formula, but found '['",
                          fmt::format("for example {}(u, v) = [ ... ]", compound.name.text));
            return std::nullopt;
        }
        if (!index || !tokens_.expect_closing("]", opening)) {
            return std::nullopt;
        }
        Expression node;
        node.kind = ExpressionKind::element;
        node.name = compound.name;
        node.span = {compound.span.begin, tokens_.previous().span.end};
        node.arguments = {{std::nullopt, *read}, {std::nullopt, *index}};
        read = add(std::move(node), first);
    }
    return read;
}

std::optional<ExpressionId> ExpressionParser::primary() {
    const Token& token = tokens_.peek();
    if (token.kind == TokenKind::number) {
        Expression node;
        node.span = token.span;
        node.value = token.value;
        node.unit = token.unit;
        tokens_.next();
        return add(std::move(node), nodes_.size());
    }
    if (token.kind == TokenKind::name) {
        return name_or_call();
    }
    if (token.is("(")) {
        return parenthesised();
    }
    if (token.is("[")) {
        return list();
    }
    if (token.kind == TokenKind::text) {
        return add_name(tokens_.next(), ExpressionKind::text);
    }
    tokens_.expected("a number, a name or '('", missing_value_remedy());
    return std::nullopt;
}

std::string ExpressionParser::missing_value_remedy() const {
    const std::string_view before = tokens_.previous().text;
    if (before == "*" && tokens_.peek().is("*")) {
        return "write a power as x^2";
    }
    return before == "," ? "remove the ',' before it, or write a value between them"
                         : fmt::format("write a value after '{}'", before);
}

std::optional<ExpressionId> ExpressionParser::parenthesised() {
    const std::size_t first = nodes_.size();
    const Span opening = tokens_.next().span;
    std::vector<Argument> elements;
    do {
        const std::optional<ExpressionId> element = expression();
        if (!element) {
            return std::nullopt;
        }
        elements.push_back({std::nullopt, *element});
    } while (tokens_.accept(","));
    if (!tokens_.expect_closing(")", opening)) {
        return std::nullopt;
    }
    const Span span = {opening.begin, tokens_.previous().span.end};
    if (elements.size() == 1) {
        nodes_[elements.front().value.value()].span = span;
        return elements.front().value;
    }
    Expression node;
    node.kind = ExpressionKind::tuple;
    node.span = span;
    node.arguments = std::move(elements);
    return add(std::move(node), first);
}

std::optional<ExpressionId> ExpressionParser::list() {
    Expression node;
    node.kind = ExpressionKind::list;
    const std::size_t first = nodes_.size();
    const Span opening = tokens_.next().span;
    if (!tokens_.accept("]")) {
        do {
            const std::optional<ExpressionId> element = expression();
            if (!element) {
                return std::nullopt;
            }
            node.arguments.push_back({std::nullopt, *element});
        } while (tokens_.accept(","));
        if (!tokens_.expect_closing("]", opening)) {
            return std::nullopt;
        }
    }
    node.span = {opening.begin, tokens_.previous().span.end};
    return add(std::move(node), first);
}

ExpressionId ExpressionParser::add_name(const Token& name, ExpressionKind kind) {
    Expression node;
    node.kind = kind;
    node.name = {name.text, name.span};
    node.span = name.span;
    return add(std::move(node), nodes_.size());
}

std::optional<ExpressionId> ExpressionParser::name_or_call() {
    const std::size_t first = nodes_.size();
    const Token name = tokens_.next();
    if (!tokens_.peek().is("(")) {
        return add_name(name);
    }
    Expression node;
    node.kind = ExpressionKind::call;
    node.name = {name.text, name.span};
    node.span = name.span;
    std::optional<std::vector<Argument>> given = arguments(tokens_.next().span);
    if (!given) {
        return std::nullopt;
    }
    node.arguments = std::move(*given);
    node.span.end = tokens_.previous().span.end;
    if (tokens_.peek().is("=") && tokens_.peek(1).is("[")) {
        return formula(std::move(node));
    }
    if (tokens_.accept("=")) {
        tokens_.expected("'= [' and the results of a formula",
                         fmt::format("for example {}(u, v) = [ ... ]", name.text));
        return std::nullopt;
    }
    return add(std::move(node), first);
}

ExpressionId ExpressionParser::add_call(const Identifier& name, std::vector<Argument> arguments,
                                        std::size_t first) {
    Expression node;
    node.kind = ExpressionKind::call;
    node.name = name;
    node.span = name.span;
    node.arguments = std::move(arguments);
    return add(std::move(node), first);
}

// The parsed arguments of a call turn out to be the parameters of a formula. Their nodes stay in
// the list unused, and the formula starts after them.
std::optional<ExpressionId> ExpressionParser::formula(Expression call) {
    Expression node;
    node.kind = ExpressionKind::formula;
    node.name = call.name;
    for (const Argument& argument : call.arguments) {
        const Expression& parameter = nodes_[argument.value.value()];
        if (argument.name || parameter.kind != ExpressionKind::name) {
            tokens_.error(parameter.span,
                          fmt::format("the parameters of the formula '{}' must be plain names",
                                      node.name.text),
                          fmt::format("for example {}(u, v) = [ ... ]", node.name.text));
            return std::nullopt;
        }
        node.parameters.push_back(parameter.name);
    }
    const std::size_t first = nodes_.size();
    tokens_.next();
    const Span opening = tokens_.next().span;
    do {
        const std::optional<ExpressionId> result = expression();
        if (!result) {
            return std::nullopt;
        }
        node.arguments.push_back({std::nullopt, *result});
    } while (tokens_.accept(","));
    if (!tokens_.expect_closing("]", opening)) {
        return std::nullopt;
    }
    node.span = {call.span.begin, tokens_.previous().span.end};
    return add(std::move(node), first);
}

std::optional<std::vector<Argument>> ExpressionParser::arguments(Span opening) {
    std::vector<Argument> given;
    if (tokens_.accept(")")) {
        return given;
    }
    do {
        Argument argument;
        if (tokens_.peek().kind == TokenKind::name && tokens_.peek(1).is("=")) {
            argument.name = Identifier{tokens_.peek().text, tokens_.peek().span};
            tokens_.next();
            tokens_.next();
        }
        const std::optional<ExpressionId> value = expression();
        if (!value) {
            return std::nullopt;
        }
        argument.value = *value;
        given.push_back(argument);
    } while (tokens_.accept(","));
    return tokens_.expect_closing(")", opening) ? std::optional(std::move(given)) : std::nullopt;
}

std::optional<ExpressionId> ExpressionParser::stage(std::string_view what) {
    if (tokens_.peek().kind != TokenKind::name) {
        const Token& token = tokens_.peek();
        const bool assigned = token.is("=") || token.is(":");
        tokens_.expected(what, assigned ? fmt::format("remove the '{}'", token.text)
                               : token.kind == TokenKind::text
                                   ? fmt::format("remove the quotation marks: {}",
                                                 token.text.substr(0, token.text.rfind(".cam")))
                                   : "run 'balcony list' for a list of all stages");
        return std::nullopt;
    }
    const std::optional<ExpressionId> read = name_or_call();
    if (!read || !tokens_.peek().is("[") || tokens_.at_new_line()) {
        return read;
    }
    const Expression& node = nodes_[read->value()];
    if (node.kind == ExpressionKind::call) {
        tokens_.expected("'= [' and the results of a formula",
                         fmt::format("for example {}(u, v) = [ ... ]", node.name.text));
    } else {
        tokens_.expected("'('",
                         fmt::format("write arguments in parentheses: {}( ... )", node.name.text));
    }
    return std::nullopt;
}

// A plain name on the same line that does not start the next statement.
bool ExpressionParser::at_word() const {
    return tokens_.peek().kind == TokenKind::name && !tokens_.at_new_line() &&
           find_statement(tokens_.peek(), Block::camera) == nullptr &&
           !is_file_keyword(tokens_.peek()) && !tokens_.peek(1).is("(") && !tokens_.peek(1).is("=");
}

std::optional<ExpressionId> ExpressionParser::stage_with_words(std::string_view what) {
    const std::optional<ExpressionId> read = stage(what);
    if (!read || nodes_[read->value()].kind != ExpressionKind::name || !at_word()) {
        return read;
    }
    Expression call = std::move(nodes_.back());
    nodes_.pop_back();
    const std::size_t first = nodes_.size();
    call.kind = ExpressionKind::call;
    call.words = true;
    while (at_word()) {
        call.arguments.push_back({std::nullopt, add_name(tokens_.next())});
    }
    call.span.end = tokens_.previous().span.end;
    return add(std::move(call), first);
}

}  // namespace balcony::lang
