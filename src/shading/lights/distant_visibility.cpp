// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "shading/lights/distant_visibility.hpp"

#include <span>

namespace balcony::render {

namespace {

using Imath::V3f;

constexpr std::size_t probes_at_place = 24;

// So many directions that arrive are as good as what is known without them.
constexpr float enough = 8.0F;

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

DistantVisibility::DistantVisibility(std::vector<DistantProbe> probes)
    : places_(std::span(probes), probes_at_place, place_of) {}

}  // namespace balcony::render
