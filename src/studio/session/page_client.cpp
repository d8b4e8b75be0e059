// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/page_client.hpp"

#include <algorithm>
#include <iterator>
#include <string>
#include <utility>

#include "lsp/rpc.hpp"
#include "studio/session/inspection_messages.hpp"
#include "studio/session/studio.hpp"
#include "studio/session/text_messages.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

// What the studio adds to the Language Server Protocol: requests that are answered at once.
struct PageClient::Row {
    std::string_view method;
    json (PageClient::*answer)(const json& asked);
};

const PageClient::Row PageClient::rows[] = {
    {"view/change", &PageClient::change_view},
    {"view/drag", &PageClient::drag},
    {"view/seen", &PageClient::see},
    {"file/save", &PageClient::save},
    {"cameras/list", &PageClient::list_cameras},
    {"cameras/show", &PageClient::show_cameras},
    {"cameras/text", &PageClient::write_camera},
    {"render/start", &PageClient::start_rendering},
    {"render/stop", &PageClient::stop_rendering},
    {"command", &PageClient::command},
};

// Requests about the text, or about a camera of it.
struct PageClient::TextRow {
    std::string_view method;
    json (*answer)(const lang::EditedText& text, const std::string& camera, const json& asked);
};

const PageClient::TextRow PageClient::text_rows[] = {
    {"handles", [](const lang::EditedText& text, const std::string& camera,
                   const json&) { return handles_answer(text, camera); }},
    {"handles/move", moved_answer},
    {"keys", [](const lang::EditedText& text, const std::string& camera,
                const json&) { return keys_answer(text, camera); }},
    {"text/set", values_answer},
    {"text/unkey", without_keys_answer},
};

// Requests about the picture that is shown, with the name of the `file` that it comes from.
struct PageClient::PictureRow {
    std::string_view method;
    Inspection& (Studio::*by)();
    json (*answer)(live::Inspector& inspector, const json& asked, const std::stop_token& stop);
};

const PageClient::PictureRow PageClient::picture_rows[] = {
    {"view/at", &Studio::inspection, sight_answer}, {"view/grid", &Studio::inspection, grid_answer},
    {"view/find", &Studio::search, places_answer},  {"view/check", &Studio::checks, remarks_answer},
    {"export", &Studio::search, export_answer},
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
      later_(posting(studio.server(), self_)),
      language_(later_) {}

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
                (*answer)["result"]["studio"]["requests"] = requests();
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
            require_beginning();
            json answer = (this->*row.answer)(message.value("params", json::object()));
            return message.contains("id")
                       ? std::optional(lsp::result_of(message["id"], std::move(answer)))
                       : std::nullopt;
        }
    }
    return has_late_answer(method, message) ? std::nullopt : language_.handle(message);
}

// Whether the answer comes from another thread. Without an id, nobody waits for it.
bool PageClient::has_late_answer(std::string_view method, const json& message) {
    const auto ask_row = [&](const auto& row) {
        if (method != row.method) {
            return false;
        }
        require_beginning();
        if (message.contains("id")) {
            ask(row, message["id"], message.value("params", json::object()));
        }
        return true;
    };
    return std::any_of(std::begin(text_rows), std::end(text_rows), ask_row) ||
           std::any_of(std::begin(picture_rows), std::end(picture_rows), ask_row);
}

json PageClient::requests() {
    json names = json::array();
    for (const Row& row : rows) {
        names.push_back(row.method);
    }
    for (const TextRow& row : text_rows) {
        names.push_back(row.method);
    }
    for (const PictureRow& row : picture_rows) {
        names.push_back(row.method);
    }
    return names;
}

void PageClient::require_beginning() const {
    if (!has_joined_) {
        throw lsp::Refusal{lsp::not_initialized, "the first request is initialize"};
    }
}

// Gives what is made on another thread to the page, unless it has left: then nobody waits for it.
PageClient::Reply PageClient::replying(const json& id) const {
    return [id, later = later_, page = std::weak_ptr(self_)](const std::function<json()>& make) {
        if (!page.expired()) {
            later(lsp::answer_of(id, make));
        }
    };
}

void PageClient::ask(const TextRow& row, const json& id, const json& asked) {
    studio_.questions().ask(studio_.text(),
                            [answer = row.answer, asked, reply = replying(id),
                             camera = asked.value("camera", studio_.camera()),
                             version = studio_.text().version()](const lang::EditedText& text) {
                                reply([&] {
                                    json made = answer(text, camera, asked);
                                    made["version"] = version;
                                    return made;
                                });
                            });
}

void PageClient::ask(const PictureRow& row, const json& id, const json& asked) {
    json about = asked;
    about["file"] = studio_.text().file().filename().string();
    (studio_.*row.by)().ask([answer = row.answer, asked = std::move(about), reply = replying(id)](
                                const auto& inspector, const std::stop_token& stop) {
        reply([&] { return answer(inspector(), asked, stop); });
    });
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

json PageClient::drag(const json& asked) {
    return {{"change", studio_.change_view({.drag = drag_of(asked)})}};
}

json PageClient::see(const json& /*asked*/) {
    flow_.seen();
    return nullptr;
}

json PageClient::list_cameras(const json& /*asked*/) { return studio_.wall().list(); }

json PageClient::show_cameras(const json& asked) {
    studio_.wall().show(studio_.view(), asked);
    return nullptr;
}

json PageClient::write_camera(const json& asked) {
    return {{"text", camera_text(asked.at("name").get<std::string>())}};
}

json PageClient::start_rendering(const json& asked) { return studio_.renderings().start(asked); }

json PageClient::stop_rendering(const json& asked) {
    studio_.renderings().stop(asked);
    return nullptr;
}

json PageClient::command(const json& /*asked*/) { return {{"line", studio_.command()}}; }

json PageClient::save(const json& asked) {
    studio_.save(asked.value("force", false));
    return {{"version", studio_.text().version()}, {"file", studio_.text().file().string()}};
}

}  // namespace balcony::studio
