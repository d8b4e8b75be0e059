// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <memory>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"
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

// Determines whether the sightings are hidden in a scene.
Diagnostics look_for_obstacles(const std::shared_ptr<const scene::Scene>& scene, Located& located,
                               const std::stop_token& stop) {
    const auto renderer = render::Renderer::make(scene, {.textures_on_demand = true}, {}, stop);
    if (!renderer) {
        return renderer.diagnostics;
    }
    std::vector<render::SightLine> lines;
    lines.reserve(located.sightings.size());
    for (const analyse::Sighting& sighting : located.sightings) {
        lines.push_back({sighting.origin, located.points[sighting.point]});
    }
    auto found = render::find_obstacles(*renderer, lines, located.axes, stop);
    located.obstacles = std::move(found.value);
    located.objects = scene->objects;
    found.diagnostics.insert(found.diagnostics.begin(), renderer.diagnostics.begin(),
                             renderer.diagnostics.end());
    return found.diagnostics;
}

}  // namespace

Result<Located> locate(const LocateRequest& request, const std::stop_token& stop) {
    Diagnostics diagnostics;
    std::shared_ptr<const scene::Scene> scene;
    if (!request.scene.empty()) {
        Result<scene::Scene> loaded = load_scene(request.scene, request.time, {}, {}, stop);
        add(diagnostics, loaded.diagnostics);
        if (loaded) {
            scene = std::make_shared<const scene::Scene>(std::move(*loaded));
        }
    }
    Result<camera::Picture> picture = scene ? load_picture(request.camera, request.set, *scene)
                                            : load_picture(request.camera, request.set);
    add(diagnostics, picture.diagnostics);
    if (has_errors(diagnostics)) {
        return diagnostics;
    }
    Located found;
    std::optional<Axes> axes = request.axes;
    if (axes) {
        found.axes_from = AxesSource::request;
    } else if (scene) {
        found.axes_from = AxesSource::scene;
        axes = scene->axes;
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
                                counted(in_part.size(), "point", "points"))));
    }
    if (found.sightings.empty() && !found.points.empty()) {
        add(diagnostics,
            explain_unseen({*picture, width, height, request.time, found.axes, found.points}));
    }
    if (scene) {
        add(diagnostics, look_for_obstacles(scene, found, stop));
        if (!found.obstacles) {
            return diagnostics;
        }
    }
    return {std::move(found), std::move(diagnostics)};
}

}  // namespace balcony::app
