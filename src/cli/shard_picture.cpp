// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/shard_picture.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/options/option_values.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

std::filesystem::path shard_file(const std::filesystem::path& picture, const render::Shard& shard) {
    std::filesystem::path file = picture;
    file += fmt::format(".shard-{}-of-{}", shard.index + 1, shard.count);
    return file;
}

render::RenderFacts output_facts(const RenderOptions& options,
                                 const std::filesystem::path& picture) {
    return {{"picture", picture.string()},
            {"exposure", options.exposure},
            {"view", options.view},
            {"dither", options.film.no_dither ? "no" : "yes"},
            {"denoiser", options.film.denoise ? options.film.denoiser : ""}};
}

MergedOutput merged_output(const render::RenderFacts& facts) {
    MergedOutput output;
    for (const auto& [name, value] : facts) {
        if (name == "picture") {
            output.picture = value;
        } else if (name == "exposure") {
            output.exposure = number_of<double>(value);
        } else if (name == "view") {
            output.view = render::view_transforms().find(value).value_or(output.view);
        } else if (name == "dither") {
            output.dither = value != "no";
        } else if (name == "denoiser") {
            output.denoiser = render::denoisers().find(value);
        }
    }
    return output;
}

void check_shard(const RenderOptions& options, Diagnostics& diagnostics) {
    if (options.job.shard.empty()) {
        return;
    }
    if (options.output == "-" || options.watch) {
        diagnostics.push_back(error(fmt::format("--shard and {} exclude each other",
                                                options.watch ? "--watch" : "--output -"),
                                    {}, "name a file for the picture that the shards make"));
    }
    if (options.exposure == "auto" && options.sampling.noise != "0") {
        diagnostics.push_back(
            error("--shard with --noise needs --exposure, as noise is relative to white", {},
                  "add --exposure 0, or the one that a quick preview reports"));
    }
}

RenderReport keep_shard(RenderReport outcome, const Request& request, const PictureOutput& output,
                        PictureRun& run, const render::Summary& summary) {
    const std::filesystem::path file = shard_file(output.file(), *request.job.shard);
    const CheckpointFile& checkpoint = run.checkpoint();
    if (summary.interrupted) {
        outcome.sentence = checkpoint.is_used()
                               ? fmt::format("interrupted; --resume continues from {}\n",
                                             checkpoint.file().string())
                               : std::string("interrupted before there was a checkpoint\n");
        outcome.code = ExitCode::interrupted;
        return outcome;
    }
    if (const Diagnostics found = run.save_shard(); has_errors(found)) {
        add(outcome, found);
        outcome.code = ExitCode::environment;
        return outcome;
    }
    if (checkpoint.is_used()) {
        checkpoint.remove();
    }
    outcome.facts["output"] = file.string();
    outcome.facts["seconds"] = summary.seconds;
    outcome.facts["rays"] = summary.camera_rays;
    outcome.sentence =
        fmt::format("{}: shard {} of {} in {}\n", file.string(), request.job.shard->index + 1,
                    request.job.shard->count, duration_text(summary.seconds));
    return outcome;
}

}  // namespace balcony::cli
