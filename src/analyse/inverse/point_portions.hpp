// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <mutex>
#include <span>
#include <utility>
#include <vector>

#include "analyse/measure/work.hpp"
#include "balcony/inverse.hpp"
#include "base/parallel_for.hpp"

namespace balcony::analyse {

/// The sightings that locate(points, in_part, work) finds of points, a portion of them at a time,
/// by all processors; what it adds to `in_part` are indices of points, too. The order is that of
/// the points, for any number of processors.
template <class Locate>
[[nodiscard]] std::vector<Sighting> locate_in_portions(std::span<const V3d> points,
                                                       std::vector<std::size_t>& in_part,
                                                       const Work& work, const Locate& locate) {
    constexpr std::size_t portion = 4096;
    if (points.size() <= portion) {
        return locate(points, in_part, work);
    }
    struct Portion {
        std::vector<Sighting> found;
        std::vector<std::size_t> in_part;
    };
    std::vector<Portion> portions((points.size() + portion - 1) / portion);
    std::mutex telling;
    std::size_t finished = 0;
    parallel_for(portions.size(), [&](std::size_t i) {
        work.go_on();
        const std::size_t begin = i * portion;
        const auto some = points.subspan(begin, std::min(portion, points.size() - begin));
        Portion& made = portions[i];
        made.found = locate(some, made.in_part, work.silent());
        for (Sighting& one : made.found) {
            one.point += begin;
        }
        for (std::size_t& one : made.in_part) {
            one += begin;
        }
        const std::lock_guard lock(telling);
        work.done(static_cast<double>(++finished) / static_cast<double>(portions.size()));
    });
    std::size_t count = 0;
    for (const Portion& one : portions) {
        count += one.found.size();
    }
    std::vector<Sighting> found;
    found.reserve(count);
    for (Portion& one : portions) {
        std::move(one.found.begin(), one.found.end(), std::back_inserter(found));
        in_part.insert(in_part.end(), one.in_part.begin(), one.in_part.end());
        one = {};
    }
    return found;
}

}  // namespace balcony::analyse
