// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/loaded.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/probe.hpp"
#include "balcony/rays.hpp"

namespace balcony::app {

namespace {

namespace fs = std::filesystem;

bool gives_times(const camera::Picture& picture) {
    const std::vector<camera::ShownCamera> cameras = shown_cameras(picture);
    return std::any_of(cameras.begin(), cameras.end(), [](const camera::ShownCamera& shown) {
        return shown.camera.parts().time.has_value();
    });
}

// When rays meet the scene: while the shutter is open, and at the times that the cameras give them.
scene::TimeInterval times_of_rays(const render::Settings& settings,
                                  const std::optional<camera::Picture>& picture,
                                  Diagnostics& found) {
    const scene::TimeInterval exposure = settings.shutter.exposure(settings.time);
    if (!picture || !gives_times(*picture)) {
        return exposure;
    }
    const Result<rays::RayTimes> times = rays::ray_times(*picture, {exposure.begin, exposure.end});
    add(found, times.diagnostics);
    return times ? scene::TimeInterval{times->first, times->last} : exposure;
}

bool read_scene(const Request& request, Loaded& loaded, Diagnostics& found) {
    if (loaded.scene) {
        return true;
    }
    const auto begin = std::chrono::steady_clock::now();
    auto scene = load_scene(request.scene, request.settings.time, request.added);
    loaded.load_seconds =
        std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
    add(found, scene.diagnostics);
    if (!scene) {
        return false;
    }
    loaded.scene = std::make_shared<const scene::Scene>(std::move(*scene));
    return true;
}

// Without a picture, for the time that the shutter is open.
bool prepare(const Request& request, const std::optional<camera::Picture>& picture, Loaded& loaded,
             Diagnostics& found) {
    const scene::TimeInterval times = times_of_rays(loaded.settings, picture, found);
    if (loaded.renderer && times.begin == loaded.times.begin && times.end == loaded.times.end) {
        return true;
    }
    if (!read_scene(request, loaded, found)) {
        return false;
    }
    auto renderer = render::Renderer::make(
        loaded.scene, {.texture_memory = request.texture_memory, .interval = times});
    add(found, renderer.diagnostics);
    loaded.renderer = std::move(renderer.value);
    loaded.times = times;
    return loaded.renderer.has_value();
}

// Fits the cameras that a workspace makes to the scene, or to its object that is named.
bool fit_cameras(const Request& request, Loaded& loaded, Diagnostics& found) {
    if (!read_scene(request, loaded, found)) {
        return false;
    }
    const Result<render::SceneExtent> extent = render::measure_scene(*loaded.scene, request.fit_to);
    add(found, extent.diagnostics);
    if (!extent) {
        return false;
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
    loaded.cameras.fit_to(std::move(measures));
    return !has_errors(found);
}

}  // namespace

std::vector<fs::path> Loaded::files() const {
    std::vector<fs::path> all = cameras.files();
    if (scene) {
        all.insert(all.end(), scene->files.begin(), scene->files.end());
    }
    all.insert(all.end(), environment.begin(), environment.end());
    return all;
}

std::vector<fs::path> environment_files(const Request& request) {
    const auto* const file = std::get_if<fs::path>(&request.light.environment);
    return file == nullptr ? std::vector<fs::path>{} : std::vector<fs::path>{*file};
}

bool load_settings(const Request& request, Loaded& loaded, Diagnostics& found) {
    Result<render::Settings> settings = settings_of(request);
    add(found, settings.diagnostics);
    loaded.environment = environment_files(request);
    if (settings && !loaded.environment.empty()) {
        const auto read = render::Environment::load(loaded.environment.front());
        add(found, read.diagnostics);
        if (!read) {
            return false;
        }
        settings->light.environment =
            read->rotated(request.light.rotation).scaled(request.light.strength);
    }
    if (settings) {
        loaded.settings = std::move(*settings);
    }
    return settings && !has_errors(found);
}

bool move_along(const camera::Picture& picture, Loaded& loaded, Diagnostics& found) {
    const scene::TimeInterval times = times_of_rays(loaded.settings, picture, found);
    if (!loaded.scene->motion && times.begin == loaded.times.begin &&
        times.end == loaded.times.end) {
        return true;
    }
    Result<render::Renderer> moved = loaded.renderer->moved(loaded.scene, times);
    add(found, moved.diagnostics);
    if (!moved) {
        return false;
    }
    loaded.renderer = std::move(*moved);
    loaded.times = times;
    return true;
}

// A camera loads fast, so its mistakes are reported before a large scene is read.
std::optional<camera::Picture> load_all(const Request& request, Loaded& loaded,
                                        Diagnostics& found) {
    Result<camera::Picture> picture;
    const bool of_file = !request.camera.empty() && !is_of_scene(request.camera);
    if (request.is_fitted() && !fit_cameras(request, loaded, found)) {
        return std::nullopt;
    }
    if (of_file) {
        picture = load_picture(request.camera, request.set, loaded.cameras);
        add(found, picture.diagnostics);
        if (picture && request.is_fitted() && loaded.cameras.fitted().empty()) {
            found.push_back(error(
                "the camera has no fit statement, so --fit cannot place it", {},
                "leave out --fit, or add a statement such as fit (px, py, pz) = scene_inside"));
        }
    }
    if (has_errors(found) || !prepare(request, picture.value, loaded, found)) {
        return std::nullopt;
    }
    if (!of_file) {
        picture = request.camera.empty() ? default_picture(*loaded.scene, *loaded.renderer)
                                         : load_picture(request.camera, request.set, *loaded.scene);
        add(found, picture.diagnostics);
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

}  // namespace balcony::app
