// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "lang/expression_parser.hpp"
#include "lang/keywords.hpp"
#include "lang/token_stream.hpp"

namespace balcony::lang {

namespace {

// Names that mean something everywhere.
constexpr std::array<std::string_view, 2> constants = {"pi", "t"};

class Parser {
public:
    Parser(SyntaxTree& tree, Reporter& reporter)
        : tree_(tree),
          tokens_(tree.source, read_tokens(tree, reporter), reporter),
          expressions_(tokens_, tree.expressions),
          reporter_(reporter) {}

    void file() {
        while (!tokens_.at_end() && !reporter_.full()) {
            const Token& token = tokens_.peek();
            if (token.is_name("import")) {
                import();
            } else if (token.is_name("let")) {
                tree_.items.emplace_back(statement(false));
            } else if (token.is_name("camera")) {
                camera();
            } else {
                stray_item();
            }
        }
    }

    bool override_value() {
        if (tokens_.peek().kind != TokenKind::name) {
            tokens_.expected("the name of a parameter", "--set takes name=value");
            return false;
        }
        tokens_.next();
        if (!tokens_.expect("=", "after the parameter's name") || !expressions_.expression()) {
            return false;
        }
        if (!tokens_.at_end()) {
            tokens_.expected("the end of the value");
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

    void stray_item() {
        const Token& token = tokens_.peek();
        const Keyword* statement_keyword = find_keyword(token);
        const bool camera_follows = looks_like_camera();
        if (statement_keyword != nullptr) {
            tokens_.error(token.span, fmt::format("'{}' stands outside of any camera", token.text),
                          "put it between the braces of camera name { ... }");
        } else if (token.kind == TokenKind::name) {
            tokens_.expected("'import', 'let' or 'camera'",
                             suggestion(token.text, {"import", "let", "camera"}, "write"));
        } else {
            tokens_.expected("'import', 'let' or 'camera'");
        }
        if (camera_follows) {
            camera();
            return;
        }
        // One message for all that follows up to the next item.
        int braces = 0;
        do {
            braces += tokens_.peek().is("{") ? 1 : tokens_.peek().is("}") ? -1 : 0;
            tokens_.next();
        } while (!tokens_.at_end() && !(is_file_keyword(tokens_.peek()) || looks_like_camera() ||
                                        (braces <= 0 && tokens_.peek().is_name("let"))));
    }

    // word name { or word name (, with a word that should be camera.
    [[nodiscard]] bool looks_like_camera() const {
        return tokens_.peek().kind == TokenKind::name && tokens_.peek(1).kind == TokenKind::name &&
               (tokens_.peek(2).is("{") || tokens_.peek(2).is("(")) &&
               find_keyword(tokens_.peek()) == nullptr;
    }

    void import() {
        const Span begin = tokens_.next().span;
        const Token& token = tokens_.peek();
        if (token.kind != TokenKind::text) {
            tokens_.expected("a file name in quotation marks after 'import'",
                             "such as import \"lengths.cam\"");
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

    // A name that is being defined. One that is taken is reported and read all the same.
    std::optional<Identifier> new_name(std::string_view what) {
        const Token& token = tokens_.peek();
        const bool constant =
            std::find(constants.begin(), constants.end(), token.text) != constants.end();
        const bool opens_statement = find_keyword(token) != nullptr || is_file_keyword(token);
        const Token& after = tokens_.peek(1);
        const bool meant_as_name = after.is("=") || after.is("{") || after.is("(");
        if (token.kind != TokenKind::name || (opens_statement && !meant_as_name)) {
            tokens_.expected(what);
            return std::nullopt;
        }
        if (constant || opens_statement) {
            tokens_.error(token.span,
                          fmt::format("'{}' is taken: it {}", token.text,
                                      token.text == "t"    ? "is time"
                                      : token.text == "pi" ? "is the number 3.14159..."
                                                           : "opens a statement"),
                          "choose another name");
        }
        tokens_.next();
        return Identifier{token.text, token.span};
    }

    // ---------------------------------------------------------------------------------- camera

    void camera() {
        CameraSyntax camera;
        camera.span = tokens_.next().span;
        camera.name = {"", camera.span};
        if (const auto name = new_name("a name for the camera")) {
            camera.name = *name;
        }
        if (tokens_.peek().is("(")) {
            parameters(camera);
        }
        if (!tokens_.peek().is("{")) {
            tokens_.expected("'{' to begin the camera");
            while (!tokens_.at_end() && !tokens_.peek().is("{") &&
                   !is_file_keyword(tokens_.peek())) {
                tokens_.next();
            }
        }
        if (tokens_.peek().is("{")) {
            camera.statements = statements(false);
        }
        camera.span.end = tokens_.previous().span.end;
        tree_.items.emplace_back(std::move(camera));
    }

    void parameters(CameraSyntax& camera) {
        const Span opening = tokens_.next().span;
        if (tokens_.accept(")")) {
            return;
        }
        do {
            const auto name = new_name("a name for the camera's parameter");
            if (!name) {
                skip_parameters(camera);
                return;
            }
            camera.parameters.push_back({*name, ExpressionId()});
            if (!tokens_.peek().is("=")) {
                tokens_.expected(fmt::format("'=' and a default value for '{}'", name->text),
                                 "every parameter has a default, so that a camera works by itself");
                skip_parameters(camera);
                return;
            }
            tokens_.next();
            const auto value = expressions_.expression();
            if (!value) {
                skip_parameters(camera);
                return;
            }
            camera.parameters.back().default_value = *value;
        } while (tokens_.accept(","));
        if (!tokens_.expect_closing(")", opening)) {
            skip_parameters(camera);
        }
    }

    // Goes to the camera's opening brace. Parameters on the way are taken note of, so that their
    // uses are no errors.
    void skip_parameters(CameraSyntax& camera) {
        int depth = 0;
        while (!tokens_.at_end() && !tokens_.peek().is("{") && !is_file_keyword(tokens_.peek()) &&
               find_keyword(tokens_.peek()) == nullptr) {
            const Token& token = tokens_.next();
            depth += token.is("(") ? 1 : token.is(")") ? -1 : 0;
            if (depth == 0 && token.kind == TokenKind::name && tokens_.peek().is("=")) {
                camera.parameters.push_back({{token.text, token.span}, ExpressionId()});
            }
        }
    }

    // { statements }, for a camera or a path.
    std::vector<Statement> statements(bool in_path) {
        const Span opening = tokens_.next().span;
        std::vector<Statement> read;
        while (!tokens_.at_end() && !tokens_.peek().is("}") && !is_file_keyword(tokens_.peek()) &&
               !reporter_.full()) {
            read.push_back(statement(in_path));
        }
        const bool hidden = tokens_.at_end() && tokens_.at_reported();
        if (!reporter_.full()) {
            tokens_.expect_closing("}", opening);
        }
        if (hidden || reporter_.full()) {
            Statement unread;
            unread.broken = true;
            read.push_back(std::move(unread));
        }
        return read;
    }

    // ------------------------------------------------------------------------------- statement

    Statement statement(bool in_path) {
        const Token& token = tokens_.peek();
        const Keyword* row = find_keyword(token);
        Statement made;
        made.keyword = token.span;
        if (row == nullptr || (in_path ? !row->in_path : !row->in_camera)) {
            made.kind = row != nullptr ? row->kind : unknown_statement(in_path);
            if (row != nullptr) {
                misplaced_statement(*row, in_path);
            }
            made.broken = true;
            tokens_.next();
        } else {
            made.kind = row->kind;
            tokens_.next();
            made.broken = !body(made);
        }
        if (made.broken) {
            skip_statement();
        }
        made.span = {made.keyword.begin, tokens_.previous().span.end};
        return made;
    }

    StatementKind unknown_statement(bool in_path) {
        const Token& token = tokens_.peek();
        const std::vector<std::string> known = keywords_for(in_path);
        if (token.is(")") || token.is("]")) {
            tokens_.error(token.span, fmt::format("this '{}' closes nothing", token.text),
                          "remove it, or add what opens it");
            return StatementKind::unknown;
        }
        if (token.is(",")) {
            tokens_.error(token.span, "this ',' separates nothing",
                          "it stands between the ranges of map and between the stages of warp, "
                          "move and place");
            return StatementKind::unknown;
        }
        if (token.kind != TokenKind::name) {
            tokens_.expected(fmt::format("a statement ({})", one_of(known)));
            return StatementKind::unknown;
        }
        tokens_.error(token.span, fmt::format("there is no statement '{}'", token.text),
                      suggestion(token.text, known, "the statements are"));
        const auto nearest = nearest_name(token.text, known);
        for (const Keyword& row : keywords()) {
            if (nearest && row.text == *nearest) {
                return row.kind;
            }
        }
        return StatementKind::unknown;
    }

    void misplaced_statement(const Keyword& row, bool in_path) {
        if (in_path) {
            tokens_.error(tokens_.peek().span,
                          fmt::format("'{}' cannot stand in a block of eye or toward", row.text),
                          fmt::format("move it out, beside the block; a block holds {}",
                                      one_of(keywords_for(true))));
        } else {
            tokens_.error(tokens_.peek().span,
                          fmt::format("'{}' stands in a block of eye or toward only", row.text),
                          "write eye { object sphere(1) }, or shorter: eye sphere(1)");
        }
    }

    // Goes to the next statement or the brace that ends this block.
    void skip_statement() {
        int braces = 0;
        while (!tokens_.at_end() && !is_file_keyword(tokens_.peek())) {
            const Token& token = tokens_.peek();
            if (braces == 0 && (token.is("}") || find_keyword(token) != nullptr)) {
                return;
            }
            braces += token.is("{") ? 1 : token.is("}") ? -1 : 0;
            tokens_.next();
        }
    }

    bool body(Statement& made) {
        switch (made.kind) {
            case StatementKind::let: return let(made);
            case StatementKind::aspect: return value(made);
            case StatementKind::axes: return axes(made);
            case StatementKind::map: return map(made);
            case StatementKind::eye:
            case StatementKind::toward:
                if (tokens_.peek().is("{")) {
                    made.block = statements(true);
                    return true;
                }
                return stages(made, "an object, such as sphere(1)", false);
            case StatementKind::object: return stages(made, "an object, such as sphere(1)", false);
            case StatementKind::warp:
                return stages(made, "a parameter transformer, such as rotate(10deg)", true);
            case StatementKind::move:
                return stages(made, "an object transformer, such as translate(0, 0, 1)", true);
            case StatementKind::look: return look(made, "a direction rule, such as normal");
            case StatementKind::place: return stages(made, "a picture arranger", true);
            case StatementKind::unknown: break;
        }
        return false;
    }

    bool value(Statement& made) {
        const auto read = expressions_.expression();
        if (read) {
            made.value = *read;
        }
        return read.has_value();
    }

    bool let(Statement& made) {
        const auto name = new_name("a name after 'let'");
        if (!name) {
            return false;
        }
        made.name = *name;
        return tokens_.expect("=", "after the name") && value(made);
    }

    bool axes(Statement& made) {
        const Token& token = tokens_.peek();
        if (token.kind != TokenKind::name || find_keyword(token) != nullptr) {
            tokens_.expected("'z_up' or 'y_up' after 'axes'");
            return false;
        }
        made.name = {token.text, token.span};
        tokens_.next();
        return true;
    }

    bool map(Statement& made) {
        do {
            const Token& coordinate = tokens_.peek();
            if (coordinate.kind != TokenKind::name || find_keyword(coordinate) != nullptr) {
                tokens_.expected("'u' or 'v'", "such as map u = -1 .. 1, v = square");
                return false;
            }
            MapRange range;
            range.coordinate = {coordinate.text, coordinate.span};
            tokens_.next();
            if (!tokens_.expect("=", fmt::format("after '{}'", coordinate.text)) ||
                !range_value(range)) {
                return false;
            }
            range.span = {coordinate.span.begin, tokens_.previous().span.end};
            made.ranges.push_back(range);
        } while (tokens_.accept(","));
        return true;
    }

    bool range_value(MapRange& range) {
        if (tokens_.peek().is_name("square") && !tokens_.peek(1).is("..")) {
            tokens_.next();
            return true;
        }
        if (tokens_.peek().is("[")) {
            tokens_.expected("a range", "a range is written -1 .. 1");
            return false;
        }
        const auto first = expressions_.expression();
        if (!first || !tokens_.expect("..", "between the two ends of the range")) {
            return false;
        }
        const auto last = expressions_.expression();
        if (!last) {
            return false;
        }
        range.first = *first;
        range.last = *last;
        return true;
    }

    bool stages(Statement& made, std::string_view what, bool several) {
        do {
            if (opens_next_statement()) {
                tokens_.expected(what);
                return false;
            }
            const auto stage = expressions_.stage(what);
            if (!stage) {
                return false;
            }
            made.stages.push_back(*stage);
        } while (several && tokens_.accept(","));
        return true;
    }

    bool look(Statement& made, std::string_view what) {
        if (opens_next_statement()) {
            tokens_.expected(what);
            return false;
        }
        const auto rule = expressions_.stage_with_words(what);
        if (rule) {
            made.stages.push_back(*rule);
        }
        return rule.has_value();
    }

    // A stage that has the name of a keyword is written with its parentheses.
    [[nodiscard]] bool opens_next_statement() const {
        return find_keyword(tokens_.peek()) != nullptr && !tokens_.peek(1).is("(");
    }

    SyntaxTree& tree_;
    TokenStream tokens_;
    ExpressionParser expressions_;
    Reporter& reporter_;
};

}  // namespace

SyntaxTree parse(std::shared_ptr<const SourceText> source, Reporter& reporter) {
    SyntaxTree tree;
    tree.source = std::move(source);
    Parser(tree, reporter).file();
    return tree;
}

SyntaxTree parse_override(std::shared_ptr<const SourceText> source, Reporter& reporter) {
    SyntaxTree tree;
    tree.source = std::move(source);
    if (!Parser(tree, reporter).override_value()) {
        tree.expressions.clear();
    }
    return tree;
}

}  // namespace balcony::lang
