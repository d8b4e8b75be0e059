// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The film of an animation and the folder of its frames.

#include <filesystem>
#include <stop_token>
#include <vector>

#include "balcony/animation.hpp"

namespace balcony::app {

/// Makes the folder of the frames, unless it is there.
[[nodiscard]] Diagnostics make_film_folder(const FilmRequest& film);

/// An error if the file of a frame is one of the inputs.
[[nodiscard]] Diagnostics check_inputs(const FramePattern& pattern,
                                       const std::vector<std::filesystem::path>& inputs);

/// Removes the frames and their folder, but nothing that this program has not written there.
void remove_frame_files(const FramePattern& pattern);

/// Makes the film of its frames, and then removes them, if that is wanted. A stop is an error of
/// Kind::interrupted.
[[nodiscard]] Diagnostics make_film_of_frames(const FilmRequest& film, const FramePattern& pattern,
                                              const FrameNumbers& frames, bool remove_frames,
                                              const Observer& observer,
                                              const std::stop_token& stop);

}  // namespace balcony::app
