// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/render.hpp"
#include "cli/loaded_picture.hpp"
#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Renders a picture whose film is larger than the memory for it, band by band, and appends the
/// bands to its EXR file.
[[nodiscard]] RenderReport make_banded_picture(RenderReport outcome, const RenderOptions& options,
                                               const Request& request, const Loaded& loaded,
                                               const camera::Picture& picture,
                                               const render::FilmLayout& layout,
                                               const PictureOutput& output);

}  // namespace balcony::cli
