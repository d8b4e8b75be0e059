// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "balcony/app.hpp"

namespace balcony::cli {

/// Rejects an output that cannot be written, before rendering: of a stream also if it is a
/// terminal.
[[nodiscard]] Diagnostics check_output(const std::filesystem::path& output);

/// The pictures of several scenes, which are alike but for these and their outputs. Expands
/// patterns of scenes such as '*.glb' that the shell has left, and "{scene}" in the name of the
/// output. Without a name, a picture is in this folder and named after its scene. Several scenes
/// need several outputs.
[[nodiscard]] std::vector<app::Request> pictures_of(const std::vector<std::string>& scenes,
                                                    const std::optional<std::string>& output,
                                                    const app::Request& request,
                                                    Diagnostics& diagnostics);

}  // namespace balcony::cli
