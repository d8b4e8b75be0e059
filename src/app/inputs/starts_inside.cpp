// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/inputs.hpp"

namespace balcony::app {

std::vector<StartInside> starts_inside(const render::Probe& probe, const scene::Scene& scene) {
    std::vector<StartInside> starts;
    for (std::size_t i = 0; i < probe.objects.size(); ++i) {
        const render::ObjectSight& sight = probe.objects[i];
        if (sight.rays_from_inside > 0) {
            starts.push_back({.object = scene.objects[i].name,
                              .share = static_cast<double>(sight.rays_from_inside) /
                                       static_cast<double>(probe.rays),
                              .point = sight.inside_at,
                              .is_around_all = sight.rays_from_inside == probe.rays});
        }
    }
    return starts;
}

}  // namespace balcony::app
