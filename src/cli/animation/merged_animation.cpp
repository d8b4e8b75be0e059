// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/animation/merged_animation.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/animation/animation_film.hpp"
#include "cli/animation/animation_options.hpp"
#include "cli/animation/frame_record.hpp"
#include "cli/interruption.hpp"
#include "cli/merged_picture.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

constexpr auto same_command =
    "give the command of the render again, without --shard: it renders what is missing";

// The parts of each frame, by the number of the frame.
std::map<std::size_t, std::vector<fs::path>> parts_of_frames(const FramePattern& pattern,
                                                             const FrameRecord& record) {
    constexpr std::string_view shard = ".shard-";
    std::map<std::size_t, std::vector<fs::path>> parts;
    std::error_code failed;
    const fs::path folder = pattern.folder().empty() ? fs::path(".") : pattern.folder();
    for (fs::directory_iterator entry(folder, failed), end; !failed && entry != end;
         entry.increment(failed)) {
        const std::string name = entry->path().filename().string();
        const std::size_t begin = name.rfind(shard);
        const auto frame = begin == std::string::npos
                               ? std::nullopt
                               : pattern.number_of_file(name.substr(0, begin));
        const bool is_complete =
            name.find_first_not_of("0123456789-of", begin + shard.size()) == std::string::npos;
        if (frame && is_complete && record.is_finished(entry->path())) {
            parts[*frame].push_back(pattern.folder() / name);
        }
    }
    return parts;
}

// Merges what is in parts; gives the frames that are still missing.
FrameNumbers merge_frames(const FramePattern& pattern, const FrameRecord& record,
                          const FrameNumbers& frames, RenderReport& outcome) {
    std::map<std::size_t, std::vector<fs::path>> parts = parts_of_frames(pattern, record);
    FrameNumbers missing;
    std::size_t merged = 0;
    for (const std::size_t frame : frames) {
        const fs::path file = pattern.file(frame);
        if (record.is_finished(file)) {
            continue;
        }
        if (!parts.contains(frame)) {
            missing.push_back(frame);
            continue;
        }
        RenderReport joined = merge_picture(parts[frame], file.string());
        for (Diagnostic& one : joined.diagnostics) {
            one.message = fmt::format("frame {}: {}", frame, one.message);
            one.remedy = one.severity == Severity::error && joined.code == ExitCode::bad_input
                             ? same_command
                             : one.remedy;
        }
        add(outcome, joined.diagnostics);
        outcome.code = outcome.code == ExitCode::done ? joined.code : outcome.code;
        merged += joined.code == ExitCode::done ? 1 : 0;
    }
    outcome.facts["merged"] = merged;
    return missing;
}

}  // namespace

bool is_animation(const std::string& name) {
    if (is_film(name)) {
        return true;
    }
    const auto pattern = FramePattern::read(name);
    std::error_code failed;
    return pattern &&
           (name.find('#') != std::string::npos || fs::exists(record_file(*pattern), failed));
}

RenderReport merge_animation(const std::string& name, const std::string& output,
                             ProgressDisplay& display) {
    RenderReport outcome;
    const bool to_film = is_film(name);
    const FramePattern pattern = to_film ? pattern_of_film(name) : *FramePattern::read(name);
    const auto record = read_record(pattern);
    if (!record) {
        return failed(std::move(outcome), ExitCode::bad_input, record.diagnostics);
    }
    if (!record->has_value()) {
        return failed(std::move(outcome), ExitCode::bad_input,
                      {error(fmt::format("there are no frames of '{}': '{}' does not exist", name,
                                         record_file(pattern).string()),
                             {}, "render them first: balcony animate ... --shard 1/2")});
    }
    const FrameRecord& known = **record;
    std::optional<FilmRequest> film;
    if (to_film || !output.empty()) {
        film = FilmRequest{output.empty() ? name : output, known.fps, {}};
        if (!known.crf.empty()) {
            film->crf = std::stod(known.crf);
        }
        if (!is_film(film->file) || ending_of(pattern.file(1)) != ".png") {
            return failed(
                std::move(outcome), ExitCode::wrong_usage,
                {error("a sequence can be merged to a film of .png frames only", {},
                       "name a film, such as --output film.mp4, or use ffmpeg for others")});
        }
        if (const Diagnostics found = check_film(*film); has_errors(found)) {
            return failed(std::move(outcome), ExitCode::environment, found);
        }
    }
    FrameNumbers frames;
    const FrameNumbers there = pattern.existing();
    std::set_union(known.frames.begin(), known.frames.end(), there.begin(), there.end(),
                   std::back_inserter(frames));
    if (to_film) {
        frames = known.frames;
    }
    const FrameNumbers missing = merge_frames(pattern, known, frames, outcome);
    if (!missing.empty()) {
        return failed(std::move(outcome), ExitCode::bad_input,
                      {error(fmt::format("{} of {} frames missing: {}", missing.size(),
                                         frames.size(), text_of(missing)),
                             {}, same_command)});
    }
    if (outcome.code != ExitCode::done) {
        return outcome;
    }
    const Job interruption;
    outcome.facts["output"] = film ? film->file.string() : pattern.text();
    outcome.facts["frames"] = text_of(frames);
    outcome.sentence = fmt::format("{}: frames {}, {} merged from parts\n",
                                   film ? film->file.string() : pattern.text(), text_of(frames),
                                   outcome.facts["merged"].get<std::size_t>());
    if (film) {
        make_film_of_frames(*film, pattern, frames, to_film, display, outcome,
                            interruption.token());
    }
    return outcome;
}

}  // namespace balcony::cli
