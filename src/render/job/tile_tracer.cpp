// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/tile_tracer.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "render/job/bent_rays.hpp"

namespace balcony::render {

namespace {

// A number minus itself is 0, or NaN if it is not finite.
bool is_finite(const Color4f& c) {
    return (c.r - c.r) + (c.g - c.g) + (c.b - c.b) + (c.a - c.a) == 0.0F;
}

// Those of packets side by side, of which the first has a square of a tile.
class SquareDifferentials final : public DifferentialSource {
public:
    SquareDifferentials(const rays::RayBatch& rays, double scale, const Square& first,
                        std::span<const LaneParts> parts,
                        packet_lanes::Differentials& differentials)
        : rays_(rays), scale_(scale), first_(first), parts_(parts), differentials_(differentials) {}

    [[nodiscard]] const packet_lanes::Differentials& of_packet(std::size_t packet) override {
        if (packet_ != packet) {
            set_differentials(rays_, first_.beside(packet), parts_[packet], scale_, differentials_);
            packet_ = packet;
        }
        return differentials_;
    }

private:
    const rays::RayBatch& rays_;
    double scale_;
    Square first_;
    std::span<const LaneParts> parts_;  // By packet.
    packet_lanes::Differentials& differentials_;
    std::optional<std::size_t> packet_;  // Whose differentials they are.
};

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

TileTracer::TileTracer(const TracedScene& traced, const Settings& settings,
                       const IntegratorRow& integrator, const LightLevels& levels)
    : traced_(&traced),
      levels_(&levels),
      clamp_(settings.path.clamp_indirect > 0.0F ? settings.path.clamp_indirect
                                                 : std::numeric_limits<float>::infinity()),
      // Many samples share the filtering; pbrt limits the reduction in the same way.
      footprint_scale_(std::max(0.125, 1.0 / std::sqrt(static_cast<double>(settings.samples)))),
      integrator_(integrator.make(traced, settings)),
      light_tracer_(integrator_->light_tracer()) {
    if (!settings.passed_objects.empty()) {
        passed_.resize(traced.scene->objects.size());
        for (const std::uint32_t object : settings.passed_objects) {
            if (object < passed_.size()) {
                passed_[object] = true;
            }
        }
    }
}

void TileTracer::intersect(const TileRays& rays, const Square& first,
                           std::span<embree::Packet> packets) {
    const std::size_t count = rays.all.part_count();
    parts_ = {};
    if (count == 1) {
        intersect(packets, *rays.shown, false);
        return;
    }
    std::array<LaneBits, packets_at_once> pending{};
    for (std::size_t k = 0; k < packets.size(); ++k) {
        for (std::size_t lane = 0; lane < embree::Packet::size; ++lane) {
            pending[k] |= packets[k].valid[lane] != 0 ? lane_bit(lane) : 0;
        }
    }
    const std::span<embree::Packet> work = std::span(work_).first(packets.size());
    for (std::size_t number = 0; number < count && pending != decltype(pending){}; ++number) {
        for (std::size_t k = 0; k < packets.size(); ++k) {
            work[k].valid.fill(0);
            for_each_ray(rays.all, first.beside(k), [&](std::size_t i, std::size_t lane) {
                if ((pending[k] & lane_bit(lane)) == 0) {
                    return;
                }
                const rays::RayBatch::Part part = rays.all.part(i, number);
                if (part.length > 0.0) {
                    const embree::Ray ray = ray_of(part, packets[k].time[lane]);
                    packets[k].set(lane, ray);
                    work[k].set(lane, ray);
                    parts_[k][lane] = static_cast<std::uint16_t>(number);
                }
            });
        }
        intersect(work, *rays.shown, true);
        for (std::size_t k = 0; k < packets.size(); ++k) {
            for (std::size_t lane = 0; lane < embree::Packet::size; ++lane) {
                if (work[k].valid[lane] != 0) {
                    packets[k].take_hit(work[k], lane);
                    pending[k] &= work[k].any(lane) ? ~lane_bit(lane) : ~LaneBits{0};
                }
            }
        }
    }
}

void TileTracer::intersect(std::span<embree::Packet> packets, const ShownObjects& shown,
                           bool bent) const {
    const embree::Accelerator& objects = shown.in(*traced_);
    if (passed_.empty() && !bent) {
        objects.intersect(packets);
        return;
    }
    std::array<embree::Packet::Floats, packets_at_once> lengths;
    for (std::size_t k = 0; k < packets.size(); ++k) {
        lengths[k] = packets[k].farthest;
    }
    objects.intersect(packets);
    for (std::size_t k = 0; k < packets.size(); ++k) {
        embree::Packet& packet = packets[k];
        embree::Packet beyond = packet;
        LaneBits passing = all_lanes;
        for (std::size_t crossings = 0; passing != 0 && crossings < max_crossings; ++crossings) {
            passing = set_beyond(packet, bent, beyond, lengths[k]);
            if (passing != 0) {
                objects.intersect(std::span(&beyond, 1));
            }
            for_each_lane(passing, [&](std::size_t lane) { packet.take_hit(beyond, lane); });
        }
    }
}

LaneBits TileTracer::set_beyond(const embree::Packet& packet, bool bent, embree::Packet& beyond,
                                embree::Packet::Floats& lengths) const {
    LaneBits passing = 0;
    beyond.valid.fill(0);
    for (std::size_t lane = 0; lane < embree::Packet::size; ++lane) {
        if (packet.valid[lane] == 0 || !packet.any(lane)) {
            continue;
        }
        const embree::Hit hit = packet.hit(lane);
        const bool is_passed =
            !passed_.empty() && passed_[traced_->scene->instances[hit.instance].object];
        if (!is_passed && !bent) {
            continue;
        }
        const V3f direction = packet.direction(lane);
        const Surface surface = traced_->surfaces.find(hit, direction, packet.time[lane]);
        if ((is_passed && !surface.entering) ||
            (bent && traced_->materials.opacity(surface.in_mesh) <= 0.0F)) {
            lengths[lane] = std::max(lengths[lane] - packet.farthest[lane], 0.0F);
            beyond.set(lane, {.origin = surface.start(direction),
                              .direction = direction,
                              .farthest = lengths[lane],
                              .time = packet.time[lane]});
            passing |= lane_bit(lane);
        }
    }
    return passing;
}

void TileTracer::trace(const TilePoints& points, const TileRays& rays, const Mask& wanted) {
    indices_.clear();
    seen_parts_.clear();
    requested_.clear();
    const PixelGroups groups(points.region, points.pass);
    std::uint32_t number = 0;
    const Region& region = points.region;
    for_each_run(region.width, region.height, packets_, [&](const Square& first, auto packets) {
        set_packets(rays.all, first, rays.interval, rays.time, packets);
        std::array<LaneBits, packets_at_once> lanes{};
        for (std::size_t k = 0; k < packets.size(); ++k) {
            for_each_ray(rays.all, first.beside(k), [&](std::size_t i, std::size_t lane) {
                packets[k].valid[lane] &= wanted[i] != 0 ? -1 : 0;
                lanes[k] |= packets[k].valid[lane] != 0 ? lane_bit(lane) : 0;
            });
        }
        if (lanes != decltype(lanes){}) {
            intersect(rays, first, packets);
        }
        for (std::size_t k = 0; k < packets.size(); ++k, ++number) {
            if (lanes[k] != 0) {
                request(points, rays, first.beside(k), packets[k], parts_[k], number, groups);
            }
        }
    });
    seen_.resize(requested_.size());
    integrator_->trace(requested_, *rays.shown, seen_);
    for (Seen& seen : seen_) {
        if (!is_finite(seen.radiance)) {
            ++repaired_;
            seen.radiance = Color4f(0.0F);
            seen.parts = {};
            seen.softened = 0.0F;
            seen.left_out = 0.0F;
            seen.cut = 0.0F;
            seen.coverage = {};
        }
    }
}

void TileTracer::request(const TilePoints& points, const TileRays& rays, const Square& square,
                         const embree::Packet& packet, const LaneParts& parts, std::uint32_t number,
                         const PixelGroups& groups) {
    set_differentials(rays.all, square, parts, footprint_scale_, differentials_);
    for_each_ray(rays.all, square, [&](std::size_t i, std::size_t lane) {
        if (packet.valid[lane] == 0) {
            return;
        }
        const std::size_t x = points.region.x + i % square.width;
        const std::size_t y = points.region.y + i / square.width;
        Sampler sampler(x, y, points.numbers);
        if (rays.through_lens) {
            (void)sampler.next_pair();
        }
        // Tracing has changed directions within their rounding errors.
        const rays::RayBatch::Part part = rays.all.part(i, parts[lane]);
        const DifferentialRay ray{V3f(part.origin), V3f(part.direction), differentials_.of(lane),
                                  packet.time[lane]};
        indices_.push_back(i);
        seen_parts_.push_back(parts[lane]);
        requested_.push_back({ray, packet.hit(lane), sampler, number, groups.of(x, y),
                              std::min(clamp_, levels_->limit(rays.layer, x, y, points.pass))});
    });
}

RayCounts TileTracer::trace_light(const Region& region, const Region& counted, const TileRays& rays,
                                  std::span<Color4f> radiance) {
    const Region within = region.intersection(counted);
    RayCounts counts{.camera_rays = within.size()};
    for_each_run(region.width, region.height, packets_, [&](const Square& first, auto packets) {
        set_packets(rays.all, first, rays.interval, rays.time, packets);
        intersect(rays, first, packets);
        SquareDifferentials differentials(rays.all, footprint_scale_, first, parts_,
                                          differentials_);
        light_tracer_->trace_light(packets, differentials,
                                   std::span(radiances_).first(packets.size()));
        for (std::size_t k = 0; k < packets.size(); ++k) {
            const auto found =
                write_square(region, within, first.beside(k).left, first.top, k, radiance);
            counts.invalid_rays += found.missing;
            counts.hits += found.shown;
        }
    });
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
