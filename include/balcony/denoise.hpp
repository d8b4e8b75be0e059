// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Denoise: removes the noise of a finished film. docs/denoising.md describes the methods.

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"
#include "balcony/names.hpp"

namespace balcony::render {

enum class Denoiser : std::uint8_t {
    automatic,  ///< `library` if there is one, otherwise `features`.
    library,    ///< Intel Open Image Denoise 1 or 2, a library of the machine.
    features,   ///< Balcony's own filter, which is the same on every machine.
};

[[nodiscard]] Names<Denoiser> denoisers();

struct DenoiseOptions {
    Denoiser denoiser = Denoiser::automatic;
    /// The file of the library; by default the one that the system finds under its usual names.
    std::filesystem::path library{};
    std::size_t threads = 0;  ///< Of Balcony's own filter; 0 for all of the machine.
};

struct DenoiseSummary {
    std::string used;  ///< For users: the library with its file, or the filter.
    double seconds = 0.0;
    /// By Balcony's filter, the part of the picture's light in single bright specks that it took
    /// for errors and left out.
    double left_out = 0.0;
};

/// The layers that a film needs to be denoised, for FilmLayout::layers.
[[nodiscard]] LayerSet denoise_layers();

/// Replaces the light of a film by an estimate without noise; alpha, display colours and layers
/// remain. The sums as rendered are kept in Film::noisy, as a layer if the film has others, and no
/// job may continue the film. It is an error if the film lacks the layers, if a pixel has fewer
/// than two samples, if the film is denoised already, or if `library` is required and not found.
/// The result of Balcony's filter does not depend on the number of threads.
[[nodiscard]] Result<DenoiseSummary> denoise(Film& film, const DenoiseOptions& options = {});

}  // namespace balcony::render
