// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// JSON-RPC 2.0: messages, their answers, and why a request is refused.

#include <cstddef>
#include <functional>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace balcony::lsp {

inline constexpr std::size_t longest_message = 16'000'000;  ///< In bytes.

/// Takes a message for the other side. May be called from any thread and does not wait.
using Sink = std::function<void(const nlohmann::json&)>;

/// The error codes of JSON-RPC and of the Language Server Protocol.
enum Code : int {
    parse_error = -32700,
    invalid_request = -32600,
    method_not_found = -32601,
    invalid_params = -32602,
    not_initialized = -32002,
    request_failed = -32803,
};

/// What is thrown where a message is handled, and becomes the answer.
struct Refusal {
    Code code;
    std::string message;
};

[[nodiscard]] nlohmann::json result_of(const nlohmann::json& id, nlohmann::json result);
/// Without an id, if it is neither a number nor a text.
[[nodiscard]] nlohmann::json error_of(const nlohmann::json& id, const Refusal& refusal);
[[nodiscard]] nlohmann::json notification(std::string_view method, nlohmann::json params);

/// Calls what handles a message. Why it refuses, if it does: by a Refusal, or by an exception of
/// the JSON library where parameters do not have their form.
[[nodiscard]] std::optional<Refusal> refusal_of(const std::function<void()>& handle);
/// What a function makes as the answer to a request, or its refusal.
[[nodiscard]] nlohmann::json answer_of(const nlohmann::json& id,
                                       const std::function<nlohmann::json()>& make);

/// A message as bytes. Replaces what is not UTF-8.
[[nodiscard]] std::string text_of(const nlohmann::json& message);

/// Handles a message and returns the answer to a request. May throw a Refusal, or an exception of
/// the JSON library where parameters do not have their form.
using Handler = std::function<std::optional<nlohmann::json>(const nlohmann::json&)>;

/// Reads the text of a message, has it handled, and gives the answer or a refusal to the sink. The
/// handler gets objects alone, with a method; an id is a number or a text.
void receive(std::string_view text, const Handler& handle, const Sink& send);

}  // namespace balcony::lsp
