// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A WebSocket on Boost.Beast.

#include <cstddef>
#include <deque>
#include <memory>
#include <string>
#include <variant>

#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/message.hpp>
#include <boost/beast/http/string_body.hpp>
#include <boost/beast/websocket.hpp>

#include "studio/web/gate.hpp"
#include "studio/web/server.hpp"

namespace balcony::studio {

class WebSocket final : public Socket, public std::enable_shared_from_this<WebSocket> {
public:
    using Request = boost::beast::http::request<boost::beast::http::string_body>;

    WebSocket(boost::beast::tcp_stream&& stream, CountedConnection counted);
    ~WebSocket() override;

    /// Answers the request that asks for it, makes its user, and reads from then on.
    void accept(Request request);

    void send(std::string text) override;
    void send(Bytes bytes) override;
    /// Says that the server ends.
    void close();
    /// It has no user any more.
    void release() { user_.reset(); }

private:
    using Message = std::variant<std::string, Bytes>;
    using Failure = boost::beast::error_code;

    void read();
    void take(Failure failure);
    void queue(Message message);
    void write();
    void end(boost::beast::websocket::close_code code);

    CountedConnection counted_;
    boost::beast::websocket::stream<boost::beast::tcp_stream> stream_;
    boost::beast::flat_buffer buffer_;
    Request request_;
    std::deque<Message> queue_;  ///< The first one is being written.
    std::size_t queued_bytes_ = 0;
    bool is_ending_ = false;
    std::unique_ptr<SocketUser> user_;
};

}  // namespace balcony::studio
