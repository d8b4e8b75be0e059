// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lsp/answers.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/lang.hpp"

namespace balcony::lsp {

using lang::WordKind;
using nlohmann::json;

json edit_in(const SourceText& text, const lang::TextEdit& edit) {
    return {{"range", range_in(text, edit.begin, edit.end)}, {"newText", edit.text}};
}

json diagnostic_of(const SourceText& text, const Diagnostic& one) {
    const bool is_here = one.span.source.get() == &text;
    std::string message = one.message;
    if (!is_here && one.span.source) {
        message = fmt::format("{}: {}", one.span.source->name(), message);
    }
    if (!one.remedy.empty()) {
        message += fmt::format("\n{}", one.remedy);
    }
    return {
        {"range", is_here ? range_in(text, one.span.begin, one.span.end) : range_in(text, 0, 0)},
        {"severity", one.severity == Severity::error ? 1 : 2},
        {"source", "balcony"},
        {"message", std::move(message)}};
}

namespace {

/// What the protocol calls a kind of word, in completions and in outlines.
struct KindRow {
    WordKind kind;
    int completion;
    int symbol;
};

constexpr std::array<KindRow, 7> kinds = {{{WordKind::keyword, 14, 15},
                                           {WordKind::stage, 3, 12},
                                           {WordKind::parameter, 10, 7},
                                           {WordKind::choice, 20, 22},
                                           {WordKind::function, 3, 12},
                                           {WordKind::value, 6, 13},
                                           {WordKind::camera, 7, 5}}};

const KindRow& row_of(WordKind kind) {
    return *std::find_if(kinds.begin(), kinds.end(),
                         [kind](const KindRow& row) { return row.kind == kind; });
}

std::string escaped(std::string_view text) {
    std::string made;
    for (const char c : text) {
        made += c == '$' || c == '}' || c == '\\' ? "\\" : "";
        made += c;
    }
    return made;
}

// sphere(radius = ${1:1})$0
std::string snippet_of(const lang::Completion& item) {
    std::string made;
    std::size_t at = 0;
    int number = 0;
    for (const lang::Completion::Blank& blank : item.blanks) {
        made += escaped(std::string_view(item.text).substr(at, blank.begin - at));
        made += fmt::format(
            "${{{}:{}}}", ++number,
            escaped(std::string_view(item.text).substr(blank.begin, blank.end - blank.begin)));
        at = blank.end;
    }
    return made + escaped(std::string_view(item.text).substr(at)) + "$0";
}

json markdown(std::string text) { return {{"kind", "markdown"}, {"value", std::move(text)}}; }

std::string block(std::string_view language, std::string_view text) {
    return fmt::format("```{}\n{}\n```\n", language, text);
}

json location_of(OpenText& text, const SourceSpan& span) {
    const std::string uri = span.source == text.source() ? text.uri() : uri_of(span.source->name());
    return {{"uri", uri}, {"range", range_in(*span.source, span.begin, span.end)}};
}

json symbol_of(const SourceText& text, const lang::DeclaredName& one) {
    json made{{"name", one.name},
              {"detail", one.detail},
              {"kind", row_of(one.kind).symbol},
              {"range", range_in(text, std::min(one.begin, one.name_begin), one.end)},
              {"selectionRange", range_in(text, one.name_begin, one.name_end)}};
    for (const lang::DeclaredName& inner : one.inside) {
        made["children"].push_back(symbol_of(text, inner));
    }
    return made;
}

}  // namespace

json completion_answer(OpenText& text, std::size_t offset, bool snippets) {
    const lang::Completions found = text.known().complete(offset);
    json items = json::array();
    for (const lang::Completion& one : found.items) {
        const bool is_snippet = snippets && !one.blanks.empty();
        json item{{"label", one.label},
                  {"kind", row_of(one.kind).completion},
                  // Clients sort by text; the order is that of the service.
                  {"sortText", fmt::format("{:05}", items.size())},
                  {"filterText", one.label},
                  {"insertTextFormat", is_snippet ? 2 : 1},
                  {"textEdit", edit_in(*text.source(), {found.begin, found.end,
                                                        is_snippet ? snippet_of(one) : one.text})}};
        if (!one.detail.empty()) {
            item["detail"] = one.detail;
        }
        if (!one.meaning.empty()) {
            item["documentation"] = one.meaning;
        }
        items.push_back(std::move(item));
    }
    return {{"isIncomplete", false}, {"items", std::move(items)}};
}

json hover_answer(OpenText& text, std::size_t offset) {
    const auto told = text.known().hover(offset);
    if (!told) {
        return nullptr;
    }
    std::string shown = block("balcony", told->signature);
    if (!told->meaning.empty()) {
        shown += fmt::format("\n{}\n", told->meaning);
    }
    if (!told->formula.empty()) {
        shown += fmt::format("\n{}", block("text", told->formula));
    }
    if (!told->example.empty()) {
        shown += fmt::format("\n{}", block("balcony", told->example));
    }
    return {{"contents", markdown(std::move(shown))},
            {"range", range_in(*text.source(), told->begin, told->end)}};
}

json signature_answer(OpenText& text, std::size_t offset) {
    const auto found = text.known().signature(offset);
    if (!found) {
        return nullptr;
    }
    json parameters = json::array();
    for (const lang::Signature::Parameter& one : found->parameters) {
        // The label is ASCII, as the names and numbers of the language are.
        parameters.push_back({{"label", {one.begin, one.end}}, {"documentation", one.meaning}});
    }
    return {{"signatures",
             {{{"label", found->label},
               {"documentation", found->meaning},
               {"parameters", std::move(parameters)}}}},
            {"activeSignature", 0},
            {"activeParameter", found->active}};
}

json definition_answer(OpenText& text, std::size_t offset) {
    const auto found = text.known().definition(offset);
    return found ? location_of(text, *found) : json(nullptr);
}

json references_answer(OpenText& text, std::size_t offset) {
    json found = json::array();
    for (const SourceSpan& one : text.known().references(offset)) {
        found.push_back(location_of(text, one));
    }
    return found;
}

json prepare_rename_answer(OpenText& text, std::size_t offset) {
    for (const SourceSpan& one : text.known().references(offset)) {
        if (one.begin <= offset && offset <= one.end) {
            return range_in(*text.source(), one.begin, one.end);
        }
    }
    return nullptr;
}

json rename_answer(OpenText& text, std::size_t offset, const std::string& name,
                   std::string& refusal) {
    const auto made = text.known().rename(offset, name);
    if (!made) {
        const Diagnostic& why = made.diagnostics.front();
        refusal = fmt::format("{}: {}", why.message, why.remedy);
        return nullptr;
    }
    json edits = json::array();
    for (const lang::TextEdit& edit : *made) {
        edits.push_back(edit_in(*text.source(), edit));
    }
    return {{"changes", {{text.uri(), std::move(edits)}}}};
}

json formatting_answer(OpenText& text) {
    const auto made = lang::format(text.source());
    if (!made) {
        return nullptr;
    }
    const std::string_view written = text.source()->text();
    return *made == written ? json::array()
                            : json::array({edit_in(*text.source(), {0, written.size(), *made})});
}

json values_answer(OpenText& text, std::size_t begin, std::size_t end) {
    json found = json::array();
    for (const lang::KnownValue& one : text.known().values()) {
        if (begin <= one.offset && one.offset <= end) {
            found.push_back({{"position", position_in(*text.source(), one.offset)},
                             {"label", "= " + one.text},
                             {"paddingLeft", true}});
        }
    }
    return found;
}

json symbols_answer(OpenText& text) {
    json found = json::array();
    for (const lang::DeclaredName& one : text.known().declared()) {
        found.push_back(symbol_of(*text.source(), one));
    }
    return found;
}

json fixes_answer(OpenText& text, std::size_t begin, std::size_t end) {
    json found = json::array();
    for (const Diagnostic& one : text.found) {
        if (one.span.source != text.source() || one.span.begin > end || one.span.end < begin) {
            continue;
        }
        for (const lang::Fix& fix : lang::fixes_of(one)) {
            found.push_back(
                {{"title", fix.title},
                 {"kind", "quickfix"},
                 {"diagnostics", {diagnostic_of(*text.source(), one)}},
                 {"edit", {{"changes", {{text.uri(), {edit_in(*text.source(), fix.edit)}}}}}}});
        }
    }
    return found;
}

json diagnostics_of(const std::string& uri, const SourceText& text, const Diagnostics& found,
                    int version) {
    json list = json::array();
    for (const Diagnostic& one : found) {
        list.push_back(diagnostic_of(text, one));
    }
    return {{"uri", uri}, {"version", version}, {"diagnostics", std::move(list)}};
}

}  // namespace balcony::lsp
