// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/web/server.hpp"

#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <boost/asio/io_context.hpp>
#include <boost/asio/ip/address_v4.hpp>
#include <boost/asio/ip/tcp.hpp>
#include <boost/asio/post.hpp>
#include <boost/asio/steady_timer.hpp>

#include "studio/web/gate.hpp"
#include "studio/web/http_connection.hpp"
#include "studio/web/web_socket.hpp"

namespace balcony::studio {

namespace {

namespace net = boost::asio;
using net::ip::tcp;
using Failure = boost::system::error_code;

constexpr std::size_t most_connections = 64;

class AsioServer final : public Server {
public:
    // The name of the failure is empty if it listens.
    AsioServer(std::uint16_t port, std::string token, Failure& failure) {
        const tcp::endpoint here(net::ip::address_v4::loopback(), port);
        acceptor_.open(here.protocol(), failure);
        if (!failure) {
            acceptor_.set_option(net::socket_base::reuse_address(true), failure);
        }
        if (!failure) {
            acceptor_.bind(here, failure);
        }
        if (!failure) {
            acceptor_.listen(net::socket_base::max_listen_connections, failure);
        }
        if (!failure) {
            gate_ = std::make_shared<Gate>(acceptor_.local_endpoint().port(), std::move(token));
        }
    }

    [[nodiscard]] std::uint16_t port() const override { return gate_->port; }

    void post(std::function<void()> function) override { net::post(context_, std::move(function)); }

    void run(SocketUserMaker make_user, const std::stop_token& stop) override {
        gate_->make_user = std::move(make_user);
        accept();
        const std::stop_callback stopping(stop, [this] { post([this] { end(); }); });
        context_.run();
        for (WebSocket* const socket : gate_->sockets) {
            socket->release();
        }
    }

private:
    void accept() {
        acceptor_.async_accept([this](Failure failure, tcp::socket socket) {
            if (failure == net::error::operation_aborted) {
                return;
            }
            if (failure) {
                // No descriptor is free, say.
                wait(std::chrono::milliseconds(100), [this] { accept(); });
                return;
            }
            if (gate_->connections < most_connections) {
                Failure ignored;
                socket.set_option(tcp::no_delay(true), ignored);
                std::make_shared<HttpConnection>(std::move(socket), gate_)->serve();
            }
            accept();
        });
    }

    // Pages are told, but not waited for.
    void end() {
        Failure ignored;
        acceptor_.close(ignored);
        for (WebSocket* const socket : gate_->sockets) {
            socket->close();
        }
        wait(std::chrono::milliseconds(200), [this] { context_.stop(); });
    }

    template <class Then>
    void wait(std::chrono::milliseconds time, Then then) {
        timer_.expires_after(time);
        timer_.async_wait([then](Failure failure) {
            if (!failure) {
                then();
            }
        });
    }

    std::shared_ptr<Gate> gate_;  // The context destroys connections, which use it.
    net::io_context context_{1};
    tcp::acceptor acceptor_{context_};
    net::steady_timer timer_{context_};
};

}  // namespace

Result<std::unique_ptr<Server>> Server::listen(std::uint16_t port, std::string token) {
    Failure failure;
    auto server = std::make_unique<AsioServer>(port, std::move(token), failure);
    if (failure) {
        return error(
            Kind::environment,
            fmt::format("port {} of 127.0.0.1 cannot be used: {}", port, failure.message()),
            "give another --port, or leave it out for a free one");
    }
    return std::unique_ptr<Server>(std::move(server));
}

}  // namespace balcony::studio
