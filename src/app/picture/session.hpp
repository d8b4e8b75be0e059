// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "app/inputs/loaded.hpp"
#include "balcony/app.hpp"

namespace balcony::app {

struct Session::State {
    Loaded loaded;
    std::optional<Request> last;
    std::shared_ptr<const render::Film> film;
    bool is_outdated = false;  ///< The picture in progress is of no use any more.

    /// Keeps what is loaded if it is what the request needs.
    void prepare(const Request& request);
    void render(const Request& request, const Observer& observer, const std::stop_token& stop,
                Report& report);
};

}  // namespace balcony::app
