// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Options of all commands that render.

#include "cli/options/render_options.hpp"

namespace balcony::cli {

/// What is rendered, and through which camera.
void add_scene_options(CLI::App& command, RenderOptions& options);
/// What the picture is like.
void add_picture_options(CLI::App& command, RenderOptions& options);
/// How the command runs and reports.
void add_run_options(CLI::App& command, RenderOptions& options);

}  // namespace balcony::cli
