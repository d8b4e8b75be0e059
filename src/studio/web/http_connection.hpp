// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A connection with one request: for a file, or for a socket, which then takes the connection.

#include <memory>
#include <optional>

#include <boost/asio/ip/tcp.hpp>
#include <boost/beast/core/flat_buffer.hpp>
#include <boost/beast/core/tcp_stream.hpp>
#include <boost/beast/http/parser.hpp>
#include <boost/beast/http/string_body.hpp>

#include "studio/web/gate.hpp"
#include "studio/web/page_response.hpp"

namespace balcony::studio {

class HttpConnection final : public std::enable_shared_from_this<HttpConnection> {
public:
    HttpConnection(boost::asio::ip::tcp::socket&& socket, std::shared_ptr<Gate> gate);

    void serve();

private:
    using Parser = boost::beast::http::request_parser<boost::beast::http::string_body>;

    void answer();
    /// Why a request is refused; nothing if a socket takes it.
    [[nodiscard]] std::optional<Response> response();
    void send(Response response);

    CountedConnection counted_;
    boost::beast::tcp_stream stream_;
    boost::beast::flat_buffer buffer_;
    Parser parser_;
    std::optional<Response> response_;
};

}  // namespace balcony::studio
