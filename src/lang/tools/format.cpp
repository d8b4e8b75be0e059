// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Prints a camera file in the standard layout: the same tokens and comments in the same order, one
// statement per line, arguments aligned, long lines broken after commas.

#include <algorithm>
#include <array>
#include <set>

#include <fmt/format.h>

#include "balcony/lang.hpp"
#include "lang/syntax/lexer.hpp"
#include "lang/syntax/parser.hpp"
#include "lang/syntax/read_source.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

constexpr std::size_t max_line = 100;
constexpr std::size_t indent_step = 4;

// A token or a comment with its layout.
struct Piece {
    std::string_view text;
    bool space = false;          // Preceded by a space, unless it starts a line.
    bool comma = false;          // A line may be broken after it.
    bool sum = false;            // An operator with spaces: a line may be broken before it.
    bool opens = false;          // ( or [
    bool closes = false;         // ) or ]
    bool on_new_line = false;    // It started a line in the source.
    bool breaks_before = false;  // A comment on its own line.
    bool breaks_after = false;   // A // comment.
};

// A statement, the head of a block, a closing brace, or comments.
struct Line {
    std::vector<Piece> pieces;
    std::size_t depth = 0;
    bool blank_before = false;
    bool statement = false;  // Starts with a keyword whose arguments are aligned.
    bool opens_block = false;
    bool closes_block = false;
    bool comment = false;
};

std::size_t length(std::string_view text) {
    // Counts code points: a UTF-8 continuation byte starts with the bits 10.
    return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
        return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U;
    }));
}

// ---------------------------------------------------------------------------------------- spaces

bool is_any(const Token& token, std::initializer_list<std::string_view> symbols) {
    return std::any_of(symbols.begin(), symbols.end(),
                       [&token](std::string_view symbol) { return token.is(symbol); });
}

bool ends_operand(const Token& token) {
    return token.kind == TokenKind::name || token.kind == TokenKind::number ||
           token.kind == TokenKind::text || is_any(token, {")", "]"});
}

enum class Role { plain, sign, tight, loose };

// The role of an operator: a prefix, or between two operands with or without spaces.
Role role_of(const Token& token, const Token* previous, bool previous_is_keyword) {
    const bool between = previous != nullptr && ends_operand(*previous) && !previous_is_keyword;
    if (is_any(token, {"-", "!"}) && !between) {
        return Role::sign;
    }
    if (is_any(token, {"*", "/", "^"})) {
        return Role::tight;
    }
    if (is_any(token, {"+", "-", "=", "..", "==", "!=", "<", "<=", ">", ">=", "&&", "||"})) {
        return Role::loose;
    }
    return Role::plain;
}

struct Previous {
    const Token* token = nullptr;
    Role role = Role::plain;
    bool keyword = false;  // The word that starts a statement, or one between operands.
    bool call = false;     // The word that starts a statement that is written as a call.
};

bool space_before(const Token& token, Role role, const Previous& previous) {
    if (previous.token == nullptr || previous.role == Role::sign || previous.role == Role::tight ||
        is_any(*previous.token, {"(", "["}) || is_any(token, {",", ")", "]"})) {
        return false;
    }
    if (role == Role::tight) {
        return false;
    }
    const bool call = token.is("(") && previous.token->kind == TokenKind::name && !previous.keyword;
    const bool element = token.is("[") && ends_operand(*previous.token) && !previous.keyword &&
                         !previous.token->is_name("in");
    return !call && !element;
}

// ------------------------------------------------------------------------------- cutting into
// lines

void add_starts(const std::vector<Statement>& statements, std::set<std::size_t>& starts) {
    for (const Statement& statement : statements) {
        starts.insert(statement.span.begin);
        add_starts(statement.block, starts);
    }
}

// Where statements and items start.
std::set<std::size_t> starts_in(const SyntaxTree& tree) {
    std::set<std::size_t> starts;
    for (const Item& item : tree.items) {
        std::visit([&](const auto& one) { starts.insert(one.span.begin); }, item);
        if (const auto* camera = std::get_if<DefinitionSyntax>(&item)) {
            add_starts(camera->statements, starts);
        } else if (const auto* let = std::get_if<Statement>(&item)) {
            add_starts(let->block, starts);
        }
    }
    return starts;
}

bool is_call(const StatementRow* row) { return row != nullptr && row->shape == Shape::call; }

class Cutter {
public:
    Cutter(const SyntaxTree& tree, const Tokens& read)
        : text_(tree.source->text()), starts_(starts_in(tree)), read_(read) {}

