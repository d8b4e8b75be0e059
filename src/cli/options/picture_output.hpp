// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <vector>

#include "balcony/app.hpp"
#include "cli/options/render_options.hpp"

namespace balcony::cli {

/// Rejects an output that cannot be written, before rendering: of a stream also if it is a
/// terminal.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& output);

/// The pictures of a command line, which are alike but for their scenes and outputs. Expands
/// patterns of scenes such as '*.glb' that the shell has left, and "{scene}" in the name of the
/// output. Without a name, a picture is in this folder and named after its scene. Several scenes
/// need several outputs.
[[nodiscard]] std::vector<app::Request> pictures_of(const RenderOptions& options,
                                                    const app::Request& request,
                                                    Diagnostics& diagnostics);

}  // namespace balcony::cli
