// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The film of an animation and the folder of its frames.

#include <stop_token>

#include "cli/animation/film_file.hpp"
#include "cli/animation/frame_numbers.hpp"
#include "cli/animation/frame_pattern.hpp"
#include "cli/report/progress_display.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Makes the folder of the frames, unless it is there.
void add_film_folder(const FilmRequest& film, Diagnostics& diagnostics);

/// Makes the film of its frames, and then removes them, if that is wanted.
void make_film_of_frames(const FilmRequest& film, const FramePattern& pattern,
                         const FrameNumbers& frames, bool remove_frames, ProgressDisplay& display,
                         RenderReport& outcome, const std::stop_token& stop);

}  // namespace balcony::cli
