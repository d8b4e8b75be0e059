// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rows of rays as numbers, computed in parallel and passed on in their order.

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <tbb/enumerable_thread_specific.h>
#include <tbb/info.h>
#include <tbb/parallel_pipeline.h>

#include "balcony/ray_maps.hpp"

namespace balcony::bridge {

/// Some whole rows of a picture.
template <class Number>
struct Rows {
    std::size_t first = 0;
    std::size_t count = 0;
    std::size_t valid = 0;       ///< Rays of these rows.
    std::vector<Number> values;  ///< Ray by ray, with all columns of a ray together.
    std::string text;            ///< What `prepare` made of them.
};

/// Computes rows of rays in parallel, and what `prepare(rows)` makes of them; `use(rows)` receives
/// them one after the other in their order, and returns false to end the run. A few hundred
/// thousand rays are in memory at a time.
template <class Number>
class RowRun {
public:
    RowRun(const RayGrid& grid, std::vector<RayColumn> columns)
        : grid_(grid), columns_(std::move(columns)) {}

    using Prepare = std::function<void(Rows<Number>&)>;
    using Use = std::function<bool(const Rows<Number>&)>;

    [[nodiscard]] RaysWritten operator()(const Prepare& prepare, const Use& use,
                                         const std::stop_token& stop) {
        // Enough rows that what depends on the column alone is shared, in bounded memory.
        constexpr std::size_t rays_at_once = std::size_t{1} << 17U;
        const std::size_t count =
            std::clamp<std::size_t>(rays_at_once / grid_.width(), 1, program::max_tile_height);
        RaysWritten written;
        std::size_t next = 0;
        bool refused = false;
        using Block = std::unique_ptr<Rows<Number>>;
        const auto begin = [&](tbb::flow_control& control) -> Block {
            if (next == grid_.height() || refused || stop.stop_requested()) {
                control.stop();
                return nullptr;
            }
            auto rows = std::make_unique<Rows<Number>>();
            rows->first = next;
            rows->count = std::min(count, grid_.height() - next);
            next += rows->count;
            return rows;
        };
        const auto compute = [&](Block rows) {
            fill(*rows);
            prepare(*rows);
            return rows;
        };
        const auto end = [&](const Block& rows) {
            refused = refused || !use(*rows);
            written.rays += refused ? 0 : rows->count * grid_.width();
            written.valid += refused ? 0 : rows->valid;
        };
        const auto blocks = static_cast<std::size_t>(2 * tbb::info::default_concurrency());
        tbb::parallel_pipeline(
            blocks, tbb::make_filter<void, Block>(tbb::filter_mode::serial_in_order, begin) &
                        tbb::make_filter<Block, Block>(tbb::filter_mode::parallel, compute) &
                        tbb::make_filter<Block, void>(tbb::filter_mode::serial_in_order, end));
        written.complete = written.rays == grid_.size();
        return written;
    }

private:
    struct Memory {
        rays::Scratch scratch;
        rays::RayBatch rays;
    };

    void fill(Rows<Number>& rows) {
        rows.values.resize(rows.count * grid_.width() * columns_.size());
        Memory& memory = memory_.local();
        for (std::size_t x = 0; x < grid_.width(); x += program::max_tile_width) {
            const std::size_t width = std::min(program::max_tile_width, grid_.width() - x);
            grid_.run(x, rows.first, width, rows.count, memory.scratch, memory.rays);
            for (std::size_t y = 0; y < rows.count; ++y) {
                Number* to = rows.values.data() + (y * grid_.width() + x) * columns_.size();
                rows.valid += put(memory.rays, y * width, width, to);
            }
        }
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
