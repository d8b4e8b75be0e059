// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/placement.hpp"

#include <algorithm>
#include <array>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "app/inputs/standpoint.hpp"
#include "balcony/inputs.hpp"
#include "balcony/names.hpp"
#include "balcony/probe.hpp"

namespace balcony::app {

namespace fs = std::filesystem;

bool Placement::places(const std::string& camera) const {
    const fs::path file = camera_file(camera);
    std::error_code ignored;
    const bool is_built_in = !lang::family_of(file.string()).empty() && !fs::exists(file, ignored);
    return is_demanded() || (is_built_in && fit.value_or(true));
}

namespace {

bool start_inside(const std::vector<camera::Camera>& cameras, const scene::Scene& scene,
                  const render::Renderer& renderer, const std::stop_token& stop) {
    constexpr std::size_t side = 64;
    const render::ProbeSettings settings{
        .width = side, .height = side, .searches = false, .time = scene.time};
    return std::any_of(cameras.begin(), cameras.end(), [&](const camera::Camera& camera) {
        const auto probe = render::probe(renderer, camera, settings, {}, stop);
        const auto starts = probe ? starts_inside(*probe, scene) : std::vector<StartInside>();
        return std::any_of(starts.begin(), starts.end(),
                           [](const StartInside& start) { return !start.is_room; });
    });
}

// With bounds that are smaller about their centre.
lang::SceneMeasures shrunk(lang::SceneMeasures measures, double scale) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const double center = 0.5 * (measures.min[axis] + measures.max[axis]);
        measures.min[axis] = center + scale * (measures.min[axis] - center);
        measures.max[axis] = center + scale * (measures.max[axis] - center);
    }
    return measures;
}

std::vector<double> values_of(const std::vector<lang::FittedParameter>& fitted) {
    std::vector<double> values;
    for (const lang::FittedParameter& parameter : fitted) {
        values.push_back(parameter.value.value_or(0.0));
    }
    return values;
}

void fit_in_the_open(lang::Workspace& cameras, const lang::SceneMeasures& measures,
                     const MakeCameras& make,
                     const std::function<bool(const std::vector<camera::Camera>&)>& is_bad) {
    constexpr double step = 0.85;
    constexpr double smallest = 0.3;
    std::vector<double> fitted;
    for (double scale = 1.0; scale > smallest; scale *= step) {
        cameras.fit_to(shrunk(measures, scale));
        if (!is_bad(make())) {
            return;
        }
        const std::vector<double> before = std::exchange(fitted, values_of(cameras.fitted()));
        if (before == fitted) {
            break;  // They do not depend on the bounds.
        }
    }
    cameras.fit_to(measures);
}

}  // namespace

std::vector<camera::Camera> cameras_of(const Result<camera::Picture>& picture) {
    std::vector<camera::Camera> cameras;
    if (picture) {
        for (const camera::ShownCamera& shown : shown_cameras(*picture)) {
            cameras.push_back(shown.camera);
        }
    }
    return cameras;
}

Diagnostics fit_cameras(lang::Workspace& cameras, const Placement& placement,
                        const scene::Scene& scene, const render::Renderer& renderer,
                        const MakeCameras& make, const std::stop_token& stop) {
    const Result<render::SceneExtent> extent =
        render::measure_scene(renderer, placement.fit_to, stop);
    if (!extent) {
        return extent.diagnostics;
    }
    const auto point = [](const Imath::V3d& p) { return std::array{p.x, p.y, p.z}; };
    const auto line = [](const std::vector<Imath::V2d>& points) {
        std::vector<std::array<double, 2>> made;
        for (const Imath::V2d& p : points) {
            made.push_back({p.x, p.y});
        }
        return made;
    };
    lang::SceneMeasures measures{.min = point(extent->bounds.min),
                                 .max = point(extent->bounds.max),
                                 .inside = point(extent->inside),
                                 .radius = extent->radius,
                                 .profile = line(extent->profile)};
    if (const auto& found = extent->revolution) {
        measures.revolution = {.axis = point(found->axis),
                               .center = point(found->center),
                               .length = found->length,
                               .radius = found->radius,
                               .reach = found->reach,
                               .arc_middle = found->arc_middle,
                               .arc = found->arc,
                               .profile = line(found->profile)};
    }
    const Result<Standpoint> stand = standpoint(placement, scene, *extent);
    if (!stand) {
        return stand.diagnostics;
    }
    measures.inside = point(stand->position);
    measures.look = stand->look;
    measures.angle = stand->angle;
    fit_in_the_open(cameras, measures, make, [&](const std::vector<camera::Camera>& made) {
        return start_inside(made, scene, renderer, stop);
    });
    return extent.diagnostics;
}

Diagnostics warn_of_unused_place(const Placement& placement,
                                 const std::vector<lang::FittedParameter>& fitted) {
    const bool is_used =
        std::any_of(fitted.begin(), fitted.end(),
                    [](const lang::FittedParameter& parameter) { return parameter.follows_place; });
    return !placement.from || is_used || fitted.empty()
               ? Diagnostics{}
               : Diagnostics{warning(
                     fmt::format("--from has no effect: the size of the scene decides where the "
                                 "camera '{}' is",
                                 printable(fitted.front().camera)),
                     {}, "move it by its own parameters, such as --set px=1")};
}

Diagnostics check_placement(const Placement& placement, bool has_scene) {
    Diagnostics found;
    if (placement.is_demanded() && !has_scene) {
        found.push_back(error(Kind::usage, "--fit places a camera in a scene, but there is none",
                              "add --scene FILE"));
    }
    if (placement.fit == false && (!placement.fit_to.empty() || placement.from)) {
        found.push_back(
            error(Kind::usage,
                  fmt::format("--no-fit contradicts {}", placement.from ? "--from" : "--fit-to"),
                  "leave out one of them"));
    }
    return found;
}

}  // namespace balcony::app
