// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows of options that several commands have.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/inputs.hpp"
#include "balcony/picture_options.hpp"
#include "cli/report/answer.hpp"

namespace balcony::cli {

using app::Effect;
using app::flag;
using app::load_picture;
using app::option;
using app::OptionType;
using app::SizeRequest;
using app::text;

/// The required argument CAMERA.
template <class Target>
[[nodiscard]] app::Option<Target> camera_argument(std::string Target::*camera) {
    return option({.name = "CAMERA",
                   .placeholder = "FILE[:NAME]",
                   .meaning = "camera file and the NAME of a camera or picture in it (default: the "
                              "last), or a built-in camera",
                   .required = true},
                  text(OptionType::camera), camera);
}

/// "scene file (.glb, ...)"
[[nodiscard]] std::string scene_files_text();

/// The required argument SCENE.
template <class Target>
[[nodiscard]] app::Option<Target> scene_argument(std::string Target::*scene, std::string meaning) {
    return option(
        {.name = "SCENE", .meaning = std::move(meaning), .required = true, .effect = Effect::run},
        text(OptionType::scene), scene);
}

/// -o and --output.
template <class Target>
[[nodiscard]] app::Option<Target> output_option(std::string Target::*output, std::string meaning,
                                                bool required = false) {
    return option({.name = "--output",
                   .letter = "-o",
                   .others = {"--out"},
                   .placeholder = "FILE",
                   .meaning = std::move(meaning),
                   .required = required,
                   .effect = Effect::run},
                  text(OptionType::file), output);
}

/// --scene, of a command for cameras.
template <class Target>
[[nodiscard]] app::Option<Target> scene_option(std::string Target::*scene, std::string meaning) {
    return option({.name = "--scene", .placeholder = "SCENE", .meaning = std::move(meaning)},
                  text(OptionType::scene), scene);
}

/// --layer, of a picture.
template <class Target>
[[nodiscard]] app::Option<Target> layer_option(std::string Target::*layer) {
    return option({.name = "--layer",
                   .placeholder = "LAYER",
                   .meaning = "the camera layer of a picture: its name or its number, counted from "
                              "1 at the back"},
                  text(), layer);
}

/// The names that --parameters lists with commas between them; nothing for "all".
[[nodiscard]] std::optional<std::vector<std::string>> open_names(std::string_view words);

/// --axes; none if they are not given.
template <class Target>
[[nodiscard]] app::Option<Target> axes_option(std::optional<Axes> Target::*axes,
                                              std::string meaning) {
    static constexpr std::array rows{Named{Axes::y_up, "y_up"}, Named{Axes::z_up, "z_up"}};
    auto value = app::maybe(app::choice(Names<Axes>(rows)));
    value.remedy = [](std::string_view) { return "write y_up or z_up"; };
    return option({.name = "--axes", .placeholder = "AXES", .meaning = std::move(meaning)}, value,
                  axes);
}

template <class Target>
[[nodiscard]] app::Option<Target> json_flag(Manner Target::*manner, std::string meaning) {
    return flag({.name = "--json", .meaning = std::move(meaning), .effect = Effect::run}, true,
                manner, &Manner::json);
}

/// --quiet and --json; the meaning is that of --json.
template <class Target>
[[nodiscard]] app::Options<Target> manner_options(
    Manner Target::*manner, std::string meaning = "print facts and diagnostics as JSON") {
    return {{flag({.name = "--quiet",
                   .letter = "-q",
                   .meaning = "print only warnings and errors",
                   .effect = Effect::run},
                  true, manner, &Manner::quiet),
             json_flag(manner, std::move(meaning))}};
}

}  // namespace balcony::cli
