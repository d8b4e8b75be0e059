// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/animation.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "app/animation/animation_film.hpp"
#include "app/animation/film_file.hpp"
#include "app/animation/frame_file.hpp"
#include "app/animation/frame_record.hpp"
#include "app/picture/paused_run.hpp"
#include "app/words.hpp"
#include "balcony/input_file.hpp"
#include "balcony/output_file.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

constexpr auto same_command =
    "give the command of the render again, without --shard: it renders what is missing";

// The parts of each frame, by the number of the frame.
std::map<std::size_t, std::vector<fs::path>> parts_of_frames(const FramePattern& pattern,
                                                             const FrameRecord& record) {
    constexpr std::string_view shard = ".shard-";
    std::map<std::size_t, std::vector<fs::path>> parts;
    for (const std::string& name : names_in(pattern.folder())) {
        const std::size_t begin = name.rfind(shard);
        const auto frame = begin == std::string::npos
                               ? std::nullopt
                               : pattern.number_of_file(name.substr(0, begin));
        const bool is_complete =
            name.find_first_not_of("0123456789-of", begin + shard.size()) == std::string::npos;
        if (frame && is_complete && record.is_finished(pattern.folder() / name)) {
            parts[*frame].push_back(pattern.folder() / name);
        }
    }
    return parts;
}

// What is wrong with the file of a frame.
Diagnostics check_whole(std::size_t frame, const fs::path& file) {
    const auto reason = why_damaged(file, FramePart::all);
    return reason ? Diagnostics{error(Kind::input,
                                      fmt::format("frame {}: '{}' is damaged: {}", frame,
                                                  file.string(), reason->message),
                                      fmt::format("remove it and {}", same_command))}
                  : Diagnostics{};
}

// Merges what is in parts; gives the frames that are still missing.
FrameNumbers merge_frames(const FramePattern& pattern, const FrameRecord& record,
                          const FrameNumbers& frames, MergedAnimation& outcome) {
    std::map<std::size_t, std::vector<fs::path>> parts = parts_of_frames(pattern, record);
    FrameNumbers missing;
    for (const std::size_t frame : frames) {
        const fs::path file = pattern.file(frame);
        if (record.is_finished(file)) {
            add(outcome.diagnostics, check_whole(frame, file));
            continue;
        }
        if (!parts.contains(frame)) {
            missing.push_back(frame);
            continue;
        }
        MergedPicture joined = merge_picture(parts[frame], file);
        for (Diagnostic& one : joined.diagnostics) {
            one.message = fmt::format("frame {}: {}", frame, one.message);
            one.remedy = one.severity == Severity::error && one.kind == Kind::input ? same_command
                                                                                    : one.remedy;
        }
        add(outcome.diagnostics, joined.diagnostics);
        outcome.merged += has_errors(joined.diagnostics) ? 0 : 1;
    }
    return missing;
}

// The film that a sequence or the frames of a film become.
Result<std::optional<FilmRequest>> film_of(const std::string& name, const std::string& output,
                                           const FramePattern& pattern, const FrameRecord& record) {
    if (!is_film(name) && output.empty()) {
        return std::optional<FilmRequest>();
    }
    FilmRequest film{output.empty() ? name : output, record.rate, record.crf};
    if (!is_film(film.file) || ending_of(pattern.file(1).string()) != ".png") {
        return error(Kind::usage, "a sequence can be merged to a film of .png frames only",
                     "name a film, such as --output film.mp4, or use ffmpeg for others");
    }
    if (const Diagnostics found = check_film(film); has_errors(found)) {
        return found;
    }
    return std::optional(film);
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

MergedAnimation merge_animation(const std::string& name, const std::string& output,
                                const Observer& observer, const std::stop_token& stop) {
    MergedAnimation merged;
    const auto fails = [&merged](const Diagnostics& found) {
        return add(merged.diagnostics, found);
    };
    const FramePattern pattern = is_film(name) ? pattern_of_film(name) : *FramePattern::read(name);
    const auto record = read_record(pattern);
    if (fails(record.diagnostics)) {
        return merged;
    }
    if (!record->has_value()) {
        fails({error(Kind::input,
                     fmt::format("there are no frames of '{}': '{}' does not exist", name,
                                 record_file(pattern).string()),
                     "render them first: balcony animate ... --shard 1/2")});
        return merged;
    }
    const FrameRecord& known = **record;
    const auto film = film_of(name, output, pattern, known);
    if (fails(film.diagnostics)) {
        return merged;
    }
    FrameNumbers frames = known.frames;
    if (!is_film(name)) {
        const FrameNumbers there = pattern.existing();
        frames.clear();
        std::set_union(known.frames.begin(), known.frames.end(), there.begin(), there.end(),
                       std::back_inserter(frames));
    }
    const FrameNumbers missing = merge_frames(pattern, known, frames, merged);
    if (!missing.empty()) {
        fails({error(Kind::input,
                     fmt::format("{} of {} frames missing: {}", missing.size(), frames.size(),
                                 text_of(missing)),
                     same_command)});
    }
    if (has_errors(merged.diagnostics)) {
        return merged;
    }
    merged.output = *film ? (*film)->file : fs::path(pattern.text());
    merged.frames = frames;
    if (*film) {
        const Diagnostics found =
            make_film_of_frames(**film, pattern, frames, is_film(name), observer, stop);
        merged.interrupted = kind_of_errors(found) == Kind::interrupted;
        if (!merged.interrupted) {
            add(merged.diagnostics, found);
        }
    }
    return merged;
}

}  // namespace balcony::app
