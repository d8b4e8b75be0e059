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

// The differentials of the rays of a tile.
class TileDifferentials final : public DifferentialSource {
public:
    TileDifferentials(const rays::RayBatch& rays, double scale) : rays_(rays), scale_(scale) {}

    [[nodiscard]] RayDifferentials differentials(std::size_t ray) const override {
        return rays_.has_footprints() ? render::differentials(rays_, ray, scale_)
                                      : RayDifferentials{};
    }

private:
    const rays::RayBatch& rays_;
    double scale_;
};

}  // namespace

TileTracer::TileTracer(const TracedScene& traced, const Settings& settings, IntegratorMaker make)
    : traced_(&traced),
      // Many samples share the filtering; pbrt limits the reduction in the same way.
      footprint_scale_(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(settings.samples)))),
      integrator_(make(traced, settings)),
      light_tracer_(integrator_->light_tracer()) {}

Ray TileTracer::camera_ray(const TileRays& rays, std::size_t i) const {
    const embree::Ray& ray = rays.rays[i];
    return {ray.origin, ray.direction,
            TileDifferentials(rays.all, footprint_scale_).differentials(i), ray.time};
}

void TileTracer::trace(const TilePoints& points, const TileRays& rays, const Mask& wanted) {
    const Region& region = points.region;
    hits_.resize(points.size());
    traced_->accelerator.intersect_grid(region.width, rays.rays, wanted, hits_);
    indices_.clear();
    requested_.clear();
    constexpr std::size_t side = embree::Accelerator::packet_side;
    std::uint32_t packet = 0;
    for (std::size_t top = 0; top < region.height; top += side) {
        for (std::size_t left = 0; left < region.width; left += side, ++packet) {
            for (std::size_t y = top; y < std::min(top + side, region.height); ++y) {
                for (std::size_t x = left; x < std::min(left + side, region.width); ++x) {
                    const std::size_t i = y * region.width + x;
                    if (wanted[i] != 0) {
                        Sampler sampler(region.x + x, region.y + y, points.numbers);
                        if (rays.through_lens) {
                            (void)sampler.next_pair();
                        }
                        indices_.push_back(i);
                        requested_.push_back({camera_ray(rays, i), hits_[i], sampler, packet});
                    }
                }
            }
        }
    }
    seen_.resize(requested_.size());
    integrator_->trace(requested_, seen_);
    for (Seen& seen : seen_) {
        if (!is_finite(seen.radiance)) {
            ++repaired_;
            seen.radiance = Color4f(0.0F);
            seen.parts = {};
        }
    }
}

void TileTracer::trace_light(std::size_t width, const TileRays& rays, std::span<Color4f> radiance) {
    hits_.resize(rays.rays.size());
    traced_->accelerator.intersect_grid(width, rays.rays, rays.valid, hits_);
    light_tracer_->trace_light(
        {rays.rays, rays.valid, hits_, TileDifferentials(rays.all, footprint_scale_)}, radiance);
    for (Color4f& color : radiance) {
        if (!is_finite(color)) {
            ++repaired_;
            color = Color4f(0.0F);
        }
    }
}

}  // namespace balcony::render
