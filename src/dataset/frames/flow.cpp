// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/frames/flow.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "balcony/probe.hpp"
#include "balcony/progress.hpp"
#include "base/parallel_for.hpp"

namespace balcony::dataset {

namespace {

using Imath::V2f;

/// The points that the rays of a film meet.
struct Hits {
    std::vector<std::size_t> pixels;
    std::vector<V3d> places;  ///< In axes with z up.
};

Hits hits_of(const render::Film& film, Axes axes) {
    const render::DataLayers& layers = *film.layers;
    Hits hits;
    for (std::size_t i = 0; i < layers.position.size(); ++i) {
        if (layers.valid[i] == 1 && std::isfinite(layers.ray_length[i])) {
            hits.pixels.push_back(i);
            hits.places.push_back(turned(V3d(layers.position[i]), axes, Axes::z_up));
        }
    }
    return hits;
}

// The straight parts of the ray of a sighting, up to its point.
void add_lines(const analyse::Sighting& sighting, const camera::Pose& pose, const V3d& place,
               const camera::ObjectFilter* objects, std::vector<render::SightLine>& lines) {
    V3d from = app::place_of(pose, sighting.origin);
    for (const V3d& turn : sighting.turns) {
        const V3d to = app::place_of(pose, turn);
        lines.push_back({from, to, objects});
        from = to;
    }
    lines.push_back({from, place, objects});
}

// Whether something is in the way of each line.
Result<std::vector<char>> hidden(const std::vector<render::SightLine>& lines,
                                 const render::Renderer& renderer, const std::stop_token& stop) {
    constexpr std::size_t at_once = 4096;
    std::vector<char> found(lines.size(), 0);
    std::vector<Diagnostics> problems((lines.size() + at_once - 1) / at_once);
    parallel_for(problems.size(), [&](std::size_t part) {
        const std::size_t begin = part * at_once;
        const auto some = std::span(lines).subspan(begin, std::min(at_once, lines.size() - begin));
        const auto obstacles = render::find_obstacles(renderer, some, Axes::z_up, stop);
        if (!obstacles) {
            problems[part] = obstacles.diagnostics;
            return;
        }
        for (std::size_t i = 0; i < some.size(); ++i) {
            found[begin + i] = (*obstacles)[i].has_value() ? 1 : 0;
        }
    });
    for (const Diagnostics& one : problems) {
        if (has_errors(one)) {
            return one;
        }
    }
    return found;
}

// What the rays of each camera layer meet.
std::vector<camera::ObjectFilter> filters_of(const camera::Picture& picture) {
    std::vector<camera::ObjectFilter> filters;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        for (const auto& use : shown.uses) {
            filters.resize(std::max(filters.size(), use.index + 1));
            filters[use.index] = use.objects;
        }
    }
    return filters;
}

}  // namespace

Result<std::vector<V2f>> FlowFinder::flow(const Plan& plan, const Frame& frame,
                                          const render::Film& film,
                                          const render::Renderer& renderer,
                                          const std::stop_token& stop) {
    std::vector<V2f> made(film.width * film.height, V2f(std::numeric_limits<float>::quiet_NaN()));
    const PlannedScene& scene = plan.scenes[frame.scene];
    const auto& next = plan.pose_of(frame).next;
    if (!next) {
        return made;
    }
    const PlannedCamera& camera = plan.camera_of(frame);
    auto locator = locators_.find(frame.camera);
    if (locator == locators_.end()) {
        auto found =
            analyse::Locator::make(camera.picture, static_cast<double>(camera.size[0]),
                                   static_cast<double>(camera.size[1]),
                                   plan.recipe.picture.settings.time, Axes::z_up, {}, stop);
        if (!found) {
            return found.diagnostics;
        }
        locator = locators_.emplace(frame.camera, *found).first;
    }
    const camera::Pose& pose = scene.poses[*next].pose;
    const Hits hits = hits_of(film, scene.axes);
    std::vector<V3d> points;
    for (const V3d& place : hits.places) {
        points.push_back(app::point_at(pose, place));
    }
    std::vector<std::size_t> in_part;
    auto sightings = locator->second.locate(points, in_part, {}, stop);
    if (!sightings) {
        return sightings.diagnostics;
    }
    // Of each point, what is in front comes first.
    std::stable_sort(sightings->begin(), sightings->end(), [](const auto& a, const auto& b) {
        return a.point != b.point   ? a.point < b.point
               : a.layer != b.layer ? a.layer > b.layer
                                    : a.distance < b.distance;
    });
    const std::vector<camera::ObjectFilter> filters = filters_of(camera.picture);
    std::vector<render::SightLine> lines;
    std::vector<std::size_t> ends;
    for (const analyse::Sighting& sighting : *sightings) {
        const bool has_filter = sighting.layer < filters.size() && !filters[sighting.layer].empty();
        add_lines(sighting, pose, hits.places[sighting.point],
                  has_filter ? &filters[sighting.layer] : nullptr, lines);
        ends.push_back(lines.size());
    }
    const auto is_hidden = hidden(lines, renderer, stop);
    if (!is_hidden) {
        return is_hidden.diagnostics;
    }
    for (std::size_t i = sightings->size(); i-- > 0;) {
        const std::size_t begin = i > 0 ? ends[i - 1] : 0;
        const bool is_seen = std::none_of(is_hidden->begin() + static_cast<std::ptrdiff_t>(begin),
                                          is_hidden->begin() + static_cast<std::ptrdiff_t>(ends[i]),
                                          [](char one) { return one != 0; });
        if (is_seen) {
            const std::size_t pixel = hits.pixels[(*sightings)[i].point];
            const Imath::V2d middle(static_cast<double>(pixel % film.width) + 0.5,
                                    static_cast<double>(pixel / film.width) + 0.5);
            made[pixel] = V2f((*sightings)[i].position - middle);
        }
    }
    return made;
}

}  // namespace balcony::dataset
