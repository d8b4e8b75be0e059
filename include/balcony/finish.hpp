// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Finish: what becomes of a film after its last pass.

#include <cstddef>
#include <filesystem>
#include <optional>

#include "balcony/denoise.hpp"
#include "balcony/film.hpp"

namespace balcony::render {

/// How a film becomes a file.
struct Finish {
    std::filesystem::path output{};  ///< "-" is a stream.
    std::optional<Denoiser> denoiser{};
    std::size_t threads = 0;  ///< Of the denoiser, as DenoiseOptions::threads.
    double exposure = 0.0;    ///< In stops.
    ViewTransform view = ViewTransform::neutral;
    bool dither = true;
    double dpi = 0.0;  ///< As DisplayOptions::dpi.

    /// Null for EXR. A stream is PNG.
    [[nodiscard]] const DisplayFormat* display_format() const;
};

}  // namespace balcony::render
