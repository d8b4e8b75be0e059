// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/words.hpp"
#include "balcony/output_file.hpp"
#include "balcony/picture_options.hpp"

namespace balcony::app {

namespace {

constexpr double best_crf = 0.0;
constexpr double worst_crf = 63.0;

void read_output(std::span<const std::string> words, AnimationRequest& animation,
                 Diagnostics& found) {
    animation.picture.output = words.back();
    Result<FrameOutput> output = frame_output_of(words.back());
    if (!add(found, output.diagnostics)) {
        animation.pattern = output->pattern;
        animation.film = std::move(output->film);
    }
}

Option<AnimationRequest> output_option() {
    return custom_option<AnimationRequest>(
        {.name = "--output",
         .letter = "-o",
         .others = {"--out"},
         .placeholder = "FILE",
         .meaning = fmt::format("a film ({}), or a sequence whose name has # for the digits of the "
                                "frame's number, such as frame.####.png",
                                fmt::join(film_extensions(), ", ")),
         .required = true,
         .effect = Effect::run,
         .type = OptionType::file},
        read_output, [](const AnimationRequest& animation) {
            const std::string output = animation.picture.output.string();
            return output.empty() ? std::vector<std::string>{} : std::vector{output};
        });
}

// Its value belongs to a film, which --output names.
Option<AnimationRequest> crf_option() {
    return custom_option<AnimationRequest>(
        {.name = "--crf",
         .placeholder = "NUMBER",
         .meaning = "quality of a film: the encoder's constant rate factor, less is better "
                    "(default: 18 for H.264, 24 for VP9)",
         .effect = Effect::run,
         .type = OptionType::number,
         .minimum = best_crf,
         .maximum = worst_crf},
        [](std::span<const std::string> words, AnimationRequest& animation, Diagnostics& found) {
            const auto crf = number_of<double>(words.back());
            if (!crf || *crf < best_crf || *crf > worst_crf) {
                found.push_back(
                    refused("--crf", words.back(),
                            "give a number from 0 (best) to 63 (smallest), such as 18"));
            } else if (animation.film) {
                animation.film->crf = crf;
            }
        },
        [](const AnimationRequest& animation) {
            return animation.film && animation.film->crf
                       ? std::vector{fmt::format("{}", *animation.film->crf)}
                       : std::vector<std::string>{};
        });
}

Options<AnimationRequest> frame_options() {
    constexpr double longest = 1e9;
    const auto run_flag = [](const char* name, const char* meaning, bool AnimationRequest::*value) {
        return flag({.name = name, .meaning = meaning, .effect = Effect::run}, true, value);
    };
    return {
        {option({.name = "--frames",
                 .others = {"--frame"},
                 .placeholder = "FRAMES",
                 .meaning = "the frames: 1-240, every tenth 1-240x10, or several of these with "
                            "commas; one number is that frame of a sequence, and the length of a "
                            "film (default: as long as the scene's animations, or 5 s of a "
                            "turntable)",
                 .effect = Effect::run},
                maybe(frame_numbers()), &AnimationRequest::frames),
         option({.name = "--duration",
                 .others = {"--length", "--seconds"},
                 .placeholder = "SECONDS",
                 .meaning = "the length of the film instead of --frames",
                 .effect = Effect::run},
                maybe(number(1e-3, 1e6, "give a number of seconds, such as 5", "s")),
                &AnimationRequest::duration),
         option({.name = "--start-time",
                 .placeholder = "T",
                 .meaning = "the time of frame 1 in seconds: of the scene's animations, and t in "
                            "the camera's formulas"},
                number(-longest, longest, "give a number of seconds", "s"),
                &AnimationRequest::start_time),
         flag({.name = "--turntable",
               .meaning = "turn the camera once round the vertical axis through the middle of the "
                          "scene, without a repeated frame at the end"},
              true, &AnimationRequest::turntable),
         option({.name = "--around",
                 .placeholder = "OBJECT",
                 .meaning = "a turntable round an object of the scene instead of all of it"},
                text(), &AnimationRequest::around),
         output_option(), crf_option(),
         run_flag("--keep-frames", "keep the pictures of a film in OUTPUT.frames",
                  &AnimationRequest::keep_frames),
         run_flag("--overwrite", "render frames again that are there, also those of other settings",
                  &AnimationRequest::overwrite),
         flag({.name = "--same-noise", .meaning = "all frames have the same pattern of noise"},
              true, &AnimationRequest::same_noise),
         option({.name = "--shard",
                 .placeholder = "PART/PARTS",
                 .meaning = "render only one of several parts, such as 2/5: every fifth frame, "
                            "from the second on",
                 .effect = Effect::run},
                maybe(shard_value()), &AnimationRequest::shard),
         option({.name = "--parts-per-frame",
                 .placeholder = "COUNT",
                 .meaning = "divide each frame into as many parts, for more shards than frames; "
                            "balcony merge joins them",
                 .effect = Effect::run},
                count(1, render::max_shards), &AnimationRequest::parts_per_frame)}};
}

void check_together(AnimationRequest& animation, const GivenWords& given, Diagnostics& found) {
    animation.turntable = animation.turntable || !animation.around.empty();
    if (animation.duration && animation.frames) {
        found.push_back(
            error(Kind::usage, "--frames and --duration exclude each other", "leave one out"));
    }
    if (animation.film) {
        animation.film->rate = animation.picture.shutter.rate;
        const auto frames = given.find("--frames");
        if (frames != given.end()) {
            animation.frames = frames_of_film(frames->second.back());
        }
    } else {
        for (const char* option : {"--crf", "--keep-frames"}) {
            if (given.contains(option)) {
                found.push_back(
                    error(Kind::usage,
                          fmt::format("{} is for films, but the output is a sequence", option),
                          "omit it, or name a film: --output film.mp4"));
            }
        }
    }
    if (animation.picture.stereo.has_two_files()) {
        found.push_back(error(Kind::usage, "an animation is one film or sequence, not two",
                              "write --stereo left, and then --stereo right"));
    }
    add(found, check_request(animation.picture));
}

}  // namespace

Value<FrameNumbers> frame_numbers() {
    Value<FrameNumbers> made;
    made.read = frame_numbers_of;
    made.write = [](const FrameNumbers& frames) { return text_of(frames); };
    made.remedy = [](std::string_view) {
        return fmt::format(
            "write the first and the last frame, such as 1-240, numbers from 0 to {}", max_frame);
    };
    return made;
}

Options<AnimationRequest> animation_options() {
    Options<Request> before = scene_options();
    before.add(&Request::shutter, shutter_options());
    before.add(&Request::stereo, stereo_options());
    Options<Request> after = picture_options();
    after.add(&Request::job, safety_options());
    after.add(thread_options());

    Options<AnimationRequest> made;
    made.add(&AnimationRequest::picture, std::move(before));
    made.add(frame_options());
    made.add(&AnimationRequest::picture, std::move(after));
    made.checks.emplace_back(check_together);
    return made;
}

}  // namespace balcony::app
