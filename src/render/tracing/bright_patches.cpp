// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/tracing/bright_patches.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

namespace {

using Imath::V3f;

constexpr std::size_t probes_at_place = 64;

// What looks at the boxes sees them all about as bright on average as all surfaces do: the factors
// from what is seen of each to irradiance.
LaneFloats irradiance_of_seen(std::span<const BrightBox> boxes,
                              std::span<const PatchProbe> probes) {
    LaneFloats seen{};
    float looks = 0.0F;
    for (const PatchProbe& probe : probes) {
        looks += probe.seen ? 1.0F : 0.0F;
        for (std::size_t i = 0; probe.seen && i < boxes.size(); ++i) {
            seen[i] += (*probe.seen)[i];
        }
    }
    LaneFloats factors{};
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        factors[i] = seen[i] > 0.0F ? boxes[i].irradiance * looks / seen[i] : 0.0F;
    }
    return factors;
}

}  // namespace

BrightPatches::Boxes::Boxes(std::span<const BrightBox> boxes) : count(boxes.size()) {
    for (std::size_t i = 0; i < most; ++i) {
        const BrightBox& box = boxes[std::min(i, count - 1)];
        low.set(i, box.low);
        high.set(i, box.high);
    }
}

BrightPatches::BrightPatches(std::span<const BrightBox> boxes, std::vector<PatchProbe> probes)
    : boxes_(boxes),
      places_(std::span(probes), probes_at_place,
              [&, factors = irradiance_of_seen(boxes, probes)](std::span<const PatchProbe> some) {
                  return place_of(some, boxes_, factors);
              }) {}

// Two parts of an integral, one that is found wherever a sample looks for it and one with this mean
// square, have the least variance together with samples as their mean and the root of that.
BrightPatches::Place BrightPatches::place_of(std::span<const PatchProbe> probes, const Boxes& boxes,
                                             const LaneFloats& irradiance_of_seen) {
    constexpr float largest_share = 0.6F;
    constexpr float least_share = 0.05F;
    LaneFloats irradiance{};
    float looks = 0.0F;
    float squares = 0.0F;
    for (const PatchProbe& probe : probes) {
        squares += probe.other * probe.other;
        looks += probe.seen ? 1.0F : 0.0F;
        for (std::size_t i = 0; probe.seen && i < boxes.count; ++i) {
            irradiance[i] += irradiance_of_seen[i] * (*probe.seen)[i];
        }
    }
    float sum = 0.0F;
    for (const float one : irradiance) {
        sum += one;
    }
    Place place;
    if (!(sum > 0.0F)) {
        return place;
    }
    const float by_patches = sum / looks;
    const float by_others = std::sqrt(squares / static_cast<float>(probes.size()));
    const float share = by_patches / (by_patches + by_others);
    place.share = share < least_share ? 0.0F : std::min(share, largest_share);
    float before = 0.0F;
    for (std::size_t i = 0; i < most; ++i) {
        const V3f sides = boxes.high.of(i) - boxes.low.of(i);
        const float probability = irradiance[i] / sum;
        place.factors[i] = probability / (3.0F * sides.x * sides.y * sides.z);
        before += probability;
        place.cumulative[i] = before;
    }
    // Whatever the rounding, one of a probability above 0 is found.
    std::replace(place.cumulative.begin(), place.cumulative.end(), before, 1.0F);
    return place;
}

V3f BrightPatches::sample(const Place& place, const V3f& from, const V3f& random) const {
    std::size_t box = 0;
    while (box + 1 < boxes_.count && !(random.x < place.cumulative[box])) {
        ++box;
    }
    const float before = box > 0 ? place.cumulative[box - 1] : 0.0F;
    const float rest = (random.x - before) / (place.cumulative[box] - before);
    const V3f low = boxes_.low.of(box);
    const V3f in_box(std::clamp(rest, 0.0F, 1.0F), random.y, random.z);
    return (low + (boxes_.high.of(box) - low) * in_box - from).normalized();
}

// An even point of a box of volume V, seen from `from`, has a density of directions of the integral
// of r² / V over the part of the ray that is in the box.
float BrightPatches::pdf(const Place& place, const V3f& from, const V3f& direction) const {
    constexpr float least = 1e-12F;
    const auto inverse = [](float x) { return 1.0F / (std::abs(x) > least ? x : least); };
    const V3f per(inverse(direction.x), inverse(direction.y), inverse(direction.z));
    alignas(64) LaneFloats densities;
    for (std::size_t i = 0; i < most; ++i) {
        const float x0 = (boxes_.low.x[i] - from.x) * per.x;
        const float x1 = (boxes_.high.x[i] - from.x) * per.x;
        const float y0 = (boxes_.low.y[i] - from.y) * per.y;
        const float y1 = (boxes_.high.y[i] - from.y) * per.y;
        const float z0 = (boxes_.low.z[i] - from.z) * per.z;
        const float z1 = (boxes_.high.z[i] - from.z) * per.z;
        const float near = std::max(std::max(std::min(x0, x1), std::min(y0, y1)),
                                    std::max(std::min(z0, z1), 0.0F));
        const float far = std::min(std::min(std::max(x0, x1), std::max(y0, y1)), std::max(z0, z1));
        const float length = std::max(far - near, 0.0F);
        densities[i] = place.factors[i] * length * (far * far + far * near + near * near);
    }
    float sum = 0.0F;
    for (const float density : densities) {
        sum += density;
    }
    return sum;
}

}  // namespace balcony::render
