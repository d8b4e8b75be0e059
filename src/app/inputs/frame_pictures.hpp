// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The picture at other times, and where points are in it then.

#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

#include "balcony/picture.hpp"
#include "balcony/render.hpp"
#include "balcony/request.hpp"
#include "balcony/scene.hpp"

namespace balcony::app {

/// Whether a request selects a camera of the scene, or its default one, and cameras move.
[[nodiscard]] bool has_moving_camera(const Request& request, const scene::Scene& scene);

/// The picture at a time. A camera of the scene has one place, so that it is made anew, with the
/// turn of the picture.
[[nodiscard]] Result<camera::Picture> picture_at(const Request& request, const scene::Scene& scene,
                                                 const camera::Picture& picture, double time);

/// The inverses of a picture at the times of frames. Each is made once: the next frame of one is
/// the previous frame of the one after the next. A picture that is at rest has a single one.
class FrameInverses {
public:
    /// The picture has this size in pixels. Cameras of the scene stand where its motion puts them.
    FrameInverses(const Request& request, std::pair<std::size_t, std::size_t> size)
        : request_(request), size_(size) {}

    /// Adds the inverses in the previous and the next frame to the settings.
    [[nodiscard]] Diagnostics add_to(render::Settings& settings, const scene::Scene& scene,
                                     const camera::Picture& picture, const std::stop_token& stop);

    /// How many inverses were made so far.
    [[nodiscard]] std::size_t made() const { return made_; }

private:
    using Inverse = std::shared_ptr<const rays::ImagePointFinder>;
    [[nodiscard]] Inverse at(double time, const scene::Scene& scene, const camera::Picture& picture,
                             const std::stop_token& stop, Diagnostics& found);

    const Request& request_;
    std::pair<std::size_t, std::size_t> size_;
    std::map<double, Inverse> inverses_;
    std::size_t made_ = 0;
};

}  // namespace balcony::app
