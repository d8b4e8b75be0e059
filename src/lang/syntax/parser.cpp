// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/parser.hpp"

#include <algorithm>
#include <array>
#include <map>
#include <set>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "lang/syntax/expression_parser.hpp"
#include "lang/syntax/meant_words.hpp"
#include "lang/syntax/statement_parser.hpp"
#include "lang/syntax/statement_rows.hpp"
#include "lang/syntax/token_stream.hpp"

namespace balcony::lang {

namespace {

class Parser {
public:
    Parser(SyntaxTree& tree, const camera::Catalogue& catalogue, Reporter& reporter)
        : tree_(tree),
          tokens_(tree.source, read_tokens(tree, reporter), reporter),
          expressions_(tokens_, tree.expressions),
          statements_(tokens_, expressions_, catalogue, reporter),
          reporter_(reporter) {}

    void file() {
        while (!tokens_.at_end() && !reporter_.full()) {
            const Token& token = tokens_.peek();
            if (token.is_name("import")) {
                import();
            } else if (token.is_name("let")) {
                add_let(statements_.statement(Block::camera));
            } else if (token.is_name("camera") || token.is_name("picture")) {
                camera();
            } else {
                stray_item();
            }
        }
    }

    bool override_value() {
        if (tokens_.peek().kind != TokenKind::name) {
            tokens_.expected("the name of a parameter", "the syntax is --set name=value");
            return false;
        }
        tokens_.next();
        if (!tokens_.expect("=", "after the parameter's name", "the syntax is --set name=value") ||
            !expressions_.expression()) {
            return false;
        }
        if (!tokens_.at_end()) {
            tokens_.expected(
                "the end of the value",
                "combine its parts with operators; use a separate --set for each parameter");
            return false;
        }
        return true;
    }

private:
    static Tokens read_tokens(SyntaxTree& tree, Reporter& reporter) {
        Tokens read = tokenize(tree.source, reporter);
        tree.comments = std::move(read.comments);
        return read;
    }

    // ------------------------------------------------------------------------- the file itself

    void add_let(Statement let) {
        tree_.broken = tree_.broken || let.let().name.text.empty();
        tree_.items.emplace_back(std::move(let));
    }

    void stray_item() {
        tree_.broken = true;
        const Token& token = tokens_.peek();
        const bool opens_statement = find_statement(token, Block::camera) != nullptr ||
                                     find_statement(token, Block::picture) != nullptr;
        const bool camera_follows = looks_like_camera();
        if (opens_statement) {
            tokens_.error(token.span,
                          fmt::format("'{}' is outside of any camera or picture", token.text),
                          "move it into the braces of camera name { ... }");
        } else if (is_unmarked_camera()) {
            tokens_.error(token.span, "a camera needs the word 'camera'",
                          fmt::format("write 'camera' before '{}'", token.text));
            skip_to_item();
            return;
        } else if (const std::size_t at = unmarked_let()) {
            tokens_.error(token.span, "a value or a function needs the word 'let'",
                          at > 1 ? fmt::format("write 'let' instead of '{}'", token.text)
                                 : fmt::format("write 'let' before '{}'", token.text));
            if (at > 1) {
                tokens_.next();
            }
            tree_.items.emplace_back(statements_.unmarked_let());
            return;
        } else if (token.kind == TokenKind::name) {
            tokens_.expected("'import', 'let', 'camera' or 'picture'", item_remedy(token.text));
        } else {
            tokens_.expected("'import', 'let', 'camera' or 'picture'",
                             "the syntax is camera name { ... }");
        }
        if (camera_follows) {
            camera();
            return;
        }
        // One message for everything up to the next item.
        int braces = 0;
        do {
            braces += tokens_.peek().is("{") ? 1 : tokens_.peek().is("}") ? -1 : 0;
            tokens_.next();
        } while (!tokens_.at_end() && !(is_file_keyword(tokens_.peek()) || looks_like_camera() ||
                                        (braces <= 0 && tokens_.peek().is_name("let"))));
    }

    // What follows a name and, if there are some, the parentheses behind it.
    [[nodiscard]] const Token& after_name(std::size_t at) const {
        const Token& next = tokens_.peek(at + 1);
        return next.is("(") ? tokens_.behind_parentheses(at + 1) : next;
    }

    // name = or name(x) =, alone or after a word such as `var` or `def`: the number of tokens up to
    // the name and with it; 0 if it is something else.
    [[nodiscard]] std::size_t unmarked_let() const {
        for (const std::size_t at : {std::size_t{0}, std::size_t{1}}) {
            if (tokens_.peek(at).kind != TokenKind::name) {
                return 0;
            }
            if (after_name(at).is("=")) {
                return at + 1;
            }
        }
        return 0;
    }

    // name = name(name =, since functions take no names.
    [[nodiscard]] bool is_unmarked_camera() const {
        const auto is_name = [this](std::size_t at) {
            return tokens_.peek(at).kind == TokenKind::name;
        };
        return is_name(0) && tokens_.peek(1).is("=") && is_name(2) && tokens_.peek(3).is("(") &&
               is_name(4) && tokens_.peek(5).is("=") && !tokens_.peek(2).is_name("keys");
    }

