// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/denoised_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/report.hpp"

namespace balcony::cli {

Result<render::Film> make_film(render::FilmLayout layout, const Request& request) {
    const render::LayerSet in_file = layout.layers;
    if (request.denoise) {
        layout.layers.insert(render::denoise_layers());
    }
    Result<render::Film> film = render::make_film(layout);
    if (film) {
        film->layer_set = in_file;
    }
    return film;
}

void denoise(const Request& request, render::Film& film, RenderReport& outcome) {
    const auto done = render::denoise(film, *request.denoise);
    if (!done) {
        for (const Diagnostic& failed : done.diagnostics) {
            add(outcome,
                {warning("the picture is not denoised: " + failed.message, {}, failed.remedy)});
        }
        return;
    }
    add(outcome, done.diagnostics);
    outcome.facts["denoiser"] = done->used;
    outcome.sentence += fmt::format("  denoised by {} in {:.1f} s\n", done->used, done->seconds);
}

}  // namespace balcony::cli
