// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/merged_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/denoise.hpp"
#include "balcony/shard.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/shard_picture.hpp"

namespace balcony::cli {

namespace {

RenderReport fail_merge(RenderReport outcome, ExitCode code, const Diagnostics& diagnostics) {
    add(outcome, diagnostics);
    outcome.code = code;
    return outcome;
}

}  // namespace

RenderReport merge_picture(const std::vector<std::filesystem::path>& shards,
                           const std::string& other_output) {
    RenderReport outcome;
    const auto heading = render::read_shard_heading(shards.front());
    if (!heading) {
        return fail_merge(std::move(outcome), ExitCode::bad_input, heading.diagnostics);
    }
    const MergedOutput wanted = merged_output(heading->output);
    const PictureOutput output(other_output.empty() ? wanted.picture
                                                    : std::filesystem::path(other_output));
    if (const ExitCode code = output.check(outcome.diagnostics); code != ExitCode::done) {
        outcome.code = code;
        return outcome;
    }
    Result<render::Film> film = render::merge_shards(shards);
    if (!film) {
        return fail_merge(std::move(outcome), ExitCode::bad_input, film.diagnostics);
    }
    if (wanted.denoiser) {
        const auto done = render::denoise(*film, {.denoiser = *wanted.denoiser, .library = {}});
        add(outcome, done.diagnostics);
        if (!done) {
            return fail_merge(std::move(outcome), ExitCode::environment, {});
        }
        outcome.facts["denoiser"] = done->used;
    }
    const double automatic =
        output.display_format() != nullptr ? render::automatic_exposure(*film) : 0.0;
    const double exposure = wanted.exposure.value_or(automatic);
    if (const Diagnostics found = output.write(
            *film, {.exposure = exposure, .view = wanted.view, .dither = wanted.dither});
        has_errors(found)) {
        return fail_merge(std::move(outcome), ExitCode::environment, found);
    }
    outcome.facts["output"] = output.name();
    outcome.facts["exposure"] = exposure;
    outcome.facts["shards"] = shards.size();
    outcome.facts["width"] = film->window.width;
    outcome.facts["height"] = film->window.height;
    outcome.sentence = fmt::format("{}: {} x {} pixels, merged from {} shards\n", output.name(),
                                   film->window.width, film->window.height, shards.size());
    return outcome;
}

}  // namespace balcony::cli