    // word name { or word name(...) {, where the word is probably a misspelled `camera`.
    [[nodiscard]] bool looks_like_camera() const {
        return tokens_.peek().kind == TokenKind::name && tokens_.peek(1).kind == TokenKind::name &&
               after_name(1).is("{") && find_statement(tokens_.peek(), Block::camera) == nullptr;
    }

    void import() {
        const Span begin = tokens_.next().span;
        const Token& token = tokens_.peek();
        if (token.kind != TokenKind::text) {
            // The point of an unquoted file name has been reported.
            if (tokens_.peek(1).kind != TokenKind::stray) {
                tokens_.expected(
                    "a file name in quotation marks after 'import'",
                    fmt::format("for example import \"{}.cam\"",
                                token.kind == TokenKind::name ? token.text : "lengths"));
            }
            skip_to_item();
            tree_.items.emplace_back(Import{begin, {}, true});
            return;
        }
        tokens_.next();
        tree_.items.emplace_back(
            Import{{begin.begin, token.span.end}, {token.text, token.span}, false});
    }

    void skip_to_item() {
        while (!tokens_.at_end() && !is_file_keyword(tokens_.peek()) &&
               !tokens_.peek().is_name("let")) {
            tokens_.next();
        }
    }

    // ---------------------------------------------------------------------------------- camera

    void camera() {
        DefinitionSyntax camera;
        camera.is_picture = tokens_.peek().is_name("picture");
        const std::string_view what = camera.is_picture ? "picture" : "camera";
        camera.span = tokens_.next().span;
        camera.name = {"", camera.span};
        statements_.enter(camera.is_picture);
        const std::size_t errors_before = reporter_.error_count();
        if (const auto name = statements_.new_name(fmt::format("a name for the {}", what))) {
            camera.name = *name;
        }
        if (tokens_.peek().is("(")) {
            statements_.parameters(camera);
        }
        if (camera.is_picture && tokens_.peek().kind == TokenKind::number) {
            size(camera);
        }
        tokens_.mute(reporter_.error_count() > errors_before);
        if (!size_failed_ && is_derived()) {
            base(camera, what);
        } else if (!tokens_.peek().is("{")) {
            missing_brace(camera, what);
        }
        tokens_.mute(false);
        camera.broken = camera.broken || reporter_.error_count() > errors_before;
        if (tokens_.peek().is("{")) {
            camera.statements =
                statements_.block(camera.is_picture ? Block::picture : Block::camera);
        }
        // With an unread statement, nothing is said to be missing.
        if (camera.broken) {
            Statement unread;
            unread.broken = true;
            camera.statements.push_back(std::move(unread));
        }
        camera.span.end = tokens_.previous().span.end;
        statements_.enter(false);
        tree_.items.emplace_back(std::move(camera));
    }

    // camera wide = fisheye(fov = 200deg), or a word of other languages instead of the '='.
    [[nodiscard]] bool is_derived() const {
        constexpr std::array<std::string_view, 6> words{"extends", "inherits", "from",
                                                        "is",      "of",       "like"};
        const Token& token = tokens_.peek();
        return (token.is("=") && !tokens_.peek(1).is("{")) || token.is(":") ||
               (token.kind == TokenKind::name &&
                std::find(words.begin(), words.end(), token.text) != words.end());
    }

    // The camera that this one is made of, with values of its parameters, and nothing else: other
    // spellings are answered with this one, which has the values that they give.
    void base(DefinitionSyntax& camera, std::string_view what) {
        const Token word = tokens_.next();
        const std::string expected = fmt::format("the name of a {}", what);
        const bool given =
            (tokens_.peek().kind == TokenKind::name || tokens_.peek().kind == TokenKind::text) &&
            !is_file_keyword(tokens_.peek());
        if (!given) {
            tokens_.expected(expected, "for example camera wide = fisheye(fov = 200deg)");
        }
        const auto call = given ? expressions_.stage(expected) : std::nullopt;
        if (!call) {
            camera.broken = true;
            skip_to_item();
            return;
        }
        camera.base = *call;
        const Token opening = tokens_.peek();
        const bool has_block = opening.is("{");
        if (word.is("=") && camera.parameters.empty() && camera.size.empty() && !has_block) {
            return;
        }
        std::vector<std::string> values = values_of(camera, tree_[*call]);
        const bool has_statements = has_block && skip_block(values);
        const std::string_view name = tree_[*call].name.text;
        tokens_.error(
            !word.is("=") ? word.span
            : has_block   ? opening.span
                          : camera.name.span,
            fmt::format("a {0} that is made of another {0} is written with '=' and values of its "
                        "parameters alone",
                        what),
            fmt::format("write {} {} = {}{}{}{}", what, camera.name.text, name,
                        values.empty() ? "" : "(", fmt::join(values, ", "),
                        values.empty() ? ", with values behind it: (NAME = VALUE)" : ")") +
                (has_statements ? fmt::format("; for other statements, write a {} of its own with "
                                              "those that 'balcony explain {}' shows",
                                              what, name)
                                : ""));
    }

