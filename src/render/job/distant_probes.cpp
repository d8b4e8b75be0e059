// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/distant_probes.hpp"

#include <algorithm>
#include <limits>
#include <vector>

#include "base/parallel_for.hpp"
#include "images/luminance.hpp"
#include "render/job/coarse_rays.hpp"
#include "render/sampling/even_pairs.hpp"
#include "shading/geometry/frame.hpp"
#include "shading/lights/distant_lights.hpp"

namespace balcony::render {

namespace {

/// A surface on a path from the camera, with the side that the path comes from.
struct Lit {
    Surface surface;
    V3f normal;
    float time = 0.0F;
};

// The surfaces on paths that every surface scatters evenly.
std::vector<Lit> lit_surfaces(const TracedScene& traced, PictureRays& all, const Film& film,
                              double time) {
    constexpr std::size_t on_path = 4;
    constexpr std::size_t panes = 8;
    const SceneTracer tracer(traced);
    std::vector<Lit> found;
    for_each_coarse_ray(traced, all, film, time, [&](const DifferentialRay& first) {
        DifferentialRay ray = first;
        ray.differentials = {};
        std::size_t passed = 0;
        for (std::size_t length = 0; length < on_path;) {
            const embree::Hit hit = tracer.nearest(ray);
            if (!hit.any()) {
                return;
            }
            const Interaction at = tracer.interaction(ray, hit);
            if (!is_black(at.straight(ray.direction)) && passed++ < panes) {
                ray.origin = at.surface.start(ray.direction);
                continue;
            }
            const Imath::V2f numbers = even_pair(found.size());
            found.push_back({at.surface, at.surface.geometric_normal, ray.time});
            ray.direction =
                Frame(at.surface.geometric_normal).to_world(sample_cosine(numbers.x, numbers.y));
            ray.origin = at.surface.start(ray.direction);
            ++length;
        }
    });
    return found;
}

class Prober {
public:
    explicit Prober(const TracedScene& traced) : tracer_(traced) {}

    [[nodiscard]] DistantProbe probe(const Lit& at, std::size_t number,
                                     std::size_t directions) const {
        std::vector<Imath::V2f> random;
        for (std::size_t i = 0; i < directions; ++i) {
            random.push_back(even_pair(number * directions + i));
        }
        return tracer_.lights().distant().probe(
            at.surface.position, random, [&](const V3f& to_light) {
                return to_light.dot(at.normal) > 0.0F
                           ? luminance(tracer_.transmittance(
                                 {at.surface.start(to_light), to_light,
                                  std::numeric_limits<float>::infinity(), at.time}))
                           : 0.0F;
            });
    }

private:
    SceneTracer tracer_;
};

// The part of directions in front of surfaces, about half of all, that see the environment.
double openness(const Prober& prober, const std::vector<Lit>& lit) {
    constexpr std::size_t directions = 4;
    constexpr std::size_t most = 512;
    const std::size_t step = std::max<std::size_t>(1, lit.size() / most);
    std::size_t tried = 0;
    std::size_t open = 0;
    for (std::size_t i = 0; i < lit.size(); i += step) {
        const DistantProbe probe = prober.probe(lit[i], i, directions);
        tried += probe.directions;
        open += probe.open.size();
    }
    return tried > 0 ? 2.0 * static_cast<double>(open) / static_cast<double>(tried) : 0.0;
}

}  // namespace

std::shared_ptr<const DistantVisibility> distant_visibility(const TracedScene& traced,
                                                            PictureRays& rays, const Film& film,
                                                            const Settings& settings,
                                                            const std::stop_token& stop) {
    constexpr double in_the_open = 0.4;
    constexpr std::size_t directions = 96;
    if (traced.lights.distant().empty()) {
        return nullptr;
    }
    const std::vector<Lit> lit = lit_surfaces(traced, rays, film, settings.time);
    const Prober prober(traced);
    if (lit.empty() || openness(prober, lit) > in_the_open) {
        return nullptr;
    }
    std::vector<DistantProbe> probes(lit.size());
    const auto probe = [&](std::size_t i) {
        if (!stop.stop_requested()) {
            probes[i] = prober.probe(lit[i], i, directions);
        }
    };
    parallel_for(lit.size(), probe, settings.threads);
    return stop.stop_requested() ? nullptr
                                 : std::make_shared<const DistantVisibility>(std::move(probes));
}

}  // namespace balcony::render
