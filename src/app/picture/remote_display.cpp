// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/picture/remote_display.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cstdint>
#include <cstring>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <netdb.h>
#include <sys/socket.h>
#include <sys/time.h>
#include <unistd.h>

namespace balcony::app {

namespace {

constexpr std::array<std::string_view, 4> channels{"R", "G", "B", "A"};
constexpr int seconds_to_wait = 2;

// Numbers are little-endian. A message begins with its length, and texts end with a zero.
class Message {
public:
    enum class Type : std::uint8_t { create_image = 4, update_image = 6 };

    Message(Type type, std::string_view picture) {
        add(std::uint32_t{0});
        add(type);
        add(std::uint8_t{0});  // It does not come to the front.
        add(picture);
    }

    template <class Number>
    void add(Number number) {
        static_assert(std::endian::native == std::endian::little);
        add(&number, sizeof(number));
    }
    void add(std::string_view text) {
        add(text.data(), text.size());
        add('\0');
    }
    void add_channels() {
        add(static_cast<std::int32_t>(channels.size()));
        for (const std::string_view channel : channels) {
            add(channel);
        }
    }
    void add(const void* data, std::size_t size) {
        const auto* const bytes = static_cast<const char*>(data);
        bytes_.insert(bytes_.end(), bytes, bytes + size);
    }

    [[nodiscard]] const std::vector<char>& finished() {
        const auto length = static_cast<std::uint32_t>(bytes_.size());
        std::memcpy(bytes_.data(), &length, sizeof(length));
        return bytes_;
    }

private:
    std::vector<char> bytes_;
};

bool send_all(int socket, const std::vector<char>& bytes) {
    for (std::size_t sent = 0; sent < bytes.size();) {
        const ssize_t now = send(socket, &bytes[sent], bytes.size() - sent, MSG_NOSIGNAL);
        if (now <= 0) {
            return false;
        }
        sent += static_cast<std::size_t>(now);
    }
    return true;
}

// Without a connection, -1.
int connected_socket(const DisplayAddress& address) {
    addrinfo wanted{};
    wanted.ai_socktype = SOCK_STREAM;
    addrinfo* found = nullptr;
    if (getaddrinfo(address.host.c_str(), std::to_string(address.port).c_str(), &wanted, &found) !=
        0) {
        return -1;
    }
    const std::unique_ptr<addrinfo, decltype(&freeaddrinfo)> all(found, freeaddrinfo);
    for (const addrinfo* one = all.get(); one != nullptr; one = one->ai_next) {
        const int made = socket(one->ai_family, one->ai_socktype | SOCK_CLOEXEC, one->ai_protocol);
        if (made < 0) {
            continue;
        }
        // The time limits connecting as well as sending.
        const timeval limit{seconds_to_wait, 0};
        setsockopt(made, SOL_SOCKET, SO_SNDTIMEO, &limit, sizeof(limit));
        if (::connect(made, one->ai_addr, one->ai_addrlen) == 0) {
            return made;
        }
        ::close(made);
    }
    return -1;
}

Message picture_message(const std::string& name, const render::Film& film) {
    Message message(Message::Type::create_image, name);
    message.add(static_cast<std::int32_t>(film.width));
    message.add(static_cast<std::int32_t>(film.height));
    message.add_channels();
    return message;
}

// Some rows of the film's window, pixel by pixel.
Message rows_message(const std::string& name, const render::Film& film, std::size_t first,
                     std::size_t count) {
    const render::Region& window = film.window;
    Message message(Message::Type::update_image, name);
    message.add_channels();
    for (const std::size_t side : {window.x, window.y + first, window.width, count}) {
        message.add(static_cast<std::int32_t>(side));
    }
    for (std::size_t c = 0; c < channels.size(); ++c) {
        message.add(static_cast<std::int64_t>(c));  // The first value of the channel,
    }
    for (std::size_t c = 0; c < channels.size(); ++c) {
        message.add(static_cast<std::int64_t>(channels.size()));  // and how far it is to the next.
    }
    for (std::size_t y = window.y + first; y < window.y + first + count; ++y) {
        for (std::size_t x = window.x; x < window.x + window.width; ++x) {
            const render::Color4f color = film.pixel(x, y);
            message.add(std::array{color.r, color.g, color.b, color.a});
        }
    }
    return message;
}

}  // namespace

RemoteDisplay::RemoteDisplay(RemoteDisplay&& other) noexcept
    : socket_(std::exchange(other.socket_, -1)), name_(std::move(other.name_)) {}

RemoteDisplay::~RemoteDisplay() { close(); }

void RemoteDisplay::close() {
    if (socket_ >= 0) {
        ::close(std::exchange(socket_, -1));
    }
}

Result<RemoteDisplay> RemoteDisplay::connect(const DisplayAddress& address, const std::string& name,
                                             const render::Film& film) {
    const int socket = connected_socket(address);
    if (socket < 0) {
        return error(Kind::environment,
                     fmt::format("no program shows pictures at {}", address.text()),
                     "start tev first, or name the address at which it listens");
    }
    RemoteDisplay made(socket, name);
    if (!send_all(socket, picture_message(name, film).finished())) {
        return error(Kind::environment,
                     fmt::format("the program at {} takes no picture", address.text()),
                     "start tev there");
    }
    return made;
}

Diagnostics RemoteDisplay::show(const render::Film& film) {
    constexpr std::size_t most_pixels = std::size_t{1} << 18;  // In a message.
    const std::size_t rows = std::max<std::size_t>(most_pixels / film.window.width, 1);
    for (std::size_t y = 0; socket_ >= 0 && y < film.window.height; y += rows) {
        const std::size_t count = std::min(rows, film.window.height - y);
        if (!send_all(socket_, rows_message(name_, film, y, count).finished())) {
            close();
            return {warning("the program that shows the picture does not take it any more", {},
                            "the render goes on without it")};
        }
    }
    return {};
}

}  // namespace balcony::app
