// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_tracer.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "render/sampling/pixel_groups.hpp"

namespace balcony::render {

namespace {

// A number minus itself is 0, or NaN if it is not finite.
bool is_finite(const Color4f& c) {
    return (c.r - c.r) + (c.g - c.g) + (c.b - c.b) + (c.a - c.a) == 0.0F;
}

// The same for a packet: the loop is vectorised.
bool all_finite(const LightTracer::Lanes& colors) {
    constexpr std::uint32_t exponent = 0x7f800000U;
    std::uint32_t not_finite = 0;
    for (const Color4f& color : colors) {
        for (const float value : {color.r, color.g, color.b, color.a}) {
            not_finite |= (std::bit_cast<std::uint32_t>(value) & exponent) == exponent ? 1U : 0U;
        }
    }
    return not_finite == 0;
}

RayDifferentials differentials_of(const rays::RayBatch& rays, std::size_t i, double scale) {
    return rays.has_footprints() ? differentials(rays, i, scale) : RayDifferentials{};
}

// Those of a packet, whose rays are a square of a tile.
class SquareDifferentials final : public DifferentialSource {
public:
    SquareDifferentials(const rays::RayBatch& rays, double scale, const Square& square,
                        packet_lanes::Differentials& differentials)
        : rays_(rays), scale_(scale), square_(square), differentials_(differentials) {}

    [[nodiscard]] const packet_lanes::Differentials& differentials() override {
        if (!set_) {
            set_differentials(rays_, square_, scale_, differentials_);
            set_ = true;
        }
        return differentials_;
    }

private:
    const rays::RayBatch& rays_;
    double scale_;
    Square square_;
    packet_lanes::Differentials& differentials_;
    bool set_ = false;
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
    return {ray.origin, ray.direction, differentials_of(rays.all, i, footprint_scale_), ray.time};
}

void TileTracer::trace(const TilePoints& points, const TileRays& rays, const Mask& wanted) {
    const Region& region = points.region;
    hits_.resize(points.size());
    traced_->accelerator.intersect_grid(region.width, rays.rays, wanted, hits_);
    indices_.clear();
    requested_.clear();
    constexpr std::size_t side = embree::Accelerator::packet_side;
    std::uint32_t packet = 0;
    const PixelGroups groups(region, points.pass);
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
                        requested_.push_back({camera_ray(rays, i), hits_[i], sampler, packet,
                                              groups.of(region.x + x, region.y + y)});
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

void TileTracer::repair(LightTracer::Lanes& colors) {
    for (Color4f& color : colors) {
        if (!is_finite(color)) {
            ++repaired_;
            color = Color4f(0.0F);
        }
    }
}

void TileTracer::trace_light(const Region& region, TileRays& rays, std::span<Color4f> radiance) {
    constexpr std::size_t side = embree::Packet::side;
    rays.valid.resize(region.size());
    for (std::size_t top = 0; top < region.height; top += side) {
        for (std::size_t left = 0; left < region.width; left += side) {
            const Square square{region.width, left, top};
            set_packet(rays.all, square, traced_->interval, rays.time, packet_);
            const auto asked = packet_.valid;
            traced_->accelerator.intersect(packet_);
            SquareDifferentials differentials(rays.all, footprint_scale_, square, differentials_);
            light_tracer_->trace_light(packet_, differentials, lanes_);
            if (!all_finite(lanes_)) {
                repair(lanes_);
            }
            const std::size_t columns = std::min(region.width - left, side);
            for (std::size_t row = 0; row < std::min(region.height - top, side); ++row) {
                const std::size_t i = (top + row) * region.width + left;
                for (std::size_t column = 0; column < columns; ++column) {
                    const std::size_t lane = row * side + column;
                    rays.valid[i + column] = asked[lane] != 0 ? 1 : 0;
                    radiance[i + column] = lanes_[lane];
                }
            }
        }
    }
}

}  // namespace balcony::render
