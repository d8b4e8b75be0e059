// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/keywords.hpp"

#include <algorithm>
#include <array>

namespace balcony::lang {

namespace {

constexpr std::array<Keyword, 11> rows = {{{StatementKind::let, "let", false, true},
                                           {StatementKind::aspect, "aspect", false, true},
                                           {StatementKind::axes, "axes", false, true},
                                           {StatementKind::map, "map", true, true},
                                           {StatementKind::eye, "eye", false, true},
                                           {StatementKind::toward, "toward", false, true},
                                           {StatementKind::object, "object", true, false},
                                           {StatementKind::warp, "warp", true, true},
                                           {StatementKind::move, "move", true, true},
                                           {StatementKind::look, "look", false, true},
                                           {StatementKind::place, "place", false, true}}};

constexpr std::array<std::string_view, 2> file_words = {"import", "camera"};

}  // namespace

std::span<const Keyword> keywords() { return rows; }

const Keyword* find_keyword(const Token& token) {
    for (const Keyword& row : rows) {
        if (token.is_name(row.text)) {
            return &row;
        }
    }
    return nullptr;
}

bool is_file_keyword(const Token& token) {
    return std::any_of(file_words.begin(), file_words.end(),
                       [&token](std::string_view word) { return token.is_name(word); });
}

std::vector<std::string> keywords_for(bool in_path) {
    std::vector<std::string> names;
    for (const Keyword& row : rows) {
        if (in_path ? row.in_path : row.in_camera) {
            names.emplace_back(row.text);
        }
    }
    return names;
}

std::string_view keyword(StatementKind kind) {
    for (const Keyword& row : rows) {
        if (row.kind == kind) {
            return row.text;
        }
    }
    return {};
}

}  // namespace balcony::lang
