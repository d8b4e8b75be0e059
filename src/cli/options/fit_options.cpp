// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/options/fit_options.hpp"

#include <numbers>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <CLI/CLI.hpp>

#include "balcony/probe.hpp"

namespace balcony::cli {

void add_fit_options(CLI::App& command, FitWords& words) {
    command.add_flag("--fit", words.fit,
                     "place the camera by the size of the scene, as its file says; --set still "
                     "sets parameters");
    command
        .add_option("--fit-to", words.object,
                    "the same by the size of an object of the scene, such as a vase")
        ->type_name("OBJECT");
}

Diagnostics fit_cameras(const FitWords& words, const scene::Scene& scene,
                        lang::Workspace& cameras) {
    const Result<render::SceneExtent> extent = render::measure_scene(scene, words.object);
    if (!extent) {
        return extent.diagnostics;
    }
    const auto point = [](const Imath::V3d& p) { return std::array{p.x, p.y, p.z}; };
    lang::SceneMeasures measures{.min = point(extent->bounds.min),
                                 .max = point(extent->bounds.max),
                                 .inside = point(extent->inside),
                                 .radius = extent->radius,
                                 .profile = {}};
    for (const Imath::V2d& p : extent->profile) {
        measures.profile.push_back({p.x, p.y});
    }
    cameras.fit_to(std::move(measures));
    return extent.diagnostics;
}

Diagnostics check_fitted(const lang::Workspace& cameras) {
    if (!cameras.fitted().empty()) {
        return {};
    }
    return {error("the camera has no fit statement, so --fit cannot place it", {},
                  "leave out --fit, or add a statement such as fit (px, py, pz) = scene_inside")};
}

std::string fitted_text(const lang::Workspace& cameras) {
    std::vector<std::string> texts;
    for (const lang::FittedParameter& parameter : cameras.fitted()) {
        if (parameter.value) {
            const double value =
                parameter.is_angle ? *parameter.value * 180.0 / std::numbers::pi : *parameter.value;
            texts.push_back(
                fmt::format("{}={:.4g}{}", parameter.name, value, parameter.is_angle ? "deg" : ""));
        }
    }
    return texts.empty() ? std::string() : fmt::format("  fitted: {}\n", fmt::join(texts, " "));
}

}  // namespace balcony::cli
