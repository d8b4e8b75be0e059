// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/token_places.hpp"

#include <algorithm>

namespace balcony::lang {

namespace {

Tokens tokens_of(const std::shared_ptr<const SourceText>& source) {
    Reporter ignored;
    return tokenize(source, ignored);
}

bool is_definition_word(const Token& token) {
    return token.is_name("camera") || token.is_name("picture");
}

}  // namespace

TokenPlaces::TokenPlaces(const std::shared_ptr<const SourceText>& source)
    : source_(source),
      tokens_(tokens_of(source)),
      at_(tokens().size()),
      after_(tokens().size()),
      closing_(tokens().size(), none),
      blocks_(tokens().size()),
      rows_(tokens().size(), nullptr) {
    std::vector<Frame> frames(1);
    for (std::size_t i = 0; i < tokens().size(); ++i) {
        visit(i, frames);
    }
}

std::size_t TokenPlaces::first_behind(std::size_t offset) const {
    const auto found =
        std::partition_point(tokens().begin(), tokens().end() - 1,
                             [offset](const Token& token) { return token.span.end <= offset; });
    return static_cast<std::size_t>(found - tokens().begin());
}

bool TokenPlaces::at_new_line(std::size_t i) const {
    const std::size_t begin = i == 0 ? 0 : tokens()[i - 1].span.end;
    return i == 0 || source_->text().substr(begin, tokens()[i].span.begin - begin).find('\n') !=
                         std::string_view::npos;
}

std::optional<Block> TokenPlaces::block_around(Around place) const {
    while (place.opening != none && !tokens()[place.opening].is("{")) {
        place = at_[place.opening];
    }
    return place.opening == none ? std::nullopt : blocks_[place.opening];
}

TokenPlaces::Around TokenPlaces::around(const std::vector<Frame>& frames) {
    const auto brace = std::find_if(frames.rbegin(), frames.rend(),
                                    [](const Frame& frame) { return frame.is_brace; });
    return {frames.back().opening, brace->statement};
}

// The words of items end whatever is open before them, where they can be nothing else.
bool TokenPlaces::begins_item(std::size_t i) const {
    if (!at_new_line(i) || i + 1 >= tokens().size()) {
        return false;
    }
    return (is_definition_word(tokens()[i]) && tokens()[i + 1].kind == TokenKind::name) ||
           (tokens()[i].is_name("import") && tokens()[i + 1].kind == TokenKind::text);
}

const StatementRow* TokenPlaces::begun_by(std::size_t i, Block block) const {
    const Token& token = tokens()[i];
    const StatementRow* row = find_statement(token, block);
    if (row == nullptr || !row->stands_in(block)) {
        return nullptr;
    }
    const bool is_called = i + 1 < tokens().size() && tokens()[i + 1].is("(");
    const bool is_value =
        i + 1 < tokens().size() && tokens()[i + 1].is("=") && row->shape != Shape::equation;
    const Token& before = tokens()[i - 1];
    const bool goes_on = before.is(",") || before.is("=") || before.is("..");
    const bool takes_parentheses =
        row->shape == Shape::call || row->shape == Shape::value || row->shape == Shape::corners ||
        row->shape == Shape::shown || row->shape == Shape::optional_corners ||
        row->shape == Shape::placements || row->shape == Shape::assignments;
    return is_value || (goes_on && !at_new_line(i)) || (is_called && !takes_parentheses) ? nullptr
                                                                                         : row;
}

std::optional<Block> TokenPlaces::opened_by(std::size_t i, const Frame& around) const {
    if (around.statement == none || !around.is_brace) {
        return std::nullopt;
    }
    const Token& word = tokens()[around.statement];
    if (around.opening == none) {
        return word.is_name("camera")    ? std::optional(Block::camera)
               : word.is_name("picture") ? std::optional(Block::picture)
                                         : std::nullopt;
    }
    const StatementRow* row = rows_[around.statement];
    if (row == nullptr || i == around.statement) {
        return std::nullopt;
    }
    return row->shape == Shape::path    ? std::optional(Block::path)
           : row->shape == Shape::layer ? std::optional(Block::layer)
           : row->shape == Shape::loop  ? std::optional(Block::loop)
                                        : std::nullopt;
}

void TokenPlaces::visit(std::size_t i, std::vector<Frame>& frames) {
    const Token& token = tokens()[i];
    if (begins_item(i)) {
        frames.resize(1);
    }
    const auto brace = std::find_if(frames.rbegin(), frames.rend(),
                                    [](const Frame& frame) { return frame.is_brace; });
    const bool nested = brace != frames.rbegin();
    if (brace->opening == none && !nested) {
        if (is_file_keyword(token) || token.is_name("let")) {
            brace->statement = i;
        }
    } else if (brace->block && token.kind == TokenKind::name && (!nested || at_new_line(i))) {
        // In a bracket that is not closed yet, a statement begins with a line.
        const StatementRow* row = begun_by(i, *brace->block);
        const bool is_free = !nested || (i + 1 < tokens().size() && !tokens()[i + 1].is(",") &&
                                         !tokens()[i + 1].is(")") && !tokens()[i + 1].is("(") &&
                                         !tokens()[i - 1].is("("));
        if (row != nullptr && is_free) {
            brace->statement = i;
            rows_[i] = row;
            while (!frames.back().is_brace) {
                frames.pop_back();
            }
        }
    }
    const bool closes = token.is(")") || token.is("]") || token.is("}");
    if (closes) {
        const std::string_view opens = token.is(")") ? "(" : token.is("]") ? "[" : "{";
        const auto match = std::find_if(frames.rbegin(), frames.rend(), [&](const Frame& frame) {
            return frame.opening != none && tokens()[frame.opening].is(opens);
        });
        // A brace closes all that is open in it.
        if (match != frames.rend() && (token.is("}") || match == frames.rbegin())) {
            closing_[match->opening] = i;
            frames.erase(match.base() - 1, frames.end());
        }
    }
    at_[i] = around(frames);
    if (token.is("(") || token.is("[") || token.is("{")) {
        Frame opened{i, token.is("{"), {}, none};
        if (opened.is_brace) {
            while (!frames.back().is_brace) {
                frames.pop_back();
            }
            blocks_[i] = opened_by(i, frames.back());
            opened.block = blocks_[i];
        }
        frames.push_back(opened);
    }
    after_[i] = around(frames);
}

}  // namespace balcony::lang
