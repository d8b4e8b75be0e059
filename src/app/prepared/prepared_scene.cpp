// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/prepared_scene.hpp"

#include <utility>

#include <fmt/format.h>

#include "app/animation/animate.hpp"
#include "app/inputs/loaded.hpp"
#include "app/inputs/placement.hpp"
#include "app/inputs/true_scale.hpp"
#include "app/picture/look.hpp"
#include "app/picture/session.hpp"
#include "app/request_check.hpp"
#include "app/words.hpp"
#include "balcony/motion.hpp"
#include "balcony/scene_edits.hpp"

namespace balcony::app {

struct PreparedScene::State {
    Request request;
    Loaded loaded;
    bool is_edited = false;                      // Its files do not tell what it is.
    std::shared_ptr<const render::Film> film{};  // Of the last picture.

    [[nodiscard]] Request request_for(const camera::Picture& picture, const Request& asked) const;
};

PreparedScene::PreparedScene(std::unique_ptr<State> state) : state_(std::move(state)) {}
PreparedScene::PreparedScene(PreparedScene&&) noexcept = default;
PreparedScene& PreparedScene::operator=(PreparedScene&&) noexcept = default;
PreparedScene::~PreparedScene() = default;

Result<PreparedScene> PreparedScene::make(const Request& request, const Observer& observer,
                                          const std::stop_token& stop) {
    auto state = std::make_unique<State>();
    state->request = request;
    return make(std::move(state), observer, stop);
}

Result<PreparedScene> PreparedScene::make(scene::Scene scene, const Request& request,
                                          const Observer& observer, const std::stop_token& stop) {
    auto state = std::make_unique<State>();
    state->request = request;
    complete(scene, request);
    state->loaded.scene = std::make_shared<const scene::Scene>(std::move(scene));
    state->is_edited = true;
    return make(std::move(state), observer, stop);
}

Result<PreparedScene> PreparedScene::make(std::unique_ptr<State> state, const Observer& observer,
                                          const std::stop_token& stop) {
    const Request& request = state->request;
    Diagnostics found;
    bool done = false;
    within_memory(found, [&] {
        done = load_settings(request, state->loaded, stop, found) &&
               load_scene_of(request, state->loaded, observer, stop, found);
    });
    if (!done) {
        return found;
    }
    return {PreparedScene(std::move(state)), std::move(found)};
}

PreparedScene PreparedScene::share() const {
    return PreparedScene(
        std::make_unique<State>(State{state_->request, shared(state_->loaded), state_->is_edited}));
}

Result<lang::OpenPicture> PreparedScene::picture(
    const lang::CameraSource& source, std::string_view name,
    const std::vector<lang::Override>& values, const std::stop_token& stop,
    const std::optional<std::vector<std::string>>& open) {
    Loaded& loaded = state_->loaded;
    const Request& request = state_->request;
    Diagnostics prepared;
    if (loaded.traced != loaded.scene && !move_along({}, loaded, stop, prepared)) {
        return prepared;
    }
    loaded.cameras.stop_with(stop);
    loaded.cameras.fit_to({});
    const auto make = [&] { return loaded.cameras.make_open_picture(source, name, values, open); };
    Result<lang::OpenPicture> made = make();
    if (made && request.placement.places(source.path().string())) {
        // Probes know no inputs.
        const auto cameras = [&] {
            return cameras_of(loaded.cameras.make_picture(source, name, values));
        };
        Diagnostics found = fit_cameras(loaded.cameras, request.placement, *loaded.scene,
                                        *loaded.renderer, cameras, stop);
        if (has_errors(found)) {
            return found;
        }
        made = make();
        add(made.diagnostics, found);
    }
    if (made && !move_along(made->picture, loaded, stop, made.diagnostics)) {
        return std::move(made.diagnostics);
    }
    if (made) {
        made->picture = made->picture.with_fit(request.size.fit);
    }
    return made;
}

Result<camera::Picture> PreparedScene::in_stereo(const camera::Picture& picture,
                                                 camera::StereoFormat format) const {
    return camera::stereo_picture(picture, format, state_->request.stereo.pair);
}

Diagnostics PreparedScene::set_time(double time) {
    Loaded& loaded = state_->loaded;
    loaded.settings.time = time;
    if (!loaded.scene->motion) {
        return {};
    }
    Result<scene::Scene> moved = scene::moved_to(*loaded.scene, time);
    loaded.scene = std::make_shared<const scene::Scene>(std::move(*moved));
    return std::move(moved.diagnostics);
}

Diagnostics PreparedScene::edit(const SceneEdit& change) {
    scene::Scene changed = *state_->loaded.scene;
    Diagnostics found = change(changed);
    if (!has_errors(found)) {
        state_->loaded.scene = std::make_shared<const scene::Scene>(std::move(changed));
        state_->is_edited = true;
    }
    return found;
}

Diagnostics PreparedScene::prepare(const std::optional<camera::Picture>& picture,
                                   const std::stop_token& stop) {
    Diagnostics found;
    static_cast<void>(move_along(picture, state_->loaded, stop, found));
    return found;
}

// What a request says besides the scene and the camera.
Request PreparedScene::State::request_for(const camera::Picture& picture,
                                          const Request& asked) const {
    Request made = asked;
    made.camera = picture.name();  // Not a camera of the scene, which would move with it.
    made.set.clear();
    made.solve.clear();
    made.placement = {};
    made.size.fit = request.size.fit;
    made.settings.time = loaded.settings.time;
    return made;
}

Report PreparedScene::render(const camera::Picture& picture, const Request& request,
                             const Observer& observer, const std::stop_token& stop) {
    const auto scaled = at_true_scale(request, *scene(), picture);
    Diagnostics found = scaled.diagnostics;
    Report report;
    if (request.job.resume && state_->is_edited) {
        found.push_back(error(Kind::usage,
                              "a picture of a scene that a program has changed is not continued",
                              "render it from the beginning, or load the changes from a file"));
    }
    if (!has_errors(found) && move_along(*scaled, state_->loaded, stop, found)) {
        report = render_in(state_->loaded, *scaled, state_->request_for(*scaled, request), observer,
                           stop, state_->film);
    } else {
        state_->film.reset();
        report.interrupted = kind_of_errors(found) == Kind::interrupted;
    }
    report.diagnostics.insert(report.diagnostics.begin(), found.begin(), found.end());
    return report;
}

std::shared_ptr<const render::Film> PreparedScene::film() const { return state_->film; }

AnimationReport PreparedScene::animate(const camera::Picture& picture,
                                       const AnimationRequest& animation, const Observer& observer,
                                       const std::stop_token& stop) {
    AnimationReport report;
    Diagnostics& found = report.diagnostics;
    AnimationRequest own = animation;
    own.overwrite = own.overwrite || !own.identity;
    within_memory(found, [&] {
        if (add(found, check_frames(own))) {
            return;
        }
        static_cast<void>(set_time(own.time_of(1)));  // The frames tell what cannot move.
        if (own.identity && state_->is_edited) {
            *own.identity += fmt::format("\nscene #{:016x}", scene::content_hash(*scene()));
        }
        own.picture = state_->request_for(picture, animation.picture);
        Loaded& loaded = state_->loaded;
        const auto scaled = at_true_scale(own.picture, *loaded.scene, picture);
        if (!add(found, scaled.diagnostics) && !add(found, check_request(own.picture)) &&
            load_settings(own.picture, loaded, stop, found) &&
            move_along(*scaled, loaded, stop, found)) {
            render_frames(own, loaded, *scaled, observer, stop, report);
        }
        report.interrupted |= kind_of_errors(found) == Kind::interrupted;
        if (report.interrupted && own.film && !own.identity) {
            end_film(own, observer, report);
        }
    });
    return report;
}

Result<double> PreparedScene::exposure(const camera::Picture& picture, std::string_view integrator,
                                       const std::stop_token& stop) const {
    if (state_->request.exposure) {
        return *state_->request.exposure;
    }
    render::Settings settings = state_->loaded.settings;
    settings.integrator = integrator;
    const Result<Look> look = look_at(picture, *state_->loaded.renderer, std::move(settings),
                                      film_layout(state_->request, picture, true), stop);
    return look ? Result<double>(look->exposure, look.diagnostics)
                : Result<double>(look.diagnostics);
}

const std::shared_ptr<const scene::Scene>& PreparedScene::scene() const {
    return state_->loaded.scene;
}
const render::Renderer& PreparedScene::renderer() const { return *state_->loaded.renderer; }
const render::Settings& PreparedScene::settings() const { return state_->loaded.settings; }

}  // namespace balcony::app
