// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The film of an animation and the folder of its frames.

#include <stop_token>

#include "balcony/animation.hpp"

namespace balcony::app {

/// Makes the folder of the frames, unless it is there.
[[nodiscard]] Diagnostics make_film_folder(const FilmRequest& film);

/// Makes the film of its frames, and then removes them, if that is wanted. A stop is an error of
/// Kind::interrupted.
[[nodiscard]] Diagnostics make_film_of_frames(const FilmRequest& film, const FramePattern& pattern,
                                              const FrameNumbers& frames, bool remove_frames,
                                              const Observer& observer,
                                              const std::stop_token& stop);

}  // namespace balcony::app
