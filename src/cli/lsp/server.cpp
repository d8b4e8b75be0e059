// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/lsp/server.hpp"

#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/lsp/answers.hpp"

namespace balcony::cli {

using nlohmann::json;

namespace {

constexpr std::size_t longest_text = 1'000'000;

/// The error codes of the protocol.
enum Code : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    internal_error = -32603,
    not_initialized = -32002,
    request_failed = -32803,
};

struct Refusal {
    Code code;
    std::string message;
};

json error_answer(const json& id, const Refusal& refusal) {
    return {{"jsonrpc", "2.0"},
            {"id", id},
            {"error", {{"code", refusal.code}, {"message", refusal.message}}}};
}

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

LanguageServer::LanguageServer()
    : checks_([this](const app::TextCheck& check) { publish(check); }) {}

void LanguageServer::refuse(NoMessage why) {
    writer_.write(error_answer(
        nullptr, why == NoMessage::too_long
                     ? Refusal{invalid_request,
                               fmt::format("a message is longer than {} bytes", longest_message)}
                     : Refusal{parse_error,
                               "a header is wrong: a message begins with "
                               "Content-Length: and its length in bytes"}));
}

void LanguageServer::receive(const std::string& text) {
    const json message = json::parse(text, nullptr, false);
    if (message.is_discarded()) {
        writer_.write(error_answer(nullptr, {parse_error, "the message is not JSON"}));
        return;
    }
    const bool is_request = message.is_object() && message.contains("id");
    const json id = is_request ? message["id"] : json(nullptr);
    try {
        handle(message);
    } catch (const Refusal& refusal) {
        if (is_request || !message.is_object()) {
            writer_.write(error_answer(id, refusal));
        }
    } catch (const json::exception&) {
        if (is_request) {
            writer_.write(error_answer(id, {invalid_params,
                                            "the parameters do not have the form that the "
                                            "protocol gives them"}));
        }
    }
}

void LanguageServer::handle(const json& message) {
    if (!message.is_object() || (!message.contains("method") && !message.contains("id"))) {
        throw Refusal{invalid_request, "the message is neither a request nor a notification"};
    }
    if (!message.contains("method")) {
        return;  // The answer to a request of the server, which makes none.
    }
    const auto& method = message["method"].get_ref<const std::string&>();
    const json params = message.value("params", json::object());
    if (!message.contains("id")) {
        notice(method, params);
        return;
    }
    const json& id = message["id"];
    if (!id.is_number_integer() && !id.is_string()) {
        throw Refusal{invalid_request, "the id of a request is a number or a text"};
    }
    if (method == "initialize" ? is_initialized_ : !is_initialized_) {
        throw method == "initialize" ? Refusal{invalid_request, "it is initialized already"}
                                     : Refusal{not_initialized, "the first request is initialize"};
    }
    if (is_shut_down_) {
        throw Refusal{invalid_request, "after shutdown there is exit alone"};
    }
    writer_.write({{"jsonrpc", "2.0"}, {"id", id}, {"result", answer(method, params)}});
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
        throw Refusal{request_failed, "a camera file is at most 1 MB"};
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
        writer_.write({{"jsonrpc", "2.0"},
                       {"method", "textDocument/publishDiagnostics"},
                       {"params", {{"uri", uri}, {"diagnostics", json::array()}}}});
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
    writer_.write(
        {{"jsonrpc", "2.0"},
         {"method", "textDocument/publishDiagnostics"},
         {"params", diagnostics_of(text.uri(), *text.source(),
                                   {error("a camera file is at most 1 MB", {text.source(), 0, 0})},
                                   text.version())}});
}

void LanguageServer::publish(const app::TextCheck& check) {
    const std::lock_guard lock(found_mutex_);
    const auto text = texts_.find(check.name);
    if (text == texts_.end() || text->second.source() != check.text) {
        return;
    }
    text->second.found = check.found;
    writer_.write(
        {{"jsonrpc", "2.0"},
         {"method", "textDocument/publishDiagnostics"},
         {"params", diagnostics_of(check.name, *check.text, check.found, text->second.version())}});
}

}  // namespace balcony::cli
