// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/loaded_picture.hpp"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/rays.hpp"
#include "cli/options/camera_argument.hpp"
#include "cli/options/default_camera.hpp"
#include "cli/options/fit_options.hpp"
#include "cli/options/scene_argument.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

namespace {

bool gives_times(const camera::Picture& picture) {
    const std::vector<camera::ShownCamera> cameras = shown_cameras(picture);
    return std::any_of(cameras.begin(), cameras.end(), [](const camera::ShownCamera& shown) {
        return shown.camera.parts().time.has_value();
    });
}

// When rays meet the scene: while the shutter is open, and at the times that the cameras give them.
scene::TimeInterval times_of_rays(const render::Settings& settings,
                                  const std::optional<camera::Picture>& picture,
                                  RenderReport& outcome) {
    const scene::TimeInterval exposure = settings.shutter.exposure(settings.time);
    if (!picture || !gives_times(*picture)) {
        return exposure;
    }
    const Result<rays::RayTimes> times = rays::ray_times(*picture, {exposure.begin, exposure.end});
    add(outcome, times.diagnostics);
    return times ? scene::TimeInterval{times->first, times->last} : exposure;
}

// Fits cameras to the scene, which is read for it.
bool fit(const RenderOptions& options, const Request& request, const std::string& scene,
         Loaded& loaded, RenderReport& outcome) {
    if (!read_scene(scene, request, loaded, outcome)) {
        return false;
    }
    add(outcome, fit_cameras(options.fit, *loaded.scene, loaded.cameras));
    return !has_errors(outcome.diagnostics);
}

}  // namespace

bool read_scene(const std::string& name, const Request& request, Loaded& loaded,
                RenderReport& outcome) {
    if (loaded.scene) {
        return true;
    }
    const auto begin = std::chrono::steady_clock::now();
    auto scene = load_scene(name, request.settings.time, request.added);
    loaded.load_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    add(outcome, scene.diagnostics);
    if (!scene) {
        return false;
    }
    loaded.scene = std::make_shared<scene::Scene>(std::move(*scene));
    return true;
}

bool load(const std::string& name, const Request& request,
          const std::optional<camera::Picture>& picture, Loaded& loaded, RenderReport& outcome) {
    const render::Settings& settings = request.settings;
    const scene::TimeInterval times = times_of_rays(settings, picture, outcome);
    if (loaded.renderer && times.begin == loaded.times.begin && times.end == loaded.times.end) {
        return true;
    }
    if (!read_scene(name, request, loaded, outcome)) {
        return false;
    }
    auto renderer = render::Renderer::make(
        loaded.scene, {.texture_memory = request.texture_memory, .interval = times});
    add(outcome, renderer.diagnostics);
    loaded.renderer = std::move(renderer.value);
    loaded.times = times;
    return loaded.renderer.has_value();
}

bool move_along(const render::Settings& settings, const camera::Picture& picture, Loaded& loaded,
                RenderReport& outcome) {
    const scene::TimeInterval times = times_of_rays(settings, picture, outcome);
    if (!loaded.scene->motion && times.begin == loaded.times.begin &&
        times.end == loaded.times.end) {
        return true;
    }
    Result<render::Renderer> moved = loaded.renderer->moved(times);
    add(outcome, moved.diagnostics);
    if (!moved) {
        return false;
    }
    loaded.renderer = std::move(*moved);
    loaded.times = times;
    return true;
}

std::optional<camera::Picture> load_all(const RenderOptions& options, const Request& request,
                                        const std::string& scene, Loaded& loaded,
                                        RenderReport& outcome) {
    // A camera loads fast, so its mistakes are reported before a large scene is read.
    Result<camera::Picture> picture;
    const bool of_file = !options.camera.empty() && !is_of_scene(options.camera);
    if (options.fit.wanted() && !fit(options, request, scene, loaded, outcome)) {
        return std::nullopt;
    }
    if (of_file) {
        picture = load_picture(options.camera, options.set, loaded.cameras);
        add(outcome, picture.diagnostics);
        if (picture && options.fit.wanted()) {
            add(outcome, check_fitted(loaded.cameras));
        }
    }
    if (has_errors(outcome.diagnostics) || !load(scene, request, picture.value, loaded, outcome)) {
        return std::nullopt;
    }
    if (!of_file) {
        picture = options.camera.empty() ? default_picture(*loaded.scene, *loaded.renderer)
                                         : load_picture(options.camera, options.set, *loaded.scene);
        add(outcome, picture.diagnostics);
    }
    return picture ? std::optional(picture->with_fit(request.size.fit)) : std::nullopt;
}

render::FilmLayout film_layout(const Request& request, const camera::Picture& picture,
                               bool is_displayed) {
    const auto whole = request.size.resolve(picture.aspect(), picture.parts().size);
    const auto [width, height] = request.crop.scaled(whole.first, whole.second);
    return {.width = width,
            .height = height,
            .window = request.crop.region(whole.first, whole.second),
            .data_layers = false,
            .layers = is_displayed ? render::LayerSet{} : request.layers};
}

void describe_preparation(RenderReport& report, const Loaded& loaded) {
    const render::Renderer::Preparation& preparation = loaded.renderer->preparation();
    report.facts["load_seconds"] = loaded.load_seconds;
    report.facts["build_seconds"] = preparation.build_seconds;
    report.facts["texture_seconds"] = preparation.texture_seconds;
    report.sentence += fitted_text(loaded.cameras);
    // Most scenes are ready at once.
    constexpr double noticeable = 0.5;
    const double preparing = preparation.build_seconds + preparation.texture_seconds;
    if (loaded.load_seconds + preparing >= noticeable) {
        report.sentence +=
            fmt::format("  scene read in {}, prepared in {}\n", duration_text(loaded.load_seconds),
                        duration_text(preparing));
    }
}

}  // namespace balcony::cli
