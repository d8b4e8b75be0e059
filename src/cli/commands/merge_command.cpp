// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// balcony merge: joins the shards of a picture or of an animation.

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "balcony/animation.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct MergeOptions {
    std::vector<std::string> shards;
    std::string output;
    Manner manner;
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

Answer merge_files(const MergeOptions& options) {
    std::vector<fs::path> files;
    for (const std::string& name : options.shards) {
        const std::vector<std::string> found = shards_beside(name);
        files.insert(files.end(), found.begin(), found.end());
    }
    RenderObserver observer({.quiet = true});
    const std::vector<app::MergedPicture> pictures =
        app::merge_pictures(files, options.output, observer.observer());
    if (pictures.size() == 1) {
        return answer_of(pictures.front());
    }
    Answer all;
    for (const app::MergedPicture& merged : pictures) {
        const Answer answer = answer_of(merged);
        all.facts["pictures"].push_back(to_json(answer));
        all.text += answer.text;
        all.add(answer.diagnostics);
    }
    return all;
}

Answer merge_parts(const MergeOptions& options) {
    const auto animation =
        std::find_if(options.shards.begin(), options.shards.end(), app::is_animation);
    if (animation == options.shards.end()) {
        return merge_files(options);
    }
    if (options.shards.size() > 1) {
        return {{error(Kind::usage,
                       fmt::format("'{}' is an animation, which is merged alone", *animation),
                       "quote the name of a sequence: 'frame.####.png'")}};
    }
    RenderObserver observer(options.manner);
    return answer_of(
        app::merge_animation(*animation, options.output, observer.observer(), observer.token()));
}

ExitCode merge(const MergeOptions& options) { return give(merge_parts(options), options.manner); }

}  // namespace

void add_merge_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, MergeOptions& options) {
        app::Options<MergeOptions> all{
            {app::words({.name = "SHARD",
                         .placeholder = "FILE",
                         .meaning = "the files of all shards, as --shard writes them, or the name "
                                    "of an animation: film.mp4, or 'frame.####.png'",
                         .required = true,
                         .effect = Effect::run,
                         .type = OptionType::file},
                        &MergeOptions::shards),
             output_option(&MergeOptions::output,
                           "output file (default: that of the renders); of a sequence, a film")}};
        all.add(manner_options(&MergeOptions::manner));
        command.add(std::move(all), options);
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
