// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/syntax/lexer.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <set>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool begins_name(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool continues_name(char c) { return begins_name(c) || is_digit(c); }
bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool is_ascii(char c) { return static_cast<unsigned char>(c) < 0x80; }

// Longer symbols first.
constexpr std::array<std::string_view, 24> symbols = {
    "..", "<=", ">=", "==", "!=", "&&", "||", "(", ")", "{", "}", "[",
    "]",  ",",  "=",  "+",  "-",  "*",  "/",  "^", "<", ">", "!", ":"};

// The length of the first code point of the bytes; 0 if they are not UTF-8.
std::size_t code_point_length(std::string_view bytes) {
    const auto lead = static_cast<unsigned char>(bytes.front());
    const std::size_t length = lead < 0x80                    ? 1
                               : lead >= 0xc2 && lead <= 0xdf ? 2
                               : lead >> 4U == 14             ? 3
                               : lead >= 0xf0 && lead <= 0xf4 ? 4
                                                              : 0;
    if (length == 0 || length > bytes.size()) {
        return 0;
    }
    const auto continues = [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) == 0x80U; };
    return std::all_of(bytes.begin() + 1, bytes.begin() + static_cast<std::ptrdiff_t>(length),
                       continues)
               ? length
               : 0;
}

class Lexer {
public:
    Lexer(const std::shared_ptr<const SourceText>& source, Reporter& reporter)
        : source_(source), text_(source->text()), reporter_(reporter) {}

    Tokens run() {
        if (is_text()) {
            while (at_ < text_.size()) {
                step();
            }
        } else {
            tokens_.cut_short = true;
        }
        // The end token follows the last token, so that a message about it shows a line with
        // text.
        const std::size_t end = tokens_.tokens.empty() ? 0 : tokens_.tokens.back().span.end;
        tokens_.tokens.push_back({TokenKind::end, {end, end}, {}, 0.0, NumberUnit::none});
        return std::move(tokens_);
    }

private:
    void error(std::size_t begin, std::size_t end, std::string message, std::string remedy = {}) {
        reporter_.error({source_, begin, end}, std::move(message), std::move(remedy));
    }

    void push(TokenKind kind, std::size_t begin) {
        tokens_.tokens.push_back(
            {kind, {begin, at_}, text_.substr(begin, at_ - begin), 0.0, NumberUnit::none});
    }

    bool is_text() {
        for (std::size_t i = 0; i < text_.size();) {
            const std::size_t length = code_point_length(text_.substr(i));
            if (length == 0 || text_[i] == '\0') {
                error(i, i + 1,
                      fmt::format("'{}' is not a text file: its byte {} is {}", source_->name(),
                                  i + 1, text_[i] == '\0' ? "zero" : "not UTF-8"),
                      "a camera file is plain text in UTF-8");
                return false;
            }
            i += length;
        }
        return true;
    }

    [[nodiscard]] char peek(std::size_t ahead = 0) const {
        return at_ + ahead < text_.size() ? text_[at_ + ahead] : '\0';
    }

    void step() {
        const char c = peek();
        if (is_space(c)) {
            ++at_;
        } else if (text_.substr(at_).starts_with("//")) {
            line_comment();
        } else if (text_.substr(at_).starts_with("/*")) {
            block_comment();
        } else if (begins_name(c)) {
            const std::size_t begin = at_;
            skip_name();
            push(TokenKind::name, begin);
        } else if (is_digit(c) || (c == '.' && is_digit(peek(1)))) {
            number();
        } else if (c == '"') {
            quoted();
        } else if (!symbol()) {
            stray();
        }
    }

    void skip_name() {
        while (continues_name(peek())) {
            ++at_;
        }
    }

    void line_comment() {
        const std::size_t begin = at_;
        at_ = std::min(text_.find('\n', at_), text_.size());
        const bool carriage_return = text_[at_ - 1] == '\r';
        tokens_.comments.push_back({begin, at_ - (carriage_return ? 1 : 0)});
    }

