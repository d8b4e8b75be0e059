// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A page at the other end of a socket.

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

#include <nlohmann/json.hpp>

#include "lsp/server.hpp"
#include "studio/session/picture_flow.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class Studio;

class PageClient final : public SocketUser {
public:
    PageClient(Studio& studio, Socket& socket);
    ~PageClient() override;

    /// Another one for each page.
    [[nodiscard]] int number() const { return number_; }

    void receive(std::string_view text) override;

    void tell(const nlohmann::json& message);
    void tell(const Bytes& picture) { socket_.send(picture); }
    void show(const Bytes& frame) { flow_.show(frame); }
    void rest(const nlohmann::json& message);
    /// Somebody else has changed the text: the message says so.
    void replace_text(const nlohmann::json& message);

private:
    struct Row;
    struct TextRow;
    struct PictureRow;
    static const Row rows[];
    static const TextRow text_rows[];
    static const PictureRow picture_rows[];
    using Reply = std::function<void(const std::function<nlohmann::json()>&)>;

    [[nodiscard]] std::optional<nlohmann::json> handle(const nlohmann::json& message);
    [[nodiscard]] bool is_about_text(const nlohmann::json& message) const;
    [[nodiscard]] bool take_text(const nlohmann::json& told);
    /// The names of all that the studio adds to the Language Server Protocol.
    [[nodiscard]] static nlohmann::json requests();
    void require_beginning() const;
    [[nodiscard]] bool has_late_answer(std::string_view method, const nlohmann::json& message);
    [[nodiscard]] Reply replying(const nlohmann::json& id) const;
    void ask(const TextRow& row, const nlohmann::json& id, const nlohmann::json& asked);
    void ask(const PictureRow& row, const nlohmann::json& id, const nlohmann::json& asked);

    [[nodiscard]] nlohmann::json change_view(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json drag(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json see(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json list_cameras(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json show_cameras(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json write_camera(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json start_rendering(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json stop_rendering(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json command(const nlohmann::json& asked);
    [[nodiscard]] nlohmann::json save(const nlohmann::json& asked);

    Studio& studio_;
    Socket& socket_;
    int number_;
    PictureFlow flow_;
    bool has_joined_ = false;
    std::shared_ptr<PageClient*> self_;  ///< What other threads post finds the page by it.
    lsp::Sink later_;                    ///< Takes a message from any thread.
    lsp::LanguageServer language_;
};

}  // namespace balcony::studio
