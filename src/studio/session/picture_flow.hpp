// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Pictures on their way to a page, which says when it has seen one. Until then, the newest of the
// next ones waits, so that a slow page is never behind.

#include <optional>
#include <string>

#include "studio/web/server.hpp"

namespace balcony::studio {

class PictureFlow {
public:
    explicit PictureFlow(Socket& socket) : socket_(socket) {}

    void show(const Bytes& frame);
    /// Goes behind the pictures.
    void rest(std::string message);
    /// The page has seen what was sent.
    void seen();

private:
    void send_next();

    Socket& socket_;
    bool is_under_way_ = false;
    Bytes waiting_;
    std::optional<std::string> rest_;
};

}  // namespace balcony::studio
