// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Approximates a movement by linear pieces of equal duration.

#include <algorithm>
#include <cstddef>
#include <vector>

#include "balcony/motion.hpp"

namespace balcony::scene {

namespace detail {

// Whether every sample is within the tolerance of the straight line between those of the steps
// around it.
template <class Value, class Deviation>
bool is_linear_between(const std::vector<Value>& samples, std::size_t stride,
                       const Deviation& deviation, double tolerance) {
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const std::size_t before = i / stride * stride;
        if (i == before) {
            continue;
        }
        const double part = static_cast<double>(i - before) / static_cast<double>(stride);
        if (!(deviation(samples[i], samples[before], samples[before + stride], part) <=
              tolerance)) {
            return false;
        }
    }
    return true;
}

}  // namespace detail

/// The fewest values at(part), of equal steps of the part from 0 to 1, between which the movement
/// is linear within a tolerance: 1 if nothing moves, otherwise a power of 2 and 1, up to `largest`.
/// The movement is looked at in at least `pieces` pieces. deviation(value, a, b, part) is the
/// distance of a value from (1 - part) a + part b.
template <class At, class Deviation>
auto equal_steps(const At& at, const Deviation& deviation, double tolerance, std::size_t pieces,
                 std::size_t largest = max_steps) {
    using Value = decltype(at(0.0));
    const std::size_t most = largest - 1;
    std::vector<Value> samples{at(0.0), at(1.0)};
    const auto refine = [&] {
        const std::size_t count = 2 * (samples.size() - 1);
        std::vector<Value> finer;
        finer.reserve(count + 1);
        for (std::size_t i = 0; i <= count; ++i) {
            finer.push_back(i % 2 == 0 ? std::move(samples[i / 2])
                                       : at(static_cast<double>(i) / static_cast<double>(count)));
        }
        samples = std::move(finer);
    };
    while (samples.size() <= std::min(std::max<std::size_t>(2 * pieces, 4), most)) {
        refine();
    }
    while (samples.size() <= most && !detail::is_linear_between(samples, 2, deviation, tolerance)) {
        refine();
    }
    // What only rounding moves stands still.
    constexpr double rounding = 1e-6;
    const bool moves = std::any_of(samples.begin(), samples.end(), [&](const Value& value) {
        return deviation(value, samples.front(), samples.front(), 0.0) > rounding * tolerance;
    });
    std::size_t stride = samples.size() - 1;
    while (stride > 1 && !detail::is_linear_between(samples, stride, deviation, tolerance)) {
        stride /= 2;
    }
    std::vector<Value> steps;
    for (std::size_t i = 0; i < samples.size(); i += stride) {
        steps.push_back(std::move(samples[i]));
    }
    steps.resize(moves ? steps.size() : 1);
    return steps;
}

}  // namespace balcony::scene
