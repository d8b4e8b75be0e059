// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "cli/options/render_options.hpp"
#include "cli/picture_run.hpp"

namespace balcony::cli {

/// What the options of a render ask for; what cannot be read is added to `diagnostics`, each with
/// its option. The environment is not read yet.
[[nodiscard]] Request read_request(const RenderOptions& options, Diagnostics& diagnostics);

}  // namespace balcony::cli
