// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/light_tree.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::render {

using Imath::V3f;

namespace {

// The cosine and the sine of an angle from 0 to pi.
struct Angle {
    Float4 cosine;
    Float4 sine;

    static Angle of(Float4 cosine) {
        return {cosine, sqrt(max(all(0.0F), 1.0F - cosine * cosine))};
    }
};

// a - b, but at least 0.
Angle rest(const Angle& a, const Angle& b) {
    const auto none = a.cosine >= b.cosine;
    return {none ? all(1.0F) : a.cosine * b.cosine + a.sine * b.sine,
            none ? all(0.0F) : a.sine * b.cosine - a.cosine * b.sine};
}

}  // namespace

// The power over the squared distance, times the greatest cosines that are possible at the light
// and at the point. Lights are within the sphere around a box. Inside the sphere, all angles are
// possible, and the distance is its radius.
Float4 LightTree::importance(const Node& node, const V3f& position, const V3f& normal) {
    const Float4 x = node.x - position.x;
    const Float4 y = node.y - position.y;
    const Float4 z = node.z - position.z;
    const Float4 radius2 =
        node.half_x * node.half_x + node.half_y * node.half_y + node.half_z * node.half_z;
    const Float4 distance2 = max(x * x + y * y + z * z, all(1e-30F));
    const Float4 inverse = 1.0F / sqrt(distance2);

    // Half of the angle that the sphere fills, seen from the point.
    const Float4 sine2 = min(radius2 / distance2, all(1.0F));
    const auto inside = sine2 >= 1.0F;
    const Angle size{inside ? all(-1.0F) : sqrt(1.0F - sine2), inside ? all(0.0F) : sqrt(sine2)};

    const Float4 along = -(node.axis_x * x + node.axis_y * y + node.axis_z * z) * inverse;
    const Angle from_axis = Angle::of(max(along, node.back * along));
    const Angle leaving = rest(rest(from_axis, {node.cosine_spread, node.sine_spread}), size);
    Float4 found = leaving.cosine > node.cosine_falloff
                       ? node.power / max(distance2, radius2) * leaving.cosine
                       : all(0.0F);
    if (normal != V3f(0.0F)) {
        const Float4 up = normal.x * x + normal.y * y + normal.z * z;
        const Float4 reach = std::abs(normal.x) * node.half_x + std::abs(normal.y) * node.half_y +
                             std::abs(normal.z) * node.half_z;
        const Float4 cosine = rest(Angle::of(up * inverse), size).cosine;
        found *= up + reach > 0.0F ? max(all(0.0F), cosine) : all(0.0F);
    }
    return max(all(0.0F), found);
}

std::optional<LightTree::Chosen> LightTree::choose(const V3f& position, const V3f& normal,
                                                   float random) const {
    if (empty()) {
        return std::nullopt;
    }
    constexpr float largest = 0x1.fffffep-1F;
    float probability = 1.0F;
    for (std::uint32_t at = 0;;) {
        const Node& node = nodes_[at];
        const Float4 weights = importance(node, position, normal);
        const float total = sum(weights);
        if (!(total > 0.0F)) {
            return std::nullopt;
        }
        float left = random * total;
        std::uint32_t child = 0;
        std::uint32_t last = 0;
        for (std::uint32_t i = 1; i < width; ++i) {
            last = weights[i] > 0.0F ? i : last;
        }
        while (child < last && left >= weights[child]) {
            left -= weights[child];
            ++child;
        }
        probability *= weights[child] / total;
        random = std::min(left / weights[child], largest);
        if ((node.leaves >> child & 1U) != 0) {
            return Chosen{node.child[child], probability};
        }
        at = node.child[child];
    }
}

float LightTree::probability(const V3f& position, const V3f& normal, std::size_t light) const {
    if (places_[light] == none) {
        return 0.0F;
    }
    float probability = 1.0F;
    std::uint32_t at = places_[light] / width;
    std::uint32_t child = places_[light] % width;
    while (at != none) {
        const Node& node = nodes_[at];
        const Float4 weights = importance(node, position, normal);
        if (!(weights[child] > 0.0F)) {
            return 0.0F;
        }
        probability *= weights[child] / sum(weights);
        child = node.place;
        at = node.parent;
    }
    return probability;
}

float LightTree::illuminance(const V3f& position, const V3f& normal) const {
    if (empty()) {
        return 0.0F;
    }
    return power_ * sum(importance(nodes_.front(), position, normal));
}

}  // namespace balcony::render
