// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Values of Python as the words of the language and of the options of the command.

#include <cstdint>
#include <string>
#include <vector>

#include <pybind11/pybind11.h>

#include "balcony/animation.hpp"
#include "balcony/editable_camera.hpp"
#include "balcony/lang.hpp"
#include "balcony/options.hpp"
#include "balcony/request.hpp"

namespace balcony::python {

/// Values for the parameters of a camera: texts are expressions of the language, numbers are in
/// radians if the parameter is an angle, and tuples and lists have numbers. Raises TypeError.
[[nodiscard]] std::vector<lang::Override> values_of(
    const pybind11::dict& values, const std::vector<app::EditableCamera::Parameter>& parameters);

/// What options are for: a scene that is loaded, a picture of it, or the frames of an animation.
enum class OptionUse : std::uint8_t { scene, picture, frames };

/// Adds options of the command to a request by their names, `no_dither` for --no-dither: texts are
/// as the command has them, True gives a flag, a tuple has the numbers of a value, and a list has
/// the values of an option that may be repeated. None gives nothing. Raises what the rows of the
/// options say, and balcony.UsageError for options of a picture that only a scene can have.
void read_options(const pybind11::dict& options, OptionUse use, app::Request& request);
/// The same for the frames of a scene that is loaded.
void read_options(const pybind11::dict& options, app::AnimationRequest& animation);

/// Whether a scene is loaded by an option of this name.
[[nodiscard]] bool is_scene_option(const std::string& name);

/// Axes by name, y_up or z_up; nothing for None. Raises ValueError.
[[nodiscard]] std::optional<Axes> axes_of(const pybind11::object& name);

}  // namespace balcony::python
