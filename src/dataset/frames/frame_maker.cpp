// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/frames/frame_maker.hpp"

#include <algorithm>
#include <utility>

#include "balcony/progress.hpp"
#include "dataset/frames/frame_layers.hpp"

namespace balcony::dataset {

namespace {

bool has_layer(const Recipe& recipe, std::string_view name) {
    return std::find(recipe.layers.begin(), recipe.layers.end(), name) != recipe.layers.end();
}

// Without layers of light, the middles of pixels are all that is needed.
void ask_for_layers(const Recipe& recipe, app::Request& request) {
    request.layers = {};
    bool has_light = false;
    for (const std::string& name : recipe.layers) {
        const FrameLayer& layer = frame_layer(name);
        request.layers.insert(layer.needs);
        has_light = has_light || layer.is_of_light;
    }
    if (!has_light) {
        request.samples = 1;
        request.settings.integrator = "preview";
        request.settings.sampling.noise = 0.0;
        request.denoise = false;
    }
}

}  // namespace

camera::Picture FrameMaker::picture_of(const Frame& frame) const {
    return plan_.camera_of(frame).picture.with_pose(plan_.pose_of(frame).pose);
}

// What a render chooses by its picture, by the first frame of the scene, whichever frames follow.
Diagnostics FrameMaker::hold_look(const std::stop_token& stop) {
    const auto first = std::find_if(plan_.frames.begin(), plan_.frames.end(),
                                    [&](const Frame& frame) { return frame.scene == scene_; });
    const camera::Picture picture = picture_of(*first);
    app::Request request = plan_.recipe.picture;
    ask_for_layers(plan_.recipe, request);
    if (has_layer(plan_.recipe, "rgb") && !request.exposure) {
        const auto exposure = prepared_.exposure(picture, request.settings.integrator, stop);
        if (!exposure) {
            return exposure.diagnostics;
        }
        request.exposure = *exposure;
    }
    app::Request look = request;
    look.size = {.width = 64, .height = 64};
    look.samples = 1;
    look.layers = {};
    look.settings.sampling.noise = 0.0;
    look.denoise = false;
    const app::Report report = prepared_.render(picture, look, {}, stop);
    if (has_errors(report.diagnostics)) {
        return report.diagnostics;
    }
    if (report.interrupted) {
        return {stopped()};
    }
    const bool has_ambient_light = report.summary.light.empty();
    if (has_ambient_light && !request.settings.ambient) {
        request.settings.ambient = report.ambient;
    }
    if (report.summary.substitute) {
        request.settings.light.substitute = report.summary.substitute;
    }
    held_ = std::move(request);
    return {};
}

Result<FrameData> FrameMaker::make(const Frame& frame, const app::Observer& observer,
                                   const std::stop_token& stop) {
    if (!held_) {
        Diagnostics found = hold_look(stop);
        if (has_errors(found)) {
            return found;
        }
    }
    const PlannedCamera& camera = plan_.camera_of(frame);
    app::Request request = *held_;
    request.size = {.width = camera.size[0], .height = camera.size[1]};
    request.settings.sampling.seed += static_cast<std::uint32_t>(frame.index);
    FrameData data{.plan = plan_, .frame = frame, .picture = picture_of(frame), .film = {}};
    app::Report report = prepared_.render(data.picture, request, observer, stop);
    if (has_errors(report.diagnostics)) {
        return std::move(report.diagnostics);
    }
    if (report.interrupted || stop.stop_requested()) {
        return stopped();
    }
    data.film = prepared_.film();
    data.display = request.display();
    if (has_layer(plan_.recipe, "flow")) {
        auto flow = flows_.flow(plan_, frame, *data.film, prepared_.renderer(), stop);
        if (!flow) {
            return std::move(flow.diagnostics);
        }
        data.flow = std::move(*flow);
    }
    return {std::move(data), std::move(report.diagnostics)};
}

}  // namespace balcony::dataset
