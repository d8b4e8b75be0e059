// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/picture_options.hpp"

#include <algorithm>
#include <array>
#include <limits>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"

namespace balcony::app {

namespace {

using Place = std::variant<Imath::V3d, std::string>;

// In metres.
constexpr std::array lengths{Named{0.001, "mm"},  Named{0.01, "cm"},   Named{1.0, "m"},
                             Named{1000.0, "km"}, Named{0.0254, "in"}, Named{0.3048, "ft"}};

Value<Place> place() {
    Value<Place> made;
    made.read = [](std::string_view word) -> std::optional<Place> {
        const std::optional<Imath::V3d> point = point_of(word);
        return point                            ? std::optional<Place>(*point)
               : is_of_scene(std::string(word)) ? std::optional<Place>(std::string(word))
                                                : std::nullopt;
    };
    made.write = [](const Place& place) {
        const auto* const point = std::get_if<Imath::V3d>(&place);
        return point != nullptr ? fmt::format("{},{},{}", point->x, point->y, point->z)
                                : std::get<std::string>(place);
    };
    made.remedy = [](std::string_view) {
        return "write X,Y,Z, such as 1,1.6,-2, or scene:NAME of a camera of the scene";
    };
    return made;
}

Value<bool> glass() {
    return converted<bool>(
        choice(std::vector<OptionChoice>{{"thin"}, {"solid"}}),
        [](const std::string& kind) { return kind == "solid"; },
        [](bool solid) { return std::string(solid ? "solid" : "thin"); });
}

}  // namespace

Value<double> unit_of_length() { return choice(Names<double>(lengths)); }

Options<Placement> placement_options() {
    return {{flag({.name = "--fit",
                   .meaning = "place the camera by the size of the scene, as its file says; "
                              "--set still sets parameters (default: built-in cameras)"},
                  true, &Placement::fit),
             flag({.name = "--no-fit",
                   .meaning = "the camera stands where its file says, also a built-in one"},
                  false, &Placement::fit),
             option({.name = "--fit-to",
                     .others = {"--look-at", "--lookat", "--target"},
                     .placeholder = "OBJECT",
                     .meaning = "place the camera by the size of an object of the scene, such as "
                                "a vase; a camera that stands at a point looks at it"},
                    text(), &Placement::fit_to),
             option({.name = "--from",
                     .others = {"--position", "--eye"},
                     .placeholder = "PLACE",
                     .meaning = "where a camera stands that is placed: X,Y,Z in the scene, or "
                                "scene:NAME as that camera of the scene"},
                    maybe(place()), &Placement::from)}};
}

namespace {

Option<Request> solve_option() {
    return option({.name = "--solve",
                   .others = {"--match"},
                   .placeholder = "FILE",
                   .meaning = "file of marks (.yml) that says what the picture is to show: "
                              "parameters of the camera are found by it, as with 'balcony solve'"},
                  converted<std::filesystem::path>(
                      text(OptionType::file),
                      [](const std::string& file) { return std::filesystem::path(file); },
                      [](const std::filesystem::path& file) { return file.string(); }),
                  &Request::solve);
}

}  // namespace

Options<Request> scene_options() {
    Options<Request> made{
        {words({.name = "--add",
                .placeholder = "SCENE",
                .meaning = "another scene file, which joins each scene: the arrows of a camera by "
                           "balcony draw, say; may be repeated",
                .type = OptionType::scene},
               &Request::added),
         option({.name = "--glass",
                 .placeholder = "KIND",
                 .meaning = "closed, curved objects of glass without a volume, as Blender exports "
                            "them: thin (as written) or solid, which refracts (default: thin, "
                            "and a warning)"},
                maybe(glass()), &Request::solid_glass),
         option({.name = "--camera",
                 .letter = "-c",
                 .others = {"--cam"},
                 .placeholder = "FILE[:NAME]",
                 .meaning = "camera file and the NAME of a camera or picture in it (default: the "
                            "last), or a built-in camera; scene:NAME is a camera of the scene "
                            "(default: its first, or one that shows the scene well)"},
                text(OptionType::camera), &Request::camera),
         unit_option(&Request::meters_per_unit), set_option(&Request::set), solve_option()}};
    made.add(&Request::placement, placement_options());
    made.add({{option({.name = "--inside",
                       .placeholder = "RULE",
                       .meaning = "rays that start in closed objects, such as furniture in the eye "
                                  "object: " +
                                  described(choices_of(inside_rules()))},
                      choice(inside_rules()), &Request::inside)}});
    return made;
}

Options<Request> picture_options() {
    Options<Request> made;
    made.add(&Request::size,
             size_options("size in pixels (default: that of the picture, or about a million pixels "
                          "with its aspect ratio)"));
    made.rows.push_back(
        option({.name = "--mm-per-pixel",
                .others = {"--gsd"},
                .placeholder = "LENGTH",
                .meaning = "in place of a size: millimetres of the surface in a pixel, for cameras "
                           "with a scale, such as rollout; --dpi becomes that of a print in "
                           "the size of the surface"},
               maybe(number(1e-6, 1e9, "give millimetres above 0, such as 0.5", "mm")),
               &Request::mm_per_pixel));
    made.add(&Request::size, aspect_options());
    made.add(&Request::crop, crop_options());
    made.add(sampling_options());
    made.add(&Request::settings, integrator_options());
    made.add(&Request::light, light_options());
    made.add(&Request::light, lamp_options());
    made.add(look_options());
    made.add(film_options());
    return made;
}

Options<Request> thread_options() {
    return {{option({.name = "--threads",
                     .letter = "-j",
                     .others = {"--jobs"},
                     .placeholder = "COUNT",
                     .meaning = "number of threads; 0 uses all processors",
                     .effect = Effect::run},
                    count(0, 1024), &Request::settings, &render::Settings::threads)}};
}

Options<Request> request_options() {
    Options<Request> made = scene_options();
    made.rows.push_back(time_option(std::numeric_limits<double>::max(), &Request::settings,
                                    &render::Settings::time));
    made.add(&Request::shutter, shutter_options());
    made.add(&Request::stereo, stereo_options());
    made.add(picture_options());
    made.add(&Request::job, job_options());
    made.add(thread_options());
    made.checks.push_back([](Request& request, const GivenWords&, Diagnostics& found) {
        add(found, check_request(request));
    });
    return made;
}

std::string option_name(std::string name) {
    std::replace(name.begin(), name.end(), '_', '-');
    return "--" + name;
}

std::string word_of_parts(const OptionInfo& row, const std::vector<std::string>& parts) {
    return fmt::format("{}", fmt::join(parts, row.type == OptionType::size ? "x" : ","));
}

}  // namespace balcony::app
