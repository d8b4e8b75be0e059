// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "render/sampling/pixel_groups.hpp"

namespace balcony::render {

namespace {

// A number minus itself is 0, or NaN if it is not finite.
bool is_finite(const Color4f& c) {
    return (c.r - c.r) + (c.g - c.g) + (c.b - c.b) + (c.a - c.a) == 0.0F;
}

RayDifferentials differentials_of(const rays::RayBatch& rays, std::size_t i, double scale) {
    return rays.has_footprints() ? differentials(rays, i, scale) : RayDifferentials{};
}

// Those of packets side by side, of which the first has a square of a tile.
class SquareDifferentials final : public DifferentialSource {
public:
    SquareDifferentials(const rays::RayBatch& rays, double scale, const Square& first,
                        packet_lanes::Differentials& differentials)
        : rays_(rays), scale_(scale), first_(first), differentials_(differentials) {}

    [[nodiscard]] const packet_lanes::Differentials& of_packet(std::size_t packet) override {
        if (packet_ != packet) {
            const std::size_t left = first_.left + packet * embree::Packet::side;
            set_differentials(rays_, {first_.width, left, first_.top}, scale_, differentials_);
            packet_ = packet;
        }
        return differentials_;
    }

private:
    const rays::RayBatch& rays_;
    double scale_;
    Square first_;
    packet_lanes::Differentials& differentials_;
    std::optional<std::size_t> packet_;  // Whose differentials they are.
};

// The part of two regions that they share.
Region both(const Region& a, const Region& b) {
    const std::size_t x = std::max(a.x, b.x);
    const std::size_t y = std::max(a.y, b.y);
    const std::size_t right = std::min(a.x + a.width, b.x + b.width);
    const std::size_t bottom = std::min(a.y + a.height, b.y + b.height);
    return {x, y, std::max(right, x) - x, std::max(bottom, y) - y};
}

// The lanes of a square at a place whose points are in a region.
LaneBits lanes_within(const Region& region, std::size_t x, std::size_t y) {
    constexpr std::size_t side = embree::Packet::side;
    LaneBits bits = 0;
    for (std::size_t lane = 0; lane < embree::Packet::size; ++lane) {
        bits |= region.contains(x + lane % side, y + lane / side) ? 1U << lane : 0U;
    }
    return bits;
}

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
            seen.coverage = {};
        }
    }
}

RayCounts TileTracer::trace_light(const Region& region, const Region& counted, const TileRays& rays,
                                  std::span<Color4f> radiance) {
    constexpr std::size_t side = embree::Packet::side;
    const Region within = both(region, counted);
    RayCounts counts{.camera_rays = within.size()};
    for (std::size_t top = 0; top < region.height; top += side) {
        for (std::size_t left = 0; left < region.width; left += packets_at_once * side) {
            const std::size_t number =
                std::min((region.width - left + side - 1) / side, packets_at_once);
            const auto packets = std::span(packets_).first(number);
            const Square first{region.width, left, top};
            set_packets(rays.all, first, traced_->interval, rays.time, packets);
            traced_->accelerator.intersect(packets);
            SquareDifferentials differentials(rays.all, footprint_scale_, first, differentials_);
            light_tracer_->trace_light(packets, differentials, std::span(radiances_).first(number));
            for (std::size_t k = 0; k < number; ++k) {
                const auto found = write_square(region, within, left + k * side, top, k, radiance);
                counts.invalid_rays += found.missing;
                counts.hits += found.shown;
            }
        }
    }
    return counts;
}

surface_lanes::LaneCounts TileTracer::write_square(const Region& region, const Region& counted,
                                                   std::size_t left, std::size_t top,
                                                   std::size_t packet,
                                                   std::span<Color4f> radiance) {
    constexpr std::size_t side = embree::Packet::side;
    const std::size_t x = region.x + left;
    const std::size_t y = region.y + top;
    const bool is_whole = counted.contains(x, y) && counted.contains(x + side - 1, y + side - 1);
    const auto lanes = is_whole ? all_lanes : lanes_within(counted, x, y);
    const auto write = [&](std::size_t stride, Color4f* to) {
        return surface_lanes::write(packets_[packet], radiances_[packet], lanes, stride, to,
                                    repaired_);
    };
    Color4f* const to = &radiance[top * region.width + left];
    const std::size_t columns = std::min(region.width - left, side);
    const std::size_t rows = std::min(region.height - top, side);
    if (columns == side && rows == side) {
        return write(region.width, to);
    }
    std::array<Color4f, embree::Packet::size> colors;
    const auto found = write(side, colors.data());
    for (std::size_t row = 0; row < rows; ++row) {
        std::copy_n(&colors[row * side], columns, to + row * region.width);
    }
    return found;
}

}  // namespace balcony::render
