// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "balcony/render.hpp"
#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// Renders a picture whose film is larger than the memory for it, band by band, and appends the
/// bands to its EXR file. The files are those that the picture is made of.
[[nodiscard]] RenderReport make_banded_picture(
    RenderReport outcome, const RenderOptions& options, const Request& request,
    std::vector<std::filesystem::path> files, const render::Renderer& renderer,
    const camera::Picture& picture, const render::FilmLayout& layout, const PictureOutput& output);

}  // namespace balcony::cli
