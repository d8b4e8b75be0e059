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
#include "balcony/render.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

std::vector<std::string> numbers_of_layers(const camera::Picture& picture, std::size_t count) {
    std::vector<std::string> numbers(count);
    for (const camera::ShownCamera& shown : shown_cameras(picture)) {
        for (const camera::ShownCamera::LayerUse& use : shown.uses) {
            numbers[use.index] = use.layer;
        }
    }
    return numbers;
}

// Determines whether the sightings are hidden in the scene of a renderer.
Diagnostics look_for_obstacles(const render::Renderer& renderer, Located& located,
                               const std::stop_token& stop) {
    std::vector<render::SightLine> lines;
    lines.reserve(located.sightings.size());
    for (const analyse::Sighting& sighting : located.sightings) {
        lines.push_back({sighting.origin, located.points[sighting.point]});
    }
    auto found = render::find_obstacles(renderer, lines, located.axes, stop);
    located.obstacles = std::move(found.value);
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

Result<camera::Picture> picture_in(const Prepared& prepared, const LocateRequest& request,
                                   const std::stop_token& stop) {
    if (is_of_scene(request.camera) || !request.placement.places(request.camera)) {
        return load_picture(request.camera, request.set, *prepared.scene);
    }
    lang::Workspace cameras;
    const auto make = [&] { return load_picture(request.camera, request.set, cameras); };
    const Diagnostics found = fit_cameras(
        cameras, request.placement, *prepared.scene, prepared.renderer,
        [&] { return cameras_of(make()); }, stop);
    return has_errors(found) ? Result<camera::Picture>(found) : make();
}

}  // namespace

Result<Located> locate(const LocateRequest& request, const std::stop_token& stop) {
    Diagnostics diagnostics = check_size(request.size);
    add(diagnostics, check_placement(request.placement, !request.scene.empty()));
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    Located found;
    const std::optional<Prepared> prepared = prepare(request, stop, diagnostics);
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    Result<camera::Picture> picture =
        prepared ? picture_in(*prepared, request, stop) : load_picture(request.camera, request.set);
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
    found.camera = picture->name();
    *picture = picture->with_fit(request.size.fit);
    std::tie(found.width, found.height) =
        request.size.resolve(picture->aspect(), picture->parts().size);
    const auto width = static_cast<double>(found.width);
    const auto height = static_cast<double>(found.height);
    const auto locator =
        analyse::Locator::make(*picture, width, height, request.time, axes, {}, stop);
    add(diagnostics, locator.diagnostics);
    if (!locator) {
        return diagnostics;
    }
    found.layers = locator->layers();
    found.numbers = numbers_of_layers(*picture, found.layers.size());
    found.closed_form = locator->closed_form();
    found.axes = locator->axes();
    found.points = request.points;
    std::vector<std::size_t> in_part;
    auto sightings = locator->locate(found.points, in_part, {}, stop);
    add(diagnostics, sightings.diagnostics);
    if (!sightings) {
        return diagnostics;
    }
    found.sightings = std::move(*sightings);
    if (!in_part.empty()) {
        diagnostics.push_back(
            warning(fmt::format("so many parts of the picture may see {} that not all "
                                "of these parts were searched",
                                counted(in_part.size(), "point"))));
    }
    if (found.sightings.empty() && !found.points.empty()) {
        add(diagnostics,
            explain_unseen({*picture, width, height, request.time, found.axes, found.points},
                           stop));
    }
    if (prepared) {
        found.objects = prepared->scene->objects;
        add(diagnostics, look_for_obstacles(prepared->renderer, found, stop));
        if (!found.obstacles) {
            return diagnostics;
        }
    }
    return {std::move(found), std::move(diagnostics)};
}

}  // namespace balcony::app
