// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <stop_token>

#include "balcony/picture.hpp"
#include "balcony/render.hpp"

namespace balcony::app {

/// A first look at a whole picture: a small one of fixed size, samples and seed. So what is chosen
/// by it is the same for any size of the same aspect, any number of samples and any part.
struct Look {
    double exposure = 0.0;  ///< In stops, as automatic_exposure().
    render::Summary summary{};
};

/// Of the settings, the samples and the seed do not count. An interrupted look has a summary that
/// says so.
[[nodiscard]] Result<Look> look_at(const camera::Picture& picture, const render::Renderer& renderer,
                                   render::Settings settings, const render::FilmLayout& layout,
                                   const std::stop_token& stop);

}  // namespace balcony::app
