// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The options that describe a picture or an animation. Each group has its file in src/app/options.

#include <string>

#include "balcony/animation.hpp"
#include "balcony/options.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// A width, or a width and a height, under the name that the info has.
[[nodiscard]] Option<SizeRequest> size_option(OptionInfo info);
/// --size, --width and --height; the meaning is that of --size.
[[nodiscard]] Options<SizeRequest> size_options(const std::string& meaning);
/// --aspect
[[nodiscard]] Options<SizeRequest> aspect_options();
/// --crop and --scale
[[nodiscard]] Options<Crop> crop_options();
/// --samples, --noise, --seed and --filter
[[nodiscard]] Options<Request> sampling_options();
/// --integrator, --bounces, --clamp and --no-path-reuse
[[nodiscard]] Options<render::Settings> integrator_options();
/// --environment and its companions
[[nodiscard]] Options<LightRequest> light_options();
/// --lamp and --lamp-at-eye
[[nodiscard]] Options<LightRequest> lamp_options();
/// --shutter, --shutter-shape and --fps
[[nodiscard]] Options<ShutterRequest> shutter_options();
/// --stereo and its companions
[[nodiscard]] Options<StereoRequest> stereo_options();
/// --exposure, --view-transform, --ambient and --background
[[nodiscard]] Options<Request> look_options();
/// --layers, --denoise, --denoiser, --no-dither, --dpi and --texture-memory
[[nodiscard]] Options<Request> film_options();
/// --time-limit, --save-every, --checkpoint-every, --film-memory, --resume and --shard
[[nodiscard]] Options<JobRequest> job_options();
/// Only --checkpoint-every and --film-memory.
[[nodiscard]] Options<JobRequest> safety_options();

/// --fit, --no-fit, --fit-to and --from
[[nodiscard]] Options<Placement> placement_options();
/// Of what is rendered, and through which camera: --add, --camera, --set and its placement
[[nodiscard]] Options<Request> scene_options();
/// Of what a picture looks like: its size and part, its light and its colours.
[[nodiscard]] Options<Request> picture_options();
/// --threads
[[nodiscard]] Options<Request> thread_options();
/// All of a picture but its scene and its output.
[[nodiscard]] Options<Request> request_options();
/// All of an animation but its scene, --output among them.
[[nodiscard]] Options<AnimationRequest> animation_options();

/// The name of the row that a name stands for where names have no hyphens: "--no-dither" of
/// no_dither.
[[nodiscard]] std::string option_name(std::string name);
/// The word of an option whose value has several parts, such as numbers: 640x480 of --size.
[[nodiscard]] std::string word_of_parts(const OptionInfo& row,
                                        const std::vector<std::string>& parts);

/// The name of a unit of length, in metres.
[[nodiscard]] Value<double> unit_of_length();

/// Frames as frame_numbers_of() reads them.
[[nodiscard]] Value<FrameNumbers> frame_numbers();
/// A number, or a fraction such as 30000/1001.
[[nodiscard]] Value<FrameRate> frames_per_second();

/// --time in seconds, at the end of a path of members.
template <class Target, class First, class... More>
[[nodiscard]] Option<Target> time_option(double largest, First Target::*first, More... more) {
    return option({.name = "--time",
                   .others = {"--frame?"},
                   .placeholder = "T",
                   .meaning = "the time in seconds: of the scene's animations, and t in the "
                              "camera's formulas"},
                  number(-largest, largest, "give a number", "s"), first, more...);
}

/// --set, the repeatable NAME=VALUE of a camera's parameters.
template <class Target>
[[nodiscard]] Option<Target> set_option(std::vector<std::string> Target::*set) {
    return words({.name = "--set",
                  .others = {"--fov=fov={}", "--param"},
                  .placeholder = "NAME=VALUE",
                  .meaning = "value of a parameter of the camera or picture; may be repeated",
                  .type = OptionType::setting},
                 set);
}

/// --unit, of a scene
template <class Target>
[[nodiscard]] Option<Target> unit_option(std::optional<double> Target::*meters_per_unit) {
    return option({.name = "--unit",
                   .others = {"--units"},
                   .placeholder = "NAME",
                   .meaning = "how long a unit of the scene is: mm, cm, m, km, in or ft (default: "
                              "what its file says, otherwise m)"},
                  maybe(unit_of_length()), meters_per_unit);
}

/// --dpi
template <class Target>
[[nodiscard]] Option<Target> dpi_option(std::optional<double> Target::*dpi) {
    return option({.name = "--dpi",
                   .others = {"--ppi", "--density"},
                   .placeholder = "NUMBER",
                   .meaning = "pixels per inch of the print, which PNG, JPEG and TIFF files name",
                   .effect = Effect::display},
                  maybe(number(1.0, 65535.0, "give 1 to 65535 pixels per inch, such as 300")), dpi);
}
/// An error if an output has no place for a resolution.
[[nodiscard]] Diagnostics check_dpi(const std::optional<double>& dpi,
                                    const std::filesystem::path& output);

/// The seed of random numbers.
[[nodiscard]] Value<std::uint32_t> seed_value();
/// PART/PARTS, a shard.
[[nodiscard]] Value<render::Shard> shard_value();

}  // namespace balcony::app
