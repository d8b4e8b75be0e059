// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/shared_tails.hpp"

#include <algorithm>
#include <bit>
#include <cmath>

#include "images/luminance.hpp"
#include "render/integrators/path_state.hpp"
#include "render/integrators/ray_order.hpp"

namespace balcony::render {

namespace {

using plain_lanes::Vectors;

// Above this cosine no normal of a surface is bent towards its viewer (surface.cpp).
constexpr float least_cosine = 2e-3F;

// A ray to a tail ends before its surface.
constexpr float before_tail = 1.0F - 1e-4F;

// Whether a material scatters light so widely that all heads of a group see nearly the same.
bool is_wide(const PlainMaterial& material) { return material.roughness > 0.3F; }

}  // namespace

bool SharedTails::can_share(const TracedScene& traced, const PathSettings& settings) {
    return settings.reuse && !traced.lights.are_at_eye() && !counts_by_surface(settings.bounces);
}

void SharedTails::begin(std::span<const CameraRay> rays) {
    ends_.clear();
    heads_.clear();
    tails_.clear();
    for (const CameraRay& ray : rays) {
        ends_.push_back({.group = ray.group});
    }
}

bool SharedTails::can_end_head(const BsdfMaterial& material) {
    return !material.layers && (!material.is_mirror() || !is_black(material.diffuse));
}

bool SharedTails::can_begin_tail(const BsdfMaterial& material, const Surface& surface,
                                 const V3f& to_viewer) {
    return !material.layers && (is_wide(material) || !is_black(material.diffuse)) &&
           std::min({surface.normal.dot(to_viewer), surface.smooth_normal.dot(to_viewer),
                     surface.geometric_normal.dot(to_viewer)}) > least_cosine;
}

void SharedTails::set_head(std::uint32_t path, const Head& head) {
    ends_[path].head = static_cast<std::uint32_t>(heads_.size());
    heads_.push_back(head);
}

void SharedTails::set_tail(const Path& path, const PlainMaterial& material,
                           const Surface& surface) {
    ends_[path.index].tail = static_cast<std::uint32_t>(tails_.size());
    Tail& tail = tails_.emplace_back(Tail{{material, surface.normal, surface.smooth_normal},
                                          surface.geometric_normal,
                                          surface.position,
                                          path.throughput,
                                          path.transmittance,
                                          is_wide(material),
                                          path.is_softened});
    if (!tail.is_whole) {
        tail.surface.material.specular = {};
    }
}

void SharedTails::add_light(const SceneTracer& tracer, std::span<const CameraRay> rays,
                            std::span<Seen> seen) {
    constexpr std::uint32_t bucket_count = 512;
    order_.resize(ends_.size());
    for (std::uint32_t i = 0; i < order_.size(); ++i) {
        order_[i] = i;
        limit_tail(i, rays[i].limit, seen[i]);
    }
    counting_sort<bucket_count>(order_, buffer_, [&](std::uint32_t i) { return ends_[i].group; });
    for (std::size_t begin = 0; begin < order_.size();) {
        std::size_t end = begin + 1;
        while (end < order_.size() && end - begin < group_size &&
               ends_[order_[end]].group == ends_[order_[begin]].group) {
            ++end;
        }
        const Indices group = std::span(order_).subspan(begin, end - begin);
        share(group, tracer);
        for (std::size_t lane = 0; lane < group.size(); ++lane) {
            const std::uint32_t path = group[lane];
            if (ends_[path].head == none) {
                continue;
            }
            const Color3f found = lanes_.light.of(lane);
            const Color3f light = head_of(path).is_clear ? found : limited(found, rays[path].limit);
            Seen& to = seen[path];
            to.radiance += Color4f(light.x, light.y, light.z, 0.0F);
            to.softened += std::min(lanes_.softened[lane], luminance(light));
            to.left_out += luminance(found) - luminance(light);
        }
        begin = end;
    }
}

// What a clear head shows is limited at its tail, where the light of lamps is direct light.
void SharedTails::limit_tail(std::uint32_t path, float limit, Seen& seen) {
    if (ends_[path].tail == none || !head_of(path).is_clear) {
        return;
    }
    ArrivingLight& light = tail(path).onward;
    const Color3f own = tail(path).throughput * light.reflected * light.radiance;
    if (largest(own) > limit) {
        const float part = limit / largest(own);
        light.radiance *= part;
        seen.left_out += (1.0F - part) * luminance(own);
    }
}

void SharedTails::share(Indices group, const SceneTracer& tracer) {
    gather(group);
    LaneBits owners = 0;
    const auto connect_all = [&] {
        if (owners != 0) {
            connect(group, owners, tracer);
        }
        owners = 0;
    };
    for (std::size_t own = 0; own < group.size(); ++own) {
        const std::uint32_t tail = ends_[group[own]].tail;
        if (tail == none ||
            (is_black(tails_[tail].lamp.radiance) && is_black(tails_[tail].onward.radiance))) {
            continue;
        }
        const auto turn = static_cast<std::size_t>(std::popcount(owners));
        owners |= lane_bit(turn * group_size + own);
        if (turn + 1 == tails_at_once) {
            connect_all();
        }
    }
    connect_all();
}

void SharedTails::gather(Indices group) {
    lanes_.all = 0;
    lanes_.light.fill(0, plain_lanes::size, V3f(0.0F));
    lanes_.softened.fill(0.0F);
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (ends_[group[i]].head == none) {
            continue;
        }
        const Head& head = head_of(group[i]);
        for (std::size_t lane = i; lane < plain_lanes::size; lane += group_size) {
            lanes_.all |= lane_bit(lane);
            lanes_.surfaces.set(lane, head.surface);
            lanes_.to_viewer.set(lane, head.to_viewer);
            lanes_.start.set(lane, head.start);
            lanes_.throughput.set(lane, head.throughput);
        }
    }
    set_views(lanes_.all, lanes_.surfaces, lanes_.to_viewer, lanes_.views);
}

