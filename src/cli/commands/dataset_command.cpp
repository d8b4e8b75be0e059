// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony dataset: pictures of scenes through cameras in many poses, with their rays, depths and
// ids.

#include <optional>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "balcony/dataset.hpp"
#include "balcony/names.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

struct DatasetOptions {
    std::string recipe;
    std::string output;
    std::optional<render::Shard> shard;
    bool overwrite = false;
    bool dry_run = false;
    app::Request threads;  // Nothing else of it.
    Manner manner;
};

std::string text_of(const dataset::DatasetReport& report, const DatasetOptions& options) {
    const std::string done = fmt::format(
        "{} rendered in {}{}", counted(report.rendered, "frame"), duration_text(report.seconds),
        report.skipped > 0 ? fmt::format(", {} finished before", report.skipped) : "");
    if (report.interrupted) {
        return fmt::format("interrupted: {}; the same command continues\n", done);
    }
    std::string text =
        fmt::format("{}: {}", printable(options.output), counted(report.frames, "frame"));
    if (options.shard) {
        text += fmt::format(", {} of this shard", report.selected);
    }
    text += options.dry_run ? std::string("\n") : fmt::format(", {}\n", done);
    for (const std::string& camera : report.cameras) {
        text += fmt::format("  {}\n", printable(camera));
    }
    return text;
}

Answer answer_of(const dataset::DatasetReport& report, const DatasetOptions& options) {
    Answer answer{report.diagnostics, report.interrupted};
    if (report.is_planned) {
        answer.facts = {{"output", options.output},    {"frames", report.frames},
                        {"selected", report.selected}, {"rendered", report.rendered},
                        {"skipped", report.skipped},   {"plan_seconds", report.plan_seconds},
                        {"seconds", report.seconds},   {"cameras", report.cameras}};
    }
    answer.text = has_errors(report.diagnostics) ? "" : text_of(report, options);
    return answer;
}

ExitCode make_dataset(const DatasetOptions& options) {
    auto recipe = dataset::read_recipe(options.recipe);
    if (!recipe) {
        return give(Answer{recipe.diagnostics}, options.manner);
    }
    if (options.threads.settings.threads > 0) {
        recipe->picture.settings.threads = options.threads.settings.threads;
    }
    RenderObserver observer(options.manner);
    dataset::DatasetReport report = dataset::make_dataset({.recipe = std::move(*recipe.value),
                                                           .folder = options.output,
                                                           .shard = options.shard,
                                                           .overwrite = options.overwrite,
                                                           .only_plan = options.dry_run},
                                                          observer.observer(), observer.token());
    observer.clear();
    report.diagnostics.insert(report.diagnostics.begin(), recipe.diagnostics.begin(),
                              recipe.diagnostics.end());
    return give(answer_of(report, options), options.manner);
}

app::Options<DatasetOptions> dataset_rows() {
    app::Options<DatasetOptions> rows{
        {option({.name = "RECIPE",
                 .placeholder = "FILE",
                 .meaning = "recipe (.toml): scenes, cameras, poses and layers",
                 .required = true,
                 .effect = Effect::run},
                text(OptionType::file), &DatasetOptions::recipe),
         option({.name = "--output",
                 .letter = "-o",
                 .others = {"--out"},
                 .placeholder = "FOLDER",
                 .meaning = "folder of the data set, which is made if it is missing",
                 .required = true,
                 .effect = Effect::run},
                text(OptionType::folder), &DatasetOptions::output),
         option({.name = "--shard",
                 .placeholder = "PART/PARTS",
                 .meaning = "render only one of several parts, such as 2/5: every fifth frame, "
                            "from the second on",
                 .effect = Effect::run},
                app::maybe(app::shard_value()), &DatasetOptions::shard),
         flag({.name = "--overwrite",
               .meaning = "render frames again that are there, also those of another recipe",
               .effect = Effect::run},
              true, &DatasetOptions::overwrite),
         flag({.name = "--dry-run",
               .meaning = "find the poses and count the frames, but write nothing",
               .effect = Effect::run},
              true, &DatasetOptions::dry_run)}};
    rows.add(&DatasetOptions::threads, app::thread_options());
    rows.add(manner_options(&DatasetOptions::manner));
    return rows;
}

}  // namespace

void add_dataset_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, DatasetOptions& options) {
        command.add(dataset_rows(), options);
        command.show_first(
            {"--output", "--shard", "--overwrite", "--dry-run", "--threads", "--quiet", "--json"});
        command.footer(
            "Examples:\n"
            "  balcony dataset room.toml -o room\n"
            "  balcony dataset room.toml -o room --shard 2/5\n"
            "  balcony dataset room.toml -o room --dry-run\n"
            "\n"
            "The same command continues after an interruption: finished frames are kept.\n"
            "docs/datasets.md describes recipes and files.");
    };
    add_command<DatasetOptions>(app, code, "dataset",
                                "renders a data set: pictures with their rays, depths and ids",
                                make_dataset, describe);
}

}  // namespace balcony::cli
