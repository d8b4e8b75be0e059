// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/ray_tree.hpp"

#include <algorithm>

namespace balcony::render {

namespace {

// The maximum number of rays per camera ray.
constexpr std::size_t max_rays = 256;

}  // namespace

void RayTree::trace(std::span<const CameraRay> rays, const ShownObjects& shown,
                    std::span<Seen> seen) {
    std::transform(rays.begin(), rays.end(), seen.begin(),
                   [&](const CameraRay& one) { return trace(one.ray, one.first, shown); });
}

Seen RayTree::trace(const DifferentialRay& ray, const embree::Hit& first,
                    const ShownObjects& shown) {
    Seen seen;
    open_.clear();
    follow({ray}, first, seen);
    for (std::size_t followed = 0; !open_.empty() && followed < max_rays; ++followed) {
        const Branch next = open_.back();
        open_.pop_back();
        follow(next, tracer_.nearest(next.ray, next.reflections == 0 ? shown.only() : nullptr),
               seen);
    }
    return seen;
}

void RayTree::follow(const Branch& branch, const embree::Hit& hit, Seen& seen) {
    const auto add = [&branch](Color4f& total, const Color3f& color) {
        const Color3f part = branch.weight * color;
        total += Color4f(part.x, part.y, part.z, 0.0F);
    };
    const bool seen_directly = branch.reflections == 0;
    if (!hit.any()) {
        if (!seen_directly) {
            add(seen.mirrored, Color3f(1.0F));
        }
        return;
    }
    const Interaction at = tracer_.interaction(branch.ray, hit);
    const float opacity = branch.crossings < max_crossings ? at.appearance().opacity : 1.0F;
    if (opacity < 1.0F) {
        Branch beyond = branch;
        beyond.weight *= 1.0F - opacity;
        ++beyond.crossings;
        beyond.ray.origin = at.surface.start(beyond.ray.direction);
        beyond.ray.differentials.origin_x = at.moved.along_x;
        beyond.ray.differentials.origin_y = at.moved.along_y;
        open_.push_back(beyond);
    }
    if (opacity <= 0.0F) {
        return;
    }
    if (seen_directly) {
        const float part = branch.weight.x * opacity;
        const VisibleSurface surface = tracer_.visible(at);
        seen.radiance.a += part;
        seen.coverage.add(surface, part);
        if (!seen.visible.any) {
            seen.visible = surface;
            seen.shown = surface;
            seen.end = surface.position;
        }
    }
    const Shaded shaded = shade(branch.ray, at);
    add(seen.radiance, opacity * (shaded.emission + shaded.ambient + shaded.direct));
    if (branch.reflections == 0) {
        seen.parts.emission += opacity * branch.weight * shaded.emission;
        seen.parts.direct += opacity * branch.weight * shaded.direct;
    } else if (branch.reflections == 1) {
        seen.parts.direct += opacity * branch.weight * shaded.emission;
    }
    for (const std::optional<Branch>& next : scatter(branch, opacity * branch.weight, at)) {
        if (next) {
            open_.push_back(*next);
        }
    }
}

RayTree::Branches RayTree::scatter(const Branch&, const Color3f&, const Interaction&) const {
    return {};
}

}  // namespace balcony::render
