// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_tracer.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

bool is_finite(const Color4f& c) {
    return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && std::isfinite(c.a);
}

}  // namespace

TileTracer::TileTracer(const TracedScene& traced, const Settings& settings, IntegratorMaker make)
    : traced_(&traced),
      // Many samples share the filtering; pbrt limits the reduction in the same way.
      footprint_scale_(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(settings.samples)))),
      integrator_(make(traced, settings)) {}

Seen TileTracer::seen(const TileRays& rays, std::size_t i, const embree::Hit& first,
                      const Sampler& sampler) {
    const Ray ray{rays.rays[i].origin, rays.rays[i].direction,
                  rays.all.has_footprints() ? differentials(rays.all, i, footprint_scale_)
                                            : RayDifferentials{}};
    Seen seen = integrator_->trace(ray, first, sampler);
    if (!is_finite(seen.radiance)) {
        ++repaired_;
        seen.radiance = Color4f(0.0F);
    }
    return seen;
}

}  // namespace balcony::render
