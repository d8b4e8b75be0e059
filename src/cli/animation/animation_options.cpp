// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/animation/animation_options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "cli/options/camera_argument.hpp"
#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

void read_output(const std::string& output, const AnimationWords& words,
                 app::AnimationRequest& request, Diagnostics& diagnostics) {
    if (app::is_film(output)) {
        request.film.emplace().file = output;
        request.film->rate = request.picture.shutter.rate;
        request.pattern = app::pattern_of_film(output);
    } else {
        const auto pattern = app::FramePattern::read(output);
        if (pattern) {
            request.pattern = *pattern;
        } else {
            const fs::path file(output);
            fs::path example = file;
            example.replace_extension();
            diagnostics.push_back(error(
                fmt::format("'{}' has no # for the number of the frame", output), {},
                fmt::format("write --output '{}.####{}', or name a film ({})", example.string(),
                            ending_of(file).empty() ? ".png" : ending_of(file),
                            fmt::join(app::film_extensions(), ", "))));
        }
    }
    if (!request.film && (!words.crf.empty() || words.keep_frames)) {
        diagnostics.push_back(error(fmt::format("{} is for films, but the output is a sequence",
                                                words.crf.empty() ? "--keep-frames" : "--crf"),
                                    {}, "omit it, or name a film: --output film.mp4"));
    }
    if (request.film && !words.crf.empty()) {
        constexpr double largest = 63.0;
        request.film->crf =
            read_number("--crf", words.crf, 0.0, largest,
                        "give a number from 0 (best) to 63 (smallest), such as 18", diagnostics);
    }
}

}  // namespace

void add_animation_options(CLI::App& command, AnimateOptions& options) {
    AnimationWords& words = options.words;
    command
        .add_option("--frames", words.frames,
                    "the frames: 1-240, 7, every tenth 1-240x10, or several of these with commas "
                    "(default: as long as the scene's animations, or 5 s of a turntable)")
        ->type_name("FRAMES");
    command
        .add_option("--start-time", words.start_time,
                    "the time of frame 1 in seconds: of the scene's animations, and t in the "
                    "camera's formulas")
        ->type_name("T")
        ->capture_default_str();
    command.add_flag("--turntable", words.turntable,
                     "turn the camera once round the vertical axis through the middle of the "
                     "scene, without a repeated frame at the end");
    command
        .add_option("--around", words.around,
                    "a turntable round an object of the scene instead of all of it")
        ->type_name("OBJECT");
    command
        .add_option_function<std::string>(
            "-o,--output", [&options](const std::string& file) { options.render.output = file; },
            fmt::format("a film ({}), or a sequence whose name has # for the digits of the "
                        "frame's number, such as frame.####.png",
                        fmt::join(app::film_extensions(), ", ")))
        ->type_name("FILE")
        ->required();
    command
        .add_option("--crf", words.crf,
                    "quality of a film: the encoder's constant rate factor, less is better "
                    "(default: 18 for H.264, 24 for VP9)")
        ->type_name("NUMBER");
    command.add_flag("--keep-frames", words.keep_frames,
                     "keep the pictures of a film in OUTPUT.frames");
    command.add_flag("--overwrite", words.overwrite,
                     "render frames again that are there, also those of other settings");
    command.add_flag("--same-noise", words.same_noise, "all frames have the same pattern of noise");
    command
        .add_option("--shard", words.shard,
                    "render only one of several parts, such as 2/5: every fifth frame, from the "
                    "second on")
        ->type_name("PART/PARTS");
    command
        .add_option("--parts-per-frame", words.parts_per_frame,
                    "divide each frame into as many parts, for more shards than frames; balcony "
                    "merge joins them")
        ->type_name("COUNT")
        ->capture_default_str();
}

app::AnimationRequest read_animation(const AnimateOptions& options, Diagnostics& diagnostics) {
    const AnimationWords& words = options.words;
    constexpr double longest = 1e9;
    app::AnimationRequest request;
    request.picture = read_request(options.render, diagnostics);
    request.picture.scene = words.scene;
    request.picture.output = options.render.output.value_or("");
    if (!words.frames.empty()) {
        request.frames = app::frame_numbers_of(words.frames);
        if (!request.frames) {
            refuse(diagnostics, "--frames", words.frames,
                   fmt::format("write the first and the last frame, such as 1-240, numbers from 0 "
                               "to {}",
                               app::max_frame));
        }
    }
    request.start_time = read_number("--start-time", words.start_time, -longest, longest,
                                     "give a number of seconds", diagnostics);
    request.turntable = words.turntable || !words.around.empty();
    request.around = words.around;
    request.keep_frames = words.keep_frames;
    request.overwrite = words.overwrite;
    request.same_noise = words.same_noise;
    request.shard = read_shard(words.shard, diagnostics);
    request.parts_per_frame =
        read_count("--parts-per-frame", words.parts_per_frame, 1, render::max_shards, diagnostics);
    read_output(options.render.output.value_or(""), words, request, diagnostics);
    if (request.picture.stereo.has_two_files()) {
        diagnostics.push_back(error("an animation is one film or sequence, not two", {},
                                    "write --stereo left, and then --stereo right"));
    }
    return request;
}

}  // namespace balcony::cli
