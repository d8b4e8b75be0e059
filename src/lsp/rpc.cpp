// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lsp/rpc.hpp"

#include <utility>

#include <nlohmann/json.hpp>

namespace balcony::lsp {

using nlohmann::json;

namespace {

// The JSON library copies and writes what is nested by functions that call themselves. Messages of
// the protocol nest some ten deep.
bool nests_too_deeply(std::string_view text) {
    constexpr int deepest = 100;
    int depth = 0;
    bool is_in_text = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        if (is_in_text && c == '\\') {
            ++i;
        } else if (c == '"') {
            is_in_text = !is_in_text;
        } else if (!is_in_text && (c == '[' || c == '{')) {
            if (++depth > deepest) {
                return true;
            }
        } else if (!is_in_text && (c == ']' || c == '}')) {
            --depth;
        }
    }
    return false;
}

bool is_id(const json& id) { return id.is_number_integer() || id.is_string(); }

void check(const json& message) {
    if (!message.is_object() || (!message.contains("method") && !message.contains("id"))) {
        throw Refusal{invalid_request, "the message is neither a request nor a notification"};
    }
    if (message.contains("method") && message.contains("id") && !is_id(message["id"])) {
        throw Refusal{invalid_request, "the id of a request is a number or a text"};
    }
}

}  // namespace

json result_of(const json& id, json result) {
    return {{"jsonrpc", "2.0"}, {"id", id}, {"result", std::move(result)}};
}

json error_of(const json& id, const Refusal& refusal) {
    return {{"jsonrpc", "2.0"},
            {"id", is_id(id) ? id : json(nullptr)},
            {"error", {{"code", refusal.code}, {"message", refusal.message}}}};
}

json notification(std::string_view method, json params) {
    return {{"jsonrpc", "2.0"}, {"method", method}, {"params", std::move(params)}};
}

std::optional<Refusal> refusal_of(const std::function<void()>& handle) {
    try {
        handle();
        return std::nullopt;
    } catch (const Refusal& refusal) {
        return refusal;
    } catch (const json::exception&) {
        return Refusal{invalid_params,
                       "the parameters do not have the form that the protocol gives them"};
    }
}

json answer_of(const json& id, const std::function<json()>& make) {
    json made;
    const std::optional<Refusal> refusal = refusal_of([&] { made = make(); });
    return refusal ? error_of(id, *refusal) : result_of(id, std::move(made));
}

std::string text_of(const json& message) {
    return message.dump(-1, ' ', false, json::error_handler_t::replace);
}

void receive(std::string_view text, const Handler& handle, const Sink& send) {
    if (nests_too_deeply(text)) {
        send(error_of(nullptr, {parse_error, "the message nests more than 100 deep"}));
        return;
    }
    const json message = json::parse(text, nullptr, false);
    if (message.is_discarded()) {
        send(error_of(nullptr, {parse_error, "the message is not JSON"}));
        return;
    }
    const bool is_request = message.is_object() && message.contains("id");
    const json id = is_request ? message["id"] : json(nullptr);
    const std::optional<Refusal> refusal = refusal_of([&] {
        check(message);
        if (!message.contains("method")) {
            return;  // The answer to a request of the server, which makes none.
        }
        if (const std::optional<json> answer = handle(message)) {
            send(*answer);
        }
    });
    if (refusal && (is_request || !message.is_object())) {
        send(error_of(id, *refusal));
    }
}

}  // namespace balcony::lsp
