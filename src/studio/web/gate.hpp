// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What all connections of a server have in common.

#include <cstddef>
#include <cstdint>
#include <memory>
#include <set>
#include <string>
#include <utility>

#include "studio/web/access.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class WebSocket;

struct Gate {
    Gate(std::uint16_t port_number, std::string secret)
        : port(port_number), token(std::move(secret)), names(port_number) {}

    std::uint16_t port;
    std::string token;
    OwnNames names;
    SocketUserMaker make_user{};
    std::set<WebSocket*> sockets{};  ///< Those that are open.
    std::size_t connections = 0;     ///< With those of the sockets.
};

/// Counts a connection as long as it is there.
class CountedConnection {
public:
    explicit CountedConnection(std::shared_ptr<Gate> gate) : gate_(std::move(gate)) {
        ++gate_->connections;
    }
    CountedConnection(CountedConnection&&) noexcept = default;
    CountedConnection& operator=(CountedConnection&&) = delete;
    ~CountedConnection() {
        if (gate_) {
            --gate_->connections;
        }
    }
    [[nodiscard]] const std::shared_ptr<Gate>& gate() const { return gate_; }

private:
    std::shared_ptr<Gate> gate_;
};

}  // namespace balcony::studio
