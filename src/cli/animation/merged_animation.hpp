// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The frames of an animation that several machines rendered, as a sequence or a film.

#include <string>

#include "cli/report/progress_display.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Whether a name is that of a film, or of frames with their record beside them.
[[nodiscard]] bool is_animation(const std::string& name);

/// Joins the parts of frames that are in parts, and makes the film: the one of this name, or of a
/// sequence the one that `output` names, if it is not empty. Frames that are missing are an error,
/// which names them.
[[nodiscard]] RenderReport merge_animation(const std::string& name, const std::string& output,
                                           ProgressDisplay& display);

}  // namespace balcony::cli
