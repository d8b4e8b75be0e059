// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A server for the browsers of this machine: the files of the page, and sockets to it.
//
// All that users of the server are told comes from the thread of run(), one call at a time.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::studio {

using Bytes = std::shared_ptr<const std::vector<std::uint8_t>>;

/// A WebSocket. Its functions are called on the thread of the server, and do not wait.
class Socket {
public:
    Socket() = default;
    Socket(const Socket&) = delete;
    Socket& operator=(const Socket&) = delete;
    virtual ~Socket() = default;

    virtual void send(std::string text) = 0;
    virtual void send(Bytes bytes) = 0;
};

/// What uses a socket.
class SocketUser {
public:
    SocketUser() = default;
    SocketUser(const SocketUser&) = delete;
    SocketUser& operator=(const SocketUser&) = delete;
    virtual ~SocketUser() = default;

    /// A message of the page.
    virtual void receive(std::string_view text) = 0;
};

/// Makes the user of a new socket, which is alive as long as its user. The user is destroyed when
/// the socket is closed.
using SocketUserMaker = std::function<std::unique_ptr<SocketUser>(Socket&)>;

class Server {
public:
    static constexpr std::size_t longest_message = 16'000'000;  ///< In bytes.
    static constexpr std::size_t most_sockets = 16;

    /// Listens at 127.0.0.1, at a free port for 0. Sockets need the token.
    [[nodiscard]] static Result<std::unique_ptr<Server>> listen(std::uint16_t port,
                                                                std::string token);
    Server() = default;
    Server(const Server&) = delete;
    Server& operator=(const Server&) = delete;
    virtual ~Server() = default;

    [[nodiscard]] virtual std::uint16_t port() const = 0;
    /// Calls a function soon, on the thread of run(). May be called from any thread, before and
    /// after run(), too.
    virtual void post(std::function<void()> function) = 0;
    /// Serves until a stop.
    virtual void run(SocketUserMaker make_user, const std::stop_token& stop) = 0;
};

}  // namespace balcony::studio
