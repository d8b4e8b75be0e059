// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/banded_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/bands.hpp"
#include "cli/interruption.hpp"

namespace balcony::cli {

RenderReport make_banded_picture(RenderReport outcome, const RenderOptions& options,
                                 const Request& request, const render::Renderer& renderer,
                                 const camera::Picture& picture, const render::FilmLayout& layout,
                                 const PictureOutput& output) {
    constexpr double giga = 1e9;
    if (request.job.resume || request.job.save_every || request.job.time_limit) {
        outcome.code = ExitCode::wrong_usage;
        add(outcome,
            {error(fmt::format("the picture takes {:.1f} GB and is rendered in bands, which "
                               "--resume, --save-every and --time-limit cannot do",
                               render::film_bytes(layout) / giga),
                   {}, "raise --film-memory, omit layers with --layers, or omit these options")});
        return outcome;
    }
    const Job interruption;
    ProgressDisplay display(options.quiet || options.json);
    const Result<render::Summary> summary = render::render_in_bands(
        renderer, picture, request.settings, layout,
        render::band_height(layout, request.job.film_memory), output.file(),
        [&display](const render::Progress& progress) { display.show(progress); },
        interruption.token());
    display.clear();
    add(outcome, summary.diagnostics);
    if (!summary) {
        outcome.code = ExitCode::environment;
        return outcome;
    }
    // What a report needs of the film.
    render::Film film;
    film.width = layout.width;
    film.height = layout.height;
    film.window = layout.window.value_or(render::Region{0, 0, layout.width, layout.height});
    film.background = request.settings.background;
    describe(outcome, output, picture, film, *summary);
    outcome.facts["output"] = output.file().string();
    outcome.facts["exposure"] = 0.0;
    outcome.code = summary->interrupted ? ExitCode::interrupted : ExitCode::done;
    return outcome;
}

}  // namespace balcony::cli
