// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <CLI/CLI.hpp>

namespace balcony::cli {

/// What leaves the renderer: the options of films and their files.
struct FilmOptions {
    bool no_dither = false;
};

void add_film_options(CLI::App& command, FilmOptions& options);

}  // namespace balcony::cli
