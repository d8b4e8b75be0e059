// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "python/words.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/picture_options.hpp"
#include "python/diagnostics.hpp"

namespace balcony::python {

namespace py = pybind11;

namespace {

bool is_list(const py::handle& value) {
    return py::isinstance<py::list>(value) || py::isinstance<py::tuple>(value);
}

// An array as lists, and what has a path as that.
py::object plain(const py::handle& value) {
    if (py::hasattr(value, "tolist")) {
        return value.attr("tolist")();
    }
    if (py::hasattr(value, "__fspath__")) {
        return value.attr("__fspath__")();
    }
    return py::reinterpret_borrow<py::object>(value);
}

[[noreturn]] void refuse(const std::string& name, const py::handle& value) {
    throw py::type_error(
        fmt::format("'{}' is {}, but a number, a text or a tuple of numbers is needed", name,
                    std::string(py::repr(value))));
}

std::string number_text(const std::string& name, const py::handle& value) {
    const double number = PyFloat_AsDouble(value.ptr());
    if (PyErr_Occurred() != nullptr) {
        PyErr_Clear();
        refuse(name, value);
    }
    if (!std::isfinite(number)) {
        throw py::value_error(fmt::format("'{}' is {}, but a finite number is needed", name,
                                          std::string(py::repr(value))));
    }
    return fmt::format("{}", number);
}

std::string expression_of(const std::string& name, const py::handle& given) {
    const py::object value = plain(given);
    if (py::isinstance<py::str>(value)) {
        return value.cast<std::string>();
    }
    if (py::isinstance<py::bool_>(value)) {
        refuse(name, value);
    }
    if (!is_list(value)) {
        return number_text(name, value);
    }
    std::vector<std::string> parts;
    for (const py::handle& part : value) {
        parts.push_back(expression_of(name, part));
    }
    const bool is_tuple = py::isinstance<py::tuple>(value);
    return fmt::format("{}{}{}", is_tuple ? '(' : '[', fmt::join(parts, ", "),
                       is_tuple ? ')' : ']');
}

// One value of an option as a word.
std::string word_of(const app::OptionInfo& row, const py::handle& given) {
    const py::object value = plain(given);
    if (py::isinstance<py::str>(value)) {
        return value.cast<std::string>();
    }
    if (!is_list(value)) {
        return number_text(row.name, value);
    }
    std::vector<std::string> parts;
    for (const py::handle& part : value) {
        parts.push_back(word_of(row, part));
    }
    return app::word_of_parts(row, parts);
}

std::vector<std::string> words_of(const app::OptionInfo& row, const py::handle& value) {
    if (row.type == app::OptionType::flag) {
        return value.cast<bool>() ? std::vector<std::string>{"true"} : std::vector<std::string>{};
    }
    std::vector<std::string> words;
    if (row.repeated && py::isinstance<py::list>(value)) {
        for (const py::handle& one : value) {
            words.push_back(word_of(row, one));
        }
    } else {
        words.push_back(word_of(row, value));
    }
    return words;
}

template <class Target>
Diagnostic unknown_option(const std::string& name, const app::Options<Target>& options,
                          std::string_view command) {
    std::vector<std::string> names;
    for (const app::OptionInfo& row : options.rows) {
        names.push_back(row.name.substr(2));
    }
    return error(
        Kind::usage, fmt::format("there is no option '{}'", name),
        did_you_mean(name, names,
                     fmt::format("docs/command.md lists the options of balcony {}", command)));
}

template <class Target>
void add_names(const app::Options<Target>& options, std::set<std::string>& names) {
    for (const app::OptionInfo& row : options.rows) {
        names.insert(row.name);
    }
}

// Whether a scene is loaded by an option, and does not change afterwards.
bool is_of_scene(const std::string& name) {
    static const std::set<std::string> names = [] {
        std::set<std::string> made{"--time", "--texture-memory", "--emission-scale"};
        add_names(app::scene_options(), made);
        add_names(app::lamp_options(), made);
        return made;
    }();
    return names.contains(name);
}

// The frames of an animation have a shutter of their own.
bool is_of_shutter(const std::string& name) {
    static const std::set<std::string> names = [] {
        std::set<std::string> made;
        add_names(app::shutter_options(), made);
        return made;
    }();
    return names.contains(name);
}

// An option that is given elsewhere in Python is an error that says so.
void check_use(const std::string& name, OptionUse use) {
    const bool is_of_camera = name == "--camera" || name == "--set" || name == "--solve";
    const bool is_of_load =
        use != OptionUse::scene &&
        (is_of_scene(name) || (use == OptionUse::picture && is_of_shutter(name)));
    if (is_of_camera || is_of_load) {
        tell({error(Kind::usage,
                    fmt::format("'{}' is no option of {}", name.substr(2),
                                use == OptionUse::scene     ? "a scene"
                                : use == OptionUse::picture ? "a picture"
                                                            : "an animation"),
                    is_of_camera ? "give parameters to camera(), and the camera to render()"
                                 : "give it to load()")});
    }
}

// The request is that of the target.
template <class Target>
void read_rows(const py::dict& options, const app::Options<Target>& known, OptionUse use,
               app::Request& request, Target& target) {
    app::GivenWords given;
    for (const auto& [key, value] : options) {
        const std::string name = app::option_name(key.template cast<std::string>());
        const auto row = std::find_if(known.rows.begin(), known.rows.end(),
                                      [&](const app::OptionInfo& one) { return one.name == name; });
        if (row == known.rows.end()) {
            tell({unknown_option(name.substr(2), known,
                                 use == OptionUse::frames ? "animate" : "render")});
        }
        if (value.is_none()) {
            continue;
        }
        check_use(row->name, use);
        std::vector<std::string> words = words_of(*row, value);
        if (!words.empty()) {
            given[row->name] = std::move(words);
        }
    }
    // Options that place a camera are those of a scene, whose cameras come later.
    const std::string camera = std::exchange(request.camera, "pinhole");
    Diagnostics found;
    known.read(given, target, found);
    request.camera = camera;
    tell(found);
}

}  // namespace

std::vector<lang::Override> values_of(
    const py::dict& values, const std::vector<app::EditableCamera::Parameter>& parameters) {
    std::vector<lang::Override> made;
    for (const auto& [key, value] : values) {
        const auto name = key.cast<std::string>();
        const bool is_angle =
            std::any_of(parameters.begin(), parameters.end(),
                        [&](const auto& one) { return one.name == name && one.is_angle; });
        std::string expression = expression_of(name, value);
        const bool is_number = !py::isinstance<py::str>(value);
        made.push_back({name, is_angle && is_number ? expression + "rad" : expression});
    }
    return made;
}

void read_options(const py::dict& options, OptionUse use, app::Request& request) {
    read_rows(options, app::request_options(), use, request, request);
}

void read_options(const py::dict& options, app::AnimationRequest& animation) {
    read_rows(options, app::animation_options(), OptionUse::frames, animation.picture, animation);
}

bool is_scene_option(const std::string& name) { return is_of_scene(app::option_name(name)); }

std::optional<Axes> axes_of(const py::object& name) {
    if (name.is_none()) {
        return {};
    }
    const auto text = name.cast<std::string>();
    if (text != "y_up" && text != "z_up") {
        throw py::value_error(fmt::format("there are no axes '{}': give 'y_up' or 'z_up'", text));
    }
    return text == "y_up" ? Axes::y_up : Axes::z_up;
}

}  // namespace balcony::python
