// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows of rays as numbers, computed in parallel and passed on in their order.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <stop_token>
#include <string>
#include <utility>
#include <vector>

#include <tbb/enumerable_thread_specific.h>

#include "balcony/ray_maps.hpp"
#include "bridge/maps/in_order.hpp"

namespace balcony::bridge {

/// The rays of some rows.
template <class Number>
struct RayRows {
    RowSpan span;
    std::size_t valid = 0;       ///< Rays of these rows.
    std::vector<Number> values;  ///< Ray by ray, with all columns of a ray together.
    std::string text;            ///< What `prepare` made of them.
};

/// Computes rows of rays in parallel, and what `prepare(rows)` makes of them; `use(rows)` receives
/// them one after the other in their order, and returns false to end the run.
template <class Number>
class RowRun {
public:
    RowRun(const RayGrid& grid, std::vector<RayColumn> columns)
        : grid_(grid), columns_(std::move(columns)) {}

    using Prepare = std::function<void(RayRows<Number>&)>;
    using Use = std::function<bool(const RayRows<Number>&)>;

    [[nodiscard]] RaysWritten operator()(const Prepare& prepare, const Use& use,
                                         const std::stop_token& stop) {
        RaysWritten written;
        written.complete = run_in_order<RayRows<Number>>(
            grid_.width(), grid_.height(),
            [&](const RowSpan& span) {
                RayRows<Number> rows = compute(span);
                prepare(rows);
                return rows;
            },
            [&](const RayRows<Number>& rows) {
                const bool used = use(rows);
                written.rays += used ? rows.span.count * grid_.width() : 0;
                written.valid += used ? rows.valid : 0;
                return used;
            },
            stop);
        return written;
    }

private:
    struct Memory {
        rays::Scratch scratch;
        rays::RayBatch rays;
    };

    RayRows<Number> compute(const RowSpan& span) {
        RayRows<Number> rows{span, 0, {}, {}};
        rows.values.resize(span.count * grid_.width() * columns_.size());
        Memory& memory = memory_.local();
        for (std::size_t x = 0; x < grid_.width(); x += program::max_tile_width) {
            const std::size_t width = std::min(program::max_tile_width, grid_.width() - x);
            grid_.run(x, span.first, width, span.count, memory.scratch, memory.rays);
            for (std::size_t y = 0; y < span.count; ++y) {
                Number* to = rows.values.data() + (y * grid_.width() + x) * columns_.size();
                rows.valid += put(memory.rays, y * width, width, to);
            }
        }
        return rows;
    }

    // Returns how many of the rays are valid.
    std::size_t put(const rays::RayBatch& rays, std::size_t first, std::size_t count,
                    Number* to) const {
        std::size_t valid = 0;
        for (std::size_t i = first; i < first + count; ++i) {
            const bool there = rays.valid(i);
            valid += there ? 1 : 0;
            for (const RayColumn& column : columns_) {
                *to++ = there ? static_cast<Number>(column.value(rays, i)) : Number{0};
            }
        }
        return valid;
    }

    const RayGrid& grid_;
    std::vector<RayColumn> columns_;
    tbb::enumerable_thread_specific<Memory> memory_;
};

}  // namespace balcony::bridge
