// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// grey("mix.png", x, y): the grey value of an image.

#include "lang/names/grey_calls.hpp"

#include <array>
#include <string>

#include <fmt/format.h>

#include "camera/tables/grey_table.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

Value evaluate_grey(const SyntaxTree& tree, const Expression& call, Scope& scope,
                    const Context& context) {
    const auto error = [&](const Span& span, std::string message) {
        context.reporter.error(tree.at(span), std::move(message),
                               "for example grey(\"mix.png\", x, y), where x and y are fractions "
                               "from the top left corner of the image");
        return Value{};
    };
    if (call.arguments.size() != 3) {
        return error(call.span, fmt::format("'grey' takes an image file and two numbers, but {} "
                                            "arguments are given",
                                            call.arguments.size()));
    }
    for (const Argument& argument : call.arguments) {
        if (argument.name) {
            return error(argument.name->span, "the function 'grey' takes no named arguments");
        }
    }
    const Expression& file = tree[call.arguments.front().value];
    if (file.kind != ExpressionKind::text) {
        return error(file.span,
                     "the first argument of 'grey' is the name of an image file in "
                     "quotation marks");
    }
    std::array<expr::Expr, 2> at;
    for (std::size_t i = 0; i < at.size(); ++i) {
        const ExpressionId id = call.arguments[i + 1].value;
        const Value value = evaluate(tree, id, scope, context);
        if (value.failed()) {
            return {};
        }
        if (value.is_angle()) {
            return error(tree[id].span, "the place in an image is a number, but this is an angle");
        }
        at[i] = value.expr;
    }
    const auto grey = context.tables.grey(tree, file.name);
    return grey ? Value{camera::grey_at(grey, at[0], at[1]), Unit::number} : Value{};
}

}  // namespace balcony::lang
