// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/path_light.hpp"

#include <algorithm>
#include <utility>

#include "images/luminance.hpp"

namespace balcony::render {

void PathLight::begin(std::span<const CameraRay> rays, std::span<Seen> seen) {
    std::fill(seen.begin(), seen.end(), Seen{});
    rays_ = rays;
    seen_ = seen;
    guided_.clear();
    if (shares_) {
        tails_.begin(rays);
    }
}

// What guided paths lose is not counted.
void PathLight::cut(const Path& path) const {
    if (path.part != Part::guided) {
        seen_[path.index].cut += luminance(path.before_tail * path.throughput);
    }
}

void PathLight::add(const Path& path, const Color3f& light) {
    add(path.part, path.index, light, {path.bounces.all, path.scattered > 1, path.is_softened});
}

void PathLight::add(Part part, std::uint32_t index, const Color3f& light, const Way& way) {
    switch (part) {
        case Part::tail: tails_.tail(index).lamp.radiance += light; break;
        case Part::onward: tails_.tail(index).onward.radiance += light; break;
        case Part::guided:
            guided_[index].light += light;
            guided_[index].is_softened |= way.softened;
            return;
        default: add_scattered(index, light, way); return;
    }
    tails_.tail(index).is_softened |= way.softened;
}

void PathLight::add(const Path& path, const embree::Ray& shadow_ray, const Color3f& light,
                    const Path* guided) {
    ShadowedLight one{.ray = shadow_ray,
                      .light = light,
                      .index = path.index,
                      .packet = path.packet,
                      .direct = path.bounces.all == 0,
                      .part = path.part,
                      .softened = path.is_softened,
                      .indirect = path.scattered > 0};
    if (guided != nullptr) {
        one.guided = static_cast<std::uint32_t>(waiting_.size());
        waiting_.push_back(*guided);
    }
    shadow_rays_.add(one);
}

void PathLight::add_scattered(std::uint32_t index, const Color3f& light, const Way& way) const {
    const Color3f added = way.indirect ? limited(light, rays_[index].limit) : light;
    Seen& seen = seen_[index];
    seen.left_out += luminance(light) - luminance(added);
    seen.softened += way.softened ? luminance(added) : 0.0F;
    seen.radiance += Color4f(added.x, added.y, added.z, 0.0F);
    if (way.bounces == 0) {
        seen.parts.emission += added;
    } else if (way.bounces == 1) {
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

void PathLight::trace_shadow_rays(const SceneTracer& tracer, PathBatch& paths) {
    shadow_rays_.trace(tracer, [&](const ShadowedLight& one, const Color3f& transmittance) {
        if (!is_black(transmittance)) {
            add(one.part, one.index, transmittance * one.light,
                {one.direct ? 1U : 2U, one.indirect, one.softened});
        } else if (one.guided != ShadowedLight::none && tracer.passes_glass(one.ray)) {
            start(waiting_[one.guided], paths);
        }
    });
    shadow_rays_.clear();
    waiting_.clear();
}

void PathLight::start(Path& guided, PathBatch& paths) {
    guided_.push_back({guided.index, guided.part});
    guided.index = static_cast<std::uint32_t>(guided_.size() - 1);
    guided.part = Part::guided;
    paths.add(guided);
}

// A head receives the light of tails whether its own ray finds one or not. No tail is shared where
// light is absorbed on its way, or where a limit is reached.
void PathLight::end_head(PathBlock& block, std::size_t lane, const BrightPatches::Place* place) {
    Path& path = block.path(lane);
    const BsdfMaterial& material = block.bsdfs().material(lane);
    if (path.part != Part::head || !SharedTails::can_end_head(material)) {
        return;
    }
    const Bounces& bounces = path.bounces;
    path.part = Part::whole;
    if (!is_black(path.absorption) || bounces.all >= bounces_.all ||
        bounces.diffuse >= bounces_.diffuse || bounces.glossy >= bounces_.glossy) {
        return;
    }
    const Surface& surface = block.at(lane).surface;
    tails_.set_head(path.index, {.surface = {material, surface.normal, surface.smooth_normal},
                                 .to_viewer = -path.ray.direction,
                                 .start = surface.start_to_light(),
                                 .throughput = path.throughput,
                                 .time = path.ray.time,
                                 .bounces = bounces,
                                 .is_clear = path.is_clear,
                                 .place = place});
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
    if (sample.delta && path.part != Part::head && path.part != Part::guided &&
        !(passes_pane && path.part == Part::onward)) {
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

void PathLight::finish(const SceneTracer& tracer) {
    for (const Guided& one : guided_) {
        add(one.part, one.index, one.light, {2, true, one.is_softened});
    }
    if (shares_) {
        tails_.add_light(tracer, rays_, seen_);
    }
}

}  // namespace balcony::render
