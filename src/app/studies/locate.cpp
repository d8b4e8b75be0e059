// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/inputs/placement.hpp"
#include "app/request_check.hpp"
#include "app/words.hpp"
#include "balcony/names.hpp"
#include "balcony/prepared_scene.hpp"
#include "balcony/render.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

// What is to be known about the camera layers of a picture, by index.
struct LayersOfPicture {
    std::vector<std::string> numbers;
    std::vector<camera::ObjectFilter> objects;
};

LayersOfPicture layers_of(const camera::Picture& picture, std::size_t count) {
    LayersOfPicture made{std::vector<std::string>(count), std::vector<camera::ObjectFilter>(count)};
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            made.numbers[use.index] = use.layer;
            made.objects[use.index] = use.objects;
        }
    }
    return made;
}

// Determines whether the sightings are hidden in the scene of a renderer.
Diagnostics look_for_obstacles(const render::Renderer& renderer,
                               const std::vector<camera::ObjectFilter>& objects, Located& located,
                               const std::stop_token& stop) {
    // One line, or several for a bent ray.
    std::vector<render::SightLine> lines;
    lines.reserve(located.sightings.size());
    for (const analyse::Sighting& sighting : located.sightings) {
        const camera::ObjectFilter* const shown =
            objects[sighting.layer].empty() ? nullptr : &objects[sighting.layer];
        analyse::V3d from = sighting.origin;
        for (const analyse::V3d& turn : sighting.turns) {
            lines.push_back({from, turn, shown});
            from = turn;
        }
        lines.push_back({from, located.points[sighting.point], shown});
    }
    auto found = render::find_obstacles(renderer, lines, located.axes, stop);
    if (!found) {
        return found.diagnostics;
    }
    located.obstacles.emplace();
    std::size_t next = 0;
    for (const analyse::Sighting& sighting : located.sightings) {
        std::optional<render::Obstacle> first;
        double before = 0.0;
        for (std::size_t part = 0; part <= sighting.turns.size(); ++part, ++next) {
            if ((*found)[next] && !first) {
                first = (*found)[next];
                first->distance += before;
            }
            before += (lines[next].to - lines[next].from).length();
        }
        located.obstacles->push_back(first);
    }
    return found.diagnostics;
}

struct Prepared {
    std::shared_ptr<const scene::Scene> scene;
    render::Renderer renderer;
};

// The scene of a request; none if it names none or that fails.
std::optional<Prepared> prepare(const LocateRequest& request, const std::stop_token& stop,
                                Diagnostics& found) {
    if (request.scene.empty()) {
        return std::nullopt;
    }
    Result<scene::Scene> loaded = load_scene(request.scene, request.time, {}, {}, stop);
    add(found, loaded.diagnostics);
    if (!loaded) {
        return std::nullopt;
    }
    const auto scene = std::make_shared<const scene::Scene>(std::move(*loaded));
    auto renderer = render::Renderer::make(scene, {.textures_on_demand = true}, {}, stop);
    add(found, renderer.diagnostics);
    return renderer ? std::optional(Prepared{scene, std::move(*renderer)}) : std::nullopt;
}

Result<analyse::Locator> locator_of(const camera::Picture& picture, const Located& size,
                                    const std::optional<Axes>& axes, double time,
                                    const std::stop_token& stop) {
    return analyse::Locator::make(picture, static_cast<double>(size.width),
                                  static_cast<double>(size.height), time, axes, {}, stop);
}

Result<camera::Picture> picture_in(const Prepared& prepared, const LocateRequest& request,
                                   lang::Workspace& cameras, const std::stop_token& stop) {
    if (is_of_scene(request.camera) || !request.placement.places(request.camera)) {
        return load_picture(request.camera, request.set, *prepared.scene);
    }
    const auto make = [&] { return load_picture(request.camera, request.set, cameras); };
    const Diagnostics found = fit_cameras(
        cameras, request.placement, *prepared.scene, prepared.renderer,
        [&] { return cameras_of(make()); }, stop);
    return has_errors(found) ? Result<camera::Picture>(found) : make();
}

}  // namespace

struct LocateSession::State {
    std::optional<Prepared> prepared;
    camera::Picture picture;
    std::vector<std::filesystem::path> files;
    double time;
    Located found;  ///< Without points.
    analyse::Locator locator;
    std::vector<camera::ObjectFilter> objects;  ///< By camera layer.

    std::vector<analyse::V3d> only_points{};  ///< Those of the first batch, if it is the only one.
    std::size_t batches = 0;
    std::size_t searched_in_part = 0;
    bool any_seen = false;

    /// `found` has the size, and what decided on the axes.
    [[nodiscard]] static Result<std::unique_ptr<State>> make(camera::Picture picture,
                                                             std::optional<Prepared> prepared,
                                                             Located found,
                                                             Result<analyse::Locator> locator,
                                                             double time);
};

Diagnostic searched_in_part(std::size_t points) {
    return warning(fmt::format(
        "so many parts of the picture may see {} that not all of these parts were searched",
        counted(points, "point")));
}

LocateSession::LocateSession(std::unique_ptr<State> state) : state_(std::move(state)) {}
LocateSession::LocateSession(LocateSession&&) noexcept = default;
LocateSession& LocateSession::operator=(LocateSession&&) noexcept = default;
LocateSession::~LocateSession() = default;

