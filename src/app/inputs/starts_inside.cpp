// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

#include <algorithm>

namespace balcony::app {

std::vector<StartInside> starts_inside(const render::Probe& probe, const scene::Scene& scene) {
    const auto seen = std::count_if(probe.objects.begin(), probe.objects.end(),
                                    [](const render::ObjectSight& sight) { return sight.seen; });
    std::vector<StartInside> starts;
    for (std::size_t i = 0; i < probe.objects.size(); ++i) {
        const render::ObjectSight& sight = probe.objects[i];
        if (sight.rays_from_inside > 0) {
            const bool is_around_all = sight.rays_from_inside == probe.rays;
            starts.push_back({.object = scene.objects[i].name,
                              .index = static_cast<std::uint32_t>(i),
                              .share = static_cast<double>(sight.rays_from_inside) /
                                       static_cast<double>(probe.rays),
                              .point = sight.inside_at,
                              .is_around_all = is_around_all,
                              .is_room = is_around_all && seen > 1});
        }
    }
    return starts;
}

}  // namespace balcony::app
