// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/inputs/loaded.hpp"

#include <algorithm>
#include <chrono>
#include <utility>

#include "app/inputs/placement.hpp"
#include "app/inputs/true_scale.hpp"
#include "app/words.hpp"
#include "balcony/inputs.hpp"
#include "balcony/rays.hpp"
#include "balcony/solving.hpp"

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
                                  const std::stop_token& stop, Diagnostics& found) {
    const scene::TimeInterval exposure = settings.shutter.exposure(settings.time);
    if (!picture || !gives_times(*picture)) {
        return exposure;
    }
    const Result<rays::RayTimes> times =
        rays::ray_times(*picture, {exposure.begin, exposure.end}, stop);
    add(found, times.diagnostics);
    return times ? scene::TimeInterval{times->first, times->last} : exposure;
}

// Whether the renderer has the scene, and these times.
bool is_prepared(const Loaded& loaded, const scene::TimeInterval& times) {
    return loaded.traced == loaded.scene && times.begin == loaded.times.begin &&
           times.end == loaded.times.end;
}

bool move_renderer(Loaded& loaded, const scene::TimeInterval& times, const std::stop_token& stop,
                   Diagnostics& found) {
    Result<render::Renderer> moved = loaded.renderer->moved(loaded.scene, times, {}, stop);
    add(found, moved.diagnostics);
    if (!moved) {
        return false;
    }
    loaded.renderer = std::move(*moved);
    loaded.traced = loaded.scene;
    loaded.times = times;
    return true;
}

// The environment of a file, which is read as far as that is not done. That of the scene and one
// that a picture has instead are kept.
Result<render::Environment> environment_of(const fs::path& file,
                                           std::vector<EnvironmentFile>& loaded,
                                           const std::stop_token& stop) {
    const auto known = std::find_if(loaded.begin(), loaded.end(), [&](const EnvironmentFile& one) {
        return one.file == file && !one.watch.has_changed();
    });
    if (known != loaded.end()) {
        std::rotate(loaded.begin(), known, known + 1);
        return loaded.front().environment;
    }
    std::erase_if(loaded, [&](const EnvironmentFile& one) { return one.file == file; });
    if (loaded.size() > 1) {
        loaded.pop_back();
    }
    FileWatch watch({file});
    auto read = render::Environment::load(file, stop);
    if (read) {
        loaded.insert(loaded.begin(), EnvironmentFile{file, std::move(watch), *read});
    }
    return read;
}

// Loads what a request needs, as far as that is not done.
class Loading {
public:
    Loading(const Request& request, Loaded& loaded, const Observer& observer,
            const std::stop_token& stop, Diagnostics& found)
        : request_(request), loaded_(loaded), observer_(observer), stop_(stop), found_(found) {
        loaded.cameras.stop_with(stop);
    }

    // A camera loads fast, so its mistakes are reported before a large scene is read.
    std::optional<camera::Picture> picture() {
        const bool of_file = !request_.camera.empty() && !is_of_scene(request_.camera);
        const bool is_solved = !request_.solve.empty();
        const bool is_placed = of_file && !is_solved && request_.placement.places(request_.camera);
        if (is_solved && !solve()) {
            return std::nullopt;
        }
        loaded_.cameras.fit_to({});
        Result<camera::Picture> picture;
        if (of_file) {
            picture = load_picture(request_.camera, set_, loaded_.cameras);
            if (picture && is_placed) {
                picture = placed_picture();
            }
            add(found_, picture.diagnostics);
        }
        if (has_errors(found_) || !prepare(picture.value)) {
            return std::nullopt;
        }
        if (!of_file) {
            picture = request_.camera.empty()
                          ? default_picture(*loaded_.scene, *loaded_.renderer, stop_)
                          : load_picture(request_.camera, request_.set, *loaded_.scene, stop_);
            add(found_, picture.diagnostics);
        }
        if (picture) {
            picture = at_true_scale(request_, *loaded_.scene, *std::move(picture.value));
            add(found_, picture.diagnostics);
        }
        return picture ? std::optional(picture->with_fit(request_.size.fit)) : std::nullopt;
    }

    // The scene alone.
    bool scene() { return prepare(std::nullopt); }

private:
    [[nodiscard]] PartDone telling(Step step) const {
        return observer_.step ? PartDone([this, step](double part) { observer_.step(step, part); })
                              : PartDone();
    }

    bool read_scene() {
        if (loaded_.scene) {
            return true;
        }
        const auto begin = std::chrono::steady_clock::now();
        auto scene = load_scene(
            request_.scene, request_.settings.time, request_.added, telling(Step::reading), stop_,
            {.emission_scale = request_.light.emission_scale, .solid_glass = request_.solid_glass});
        loaded_.load_seconds =
            std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
        add(found_, scene.diagnostics);
        if (!scene) {
            return false;
        }
        complete(*scene, request_);
        loaded_.scene = std::make_shared<const scene::Scene>(std::move(*scene));
        return true;
    }