Result<LocateSession> LocateSession::make(const LocateRequest& request,
                                          const std::stop_token& stop) {
    Diagnostics diagnostics = check_size(request.size);
    add(diagnostics, check_placement(request.placement, !request.scene.empty()));
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    Located found;
    std::optional<Prepared> prepared = prepare(request, stop, diagnostics);
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    lang::Workspace workspace;
    Result<camera::Picture> picture = prepared
                                          ? picture_in(*prepared, request, workspace, stop)
                                          : load_picture(request.camera, request.set, workspace);
    add(diagnostics, picture.diagnostics);
    if (!picture) {
        return diagnostics;
    }
    std::optional<Axes> axes = request.axes;
    if (axes) {
        found.axes_from = AxesSource::request;
    } else if (prepared) {
        found.axes_from = AxesSource::scene;
        axes = prepared->scene->axes;
    }
    *picture = picture->with_fit(request.size.fit);
    std::tie(found.width, found.height) =
        request.size.resolve(picture->aspect(), picture->parts().size);
    std::vector<std::filesystem::path> files = workspace.files();
    files.emplace_back(request.scene);
    auto locator = locator_of(*picture, found, axes, request.time, stop);
    auto state = State::make(std::move(*picture), std::move(prepared), std::move(found),
                             std::move(locator), request.time);
    add(diagnostics, state.diagnostics);
    if (!state) {
        return diagnostics;
    }
    (*state)->files = std::move(files);
    return {LocateSession(std::move(*state)), std::move(diagnostics)};
}

Result<LocateSession> LocateSession::make(const camera::Picture& picture,
                                          const PreparedScene& scene,
                                          const std::array<std::size_t, 2>& size,
                                          const std::stop_token& stop,
                                          const std::optional<analyse::Locator>& inverse) {
    Located found;
    found.axes_from = AxesSource::scene;
    found.width = size[0];
    found.height = size[1];
    const Axes axes = scene.scene()->axes;
    const double time = scene.settings().time;
    auto locator =
        inverse ? Result<analyse::Locator>(*inverse) : locator_of(picture, found, axes, time, stop);
    auto state = State::make(picture, Prepared{scene.scene(), scene.renderer()}, std::move(found),
                             std::move(locator), time);
    return state ? Result<LocateSession>({LocateSession(std::move(*state)), state.diagnostics})
                 : Result<LocateSession>(state.diagnostics);
}

Result<std::unique_ptr<LocateSession::State>> LocateSession::State::make(
    camera::Picture picture, std::optional<Prepared> prepared, Located found,
    Result<analyse::Locator> locator, double time) {
    found.camera = picture.name();
    Diagnostics diagnostics = locator.diagnostics;
    if (!locator) {
        return diagnostics;
    }
    found.layers = locator->layers();
    LayersOfPicture layers = layers_of(picture, found.layers.size());
    found.numbers = std::move(layers.numbers);
    if (prepared) {
        add(diagnostics, render::check_objects(picture, *prepared->scene));
        if (has_errors(diagnostics)) {
            return diagnostics;
        }
        found.objects = prepared->scene->objects;
    }
    found.closed_form = locator->closed_form();
    found.axes = locator->axes();
    return {std::make_unique<State>(State{std::move(prepared),
                                          std::move(picture),
                                          {},
                                          time,
                                          std::move(found),
                                          std::move(*locator),
                                          std::move(layers.objects)}),
            std::move(diagnostics)};
}

Result<Located> LocateSession::locate(std::vector<analyse::V3d> points,
                                      const std::stop_token& stop) {
    State& state = *state_;
    Located found = state.found;
    found.points = std::move(points);
    std::vector<std::size_t> in_part;
    auto sightings = state.locator.locate(found.points, in_part, {}, stop);
    if (!sightings) {
        return sightings.diagnostics;
    }
    found.sightings = std::move(*sightings);
    Diagnostics diagnostics = std::move(sightings.diagnostics);
    if (state.prepared) {
        add(diagnostics, look_for_obstacles(state.prepared->renderer, state.objects, found, stop));
        if (!found.obstacles) {
            return diagnostics;
        }
    }
    state.searched_in_part += in_part.size();
    state.any_seen = state.any_seen || !found.sightings.empty();
    state.only_points = ++state.batches == 1 ? found.points : std::vector<analyse::V3d>();
    return {std::move(found), std::move(diagnostics)};
}

const std::vector<std::filesystem::path>& LocateSession::files() const { return state_->files; }

Diagnostics LocateSession::finish(const std::stop_token& stop) const {
    const State& state = *state_;
    Diagnostics diagnostics;
    if (state.searched_in_part > 0) {
        diagnostics.push_back(searched_in_part(state.searched_in_part));
    }
    if (!state.any_seen && !state.only_points.empty()) {
        add(diagnostics, explain_unseen({state.picture, static_cast<double>(state.found.width),
                                         static_cast<double>(state.found.height), state.time,
                                         state.found.axes, state.only_points},
                                        stop));
    }
    return diagnostics;
}

Result<Located> locate(const LocateRequest& request, const std::stop_token& stop) {
    Result<LocateSession> search = LocateSession::make(request, stop);
    Diagnostics diagnostics = search.diagnostics;
    if (!search) {
        return diagnostics;
    }
    Result<Located> found = search->locate(request.points, stop);
    add(diagnostics, found.diagnostics);
    if (!found) {
        return diagnostics;
    }
    add(diagnostics, search->finish(stop));
    return {std::move(*found), std::move(diagnostics)};
}

}  // namespace balcony::app
