// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/picture_flow.hpp"

#include <utility>

namespace balcony::studio {

void PictureFlow::show(const Bytes& frame) {
    waiting_ = frame;
    rest_.reset();
    send_next();
}

void PictureFlow::rest(std::string message) {
    rest_ = std::move(message);
    send_next();
}

void PictureFlow::seen() {
    is_under_way_ = false;
    send_next();
}

void PictureFlow::send_next() {
    if (waiting_ && !is_under_way_) {
        is_under_way_ = true;
        socket_.send(std::exchange(waiting_, nullptr));
    }
    if (!waiting_ && rest_) {
        socket_.send(*std::exchange(rest_, std::nullopt));
    }
}

}  // namespace balcony::studio
