// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Connected regions of samples.

#include <cstddef>
#include <functional>
#include <vector>

#include "balcony/diagnose.hpp"

namespace balcony::analyse {

/// Samples connected through their four neighbours.
struct SampleRegion {
    std::vector<std::size_t> samples;  ///< Row by row.
    std::size_t middle = 0;            ///< The sample nearest to the mean position.
};

/// Whether a sample is in a region; whether two neighbouring samples are connected.
using SampleTest = std::function<bool(std::size_t)>;
using PairTest = std::function<bool(std::size_t, std::size_t)>;

/// The largest first.
[[nodiscard]] std::vector<SampleRegion> find_regions(const SampleGrid& grid,
                                                     const SampleTest& inside,
                                                     const PairTest& connected);

/// The up to four neighbours of a sample.
[[nodiscard]] std::vector<std::size_t> neighbours(const SampleGrid& grid, std::size_t sample);

}  // namespace balcony::analyse