    // Gives the parameters the values with which the picture shows the marks.
    bool solve() {
        loaded_.marks = {request_.solve};
        const Result<SolveReport> solved =
            solve_camera({request_.camera, request_.set, request_.solve}, stop_);
        add(found_, solved.diagnostics);
        if (solved) {
            const std::vector<std::string> values = settings_of(*solved);
            set_.insert(set_.end(), values.begin(), values.end());
        }
        return solved.value.has_value();
    }

    // Without a picture, for the time that the shutter is open.
    bool prepare(const std::optional<camera::Picture>& picture) {
        const scene::TimeInterval times = times_of_rays(loaded_.settings, picture, stop_, found_);
        if (loaded_.renderer) {
            return is_prepared(loaded_, times) || move_renderer(loaded_, times, stop_, found_);
        }
        if (!read_scene()) {
            return false;
        }
        auto renderer = render::Renderer::make(
            loaded_.scene, {.texture_memory = request_.texture_memory, .interval = times},
            telling(Step::building), stop_);
        add(found_, renderer.diagnostics);
        loaded_.renderer = std::move(renderer.value);
        loaded_.traced = loaded_.scene;
        loaded_.times = times;
        return loaded_.renderer.has_value();
    }

    // The camera of a file where the scene places it.
    Result<camera::Picture> placed_picture() {
        if (!prepare(std::nullopt)) {
            return Diagnostics{};
        }
        const auto make = [this] {
            return load_picture(request_.camera, request_.set, loaded_.cameras);
        };
        Diagnostics found = fit_cameras(
            loaded_.cameras, request_.placement, *loaded_.scene, *loaded_.renderer,
            [&] { return cameras_of(make()); }, stop_);
        if (has_errors(found)) {
            return found;
        }
        Result<camera::Picture> picture = make();
        add(picture.diagnostics, found);
        add(picture.diagnostics,
            warn_of_unused_place(request_.placement, loaded_.cameras.fitted()));
        if (picture && request_.placement.is_demanded() && loaded_.cameras.fitted().empty()) {
            return error(
                "the camera has no fit statement, so --fit cannot place it", {},
                "leave out --fit, or add a statement such as fit (px, py, pz) = scene_inside");
        }
        return picture;
    }

    const Request& request_;
    std::vector<std::string> set_ = request_.set;
    Loaded& loaded_;
    const Observer& observer_;
    const std::stop_token& stop_;
    Diagnostics& found_;
};

}  // namespace

std::vector<fs::path> Loaded::files() const {
    std::vector<fs::path> all = cameras.files();
    if (scene) {
        all.insert(all.end(), scene->files.begin(), scene->files.end());
    }
    if (environment) {
        all.push_back(*environment);
    }
    all.insert(all.end(), marks.begin(), marks.end());
    return all;
}

Loaded shared(const Loaded& loaded) {
    Loaded made;
    made.scene = loaded.scene;
    made.renderer = loaded.renderer;
    made.traced = loaded.traced;
    made.times = loaded.times;
    made.load_seconds = loaded.load_seconds;
    made.settings = loaded.settings;
    made.environment = loaded.environment;
    made.environments = loaded.environments;
    made.since = loaded.since;
    return made;
}

bool load_settings(const Request& request, Loaded& loaded, const std::stop_token& stop,
                   Diagnostics& found) {
    Result<render::Settings> settings = settings_of(request);
    add(found, settings.diagnostics);
    const auto* const file = std::get_if<fs::path>(&request.light.environment);
    loaded.environment.reset();
    if (file != nullptr && settings) {
        const auto environment = environment_of(*file, loaded.environments, stop);
        add(found, environment.diagnostics);
        if (!environment) {
            return false;
        }
        loaded.environment = *file;
        settings->light.environment =
            environment->rotated(request.light.rotation).scaled(request.light.strength);
    }
    if (settings) {
        loaded.settings = std::move(*settings);
    }
    return settings && !has_errors(found);
}

bool move_along(const std::optional<camera::Picture>& picture, Loaded& loaded,
                const std::stop_token& stop, Diagnostics& found) {
    const scene::TimeInterval times = times_of_rays(loaded.settings, picture, stop, found);
    return is_prepared(loaded, times) || move_renderer(loaded, times, stop, found);
}

void complete(scene::Scene& scene, const Request& request) {
    set_unit(scene, request.meters_per_unit);
    if (const auto& lamps = request.light.lamps; !lamps.empty()) {
        scene.lights.insert(scene.lights.end(), lamps.begin(), lamps.end());
        scene.default_light = false;
    }
}

std::optional<camera::Picture> load_all(const Request& request, Loaded& loaded,
                                        const Observer& observer, const std::stop_token& stop,
                                        Diagnostics& found) {
    return Loading(request, loaded, observer, stop, found).picture();
}

bool load_scene_of(const Request& request, Loaded& loaded, const Observer& observer,
                   const std::stop_token& stop, Diagnostics& found) {
    return Loading(request, loaded, observer, stop, found).scene();
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
