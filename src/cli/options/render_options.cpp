// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/render_options.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string_view>

#include <fmt/format.h>

#include "cli/options/option_values.hpp"

namespace balcony::cli {

namespace {

std::optional<render::Color3f> read_background(const std::string& text, Diagnostics& diagnostics) {
    if (text == "auto" || text == "transparent") {
        return std::nullopt;
    }
    if (text == "black" || text == "white") {
        return render::Color3f(text == "white" ? 1.0F : 0.0F);
    }
    const auto color = color_of(text);
    if (!color || std::min({color->x, color->y, color->z}) < 0.0F) {
        refuse(
            diagnostics, "--background", text,
            "write auto, transparent, black, white, a grey level such as 0.2, or red,green,blue");
    }
    return color;
}

}  // namespace

render::Settings read_settings(const RenderOptions& options, Diagnostics& diagnostics) {
    constexpr double any = std::numeric_limits<double>::max();
    constexpr float brightest = std::numeric_limits<float>::max();
    render::Settings settings;
    read_sampling(options.sampling, settings, diagnostics);
    read_light(options.light, settings, diagnostics);
    settings.threads = read_count("--threads", options.threads, 0, 1024, diagnostics);
    settings.time = read_number("--time", options.time, -any, any, "give a number", diagnostics);
    settings.shutter = read_shutter(options.shutter, diagnostics);
    settings.frames.duration = read_frame_time(options.shutter, diagnostics);
    if (options.ambient != "auto") {
        settings.ambient =
            render::Color3f(read_number("--ambient", options.ambient, 0.0F, brightest,
                                        "give auto, or a number of at least 0", diagnostics));
    }
    read_integrator(options.integrator, settings, diagnostics);
    settings.background = read_background(options.background, diagnostics);
    settings.light.visible = options.background == "auto";
    return settings;
}

render::ViewTransform read_view(const RenderOptions& options, Diagnostics& diagnostics) {
    check_name("--view-transform", options.view, render::view_transform_names(), diagnostics);
    return render::find_view_transform(options.view).value_or(render::ViewTransform::neutral);
}

// More stops than between the smallest and the largest float would give 0 or infinity.
std::optional<double> read_exposure(const RenderOptions& options, Diagnostics& diagnostics) {
    if (options.exposure == "auto") {
        return std::nullopt;
    }
    constexpr double max_stops = 200.0;
    return read_number("--exposure", options.exposure, -max_stops, max_stops,
                       fmt::format("give auto, or stops from -{0} to {0}, such as -1.5", max_stops),
                       diagnostics);
}

}  // namespace balcony::cli
