// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lsp/server.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lsp/answers.hpp"

namespace balcony::lsp {

using nlohmann::json;

namespace {

constexpr std::string_view publishing = "textDocument/publishDiagnostics";

/// Requests about a place of a text.
struct PlaceRow {
    std::string_view method;
    json (*answer)(OpenText& text, std::size_t offset);
};

constexpr std::array<PlaceRow, 5> place_rows = {{
    {"textDocument/hover", hover_answer},
    {"textDocument/signatureHelp", signature_answer},
    {"textDocument/definition", definition_answer},
    {"textDocument/references", references_answer},
    {"textDocument/prepareRename", prepare_rename_answer},
}};

/// Requests about a whole text.
struct TextRow {
    std::string_view method;
    json (*answer)(OpenText& text);
};

constexpr std::array<TextRow, 2> text_rows = {{
    {"textDocument/formatting", formatting_answer},
    {"textDocument/documentSymbol", symbols_answer},
}};

}  // namespace

LanguageServer::LanguageServer(Sink send)
    : send_(std::move(send)), checks_([this](const app::TextCheck& check) { publish(check); }) {}

void LanguageServer::receive(std::string_view text) {
    lsp::receive(
        text, [this](const json& message) { return handle(message); }, send_);
}

std::optional<json> LanguageServer::handle(const json& message) {
    const auto& method = message["method"].get_ref<const std::string&>();
    const json params = message.value("params", json::object());
    if (!message.contains("id")) {
        notice(method, params);
        return std::nullopt;
    }
    if (method == "initialize" ? is_initialized_ : !is_initialized_) {
        throw method == "initialize" ? Refusal{invalid_request, "it is initialized already"}
                                     : Refusal{not_initialized, "the first request is initialize"};
    }
    if (is_shut_down_) {
        throw Refusal{invalid_request, "after shutdown there is exit alone"};
    }
    return result_of(message["id"], answer(method, params));
}

json LanguageServer::initialize(const json& asked) {
    is_initialized_ = true;
    const json::json_pointer snippets(
        "/capabilities/textDocument/completion/completionItem/snippetSupport");
    snippets_ = asked.contains(snippets) && asked[snippets] == true;
    return {{"capabilities",
             {{"positionEncoding", "utf-16"},
              {"textDocumentSync", {{"openClose", true}, {"change", 2}}},
              {"completionProvider", {{"triggerCharacters", {"(", ",", "=", " "}}}},
              {"hoverProvider", true},
              {"signatureHelpProvider", {{"triggerCharacters", {"(", ","}}}},
              {"definitionProvider", true},
              {"referencesProvider", true},
              {"renameProvider", {{"prepareProvider", true}}},
              {"documentFormattingProvider", true},
              {"documentSymbolProvider", true},
              {"inlayHintProvider", true},
              {"codeActionProvider", {{"codeActionKinds", {"quickfix"}}}}}},
            {"serverInfo", {{"name", "balcony"}, {"version", BALCONY_VERSION}}}};
}

json LanguageServer::answer(const std::string& method, const json& asked) {
    if (method == "initialize") {
        return initialize(asked);
    }
    if (method == "shutdown") {
        is_shut_down_ = true;
        return nullptr;
    }
    for (const PlaceRow& row : place_rows) {
        if (method == row.method) {
            OpenText& text = text_of(asked);
            return row.answer(text, text.offset_of(asked.at("position")));
        }
    }
    for (const TextRow& row : text_rows) {
        if (method == row.method) {
            return row.answer(text_of(asked));
        }
    }
    if (method == "textDocument/completion") {
        OpenText& text = text_of(asked);
        return completion_answer(text, text.offset_of(asked.at("position")), snippets_);
    }
    if (method == "textDocument/inlayHint") {
        OpenText& text = text_of(asked);
        const json& range = asked.at("range");
        return values_answer(text, text.offset_of(range.at("start")),
                             text.offset_of(range.at("end")));
    }
    if (method == "textDocument/codeAction") {
        return fixes(asked);
    }
    if (method == "textDocument/rename") {
        OpenText& text = text_of(asked);
        std::string refusal;
        json made = rename_answer(text, text.offset_of(asked.at("position")),
                                  asked.at("newName").get_ref<const std::string&>(), refusal);
        if (!refusal.empty()) {
            throw Refusal{request_failed, std::move(refusal)};
        }
        return made;
    }
    throw Refusal{method_not_found, fmt::format("there is no request '{}'", method)};
}

json LanguageServer::fixes(const json& asked) {
    OpenText& text = text_of(asked);
    const json& range = asked.at("range");
    const std::lock_guard lock(found_mutex_);
    return fixes_answer(text, text.offset_of(range.at("start")), text.offset_of(range.at("end")));
}

OpenText& LanguageServer::text_of(const json& asked) {
    const auto& uri = asked.at("textDocument").at("uri").get_ref<const std::string&>();
    const auto found = texts_.find(uri);
    if (found == texts_.end()) {
        throw Refusal{invalid_params, fmt::format("'{}' is not open", uri)};
    }
    if (found->second.source()->text().size() > longest_text) {
        throw Refusal{request_failed, std::string(too_long)};
    }
    return found->second;
}

// Notifications have no answer, so that a wrong one is passed over.
void LanguageServer::notice(const std::string& method, const json& told) {
    if (method == "exit") {
        has_ended_ = true;
    } else if (!is_initialized_ || is_shut_down_) {
        return;
    } else if (method == "textDocument/didOpen") {
        open(told.at("textDocument"));
    } else if (method == "textDocument/didChange") {
        change(told);
    } else if (method == "textDocument/didClose") {
        const std::string uri = told.at("textDocument").at("uri");
        checks_.forget(uri);
        const std::lock_guard lock(found_mutex_);
        texts_.erase(uri);
        // A closed text has no marks.
        send_(notification(publishing, {{"uri", uri}, {"diagnostics", json::array()}}));
    }
}

void LanguageServer::open(const json& document) {
    const std::string uri = document.at("uri");
    OpenText made(uri, document.at("text"), document.value("version", 0));
    const OpenText* opened = nullptr;
    {
        const std::lock_guard lock(found_mutex_);
        opened = &texts_.insert_or_assign(uri, std::move(made)).first->second;
    }
    check(*opened);
}

void LanguageServer::change(const json& told) {
    const json& document = told.at("textDocument");
    const auto found = texts_.find(document.at("uri").get_ref<const std::string&>());
    if (found == texts_.end()) {
        return;
    }
    {
        const std::lock_guard lock(found_mutex_);
        found->second.change(told.at("contentChanges"), document.value("version", 0));
    }
    check(found->second);
}

void LanguageServer::check(const OpenText& text) {
    if (text.source()->text().size() <= longest_text) {
        checks_.check(text.uri(), text.source(), text.folder());
        return;
    }
    checks_.forget(text.uri());
    send_(notification(
        publishing,
        diagnostics_of(text.uri(), *text.source(),
                       {error(std::string(too_long), {text.source(), 0, 0})}, text.version())));
}

void LanguageServer::publish(const app::TextCheck& check) {
    const std::lock_guard lock(found_mutex_);
    const auto text = texts_.find(check.name);
    if (text == texts_.end() || text->second.source() != check.text) {
        return;
    }
    text->second.found = check.found;
    send_(notification(
        publishing, diagnostics_of(check.name, *check.text, check.found, text->second.version())));
}

}  // namespace balcony::lsp
