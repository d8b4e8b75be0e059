// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include <CLI/CLI.hpp>

#include "balcony/base.hpp"
#include "balcony/denoise.hpp"
#include "balcony/layers.hpp"

namespace balcony::cli {

/// What leaves the renderer: the options of films and their files.
struct FilmOptions {
    std::string layers = "default";
    bool denoise = false;
    std::string denoiser = "auto";
    bool no_dither = false;
};

/// The layers that an EXR file shall have.
[[nodiscard]] render::LayerSet read_layers(const FilmOptions& options, Diagnostics& diagnostics);

[[nodiscard]] render::Denoiser read_denoiser(const FilmOptions& options, Diagnostics& diagnostics);

void add_film_options(CLI::App& command, FilmOptions& options);

}  // namespace balcony::cli
