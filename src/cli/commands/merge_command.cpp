// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony merge: joins the shards of a picture or of an animation.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <CLI/CLI.hpp>
#include <nlohmann/json.hpp>

#include "balcony/animation.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/common_options.hpp"
#include "cli/report/json.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"
#include "cli/report/report.hpp"

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

ExitCode finish(const nlohmann::json& facts, const std::string& text,
                const Diagnostics& diagnostics, bool interrupted, const MergeOptions& options) {
    if (options.json) {
        print_json(facts);
    } else {
        report(diagnostics);
        if (!options.quiet && !text.empty()) {
            print_result(text);
        }
    }
    return exit_code_of(diagnostics, interrupted);
}

ExitCode merge_files(const MergeOptions& options) {
    std::vector<fs::path> files;
    for (const std::string& name : options.shards) {
        const std::vector<std::string> found = shards_beside(name);
        files.insert(files.end(), found.begin(), found.end());
    }
    RenderObserver observer(true);
    const std::vector<app::MergedPicture> pictures =
        app::merge_pictures(files, options.output, observer.observer());
    if (pictures.size() == 1) {
        return finish(report_json(pictures.front()), report_text(pictures.front()),
                      pictures.front().diagnostics, false, options);
    }
    nlohmann::json facts{{"pictures", nlohmann::json::array()}};
    std::string text;
    Diagnostics all;
    for (const app::MergedPicture& merged : pictures) {
        facts["pictures"].push_back(report_json(merged));
        text += report_text(merged);
        all.insert(all.end(), merged.diagnostics.begin(), merged.diagnostics.end());
    }
    facts["diagnostics"] = to_json(all);
    return finish(facts, text, all, false, options);
}

ExitCode merge(const MergeOptions& options) {
    const auto animation =
        std::find_if(options.shards.begin(), options.shards.end(), app::is_animation);
    if (animation == options.shards.end()) {
        return merge_files(options);
    }
    if (options.shards.size() > 1) {
        app::MergedAnimation refused;
        refused.diagnostics = {error(
            Kind::usage, fmt::format("'{}' is an animation, which is merged alone", *animation),
            "quote the name of a sequence: 'frame.####.png'")};
        return finish({{"diagnostics", to_json(refused.diagnostics)}}, "", refused.diagnostics,
                      false, options);
    }
    RenderObserver observer(options.quiet || options.json);
    const app::MergedAnimation merged =
        app::merge_animation(*animation, options.output, observer.observer(), observer.token());
    observer.clear();
    return finish(report_json(merged), report_text(merged), merged.diagnostics, merged.interrupted,
                  options);
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
