// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/camera_rays.hpp"

#include <algorithm>
#include <cmath>

#include "shading/surfaces/packet_lanes.hpp"

namespace balcony::render {

bool traceable(const rays::RayBatch& rays, std::size_t i) {
    const V3d d = rays.direction(i);
    return rays.valid(i) && embree::in_range(rays.origin(i)) && std::abs(d.length2() - 1.0) < 1e-6;
}

namespace {

constexpr std::size_t side = embree::Packet::side;

bool is_whole(const rays::RayBatch& rays, const Square& square) {
    return square.width - square.left >= side && rays.size() / square.width - square.top >= side;
}

}  // namespace

void set_packets(const rays::RayBatch& rays, const Square& square,
                 const scene::TimeInterval& interval, float time,
                 std::span<embree::Packet> packets) {
    const std::size_t rows = rays.size() / square.width - square.top;
    const std::size_t whole =
        rows < side ? 0 : std::min((square.width - square.left) / side, packets.size());
    packet_lanes::set_rays(rays.arrays(), square.top * square.width + square.left, square.width,
                           time, packets.first(whole));
    for (std::size_t k = 0; k < packets.size(); ++k) {
        embree::Packet& packet = packets[k];
        const Square one = square.beside(k);
        if (k >= whole) {
            packet.valid.fill(0);
            for_each_ray(rays, one, [&](std::size_t i, std::size_t lane) {
                if (traceable(rays, i)) {
                    packet.set(lane, {.origin = V3f(rays.origin(i)),
                                      .direction = V3f(rays.direction(i)),
                                      .time = time});
                }
            });
        }
        if (rays.has_times()) {
            for_each_ray(rays, one, [&](std::size_t i, std::size_t lane) {
                packet.time[lane] = static_cast<float>(interval.part_at(rays.time(i)));
            });
        }
    }
}

void set_differentials(const rays::RayBatch& rays, const Square& square, const LaneParts& parts,
                       double fraction, packet_lanes::Differentials& differentials) {
    if (!rays.has_footprints()) {
        differentials = {};
    } else if (is_whole(rays, square) && rays.part_count() == 1) {
        packet_lanes::set_differentials(rays.footprint_arrays(),
                                        square.top * square.width + square.left, square.width,
                                        fraction, differentials);
    } else {
        for_each_ray(rays, square, [&](std::size_t i, std::size_t lane) {
            differentials.set(lane, render::differentials(rays, i, parts[lane], fraction));
        });
    }
}

V2f parameters(const rays::RayBatch& rays, std::size_t i) {
    if (!rays.has_parameters()) {
        return V2f(0.0F);
    }
    const V2f p(rays.parameters(i));
    return {std::isfinite(p.x) ? p.x : 0.0F, std::isfinite(p.y) ? p.y : 0.0F};
}

float magnification(const rays::RayBatch& rays, std::size_t i, std::size_t part, const V3d& point) {
    if (!rays.has_footprints()) {
        return 0.0F;
    }
    const rays::Ray ray = rays.ray_of_part(i, part);
    const double length = (point - ray.origin).length();
    const V3d by_x = ray.origin_by_x + length * ray.direction_by_x;
    const V3d by_y = ray.origin_by_y + length * ray.direction_by_y;
    const double area = std::abs(by_x.cross(by_y).dot(ray.direction));  // Of a pixel.
    const auto pixels = static_cast<float>(1.0 / std::sqrt(area));
    return std::isfinite(pixels) ? pixels : 0.0F;
}

RayDifferentials differentials(const rays::RayBatch& rays, std::size_t i, std::size_t part,
                               double fraction) {
    RayDifferentials d;
    const rays::Ray ray = rays.ray_of_part(i, part);
    const auto set = [fraction](const V3d& origin_by, const V3d& direction_by, V3f& origin,
                                V3f& direction) {
        const V3d moved = fraction * origin_by;
        const V3d turned = fraction * direction_by;
        if (embree::in_range(moved) && embree::in_range(turned)) {
            origin = V3f(moved);
            direction = V3f(turned);
        }
    };
    set(ray.origin_by_x, ray.direction_by_x, d.origin_x, d.direction_x);
    set(ray.origin_by_y, ray.direction_by_y, d.origin_y, d.direction_y);
    return d;
}

}  // namespace balcony::render