    std::vector<Line> run() {
        std::size_t comment = 0;
        for (std::size_t i = 0; i < read_.tokens.size(); ++i) {
            const Token& token = read_.tokens[i];
            while (comment < read_.comments.size() &&
                   read_.comments[comment].begin < token.span.begin) {
                add_comment(read_.comments[comment++], token);
            }
            if (token.kind != TokenKind::end) {
                add(token);
            }
        }
        while (comment < read_.comments.size()) {
            add_comment(read_.comments[comment++], read_.tokens.back());
        }
        return std::move(lines_);
    }

private:
    [[nodiscard]] std::ptrdiff_t line_breaks_since(std::size_t end) const {
        const std::string_view between = text_.substr(last_end_, end - last_end_);
        return std::count(between.begin(), between.end(), '\n');
    }

    Line& new_line(std::size_t begin) {
        const bool after_block = depth_ == 0 && !lines_.empty() && lines_.back().closes_block;
        Line line;
        line.depth = depth_;
        line.blank_before = !lines_.empty() && !lines_.back().opens_block &&
                            (after_block || line_breaks_since(begin) > 1);
        lines_.push_back(std::move(line));
        previous_ = {};
        line_ended_ = false;
        return lines_.back();
    }

    [[nodiscard]] bool begins_line(const Token& token) const {
        return lines_.empty() || line_ended_ || starts_.contains(token.span.begin) || token.is("}");
    }

    void add(const Token& token) {
        if (token.is("}")) {
            depth_ -= depth_ > 0 ? 1 : 0;
        }
        const bool first = begins_line(token);
        if (first) {
            Line& line = new_line(token.span.begin);
            line.closes_block = token.is("}");
            line.statement = depth_ > 0 && !line.closes_block;
            // No blank line precedes the end of a block; one precedes its start, unless comments
            // do.
            line.blank_before = line.blank_before && !line.closes_block;
            const bool below_comment = lines_.size() > 1 && lines_[lines_.size() - 2].comment;
            if (token.is_name("camera") || token.is_name("picture")) {
                line.blank_before = line.blank_before || (lines_.size() > 1 && !below_comment);
            }
        }
        Piece piece;
        piece.text = text_.substr(token.span.begin, token.span.end - token.span.begin);
        const Role role = role_of(token, previous_.token, previous_.keyword);
        piece.space = space_before(token, role, previous_);
        piece.comma = token.is(",");
        piece.on_new_line = !first && line_breaks_since(token.span.begin) > 0;
        piece.opens = is_any(token, {"(", "["});
        piece.closes = is_any(token, {")", "]"});
        piece.sum = role == Role::loose && !token.is("=");
        lines_.back().pieces.push_back(piece);
        // Some statements are written as a call; others have their content after a space.
        const bool call = is_call(find_statement(token, Block::picture)) ||
                          is_call(find_statement(token, Block::camera));
        // A word behind an operand, such as `from` of limits, is no operand.
        const bool word = token.kind == TokenKind::name && previous_.token != nullptr &&
                          ends_operand(*previous_.token) && !previous_.keyword && !previous_.call;
        previous_ = {&token, role, (first && !call) || word, first && call};
        if (token.is("{")) {
            ++depth_;
            lines_.back().opens_block = true;
            lines_.back().statement = false;
        }
        line_ended_ = is_any(token, {"{", "}"});
        last_end_ = token.span.end;
    }

    // After the code in its line, on a separate line, or inside a statement.
    void add_comment(const Span& span, const Token& next) {
        const bool trails = !lines_.empty() && line_breaks_since(span.begin) == 0;
        const bool between = lines_.empty() || lines_.back().comment || line_ended_ ||
                             starts_.contains(next.span.begin) || next.is("}") ||
                             next.kind == TokenKind::end;
        if (!trails && between) {
            new_line(span.begin).comment = true;
        }
        Piece piece;
        piece.text = text_.substr(span.begin, span.end - span.begin);
        piece.text = piece.text.substr(0, piece.text.find_last_not_of(" \t\r") + 1);
        piece.space = true;
        piece.breaks_before = !trails;
        piece.breaks_after = piece.text.starts_with("//");
        lines_.back().pieces.push_back(piece);
        last_end_ = span.end;
    }

    std::string_view text_;
    const std::set<std::size_t> starts_;
    const Tokens& read_;
    std::vector<Line> lines_;
    Previous previous_;
    std::size_t depth_ = 0;
    std::size_t last_end_ = 0;
    bool line_ended_ = false;
};

// -------------------------------------------------------------------------------- printing a line

