// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/page_client.hpp"

#include <string>
#include <utility>

#include "lsp/answers.hpp"
#include "lsp/rpc.hpp"
#include "studio/session/studio.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

struct PageClient::Row {
    std::string_view method;
    json (PageClient::*answer)(const json& asked);
};

// What the studio adds to the Language Server Protocol.
const PageClient::Row PageClient::rows[] = {
    {"view/change", &PageClient::change_view},
    {"view/seen", &PageClient::see},
    {"text/set", &PageClient::set_values},
    {"file/save", &PageClient::save},
};

namespace {

int next_number() {
    static int last = 0;
    return ++last;
}

// Messages of the checks' thread reach the socket on the thread of the server.
lsp::Sink posting(Server& server, const std::shared_ptr<PageClient*>& page) {
    return [&server, page = std::weak_ptr<PageClient*>(page)](const json& message) {
        server.post([page, message] {
            if (const auto there = page.lock()) {
                (*there)->tell(message);
            }
        });
    };
}

}  // namespace

PageClient::PageClient(Studio& studio, Socket& socket)
    : studio_(studio),
      socket_(socket),
      number_(next_number()),
      flow_(socket),
      self_(std::make_shared<PageClient*>(this)),
      language_(posting(studio.server(), self_)) {}

PageClient::~PageClient() { studio_.leave(*this); }

void PageClient::tell(const json& message) { socket_.send(lsp::text_of(message)); }
void PageClient::rest(const json& message) { flow_.rest(lsp::text_of(message)); }

void PageClient::receive(std::string_view text) {
    bool begins = false;
    lsp::receive(
        text,
        [&](const json& message) {
            std::optional<json> answer = handle(message);
            if (answer && message["method"] == "initialize") {
                (*answer)["result"]["studio"] = studio_.about();
                begins = true;
            }
            return answer;
        },
        [this](const json& answer) { tell(answer); });
    if (begins) {
        has_joined_ = true;
        studio_.join(*this);
    }
}

std::optional<json> PageClient::handle(const json& message) {
    const auto& method = message["method"].get_ref<const std::string&>();
    if (method == "textDocument/didOpen" && is_about_text(message)) {
        json opened = message;
        opened["params"]["textDocument"]["text"] = studio_.text().text();
        opened["params"]["textDocument"]["version"] = studio_.text().version();
        return language_.handle(opened);
    }
    if (method == "textDocument/didChange" && is_about_text(message) && has_joined_ &&
        !take_text(message["params"])) {
        tell(studio_.text_message(nullptr));
        return std::nullopt;
    }
    for (const Row& row : rows) {
        if (method == row.method) {
            if (!has_joined_) {
                throw lsp::Refusal{lsp::not_initialized, "the first request is initialize"};
            }
            json answer = (this->*row.answer)(message.value("params", json::object()));
            return message.contains("id")
                       ? std::optional(lsp::result_of(message["id"], std::move(answer)))
                       : std::nullopt;
        }
    }
    return language_.handle(message);
}

bool PageClient::is_about_text(const json& message) const {
    static const json::json_pointer uri("/params/textDocument/uri");
    return message.contains(uri) && message[uri] == studio_.uri();
}

// False if it was made of another text, or does not have the form that this text needs.
bool PageClient::take_text(const json& told) {
    const json& changes = told.at("contentChanges");
    const json& version = told.at("textDocument").at("version");
    return changes.is_array() && changes.size() == 1 && !changes[0].contains("range") &&
           version.is_number_integer() &&
           studio_.take_text(version.get<int>(), changes[0].at("text").get<std::string>(), *this);
}

void PageClient::replace_text(const json& message) {
    const json& told = message["params"];
    static_cast<void>(language_.handle(
        lsp::notification("textDocument/didChange",
                          {{"textDocument", {{"uri", studio_.uri()}, {"version", told["version"]}}},
                           {"contentChanges", json::array({{{"text", told["text"]}}})}})));
    tell(message);
}

json PageClient::change_view(const json& asked) {
    return {{"change", studio_.change_view(change_of(asked))}};
}

json PageClient::see(const json& /*asked*/) {
    flow_.seen();
    return nullptr;
}

json PageClient::set_values(const json& asked) {
    const auto made = studio_.edits_of(values_of(asked.at("values")));
    if (!made) {
        throw lsp::Refusal{lsp::request_failed, to_text(made.diagnostics)};
    }
    const SourceText text("", studio_.text().text());
    json edits = json::array();
    for (const lang::TextEdit& edit : *made) {
        edits.push_back(lsp::edit_in(text, edit));
    }
    return {{"edits", std::move(edits)}, {"version", studio_.text().version()}};
}

json PageClient::save(const json& asked) {
    studio_.save(asked.value("force", false));
    return {{"version", studio_.text().version()}, {"file", studio_.text().file().string()}};
}

}  // namespace balcony::studio
