// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <memory>
#include <optional>

#include "app/inputs/loaded.hpp"
#include "balcony/app.hpp"

namespace balcony::app {

/// What a session keeps, and how it renders.
struct SessionState {
    Loaded loaded;
    std::optional<Request> last;
    std::shared_ptr<const render::Film> film;
    bool is_outdated = false;  ///< The picture in progress is of no use any more.

    /// Keeps what is loaded if it is what the request needs.
    void prepare(const Request& request);
    void render(const Request& request, const Observer& observer, const std::stop_token& stop,
                Report& report);
    /// A picture of the scene that is loaded, with its settings.
    void render_picture(const camera::Picture& loaded_picture, const Request& request,
                        const Observer& observer, const std::stop_token& stop, Report& report);
};

struct Session::State : SessionState {};

/// Renders a picture of a scene that is loaded, with the light and the settings of a request. The
/// scene keeps the files of environments that are read. The film is as Session::film().
[[nodiscard]] Report render_in(Loaded& scene, const camera::Picture& picture,
                               const Request& request, const Observer& observer,
                               const std::stop_token& stop,
                               std::shared_ptr<const render::Film>& film);

}  // namespace balcony::app
