// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Where names are declared and used, and their renaming.

#include <algorithm>

#include <fmt/format.h>

#include "lang/service/known_text.hpp"
#include "lang/syntax/statement_rows.hpp"

namespace balcony::lang {

namespace {

struct Declaration {
    const KnownText& text;

    std::optional<SourceSpan> operator()(const OwnName* own) const {
        return text.tree().at(own->name.span);
    }
    std::optional<SourceSpan> operator()(const MeantFormulaParameter& meant) const {
        return text.tree().at(meant.declaration);
    }
    std::optional<SourceSpan> operator()(const MeantCamera& meant) const {
        return of_file(meant.place, meant.place.camera->name.span);
    }
    std::optional<SourceSpan> operator()(const MeantCameraParameter& meant) const {
        return of_file(meant.place, meant.parameter->name.span);
    }
    std::optional<SourceSpan> operator()(const MeantImport& meant) const {
        return meant.definition->place;
    }
    template <class Other>
    std::optional<SourceSpan> operator()(const Other&) const {
        return std::nullopt;
    }

private:
    // The texts of built-in cameras are no files.
    static std::optional<SourceSpan> of_file(const LocatedDefinition& place, Span span) {
        return place.module->built_in ? std::nullopt : std::optional(place.module->tree.at(span));
    }
};

std::optional<SourceSpan> declaration_of(const KnownText& text, std::size_t token) {
    return std::visit(Declaration{text}, text.meant_by(token));
}

bool is_name(const std::shared_ptr<const SourceText>& source) {
    const TokenPlaces read(source);
    return read.tokens().size() == 2 && read[0].kind == TokenKind::name &&
           read[0].span.end == source->text().size() && read[0].span.begin == 0;
}

// Whether a word cannot be a name, since it begins a statement or is a constant.
bool is_reserved(const Token& word) {
    return is_file_keyword(word) || word.is_name("pi") || word.is_name("t") ||
           find_statement(word, Block::camera) != nullptr ||
           find_statement(word, Block::picture) != nullptr;
}

// Whether a place of the old name would mean something else, or a place of the new name this.
bool is_taken(const KnownText& text, const std::vector<SourceSpan>& places, const SourceSpan& of,
              std::string_view name) {
    const auto own = std::find_if(text.names.begin(), text.names.end(), [&](const OwnName& one) {
        return one.name.span.begin == of.begin;
    });
    const bool of_camera = own != text.names.end() && own->kind == OwnKind::camera;
    for (const OwnName& other : text.names) {
        const bool same_kind = (other.kind == OwnKind::camera) == of_camera;
        if (other.name.text != name || !same_kind) {
            continue;
        }
        const bool overlaps = own == text.names.end() || (other.scope.begin < own->scope.end &&
                                                          own->scope.begin < other.scope.end);
        if (overlaps) {
            return true;
        }
    }
    return std::any_of(places.begin(), places.end(), [&](const SourceSpan& place) {
        const std::size_t token = text.places.first_behind(place.begin);
        const Expected here = text.expected(token);
        return std::any_of(here.formula_parameters.begin(), here.formula_parameters.end(),
                           [&](std::size_t i) { return text.places[i].text == name; });
    });
}

}  // namespace

std::optional<SourceSpan> definition(const KnownText& text, std::size_t offset) {
    const auto word = text.word_at(offset);
    return word ? declaration_of(text, *word) : std::nullopt;
}

std::vector<SourceSpan> references(const KnownText& text, std::size_t offset) {
    const auto declared = definition(text, offset);
    std::vector<SourceSpan> found;
    if (!declared || declared->source != text.source) {
        return found;
    }
    const std::string_view name =
        text.source->text().substr(declared->begin, declared->end - declared->begin);
    for (std::size_t i = 0; i + 1 < text.places.tokens().size(); ++i) {
        const Token& token = text.places[i];
        if (token.kind != TokenKind::name || token.text != name) {
            continue;
        }
        const bool is_declaration = token.span.begin == declared->begin;
        const auto meant = is_declaration ? declared : declaration_of(text, i);
        if (meant && meant->source == declared->source && meant->begin == declared->begin) {
            found.push_back(text.tree().at(token.span));
        }
    }
    return found;
}

Result<std::vector<TextEdit>> rename(const KnownText& text, std::size_t offset,
                                     std::string_view new_name) {
    const std::vector<SourceSpan> places = references(text, offset);
    if (places.empty()) {
        return error("this name is not declared in this file", {},
                     "rename it where it is declared; names of the language keep theirs");
    }
    const auto written = std::make_shared<const SourceText>("new name", std::string(new_name));
    if (!is_name(written)) {
        return error(fmt::format("'{}' is not a name", new_name), {},
                     "names consist of letters, digits and _, and start with a letter");
    }
    if (is_reserved(TokenPlaces(written)[0])) {
        return error(fmt::format("'{}' is reserved", new_name), {}, "choose another name");
    }
    if (is_taken(text, places, *definition(text, offset), new_name)) {
        return error(fmt::format("'{}' is the name of something else here", new_name), {},
                     "choose another name");
    }
    std::vector<TextEdit> edits;
    for (const SourceSpan& place : places) {
        edits.push_back({place.begin, place.end, std::string(new_name)});
    }
    return edits;
}

}  // namespace balcony::lang