    void block_comment() {
        const std::size_t begin = at_;
        const std::size_t close = text_.find("*/", at_ + 2);
        if (close == std::string_view::npos) {
            error(begin, begin + 2, "this comment is not closed", "end it with */");
            tokens_.cut_short = true;
            at_ = text_.size();
            return;
        }
        at_ = close + 2;
        tokens_.comments.push_back({begin, at_});
    }

    void quoted() {
        const std::size_t begin = at_;
        const std::size_t line_end = std::min(text_.find('\n', at_), text_.size());
        const std::size_t close = text_.find('"', at_ + 1);
        if (close >= line_end) {
            error(begin, begin + 1, "this quotation mark is not closed on its line",
                  "close the file name with \"");
            at_ = line_end;
            push(TokenKind::stray, begin);
            return;
        }
        at_ = close + 1;
        push(TokenKind::text, begin);
        Token& token = tokens_.tokens.back();
        token.text = token.text.substr(1, token.text.size() - 2);
    }

    void skip_digits() {
        while (is_digit(peek())) {
            ++at_;
        }
    }

    // A point belongs to the number unless it starts '..'; an e only if an exponent follows.
    void number() {
        const std::size_t begin = at_;
        skip_digits();
        if (peek() == '.' && peek(1) != '.') {
            ++at_;
            skip_digits();
        }
        if (peek() == 'e' || peek() == 'E') {
            const std::size_t sign = peek(1) == '+' || peek(1) == '-' ? 1 : 0;
            if (is_digit(peek(1 + sign))) {
                at_ += 1 + sign;
                skip_digits();
            }
        }
        if (peek() == '.' && is_digit(peek(1))) {
            ++at_;
            skip_digits();
            push(TokenKind::stray, begin);
            error(begin, at_, "this number has two decimal points",
                  "remove one; a range is written 0.5 .. 1");
            return;
        }
        const std::size_t digits_end = at_;
        if (percent_or_degree(begin)) {
            return;
        }
        // 800x600: the size of a picture.
        if (peek() != 'x' || !is_digit(peek(1))) {
            skip_name();
        }
        push(TokenKind::number, begin);
        convert(tokens_.tokens.back(), digits_end);
        if (at_ == digits_end && peek() == 'x' && is_digit(peek(1))) {
            ++at_;
            push(TokenKind::name, digits_end);
        }
    }

    // 50% and 30° are one mistake with their number, reported at the first of each kind.
    bool percent_or_degree(std::size_t begin) {
        constexpr std::string_view degree = "\xc2\xb0";
        const std::string_view rest = text_.substr(at_);
        const std::string_view digits = text_.substr(begin, at_ - begin);
        if (rest.starts_with(degree)) {
            at_ += degree.size();
            error_once(begin, "'\xc2\xb0' is not part of the language",
                       fmt::format("write {}deg", digits));
        } else if (rest.starts_with("%") && !continues_operand(at_ + 1)) {
            ++at_;
            error_once(begin, "'%' is not part of the language", "write a fraction, 0.5 for 50 %");
        } else {
            return false;
        }
        push(TokenKind::stray, begin);
        return true;
    }

    // Whether an operand follows on the line, so that % is a remainder.
    [[nodiscard]] bool continues_operand(std::size_t at) const {
        while (at < text_.size() && text_[at] == ' ') {
            ++at;
        }
        return at < text_.size() && (continues_name(text_[at]) || text_[at] == '(');
    }

    void error_once(std::size_t begin, std::string message, std::string remedy) {
        if (said_.insert(message).second) {
            error(begin, at_, std::move(message), std::move(remedy));
        }
    }