// Of the heads beside that of a lane, those which are like it.
LaneBits SharedTails::like(Indices group, std::size_t own) const {
    const Head& head = head_of(group[own % group_size]);
    const std::size_t first = own - own % group_size;
    LaneBits found = 0;
    for (std::size_t i = 0; i < group.size(); ++i) {
        if ((lanes_.all & lane_bit(first + i)) != 0) {
            const Head& other = head_of(group[i]);
            found |=
                head.time == other.time && head.bounces == other.bounces ? lane_bit(first + i) : 0;
        }
    }
    return found;
}

// Adds the light of the tails of some heads, one in each part of the lanes, to all heads that see
// them.
void SharedTails::connect(Indices group, LaneBits owners, const SceneTracer& tracer) {
    LaneBits heads = 0;
    at_.tails.fill(nullptr);
    for_each_lane(owners, [&](std::size_t own) {
        const Tail& tail = tails_[ends_[group[own % group_size]].tail];
        at_.tails[own / group_size] = &tail;
        at_.surfaces.fill(own - own % group_size, group_size, tail.surface);
        heads |= like(group, own);
    });
    set_ways();
    const LaneBits lanes = facing(heads);
    trace(group, lanes, owners, tracer);
    set_densities(group, lanes, tracer);
    reflect(lanes);
    add(lanes, owners);
}

void SharedTails::set_ways() {
    for (std::size_t part = 0; part < tails_at_once; ++part) {
        if (at_.tails[part] == nullptr) {
            continue;
        }
        const Tail& tail = *at_.tails[part];
        const V3f& n = tail.surface.normal;
        const V3f& s = tail.surface.side_normal;
        const V3f& f = tail.flat_normal;
        for (std::size_t i = part * group_size; i < (part + 1) * group_size; ++i) {
            const float x = tail.position.x - lanes_.start.x[i];
            const float y = tail.position.y - lanes_.start.y[i];
            const float z = tail.position.z - lanes_.start.z[i];
            const float length = std::sqrt(x * x + y * y + z * z);
            at_.length[i] = length;
            at_.to_tail.x[i] = x / length;
            at_.to_tail.y[i] = y / length;
            at_.to_tail.z[i] = z / length;
            at_.to_head.x[i] = -(x / length);
            at_.to_head.y[i] = -(y / length);
            at_.to_head.z[i] = -(z / length);
            at_.cosine[i] = -(f.x * x + f.y * y + f.z * z) / length;
            at_.facing[i] =
                std::min(at_.cosine[i], std::min(-(n.x * x + n.y * y + n.z * z) / length,
                                                 -(s.x * x + s.y * y + s.z * z) / length));
        }
    }
}

// Of some heads, those from which light could be scattered towards their tail.
LaneBits SharedTails::facing(LaneBits heads) {
    LaneBits before = 0;
    for_each_lane(heads, [&](std::size_t lane) {
        before |= at_.facing[lane] > least_cosine ? lane_bit(lane) : 0;
    });
    evaluate(before, lanes_.surfaces, lanes_.views, at_.to_tail, at_.at_head);
    LaneBits found = 0;
    for_each_lane(before, [&](std::size_t lane) {
        found |= at_.at_head.pdf[lane] > 0.0F ? lane_bit(lane) : 0;
    });
    return found;
}

