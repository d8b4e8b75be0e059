// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A language server: requests of an editor about its open texts, and their answers.

#include <map>
#include <mutex>
#include <optional>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "balcony/text_checks.hpp"
#include "lsp/open_text.hpp"
#include "lsp/rpc.hpp"

namespace balcony::lsp {

class LanguageServer {
public:
    /// What it says goes to the sink.
    explicit LanguageServer(Sink send);

    /// Answers the text of a message.
    void receive(std::string_view text);
    /// The answer to a request, or nothing for a notification, as a Handler.
    [[nodiscard]] std::optional<nlohmann::json> handle(const nlohmann::json& message);

    /// Whether the client has asked for the end, and whether it has announced it before.
    [[nodiscard]] bool has_ended() const { return has_ended_; }
    [[nodiscard]] bool was_shut_down() const { return is_shut_down_; }

private:
    [[nodiscard]] nlohmann::json answer(const std::string& method, const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json initialize(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json fixes(const nlohmann::json& asked);
    void notice(const std::string& method, const nlohmann::json& told);
    void open(const nlohmann::json& document);
    void change(const nlohmann::json& told);
    void check(const OpenText& text);
    void publish(const app::TextCheck& check);
    [[nodiscard]] OpenText& text_of(const nlohmann::json& asked);

    Sink send_;
    std::map<std::string, OpenText> texts_;
    bool is_initialized_ = false;
    bool is_shut_down_ = false;
    bool has_ended_ = false;
    bool snippets_ = false;
    /// Protects the texts' versions and findings, which the checks' thread uses.
    std::mutex found_mutex_;
    app::TextChecks checks_;  // The last member: its thread uses the others.
};

}  // namespace balcony::lsp