    void convert(Token& token, std::size_t digits_end) {
        const std::size_t begin = token.span.begin;
        const std::string_view digits = text_.substr(begin, digits_end - begin);
        const auto [end, status] =
            std::from_chars(digits.data(), digits.data() + digits.size(), token.value);
        if (status != std::errc()) {
            error(begin, digits_end, "this number cannot be represented",
                  "the range of numbers is about 1e-308 to 1e308");
            token.kind = TokenKind::stray;
        }
        const std::string_view unit = text_.substr(digits_end, at_ - digits_end);
        if (unit == "deg" || unit == "rad") {
            token.unit = unit == "deg" ? NumberUnit::degrees : NumberUnit::radians;
        } else if (unit == "px") {
            error_once(begin, "there is no unit 'px'",
                       "write the size of a picture as 1920 x 1080; positions and widths in a "
                       "picture are fractions, such as 0.5 for its middle");
            token.kind = TokenKind::stray;
        } else if (!unit.empty()) {
            const bool angle = nearest_name(unit, {"deg", "rad", "degrees", "radians"}).has_value();
            error(digits_end, at_, fmt::format("unknown unit '{}'", unit),
                  angle ? "angles are written 30deg or 0.5rad"
                        : fmt::format("angles are written 30deg or 0.5rad, lengths {}, in units of "
                                      "the scene, products {}*{}",
                                      digits, digits, unit));
            token.kind = TokenKind::stray;
        }
    }

    bool symbol() {
        for (const std::string_view symbol : symbols) {
            if (text_.substr(at_).starts_with(symbol)) {
                const std::size_t begin = at_;
                at_ += symbol.size();
                push(TokenKind::symbol, begin);
                return true;
            }
        }
        return false;
    }

    void stray() {
        const std::size_t begin = at_;
        if (peek() == ';') {
            ++at_;
            error(begin, at_, "';' is not needed",
                  "remove it: a statement ends where the next one starts");
            return;
        }
        const bool ascii = is_ascii(peek());
        do {
            at_ += code_point_length(text_.substr(at_));
        } while (!ascii && at_ < text_.size() && !is_ascii(peek()));
        const std::string_view what = text_.substr(begin, at_ - begin);
        const bool third_point = what == "." && begin > 0 && text_[begin - 1] == '.';
        error(begin, at_, fmt::format("'{}' is not part of the language", what),
              third_point ? "write a range with two dots, 0 .. 1" : remedy_for(what));
        push(TokenKind::stray, begin);
    }

    static std::string remedy_for(std::string_view what) {
        struct Instead {
            std::string_view written, meant;
        };
        constexpr std::array<Instead, 15> instead = {
            {{".", "\"vase.obj\", in quotation marks, for a file name; 0.5 for a number"},
             {"\\", "'/' between a folder and a file"},
             {"%", "mod(a, b) for a remainder, 0.5 for 50 %"},
             {"?", "if(condition, a, b) for a choice"},
             {"#", "// for a comment, import \"file.cam\" for a file"},
             {"&", "'&&'"},
             {"|", "'||'"},
             {"\xc2\xb0", "30deg for an angle"},
             {"\xe2\x88\x92", "'-'"},
             {"\xe2\x80\x93", "'-'"},
             {"\xc3\x97", "'*'"},
             {"\xc2\xb7", "'*'"},
             {"\xcf\x80", "'pi'"},
             {"\xe2\x80\xa6", "'..'"},
             {"'", "\" around a file name"}}};
        for (const Instead& row : instead) {
            if (row.written == what) {
                return fmt::format("write {}", row.meant);
            }
        }
        return is_ascii(what.front()) ? "remove it"
                                      : "names consist of the letters a to z and A to Z, digits "
                                        "and _; comments may contain any character";
    }

    const std::shared_ptr<const SourceText>& source_;
    std::string_view text_;
    Reporter& reporter_;
    Tokens tokens_;
    std::set<std::string> said_;  // Messages of error_once().
    std::size_t at_ = 0;
};

}  // namespace

Tokens tokenize(const std::shared_ptr<const SourceText>& source, Reporter& reporter) {
    return Lexer(source, reporter).run();
}

}  // namespace balcony::lang
