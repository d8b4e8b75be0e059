// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "balcony/inspect.hpp"
#include "balcony/progress.hpp"
#include "balcony/studies.hpp"
#include "live/followed_picture.hpp"
#include "live/remarks.hpp"

namespace balcony::live {

using Imath::V2d;
using Imath::V3d;

struct Inspector::State {
    app::PreparedScene scene;
    std::filesystem::path folder;
    FollowedPicture camera;
    std::optional<Shown> shown{};
    std::optional<app::LocateSession> places{};  ///< Of what is shown, when it was asked for.

    [[nodiscard]] std::optional<Sight> sight(const render::Film& film, std::size_t i,
                                             const std::stop_token& stop);
    /// With all of its values, and these parameters open; all that can be without a list.
    [[nodiscard]] Result<lang::OpenPicture> picture_in(
        app::PreparedScene& of, const std::optional<std::vector<std::string>>& open,
        const std::stop_token& stop);
    /// The same with none open, in a scene that may be at another time.
    [[nodiscard]] Result<lang::OpenPicture> closed_picture(app::PreparedScene& of,
                                                           const std::stop_token& stop) {
        return picture_in(of, std::vector<std::string>(), stop);
    }
    /// What is shown of it.
    [[nodiscard]] Result<camera::Picture> seen_picture(const std::stop_token& stop);
    [[nodiscard]] Diagnostics make_places(const std::stop_token& stop);
};

Inspector::Inspector(app::PreparedScene scene, std::filesystem::path folder)
    : state_(std::make_unique<State>(
          State{std::move(scene), folder, FollowedPicture(std::move(folder))})) {}
Inspector::Inspector(Inspector&&) noexcept = default;
Inspector& Inspector::operator=(Inspector&&) noexcept = default;
Inspector::~Inspector() = default;

Diagnostics Inspector::show(const Shown& shown, const std::stop_token& stop) {
    State& state = *state_;
    if (state.shown && state.shown->change == shown.change) {
        return {};
    }
    state.shown.reset();
    state.places.reset();
    Diagnostics found;
    if (!state.camera.follow(state.scene, shown, false, stop, found)) {
        return found;
    }
    state.camera.picture().move(shown.values, found);
    if (!has_errors(found)) {
        state.shown = shown;
    }
    return found;
}

namespace {

Diagnostic nothing_is_shown() {
    return error(Kind::usage, "no camera is shown", "show one, and ask again");
}

std::string name_in(const std::vector<std::string>& names, std::size_t id) {
    return id >= 1 && id <= names.size() ? names[id - 1] : std::string();
}

// Of the material that covers most of a pixel.
std::uint32_t main_material(const render::Film& film, std::size_t i) {
    const auto& entries = film.means.materials[i].entries;
    return std::max_element(
               entries.begin(), entries.end(),
               [](const auto& one, const auto& other) { return one.coverage < other.coverage; })
        ->id;
}

// What a pixel of a film shows, by its index.
std::optional<Sight> sight_of(const render::Film& film, std::size_t i) {
    const render::DataLayers& data = *film.layers;
    if (data.valid[i] == 0) {
        return std::nullopt;
    }
    const bool has_layers = film.picture_layers.size() > 1;
    Sight made{.layer = has_layers ? name_in(film.picture_layers, data.layer[i]) : "",
               .origin = V3d(data.origin[i]),
               .direction = V3d(data.direction[i]),
               .parameters = V2d(data.parameters[i])};
    if (data.object[i] != 0) {
        made.hit = Sight::Hit{.object = name_in(film.objects, data.object[i]),
                              .material = name_in(film.materials, main_material(film, i)),
                              .distance = data.ray_length[i],
                              .point = V3d(data.position[i]),
                              .normal = V3d(data.normal[i]),
                              .magnification = data.magnification[i]};
    }
    return made;
}

}  // namespace

// With the metric of a film of one row of pixels.
std::optional<Sight> Inspector::State::sight(const render::Film& film, std::size_t i,
                                             const std::stop_token& stop) {
    std::optional<Sight> made = sight_of(film, i);
    if (made && made->hit) {
        const V2d middle(static_cast<double>(film.window.x + i) + 0.5,
                         static_cast<double>(film.window.y) + 0.5);
        made->hit->metric = camera.picture().metric(scene, film.layers->layer[i] - 1U, middle,
                                                    made->hit->distance, stop);
    }
    return made;
}

std::string Inspector::camera() const {
    return state_->shown ? state_->camera.picture().opened().picture.name() : std::string();
}

Result<std::optional<Sight>> Inspector::at(const V2d& point, const std::stop_token& stop) {
    if (!state_->shown) {
        return nothing_is_shown();
    }
    LivePicture& picture = state_->camera.picture();
    const auto width = static_cast<double>(picture.size()[0]);
    const auto height = static_cast<double>(picture.size()[1]);
    if (!(point.x >= 0.0 && point.x < width && point.y >= 0.0 && point.y < height)) {
        return error(Kind::usage,
                     fmt::format("the point {}, {} is not in a picture of {} x {} pixels", point.x,
                                 point.y, width, height),
                     "count pixels from the top left corner");
    }
    Diagnostics found;
    const render::Film* const film = picture.data(
        state_->scene, {static_cast<std::size_t>(point.x), static_cast<std::size_t>(point.y), 1, 1},
        stop, found);
    if (film == nullptr) {
        return has_errors(found) ? found : Diagnostics{stopped()};
    }
    return state_->sight(*film, 0, stop);
}

// A row of pixels at a time: as many rays as pixels in these rows, of which the columns are taken.
Result<std::vector<std::optional<Sight>>> Inspector::grid(std::size_t columns, std::size_t rows,
                                                          const std::stop_token& stop) {
    if (!state_->shown) {
        return nothing_is_shown();
    }
    LivePicture& picture = state_->camera.picture();
    const auto [width, height] = picture.size();
    const auto middle = [](std::size_t cell, std::size_t cells, std::size_t pixels) {
        return (2 * cell + 1) * pixels / (2 * cells);
    };
    std::vector<std::optional<Sight>> made;
    made.reserve(columns * rows);
    for (std::size_t row = 0; row < rows; ++row) {
        Diagnostics found;
        const render::Film* const film =
            picture.data(state_->scene, {0, middle(row, rows, height), width, 1}, stop, found);
        if (film == nullptr) {
            return has_errors(found) ? found : Diagnostics{stopped()};
        }
        for (std::size_t column = 0; column < columns; ++column) {
            made.push_back(state_->sight(*film, middle(column, columns, width), stop));
        }
    }
    return made;
}

Result<lang::OpenPicture> Inspector::State::picture_in(
    app::PreparedScene& of, const std::optional<std::vector<std::string>>& open,
    const std::stop_token& stop) {
    return of.picture(source_of(*shown, folder), shown->camera,
                      camera.picture().all_closed(shown->values), stop, open);
}

Result<camera::Picture> Inspector::State::seen_picture(const std::stop_token& stop) {
    Result<lang::OpenPicture> made = closed_picture(scene, stop);
    Diagnostics found = std::move(made.diagnostics);
    return made && apply_stereo(scene, shown->stereo, made->picture, found)
               ? Result<camera::Picture>(std::move(made->picture), std::move(found))
               : Result<camera::Picture>(std::move(found));
}

Diagnostics Inspector::State::make_places(const std::stop_token& stop) {
    const Result<camera::Picture> made = seen_picture(stop);
    if (!made) {
        return made.diagnostics;
    }
    Result<app::LocateSession> session = app::LocateSession::make(*made, scene, shown->size, stop);
    places = std::move(session.value);
    return std::move(session.diagnostics);
}

Result<std::vector<Appearance>> Inspector::places_of(const V3d& point,
                                                     const std::stop_token& stop) {
    if (!state_->shown) {
        return nothing_is_shown();
    }
    if (!state_->places) {
        if (Diagnostics found = state_->make_places(stop); !state_->places) {
            return found;
        }
    }
    const Result<app::Located> located = state_->places->locate({point}, stop);
    if (!located) {
        return located.diagnostics;
    }
    std::vector<Appearance> made;
    for (std::size_t i = 0; i < located->sightings.size(); ++i) {
        const analyse::Sighting& one = located->sightings[i];
        Appearance place{.position = one.position,
                         .layer = located->layers.size() > 1 ? located->layers[one.layer] : "",
                         .origin = one.origin,
                         .distance = one.distance};
        if (const auto& hides = (*located->obstacles)[i]) {
            place.hidden_by = located->objects[hides->object].name;
        }
        made.push_back(std::move(place));
    }
    return {std::move(made), located.diagnostics};
}

Result<std::vector<Remark>> Inspector::check(const std::stop_token& stop) {
    if (!state_->shown) {
        return nothing_is_shown();
    }
    const Result<camera::Picture> picture = state_->seen_picture(stop);
    if (!picture) {
        return picture.diagnostics;
    }
    const auto checks = app::check(*picture, state_->scene, state_->shown->size, stop);
    if (!checks) {
        return checks.diagnostics;
    }
    std::vector<Remark> made;
    for (const app::CameraCheck& one : *checks) {
        add_remarks(one, made);
    }
    std::stable_sort(made.begin(), made.end(), [](const Remark& one, const Remark& other) {
        return one.defect && !other.defect;
    });
    return made;
}

Result<app::CameraExport> Inspector::export_camera(app::CameraExportRequest request,
                                                   const std::stop_token& stop) {
    State& state = *state_;
    if (!state.shown) {
        return nothing_is_shown();
    }
    Result<lang::OpenPicture> made =
        state.picture_in(state.scene, app::parameters_for(*request.target), stop);
    if (!made) {
        return std::move(made.diagnostics);
    }
    for (const lang::Override& one : state.camera.picture().all_closed(state.shown->values)) {
        request.title += fmt::format(" --set {}={}", one.name, one.expression);
    }
    lang::Workspace workspace;
    request.comment =
        app::comment_of(workspace, source_of(*state.shown, state.folder), made->picture.name());
    request.size = state.shown->size;
    return app::export_camera(*made, request);
}

namespace {

template <class Report>
Report failed(Diagnostics found) {
    Report made;
    made.interrupted = kind_of_errors(found) == Kind::interrupted;
    made.diagnostics = std::move(found);
    return made;
}

}  // namespace

app::Report Inspector::render(const app::Request& request, const app::Observer& observer,
                              const std::stop_token& stop) {
    if (!state_->shown) {
        return failed<app::Report>({nothing_is_shown()});
    }
    Result<lang::OpenPicture> made = state_->closed_picture(state_->scene, stop);
    return made ? state_->scene.render(made->picture, with_stereo_of(request, *state_->shown),
                                       observer, stop)
                : failed<app::Report>(std::move(made.diagnostics));
}

app::AnimationReport Inspector::animate(const app::AnimationRequest& animation,
                                        const app::Observer& observer,
                                        const std::stop_token& stop) {
    if (!state_->shown) {
        return failed<app::AnimationReport>({nothing_is_shown()});
    }
    // The film places its camera at the time of its first frame, as the command does.
    app::PreparedScene scene = state_->scene.share();
    Diagnostics found = scene.set_time(animation.time_of(1));
    Result<lang::OpenPicture> made = state_->closed_picture(scene, stop);
    found.insert(found.end(), made.diagnostics.begin(), made.diagnostics.end());
    if (!made) {
        return failed<app::AnimationReport>(std::move(found));
    }
    app::AnimationRequest own = animation;
    own.picture = with_stereo_of(own.picture, *state_->shown);
    return scene.animate(made->picture, own, observer, stop);
}

}  // namespace balcony::live
