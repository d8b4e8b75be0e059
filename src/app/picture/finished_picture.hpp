// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// From the last pass to the file: denoising, exposure, writing.

#include <optional>

#include "balcony/app.hpp"

namespace balcony::app {

[[nodiscard]] Finish finish_of(const Request& request);

/// An empty film, with what denoising needs beside the layers of the file.
[[nodiscard]] Result<render::Film> make_film(render::FilmLayout layout, const Request& request);

/// Denoises if that is wanted. A film that cannot be denoised stays as it is, which is an error.
[[nodiscard]] Result<std::optional<render::DenoiseSummary>> denoise(const Finish& finish,
                                                                    render::Film& film);
/// The same, but with a warning instead of the error.
[[nodiscard]] std::optional<render::DenoiseSummary> try_to_denoise(const Finish& finish,
                                                                   render::Film& film,
                                                                   Diagnostics& found);

}  // namespace balcony::app
