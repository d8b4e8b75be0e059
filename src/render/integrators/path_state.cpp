// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/path_state.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace balcony::render {

void pass_pane(Path& path, const Interaction& at) {
    path.ray.origin = at.surface.start(path.ray.direction);
    path.ray.differentials.origin_x = at.moved.along_x;
    path.ray.differentials.origin_y = at.moved.along_y;
    ++path.crossings;
}

void pass_through(Path& path, const Interaction& at) {
    pass_pane(path, at);
    path.transmittance *= 1.0F - at.appearance().opacity;
    path.may_be_guided = false;
}

void absorb(Path& path, const V3f& position) {
    if (!is_black(path.absorption)) {
        const float all = (position - path.from.position).length();
        const float length = all - std::exchange(path.absorbed, all);
        path.throughput *=
            Color3f(std::exp(-path.absorption.x * length), std::exp(-path.absorption.y * length),
                    std::exp(-path.absorption.z * length));
    }
}

void count_bounce(Path& path, BsdfLobe lobe, const BounceLimits& limits) {
    const auto count = [&path](std::uint8_t& bounces, std::size_t limit) {
        path.is_last = path.is_last || ++bounces > limit;
    };
    count(path.bounces.all, limits.all);
    switch (lobe) {
        case BsdfLobe::diffuse: count(path.bounces.diffuse, limits.diffuse); break;
        case BsdfLobe::glossy: count(path.bounces.glossy, limits.glossy); break;
        case BsdfLobe::transmission: count(path.bounces.transmission, limits.transmission); break;
    }
}

bool counts_by_surface(const BounceLimits& limits) {
    constexpr std::size_t many = 4;
    return std::min(limits.diffuse, limits.glossy) < std::min(limits.all, many);
}

Color3f limited(const Color3f& light, float limit) {
    return largest(light) > limit ? light * (limit / largest(light)) : light;
}

float survival(const Color3f& throughput) { return std::min(1.0F, std::sqrt(largest(throughput))); }

bool survives(Path& path, SampleReader& numbers, float factor) {
    const float probability = survival(factor * path.before_tail * path.throughput);
    if (!(probability < 1.0F)) {
        return true;
    }
    if (!(numbers.next() < probability)) {
        return false;
    }
    path.throughput /= probability;
    return true;
}

}  // namespace balcony::render