// What passes between heads and tails: the solid angle of an area of the tail. The owners' own rays
// have arrived.
void SharedTails::trace(Indices group, LaneBits lanes, LaneBits owners, const SceneTracer& tracer) {
    std::array<embree::Ray, plain_lanes::size> rays;
    std::array<Color3f, plain_lanes::size> passed;
    std::size_t count = 0;
    for_each_lane(lanes & ~owners, [&](std::size_t lane) {
        rays[count++] = {lanes_.start.of(lane), at_.to_tail.of(lane),
                         before_tail * at_.length[lane], head_of(group[lane % group_size]).time};
    });
    if (count > 0) {
        tracer.openness(std::span(rays).first(count), passed);
    }
    count = 0;
    for_each_lane(lanes, [&](std::size_t lane) {
        const bool own = (owners & lane_bit(lane)) != 0;
        const float transmittance =
            own ? at_.tails[lane / group_size]->transmittance : passed[count++].x;
        at_.per_area[lane] =
            transmittance * at_.cosine[lane] / (at_.length[lane] * at_.length[lane]);
    });
}

// The sums of q_k over the heads of each tail.
void SharedTails::set_densities(Indices group, LaneBits lanes, const SceneTracer& tracer) {
    const BrightPatches* const patches = tracer.scene().patches.get();
    std::array<float, tails_at_once> sums{};
    for_each_lane(lanes, [&](std::size_t lane) {
        const float pdf = at_.at_head.pdf[lane];
        const Color3f throughput =
            lanes_.throughput.of(lane) * at_.at_head.reflected.of(lane) / pdf;
        const BrightPatches::Place* const place = head_of(group[lane % group_size]).place;
        const float mixed = place == nullptr ? pdf
                                             : patches->mixed_pdf(*place, lanes_.start.of(lane),
                                                                  at_.to_tail.of(lane), pdf);
        sums[lane / group_size] += at_.per_area[lane] * mixed * survival(throughput);
    });
    for (std::size_t lane = 0; lane < plain_lanes::size; ++lane) {
        at_.density[lane] = sums[lane / group_size];
    }
}

// What the tails reflect towards the heads.
void SharedTails::reflect(LaneBits lanes) {
    const auto evaluate_at_tails = [&](ArrivingLight Tail::*light, plain_lanes::Values& values) {
        LaneBits lit = 0;
        for (std::size_t part = 0; part < tails_at_once; ++part) {
            if (at_.tails[part] != nullptr && !is_black((at_.tails[part]->*light).radiance)) {
                lit |= lane_bit(part * group_size) * (lane_bit(group_size) - 1);
                at_.to_light.fill(part * group_size, group_size,
                                  (at_.tails[part]->*light).direction);
            }
        }
        evaluate(lanes & lit, at_.surfaces, at_.views, at_.to_light, values);
    };
    set_views(lanes, at_.surfaces, at_.to_head, at_.views);
    evaluate_at_tails(&Tail::lamp, at_.from_lamp);
    evaluate_at_tails(&Tail::onward, at_.from_onward);
}

void SharedTails::add(LaneBits lanes, LaneBits owners) {
    for_each_lane(lanes, [&](std::size_t lane) {
        if (!(at_.density[lane] > 0.0F)) {
            return;
        }
        const Tail& tail = *at_.tails[lane / group_size];
        const Color3f lamp = at_.from_lamp.reflected.of(lane);
        const Color3f onward = at_.from_onward.reflected.of(lane);
        Color3f light = at_.per_area[lane] / at_.density[lane] * lanes_.throughput.of(lane) *
                        at_.at_head.reflected.of(lane) *
                        (lamp * tail.lamp.radiance + onward * tail.onward.radiance);
        if (!tail.is_whole && (owners & lane_bit(lane)) != 0) {
            light += tail.throughput * ((tail.lamp.reflected - lamp) * tail.lamp.radiance +
                                        (tail.onward.reflected - onward) * tail.onward.radiance);
        }
        const std::size_t head = lane % group_size;
        lanes_.light.set(head, lanes_.light.of(head) + light);
        lanes_.softened[head] += tail.is_softened ? luminance(light) : 0.0F;
    });
}

}  // namespace balcony::render
