// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/web/web_socket.hpp"

#include <exception>
#include <utility>

#include <boost/asio/buffer.hpp>

namespace balcony::studio {

namespace net = boost::asio;
namespace beast = boost::beast;
namespace websocket = beast::websocket;

namespace {

/// A page that does not read so much is not there any more.
constexpr std::size_t most_queued_bytes = 64'000'000;

net::const_buffer buffer_of(const std::variant<std::string, Bytes>& message) {
    if (const auto* text = std::get_if<std::string>(&message)) {
        return net::buffer(*text);
    }
    return net::buffer(*std::get<Bytes>(message));
}

}  // namespace

WebSocket::WebSocket(beast::tcp_stream&& stream, CountedConnection counted)
    : counted_(std::move(counted)), stream_(std::move(stream)) {
    counted_.gate()->sockets.insert(this);
}

WebSocket::~WebSocket() { counted_.gate()->sockets.erase(this); }

void WebSocket::accept(Request request) {
    // Beast has its own: a page that has not answered a ping for minutes is gone.
    beast::get_lowest_layer(stream_).expires_never();
    stream_.set_option(websocket::stream_base::timeout::suggested(beast::role_type::server));
    stream_.read_message_max(Server::longest_message);
    stream_.auto_fragment(false);
    request_ = std::move(request);
    stream_.async_accept(request_, [self = shared_from_this()](Failure failure) {
        if (!failure) {
            self->user_ = self->counted_.gate()->make_user(*self);
            self->read();
        }
    });
}

void WebSocket::read() {
    stream_.async_read(buffer_, [self = shared_from_this()](Failure failure, std::size_t) {
        self->take(failure);
    });
}

void WebSocket::take(Failure failure) {
    if (failure) {
        release();
        return;
    }
    if (stream_.got_binary()) {
        end(websocket::close_code::unknown_data);
    } else if (user_) {
        const net::const_buffer read = buffer_.cdata();
        try {
            user_->receive({static_cast<const char*>(read.data()), read.size()});
        } catch (const std::exception&) {
            end(websocket::close_code::internal_error);
        }
    }
    buffer_.clear();
    read();
}

void WebSocket::send(std::string text) { queue(std::move(text)); }
void WebSocket::send(Bytes bytes) { queue(std::move(bytes)); }

void WebSocket::queue(Message message) {
    if (is_ending_) {
        return;
    }
    queued_bytes_ += buffer_of(message).size();
    if (queued_bytes_ > most_queued_bytes) {
        is_ending_ = true;
        beast::get_lowest_layer(stream_).close();
        return;
    }
    queue_.push_back(std::move(message));
    if (queue_.size() == 1) {
        write();
    }
}

void WebSocket::write() {
    stream_.text(std::holds_alternative<std::string>(queue_.front()));
    stream_.async_write(buffer_of(queue_.front()),
                        [self = shared_from_this()](Failure failure, std::size_t) {
                            self->queued_bytes_ -= buffer_of(self->queue_.front()).size();
                            self->queue_.pop_front();
                            if (!failure && !self->queue_.empty()) {
                                self->write();
                            }
                        });
}

void WebSocket::close() { end(websocket::close_code::going_away); }

void WebSocket::end(websocket::close_code code) {
    if (!std::exchange(is_ending_, true)) {
        stream_.async_close(code, [self = shared_from_this()](Failure) {});
    }
}

}  // namespace balcony::studio
