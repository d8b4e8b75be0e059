// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/film_options.hpp"

#include "cli/options/option_values.hpp"

namespace balcony::cli {

render::LayerSet read_layers(const FilmOptions& options, Diagnostics& diagnostics) {
    const Result<render::LayerSet> layers = render::find_layers(options.layers);
    for (const Diagnostic& found : layers.diagnostics) {
        diagnostics.push_back(error("--layers: " + found.message, {}, found.remedy));
    }
    return layers.value.value_or(render::LayerSet{});
}

render::Denoiser read_denoiser(const FilmOptions& options, Diagnostics& diagnostics) {
    check_name("--denoiser", options.denoiser, render::denoisers().all(), diagnostics);
    return render::denoisers().find(options.denoiser).value_or(render::Denoiser::automatic);
}

void add_film_options(CLI::App& command, FilmOptions& options) {
    command
        .add_option("--layers", options.layers,
                    "layers of an EXR file beside the picture: default, all, none, or names "
                    "separated by commas, such as default,direct,indirect (see docs/layers.md)")
        ->type_name("LIST")
        ->capture_default_str();
    command.add_flag("--denoise", options.denoise,
                     "remove the noise of the finished picture (see docs/denoising.md)");
    command
        .add_option("--denoiser", options.denoiser,
                    "library (Open Image Denoise), features (Balcony's filter, the same on every "
                    "machine) or auto (library where there is one)")
        ->type_name("NAME")
        ->capture_default_str();
    command.add_flag("--no-dither", options.no_dither,
                     "round the colours of files with 8 bits instead of dithering them");
}

}  // namespace balcony::cli
