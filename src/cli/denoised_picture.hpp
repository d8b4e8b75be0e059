// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Denoising between the last pass and the file.

#include "cli/picture_run.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

/// An empty film, with what denoising needs beside the layers of the file.
[[nodiscard]] Result<render::Film> make_film(render::FilmLayout layout, const Request& request);

/// Denoises as requested. A picture that cannot be denoised stays as it is, with a warning.
void denoise(const Request& request, render::Film& film, RenderReport& outcome);

}  // namespace balcony::cli
