// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/web/http_connection.hpp"

#include <chrono>
#include <string_view>
#include <utility>

#include <boost/beast/http/read.hpp>
#include <boost/beast/http/write.hpp>
#include <boost/beast/websocket/rfc6455.hpp>

#include "studio/web/web_socket.hpp"

namespace balcony::studio {

namespace beast = boost::beast;
namespace http = beast::http;

namespace {

constexpr std::uint32_t longest_header = 16384;
constexpr std::size_t buffer_size = 2 * longest_header;
constexpr std::chrono::seconds patience(30);

std::string_view text_of(beast::string_view text) { return {text.data(), text.size()}; }

}  // namespace

HttpConnection::HttpConnection(boost::asio::ip::tcp::socket&& socket, std::shared_ptr<Gate> gate)
    : counted_(std::move(gate)), stream_(std::move(socket)), buffer_(buffer_size) {
    parser_.header_limit(longest_header);
}

void HttpConnection::serve() {
    stream_.expires_after(patience);
    http::async_read_header(stream_, buffer_, parser_,
                            [self = shared_from_this()](beast::error_code failure, std::size_t) {
                                if (!failure) {
                                    self->answer();
                                }
                            });
}

void HttpConnection::answer() {
    if (std::optional<Response> refusal = response()) {
        send(std::move(*refusal));
        return;
    }
    std::make_shared<WebSocket>(std::move(stream_), std::move(counted_))->accept(parser_.release());
}

std::optional<Response> HttpConnection::response() {
    const auto& request = parser_.get();
    const Gate& gate = *counted_.gate();
    const auto refused = [&gate](http::status status, std::string_view reason) {
        return refusal_response(status, reason, gate.port);
    };
    const std::string_view target = text_of(request.target());
    const std::string_view path = target.substr(0, target.find('?'));
    const auto origin = request.find(http::field::origin);
    if (request.count(http::field::host) != 1 ||
        !gate.names.has_host(text_of(request[http::field::host]))) {
        return refused(http::status::forbidden, "the name of this server is another one");
    }
    if (origin != request.end() && !gate.names.has_origin(text_of(origin->value()))) {
        return refused(http::status::forbidden, "pages of other servers are not served");
    }
    if (request.method() != http::verb::get) {
        return refused(http::status::method_not_allowed, "only GET is served");
    }
    if (path != "/live") {
        return file_response(path, gate.port);
    }
    if (!is_same_secret(query_value(target, "token"), gate.token)) {
        return refused(http::status::forbidden,
                       "the token is another one: open the address that balcony studio prints");
    }
    if (!beast::websocket::is_upgrade(request)) {
        return refused(http::status::upgrade_required, "a WebSocket is served here");
    }
    if (gate.sockets.size() >= Server::most_sockets) {
        return refused(http::status::service_unavailable,
                       "there are 16 pages already: close one of them");
    }
    return std::nullopt;
}

void HttpConnection::send(Response response) {
    response_ = std::move(response);
    stream_.expires_after(patience);
    http::async_write(
        stream_, *response_, [self = shared_from_this()](beast::error_code, std::size_t) {
            beast::error_code ignored;
            self->stream_.socket().shutdown(boost::asio::ip::tcp::socket::shutdown_send, ignored);
        });
}

}  // namespace balcony::studio
