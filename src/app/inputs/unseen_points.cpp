// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <fmt/format.h>

#include "balcony/rays.hpp"

namespace balcony::app {

namespace {

using analyse::V3d;

Result<std::size_t> count_seen(const PointSearch& search, Axes axes, const std::stop_token& stop) {
    const auto locator = analyse::Locator::make(search.picture, search.width, search.height,
                                                search.time, axes, {}, stop);
    if (!locator) {
        return locator.diagnostics;
    }
    std::vector<std::size_t> in_part;
    const auto sightings = locator->locate(search.points, in_part, {}, stop);
    if (!sightings) {
        return sightings.diagnostics;
    }
    std::set<std::size_t> seen;
    for (const analyse::Sighting& sighting : *sightings) {
        seen.insert(sighting.point);
    }
    return seen.size();
}

/// The distance from a ray to the nearest point, if all points lie behind the ray.
struct Behind {
    bool all = true;
    double nearest = std::numeric_limits<double>::infinity();
};

void examine(const camera::Camera& camera, const PointSearch& search, const std::stop_token& stop,
             Behind& behind) {
    constexpr std::size_t side = 16;
    const auto rays =
        rays::compile(camera, search.width, search.height, {.axes = search.axes}, stop);
    if (!rays) {
        behind.all = false;
        return;
    }
    // A grid of square steps over the longer side.
    const double step = std::max(search.width, search.height) / static_cast<double>(side);
    const auto steps = [step](double length) {
        return static_cast<std::size_t>(std::max(1.0, length / step));
    };
    rays::Scratch scratch;
    rays::RayBatch batch;
    rays->run(
        {0.5 * step, 0.5 * step, step, steps(search.width), steps(search.height), search.time},
        scratch, batch);
    for (std::size_t i = 0; i < batch.size() && behind.all && !stop.stop_requested(); ++i) {
        for (const V3d& point : search.points) {
            const V3d away = point - batch.origin(i);
            if (batch.valid(i)) {
                behind.all = behind.all && away.dot(batch.direction(i)) < 0.0;
                behind.nearest = std::min(behind.nearest, away.length());
            }
        }
    }
}

}  // namespace

std::string_view axes_text(Axes axes) { return axes == Axes::y_up ? "y up" : "z up"; }

Diagnostics explain_unseen(const PointSearch& search, const std::stop_token& stop) {
    const Axes other = search.axes == Axes::y_up ? Axes::z_up : Axes::y_up;
    if (const std::size_t seen = count_seen(search, other, stop).value.value_or(0); seen > 0) {
        return {warning(
            fmt::format("no point is in the picture if they are read with {}; with {}, {} of {} {}",
                        axes_text(search.axes), axes_text(other), seen, search.points.size(),
                        seen == 1 ? "is" : "are"),
            {}, fmt::format("add --axes {}", other == Axes::y_up ? "y_up" : "z_up"))};
    }
    Behind behind;
    for (const camera::ShownCamera& shown : shown_cameras(search.picture)) {
        examine(shown.camera, search, stop, behind);
    }
    if (stop.stop_requested()) {
        return {stopped()};
    }
    if (!behind.all || !std::isfinite(behind.nearest)) {
        return {};
    }
    return {warning(
        fmt::format("all points lie behind the camera, the nearest at a distance of {:.4g}",
                    behind.nearest),
        {},
        "check the unit and the axes of the points; balcony draw shows where the camera looks")};
}

}  // namespace balcony::app