// Consecutive statements have their arguments in one column, given by the longest keyword.
std::vector<std::size_t> argument_columns(const std::vector<Line>& lines) {
    std::vector<std::size_t> columns(lines.size(), 0);
    for (std::size_t begin = 0; begin < lines.size();) {
        std::size_t end = begin;
        std::size_t longest = 0;
        while (end < lines.size() && (lines[end].statement || lines[end].comment) &&
               lines[end].depth == lines[begin].depth &&
               (end == begin || !lines[end].blank_before)) {
            if (lines[end].statement) {
                longest = std::max(longest, length(lines[end].pieces.front().text));
            }
            ++end;
        }
        end = std::max(end, begin + 1);
        for (std::size_t i = begin; i < end; ++i) {
            columns[i] = lines[i].depth * indent_step + longest + 1;
        }
        begin = end;
    }
    return columns;
}

class LinePrinter {
public:
    LinePrinter(const Line& line, std::size_t argument_column, std::string& out)
        : pieces_(line.pieces), argument_column_(argument_column), out_(out) {
        column_ = line.depth * indent_step;
        out_.append(column_, ' ');
        aligned_ = line.statement;
        continuation_ = line.statement ? argument_column : column_ + indent_step;
    }

    void run() {
        for (std::size_t i = 0; i < pieces_.size(); ++i) {
            print(i);
        }
    }

private:
    struct Bracket {
        std::size_t column;  // After it.
        bool of_list;
    };

    void print(std::size_t i) {
        const Piece& piece = pieces_[i];
        if (i > 0 && must_break(i)) {
            column_ = brackets_.empty() ? continuation_ : brackets_.back().column;
            out_ += '\n';
            out_.append(column_, ' ');
        } else if (i == 1 && aligned_ && piece.space && !is_comment(piece)) {
            const std::size_t gap = argument_column_ - column_;
            out_.append(gap, ' ');
            column_ += gap;
        } else if (i > 0 && piece.space) {
            const std::size_t gap = is_comment(piece) ? 2 : 1;
            out_.append(gap, ' ');
            column_ += gap;
        }
        out_ += piece.text;
        column_ += length(piece.text);
        if (piece.opens) {
            brackets_.push_back({column_, piece.text == "["});
        } else if (piece.closes && !brackets_.empty()) {
            brackets_.pop_back();
        }
    }

    static bool is_comment(const Piece& piece) {
        return piece.text.starts_with("//") || piece.text.starts_with("/*");
    }

    [[nodiscard]] bool must_break(std::size_t i) const {
        const Piece& piece = pieces_[i];
        const Piece& before = pieces_[i - 1];
        if (before.breaks_after || piece.breaks_before) {
            return true;
        }
        // The rows of a list, such as a control net, keep the author's line breaks.
        if (before.comma && piece.on_new_line && !brackets_.empty() && brackets_.back().of_list) {
            return true;
        }
        const bool may_break = before.comma || piece.sum;
        return may_break && !is_comment(piece) &&
               column_ + (piece.space ? 1 : 0) + width_of_element(i) > max_line;
    }

    // Up to the next possible line break at this bracket depth, or the closing bracket, or until it
    // fits no line.
    [[nodiscard]] std::size_t width_of_element(std::size_t i) const {
        std::size_t width = 0;
        std::size_t depth = 0;
        const bool of_list = pieces_[i - 1].comma;
        for (std::size_t k = i; k < pieces_.size() && width <= max_line && !is_comment(pieces_[k]);
             ++k) {
            const Piece& piece = pieces_[k];
            const bool next_operand = !of_list && k > i && depth == 0 && piece.sum;
            if (next_operand) {
                break;
            }
            width += length(piece.text) + (k > i && piece.space ? 1 : 0);
            depth += piece.opens ? 1 : 0;
            if (depth == 0 && (piece.comma || piece.closes)) {
                break;
            }
            depth -= piece.closes ? 1 : 0;
        }
        return width;
    }

    const std::vector<Piece>& pieces_;
    std::size_t argument_column_;
    std::string& out_;
    std::size_t column_ = 0;
    std::size_t continuation_ = 0;
    bool aligned_ = false;
    std::vector<Bracket> brackets_;
};

}  // namespace

Result<std::string> format(const std::shared_ptr<const SourceText>& source) {
    Reporter reporter;
    const SyntaxTree tree = parse(source, camera::catalogue(), reporter);
    if (reporter.error_count() > 0) {
        return reporter.take();
    }
    const Tokens read = tokenize(source, reporter);
    const std::vector<Line> lines = Cutter(tree, read).run();
    const std::vector<std::size_t> columns = argument_columns(lines);
    std::string out;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        if (lines[i].blank_before) {
            out += '\n';
        }
        LinePrinter(lines[i], columns[i], out).run();
        out += '\n';
    }
    if (out.size() > max_file) {
        return error(
            fmt::format(
                "'{}' would be larger than 1 MB after formatting, the maximum for camera files",
                source->name()),
            {}, "move a part of it to another file and import that file");
    }
    return out;
}

}  // namespace balcony::lang
