// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows of a picture, computed in parallel and passed on in their order.

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <optional>
#include <stop_token>
#include <vector>

#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include "balcony/program.hpp"
#include "base/tsan.hpp"

namespace balcony::bridge {

/// Some whole rows of a picture.
struct RowSpan {
    std::size_t first = 0;
    std::size_t count = 0;
};

namespace detail {

inline char rows_begun = 0;
inline char rows_made = 0;

}  // namespace detail

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
    const std::size_t count = (height + rows - 1) / rows;
    std::vector<std::optional<Made>> parts(count);
    std::size_t begun = 0;
    std::size_t done = 0;
    std::atomic<bool> refused = false;  // Also read where parts begin.
    const auto begin = [&](tbb::flow_control& control) {
        if (begun == count || refused || stop.stop_requested()) {
            control.stop();
            return begun;
        }
        return begun++;
    };
    const auto make = [&](std::size_t part) {
        const std::size_t first = part * rows;
        parts[part].emplace(compute(RowSpan{first, std::min(rows, height - first)}));
        return part;
    };
    const auto end = [&](std::size_t part) {
        refused = refused || !use(*parts[part]);
        done += refused ? 0 : 1;
        parts[part].reset();
    };
    using tbb::filter_mode;
    using tsan::ordered;
    using Part = std::size_t;
    tsan::release(detail::rows_begun);
    tbb::parallel_pipeline(
        static_cast<std::size_t>(2 * tbb::info::default_concurrency()),
        tbb::make_filter<void, Part>(filter_mode::serial_in_order,
                                     ordered<detail::rows_begun, detail::rows_begun>(begin)) &
            tbb::make_filter<Part, Part>(filter_mode::parallel,
                                         ordered<detail::rows_begun, detail::rows_made>(make)) &
            tbb::make_filter<Part, void>(filter_mode::serial_in_order,
                                         ordered<detail::rows_made, detail::rows_made>(end)));
    tsan::acquire(detail::rows_begun);
    tsan::acquire(detail::rows_made);
    return done == count;
}

}  // namespace balcony::bridge
