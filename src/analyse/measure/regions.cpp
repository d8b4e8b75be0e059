// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "analyse/measure/regions.hpp"

#include <algorithm>

namespace balcony::analyse {

namespace {

std::size_t middle_of(const SampleGrid& grid, const std::vector<std::size_t>& samples) {
    V2d mean(0.0);
    for (const std::size_t sample : samples) {
        mean += grid.at(sample) / static_cast<double>(samples.size());
    }
    return *std::min_element(samples.begin(), samples.end(), [&](std::size_t a, std::size_t b) {
        return (grid.at(a) - mean).length2() < (grid.at(b) - mean).length2();
    });
}

}  // namespace

std::vector<std::size_t> neighbours(const SampleGrid& grid, std::size_t sample) {
    std::vector<std::size_t> found;
    const std::size_t column = sample % grid.columns;
    if (column > 0) {
        found.push_back(sample - 1);
    }
    if (column + 1 < grid.columns) {
        found.push_back(sample + 1);
    }
    if (sample >= grid.columns) {
        found.push_back(sample - grid.columns);
    }
    if (sample + grid.columns < grid.size()) {
        found.push_back(sample + grid.columns);
    }
    return found;
}

std::vector<SampleRegion> find_regions(const SampleGrid& grid, const SampleTest& inside,
                                       const PairTest& connected) {
    std::vector<SampleRegion> regions;
    std::vector<bool> known(grid.size(), false);
    for (std::size_t start = 0; start < grid.size(); ++start) {
        if (known[start] || !inside(start)) {
            continue;
        }
        SampleRegion region{{start}, start};
        known[start] = true;
        for (std::size_t next = 0; next < region.samples.size(); ++next) {
            const std::size_t sample = region.samples[next];
            for (const std::size_t other : neighbours(grid, sample)) {
                if (!known[other] && inside(other) && connected(sample, other)) {
                    known[other] = true;
                    region.samples.push_back(other);
                }
            }
        }
        std::sort(region.samples.begin(), region.samples.end());
        region.middle = middle_of(grid, region.samples);
        regions.push_back(std::move(region));
    }
    std::stable_sort(regions.begin(), regions.end(),
                     [](const SampleRegion& a, const SampleRegion& b) {
                         return a.samples.size() > b.samples.size();
                     });
    return regions;
}

}  // namespace balcony::analyse
