// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows of a picture, computed in parallel and passed on in their order.

#include <algorithm>
#include <cstddef>
#include <memory>
#include <stop_token>

#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include "balcony/program.hpp"

namespace balcony::bridge {

/// Some whole rows of a picture.
struct RowSpan {
    std::size_t first = 0;
    std::size_t count = 0;
};

/// use(compute(rows)) for all rows of a picture, from top to bottom. Parts are computed in
/// parallel; a few hundred thousand pixels are in memory at a time. Ends early if `use` returns
/// false or if it is stopped; returns whether it did not.
template <class Made, class Compute, class Use>
bool run_in_order(std::size_t width, std::size_t height, const Compute& compute, const Use& use,
                  const std::stop_token& stop) {
    // Enough rows that what depends on the column alone is shared, in bounded memory.
    constexpr std::size_t pixels_at_once = std::size_t{1} << 17U;
    const std::size_t rows =
        std::clamp<std::size_t>(pixels_at_once / width, 1, program::max_tile_height);
    std::size_t next = 0;
    std::size_t done = 0;
    bool refused = false;
    using Part = std::unique_ptr<Made>;
    const auto begin = [&](tbb::flow_control& control) {
        if (next == height || refused || stop.stop_requested()) {
            control.stop();
            return RowSpan{};
        }
        const RowSpan span{next, std::min(rows, height - next)};
        next += span.count;
        return span;
    };
    const auto make = [&](const RowSpan& span) { return std::make_unique<Made>(compute(span)); };
    const auto end = [&](const Part& made) {
        refused = refused || !use(*made);
        done += refused ? 0 : 1;
    };
    using tbb::filter_mode;
    tbb::parallel_pipeline(static_cast<std::size_t>(2 * tbb::info::default_concurrency()),
                           tbb::make_filter<void, RowSpan>(filter_mode::serial_in_order, begin) &
                               tbb::make_filter<RowSpan, Part>(filter_mode::parallel, make) &
                               tbb::make_filter<Part, void>(filter_mode::serial_in_order, end));
    return done == (height + rows - 1) / rows;
}

}  // namespace balcony::bridge
