// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/path_light.hpp"

#include <algorithm>
#include <utility>

#include "images/luminance.hpp"

namespace balcony::render {

void PathLight::begin(std::span<const CameraRay> rays, std::span<Seen> seen) {
    std::fill(seen.begin(), seen.end(), Seen{});
    seen_ = seen;
    if (shares_) {
        tails_.begin(rays);
    }
}

void PathLight::add(const Path& path, const Color3f& light) {
    if (path.part == Part::onward) {
        add_onward(path.index, light, path.is_softened);
    } else {
        add_scattered(seen_[path.index], light, path.bounces.all, path.is_softened);
    }
}

void PathLight::add_onward(std::uint32_t index, const Color3f& light, bool softened) {
    Tail& tail = tails_.tail(index);
    tail.onward.radiance += light;
    tail.is_softened |= softened;
}

void PathLight::add_scattered(Seen& seen, const Color3f& light, std::size_t bounces,
                              bool softened) const {
    const Color3f added = bounces > 1 ? limited(light, settings_->clamp_indirect) : light;
    seen.softened += softened ? luminance(added) : 0.0F;
    seen.radiance += Color4f(added.x, added.y, added.z, 0.0F);
    if (bounces == 0) {
        seen.parts.emission += added;
    } else if (bounces == 1) {
        seen.parts.direct += added;
    }
}

Color3f PathLight::received(const Path& path, const ArrivingLight& lamp) {
    if (path.part != Part::tail) {
        return lamp.radiance * lamp.reflected;
    }
    tails_.tail(path.index).lamp = {lamp.direction, Color3f(0.0F), lamp.reflected};
    return lamp.radiance;
}

void PathLight::trace_shadow_rays(const SceneTracer& tracer) {
    shadow_rays_.trace(tracer, [&](const ShadowedLight& one, const Color3f& transmittance) {
        const Color3f light = transmittance * one.light;
        switch (one.part) {
            case Part::tail: tails_.tail(one.index).lamp.radiance += light; break;
            case Part::onward: add_onward(one.index, light, one.softened); break;
            default: add_scattered(seen_[one.index], light, one.direct ? 1 : 2, one.softened);
        }
    });
    shadow_rays_.clear();
}

// A head receives the light of tails whether its own ray finds one or not. No tail is shared where
// light is absorbed on its way, or where a limit is reached.
void PathLight::end_head(PathBlock& block, std::size_t lane) {
    Path& path = block.path(lane);
    const BsdfMaterial& material = block.bsdfs().material(lane);
    if (path.part != Part::head || !SharedTails::can_end_head(material)) {
        return;
    }
    const Bounces& bounces = path.bounces;
    const BounceLimits& limits = settings_->bounces;
    path.part = Part::whole;
    if (!is_black(path.absorption) || bounces.all >= limits.all ||
        bounces.diffuse >= limits.diffuse || bounces.glossy >= limits.glossy) {
        return;
    }
    const Surface& surface = block.at(lane).surface;
    tails_.set_head(path.index, {.surface = {material, surface.normal, surface.smooth_normal},
                                 .to_viewer = -path.ray.direction,
                                 .start = surface.start_to_light(),
                                 .throughput = path.throughput,
                                 .time = path.ray.time,
                                 .bounces = bounces});
    path.part = Part::between;
}

void PathLight::begin_tail(PathBlock& block, std::size_t lane) {
    Path& path = block.path(lane);
    if (path.part != Part::between) {
        return;
    }
    const BsdfMaterial& material = block.bsdfs().material(lane);
    const Surface& surface = block.at(lane).surface;
    path.part = Part::whole;
    if (SharedTails::can_begin_tail(material, surface, -path.ray.direction)) {
        tails_.set_tail(path, material, surface);
        path.before_tail = std::exchange(path.throughput, Color3f(1.0F));
        path.part = Part::tail;
    }
}

// What a path finds by way of a mirror, at its tail or behind it, is its own: a lamp there is rare
// and bright.
void PathLight::scatter(Path& path, const BsdfSample& sample, bool passes_pane) {
    if (sample.delta && path.part != Part::head && !(passes_pane && path.part == Part::onward)) {
        path.throughput *= std::exchange(path.before_tail, Color3f(1.0F));
        path.part = Part::whole;
    }
    if (path.part == Part::tail) {
        go_on_from_tail(path, sample);
    } else {
        path.throughput *= sample.weight;
    }
}

void PathLight::go_on_from_tail(Path& path, const BsdfSample& sample) {
    const Color3f reflected = sample.pdf * sample.weight;
    tails_.tail(path.index).onward = {sample.to_light, Color3f(0.0F), reflected};
    path.before_tail *= reflected;
    path.throughput = Color3f(1.0F / sample.pdf);
    path.part = Part::onward;
}

void PathLight::share_tails(const SceneTracer& tracer) {
    if (shares_) {
        tails_.add_light(tracer, settings_->clamp_indirect, seen_);
    }
}

}  // namespace balcony::render
