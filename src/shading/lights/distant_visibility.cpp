// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/distant_visibility.hpp"

#include <algorithm>
#include <utility>

namespace balcony::render {

namespace {

using Imath::V3f;

constexpr std::size_t probes_at_place = 24;

// So many directions that arrive are as good as what is known without them.
constexpr float enough = 8.0F;

// The longest side of the box around some points.
int longest_side(std::span<const DistantProbe> probes) {
    V3f low = probes.front().position;
    V3f high = low;
    for (const DistantProbe& probe : probes) {
        for (int axis = 0; axis < 3; ++axis) {
            low[axis] = std::min(low[axis], probe.position[axis]);
            high[axis] = std::max(high[axis], probe.position[axis]);
        }
    }
    const V3f sides = high - low;
    return static_cast<int>(std::max_element(&sides.x, &sides.x + 3) - &sides.x);
}

// A direction that arrives says something about the sectors around its own, too.
void spread(std::size_t sector, std::span<float> counts) {
    constexpr float to_neighbour = 0.125F;
    constexpr std::size_t columns = EnvironmentMap::sector_columns;
    const std::size_t row = sector / columns;
    const std::size_t column = sector % columns;
    counts[sector] += 1.0F;
    counts[row * columns + (column + 1) % columns] += to_neighbour;
    counts[row * columns + (column + columns - 1) % columns] += to_neighbour;
    if (row > 0) {
        counts[sector - columns] += to_neighbour;
    }
    if (row + 1 < EnvironmentMap::sector_rows) {
        counts[sector + columns] += to_neighbour;
    }
}

DistantVisibility::Place place_of(std::span<const DistantProbe> probes) {
    DistantVisibility::Place place;
    place.suns.assign(probes.front().suns.size(), 0.0F);
    std::array<float, EnvironmentMap::sector_count> counts{};
    float open = 0.0F;
    float directions = 0.0F;
    for (const DistantProbe& probe : probes) {
        directions += static_cast<float>(probe.directions);
        open += static_cast<float>(probe.open.size());
        for (const std::uint16_t sector : probe.open) {
            spread(sector, counts);
        }
        for (std::size_t sun = 0; sun < place.suns.size(); ++sun) {
            place.suns[sun] += probe.suns[sun] / static_cast<float>(probes.size());
        }
    }
    float total = 0.0F;
    for (const float count : counts) {
        total += count;
    }
    place.environment = directions > 0.0F ? open / directions : 1.0F;
    place.known = open / (open + enough);
    float sum = 0.0F;
    for (std::size_t i = 0; i < counts.size(); ++i) {
        sum += counts[i];
        place.sectors[i + 1] = total > 0.0F ? sum / total : 0.0F;
    }
    return place;
}

}  // namespace

DistantVisibility::DistantVisibility(std::vector<DistantProbe> probes) {
    nodes_.emplace_back();
    divide(0, probes);
}

void DistantVisibility::divide(std::size_t node, std::span<DistantProbe> probes) {
    if (probes.size() < 2 * probes_at_place) {
        nodes_[node].first = static_cast<std::uint32_t>(places_.size());
        places_.push_back(place_of(probes));
        return;
    }
    const int axis = longest_side(probes);
    const auto order = [axis](const DistantProbe& probe) {
        const V3f& p = probe.position;
        return std::array{p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]};
    };
    const std::size_t middle = probes.size() / 2;
    std::nth_element(
        probes.begin(), probes.begin() + static_cast<std::ptrdiff_t>(middle), probes.end(),
        [&](const DistantProbe& a, const DistantProbe& b) { return order(a) < order(b); });
    const auto below = static_cast<std::uint32_t>(nodes_.size());
    nodes_[node] = {probes[middle].position[axis], axis, below};
    nodes_.resize(nodes_.size() + 2);
    divide(below, probes.first(middle));
    divide(below + 1, probes.subspan(middle));
}

const DistantVisibility::Place& DistantVisibility::at(const V3f& position) const {
    const Node* node = &nodes_.front();
    while (node->axis >= 0) {
        node = &nodes_[node->first + (position[node->axis] < node->border ? 0 : 1)];
    }
    return places_[node->first];
}

}  // namespace balcony::render