    // fov = 200deg: what a call gives, with the defaults of parameters instead of their names, and
    // the other parameters.
    [[nodiscard]] std::vector<std::string> values_of(const DefinitionSyntax& camera,
                                                     const Expression& call) const {
        std::map<std::string_view, std::string_view> defaults;
        for (const DefinitionParameter& parameter : camera.parameters) {
            if (parameter.default_value.valid()) {
                defaults.emplace(parameter.name.text, text_of(parameter.default_value));
            }
        }
        std::vector<std::string> values;
        std::set<std::string_view> passed;
        for (const Argument& argument : call.arguments) {
            const std::string_view written = text_of(argument.value);
            const auto known = defaults.find(written);
            passed.insert(written);
            values.push_back(fmt::format("{}{}{}", argument.name ? argument.name->text : "",
                                         argument.name ? " = " : "",
                                         known == defaults.end() ? written : known->second));
        }
        for (const auto& [name, written] : defaults) {
            if (!passed.contains(name)) {
                values.push_back(fmt::format("{} = {}", name, written));
            }
        }
        return values;
    }

    [[nodiscard]] std::string_view text_of(ExpressionId id) const {
        return tree_.text(tree_[id].span);
    }

    // Skips a block and adds the values that it gives to parameters: name = value, name: value or
    // let name = value. Returns whether there is anything else in it.
    bool skip_block(std::vector<std::string>& values) {
        const bool muted = tokens_.muted();
        tokens_.mute(true);
        tokens_.next();
        bool has_statements = false;
        while (!tokens_.at_end() && !tokens_.peek().is("}") && !is_file_keyword(tokens_.peek())) {
            if (tokens_.peek().is_name("let") || tokens_.peek().is(",")) {
                tokens_.next();
                continue;
            }
            const Token name = tokens_.next();
            const bool is_value = name.kind == TokenKind::name &&
                                  find_statement(name, Block::camera) == nullptr &&
                                  (tokens_.peek().is("=") || tokens_.peek().is(":"));
            if (!is_value) {
                has_statements = true;
                skip_line();
                continue;
            }
            tokens_.next();
            if (const auto value = expressions_.expression()) {
                values.push_back(fmt::format("{} = {}", name.text, text_of(*value)));
            } else {
                skip_line();
            }
        }
        tokens_.accept("}");
        tokens_.mute(muted);
        return has_statements;
    }

    // Up to the next line or the end of the block.
    void skip_line() {
        int braces = 0;
        while (!tokens_.at_end() &&
               (braces > 0 || !(tokens_.peek().is("}") || tokens_.at_new_line()))) {
            braces += tokens_.peek().is("{") ? 1 : tokens_.peek().is("}") ? -1 : 0;
            tokens_.next();
        }
    }

    // What follows a name instead of the opening brace is skipped up to the brace.
    void missing_brace(DefinitionSyntax& camera, std::string_view what) {
        camera.broken = true;
        const Token& token = tokens_.peek();
        const std::string syntax = fmt::format(
            "the syntax is {} name {{ ... }}; names consist of letters, digits and _", what);
        const bool on_line = token.kind == TokenKind::name && !tokens_.at_new_line();
        if (size_failed_) {
            size_failed_ = false;
        } else if (on_line) {
            tokens_.error(
                {camera.name.span.begin, token.span.end},
                fmt::format("the name of a {} is one word", what),
                fmt::format("write {} {}_{} {{ ... }}", what, camera.name.text, token.text));
            tokens_.next();
        } else {
            tokens_.expected(fmt::format("'{{' to start the {}", what), syntax);
        }
        while (!tokens_.at_end() && !tokens_.peek().is("{") &&
               (!is_file_keyword(tokens_.peek()) || !tokens_.at_new_line())) {
            tokens_.next();
        }
    }

    // 1920 x 1080
    void size(DefinitionSyntax& picture) {
        size_failed_ = true;
        const auto width = expressions_.expression();
        if (!width) {
            return;
        }
        if (!tokens_.peek().is_name("x")) {
            tokens_.expected("'x' and the height of the picture", "for example 1920 x 1080");
            return;
        }
        tokens_.next();
        if (const auto height = expressions_.expression()) {
            picture.size = {*width, *height};
            size_failed_ = false;
        }
    }

    SyntaxTree& tree_;
    TokenStream tokens_;
    ExpressionParser expressions_;
    StatementParser statements_;
    Reporter& reporter_;
    bool size_failed_ = false;  // That of the current picture; it has been reported.
};

}  // namespace

SyntaxTree parse(std::shared_ptr<const SourceText> source, const camera::Catalogue& catalogue,
                 Reporter& reporter) {
    SyntaxTree tree;
    tree.source = std::move(source);
    Parser(tree, catalogue, reporter).file();
    return tree;
}

SyntaxTree parse_override(std::shared_ptr<const SourceText> source,
                          const camera::Catalogue& catalogue, Reporter& reporter) {
    SyntaxTree tree;
    tree.source = std::move(source);
    if (!Parser(tree, catalogue, reporter).override_value()) {
        tree.expressions.clear();
    }
    return tree;
}

}  // namespace balcony::lang
