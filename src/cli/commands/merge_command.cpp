// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony merge: joins the shards of a picture or of an animation.

#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "balcony/shard.hpp"
#include "cli/animation/merged_animation.hpp"
#include "cli/commands/command.hpp"
#include "cli/merged_picture.hpp"
#include "cli/options/common_options.hpp"
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

// The shards of a picture that are beside it; the file itself if there are none, or if it is one.
std::vector<std::string> shards_beside(const std::string& name) {
    const fs::path picture(name);
    const std::string beginning = picture.filename().string() + ".shard-";
    std::vector<std::string> shards;
    std::error_code failed;
    for (fs::directory_iterator
             entry(picture.has_parent_path() ? picture.parent_path() : ".", failed),
         end;
         !failed && entry != end; entry.increment(failed)) {
        const std::string file = entry->path().filename().string();
        if (file.starts_with(beginning) &&
            file.find_first_not_of("0123456789-of", beginning.size()) == std::string::npos) {
            shards.push_back((picture.parent_path() / file).string());
        }
    }
    std::sort(shards.begin(), shards.end());
    return shards.empty() ? std::vector{name} : shards;
}

// The shards of each frame; those of a picture have no frame.
Result<std::map<std::string, std::vector<fs::path>>> shards_of_frames(
    const std::vector<fs::path>& files) {
    std::map<std::string, std::vector<fs::path>> frames;
    for (const fs::path& file : files) {
        const auto heading = render::read_shard_heading(file);
        if (!heading) {
            return heading.diagnostics;
        }
        const auto& facts = heading->facts;
        const auto frame =
            std::find_if(facts.begin(), facts.end(),
                         [](const render::RenderFact& fact) { return fact.name == frame_fact; });
        frames[frame == facts.end() ? "" : merged_output(heading->output).picture.string()]
            .push_back(file);
    }
    return frames;
}

RenderReport merge_files(const MergeOptions& options) {
    std::vector<std::string> names;
    for (const std::string& name : options.shards) {
        const std::vector<std::string> found = shards_beside(name);
        names.insert(names.end(), found.begin(), found.end());
    }
    const std::vector<fs::path> files(names.begin(), names.end());
    if (!options.output.empty()) {
        return merge_picture(files, options.output);
    }
    RenderReport outcome;
    const auto pictures = shards_of_frames(files);
    if (!pictures) {
        add(outcome, pictures.diagnostics);
        outcome.code = ExitCode::bad_input;
        return outcome;
    }
    if (pictures->size() == 1) {
        return merge_picture(files, "");
    }
    outcome.facts["pictures"] = nlohmann::json::array();
    for (const auto& [picture, shards] : *pictures) {
        const RenderReport merged = merge_picture(shards, "");
        add(outcome, merged.diagnostics);
        outcome.sentence += merged.sentence;
        outcome.facts["pictures"].push_back(merged.facts);
        outcome.code = outcome.code == ExitCode::done ? merged.code : outcome.code;
    }
    return outcome;
}

RenderReport merge_all(const MergeOptions& options) {
    const auto animation = std::find_if(options.shards.begin(), options.shards.end(), is_animation);
    if (animation == options.shards.end()) {
        return merge_files(options);
    }
    if (options.shards.size() > 1) {
        RenderReport outcome;
        add(outcome, {error(fmt::format("'{}' is an animation, which is merged alone", *animation),
                            {}, "quote the name of a sequence: 'frame.####.png'")});
        outcome.code = ExitCode::wrong_usage;
        return outcome;
    }
    ProgressDisplay display(options.quiet || options.json);
    return merge_animation(*animation, options.output, display);
}

ExitCode merge(const MergeOptions& options) {
    const RenderReport outcome = merge_all(options);
    if (options.json) {
        print_json(json_of(outcome));
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (!options.quiet && !outcome.sentence.empty()) {
        print_result(outcome.sentence);
    }
    return outcome.code;
}

}  // namespace

void add_merge_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](CLI::App& command, MergeOptions& options) {
        command
            .add_option(
                "SHARD", options.shards,
                "the files of all shards, as --shard writes them, or the name of an animation: "
                "film.mp4, or 'frame.####.png'")
            ->type_name("FILE")
            ->required();
        command
            .add_option("-o,--output", options.output,
                        "output file (default: that of the renders); of a sequence, a film")
            ->type_name("FILE");
        add_quiet_option(command, options.quiet);
        command.add_flag("--json", options.json, "print facts and diagnostics as JSON");
        command.footer(
            "Examples:\n"
            "  balcony merge room.png\n"
            "  balcony merge room.png.shard-*\n"
            "  balcony merge room.exr.shard-1-of-2 room.exr.shard-2-of-2 -o whole.exr\n"
            "  balcony merge film.mp4\n"
            "  balcony merge 'frame.####.png' -o film.mp4");
    };
    add_command<MergeOptions>(app, code, "merge",
                              "joins the parts of a picture or film that several machines rendered",
                              merge, describe);
}

}  // namespace balcony::cli
