// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony merge: joins the shards of a picture.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "balcony/denoise.hpp"
#include "balcony/shard.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/common_options.hpp"
#include "cli/options/picture_output.hpp"
#include "cli/report/json.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"
#include "cli/shard_picture.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<std::string> shards;
    std::string output;
    bool quiet = false;
    bool json = false;
};

RenderReport fail_merge(RenderReport outcome, ExitCode code, const Diagnostics& diagnostics) {
    add(outcome, diagnostics);
    outcome.code = code;
    return outcome;
}

RenderReport merge_files(const MergeOptions& options) {
    RenderReport outcome;
    const std::vector<fs::path> files(options.shards.begin(), options.shards.end());
    const auto heading = render::read_shard_heading(files.front());
    if (!heading) {
        return fail_merge(std::move(outcome), ExitCode::bad_input, heading.diagnostics);
    }
    const MergedOutput wanted = merged_output(heading->output);
    const PictureOutput output(options.output.empty() ? wanted.picture : fs::path(options.output));
    if (const ExitCode code = output.check(outcome.diagnostics); code != ExitCode::done) {
        outcome.code = code;
        return outcome;
    }
    Result<render::Film> film = render::merge_shards(files);
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
    outcome.facts["shards"] = files.size();
    outcome.facts["width"] = film->window.width;
    outcome.facts["height"] = film->window.height;
    outcome.sentence = fmt::format("{}: {} x {} pixels, merged from {} shards\n", output.name(),
                                   film->window.width, film->window.height, files.size());
    return outcome;
}

ExitCode merge(const MergeOptions& options) {
    const RenderReport outcome = merge_files(options);
    if (options.json) {
        print_json(json_of(outcome));
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (!options.quiet && outcome.code == ExitCode::done) {
        print_result(outcome.sentence);
    }
    return outcome.code;
}

}  // namespace

void add_merge_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, MergeOptions& options) {
        command
            .add_option("SHARD", options.shards,
                        "the files of all shards, as balcony render --shard writes them")
            ->type_name("FILE")
            ->required();
        command
            .add_option("-o,--output", options.output, "output file (default: that of the renders)")
            ->type_name("FILE");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
        command.footer(
            "Examples:\n"
            "  balcony merge room.png.shard-*\n"
            "  balcony merge room.exr.shard-1-of-2 room.exr.shard-2-of-2 -o whole.exr");
    };
    add_command<MergeOptions>(app, code, "merge",
                              "joins the parts of a picture that several machines rendered", merge,
                              describe);
}

}  // namespace balcony::cli
