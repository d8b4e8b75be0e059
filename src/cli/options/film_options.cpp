// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/film_options.hpp"

namespace balcony::cli {

void add_film_options(CLI::App& command, FilmOptions& options) {
    command.add_flag("--no-dither", options.no_dither,
                     "round the colours of files with 8 bits instead of dithering them");
}

}  // namespace balcony::cli
