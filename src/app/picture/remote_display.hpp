// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A program in which a picture is seen while it is rendered: tev, or another one that takes its
// messages (github.com/Tom94/tev, Ipc.h).

#include <optional>
#include <string>
#include <utility>

#include "balcony/film.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// A connection to the program, on which the film of one picture is shown. It does not wait for a
/// program that does not listen.
class RemoteDisplay {
public:
    /// Connects, and opens a picture of this name. A program that cannot be reached is an error.
    [[nodiscard]] static Result<RemoteDisplay> connect(const DisplayAddress& address,
                                                       const std::string& name,
                                                       const render::Film& film);
    RemoteDisplay(RemoteDisplay&& other) noexcept;
    RemoteDisplay& operator=(RemoteDisplay&&) = delete;
    ~RemoteDisplay();

    /// Shows the film as it is: linear light before exposure. After the first time that this
    /// fails, which is a warning, nothing is shown any more.
    [[nodiscard]] Diagnostics show(const render::Film& film);

private:
    RemoteDisplay(int socket, std::string name) : socket_(socket), name_(std::move(name)) {}
    void close();

    int socket_ = -1;
    std::string name_;
};

}  // namespace balcony::app
