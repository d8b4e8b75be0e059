// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Tiles and lists of points of any size, run in parts that the registers can hold.

#include <algorithm>

#include "base/precondition.hpp"
#include "program/tape.hpp"

namespace balcony::program {

namespace {

// The part of a tile whose first point is (x, y), with its share of the inputs.
class TilePart {
public:
    TilePart(const Program& program, const Tile& whole, std::size_t x, std::size_t y)
        : x_(x), y_(y), tile_(whole), gathered_(whole.inputs.size()) {
        tile_.x = whole.x + static_cast<double>(x) * whole.step;
        tile_.y = whole.y + static_cast<double>(y) * whole.step;
        tile_.width = std::min(max_tile_width, whole.width - x);
        tile_.height = std::min(max_tile_height, whole.height - y);
        for (std::size_t k = 0; k < whole.inputs.size(); ++k) {
            inputs_.push_back(
                share(program.inputs()[k].rate, whole.inputs[k], whole.width, gathered_[k]));
        }
        tile_.inputs = inputs_;
    }

    [[nodiscard]] const Tile& tile() const { return tile_; }

    /// Copies a root's values to their places in the whole tile.
    void scatter(const double* values, double* whole, std::size_t whole_width) const {
        for (std::size_t j = 0; j < tile_.height; ++j) {
            std::copy_n(values + j * tile_.width, tile_.width, whole + (y_ + j) * whole_width + x_);
        }
    }

private:
    std::span<const double> share(Rate rate, std::span<const double> values,
                                  std::size_t whole_width, std::vector<double>& gathered) const {
        switch (rate) {
            case Rate::uniform: break;
            case Rate::column: return values.subspan(x_, tile_.width);
            case Rate::row: return values.subspan(y_, tile_.height);
            case Rate::pixel:
                for (std::size_t j = 0; j < tile_.height; ++j) {
                    const auto row = values.subspan((y_ + j) * whole_width + x_, tile_.width);
                    gathered.insert(gathered.end(), row.begin(), row.end());
                }
                return gathered;
        }
        return values;
    }

    std::size_t x_;
    std::size_t y_;
    Tile tile_;
    std::vector<std::vector<double>> gathered_;  // Of the inputs that have a value by point.
    std::vector<std::span<const double>> inputs_;
};

constexpr auto not_compiled_for = "a program runs over what it is compiled for";

}  // namespace

void run(const Program& program, const Tile& tile, Scratch& scratch,
         std::span<double* const> results) {
    precondition(fits(program, tile) && results.size() == program.root_count(), not_compiled_for);
    if (tile.width <= max_tile_width && tile.height <= max_tile_height) {
        run_on(0, program, tile, scratch, results);
        return;
    }
    ResultArrays values;
    for (std::size_t y = 0; y < tile.height; y += max_tile_height) {
        for (std::size_t x = 0; x < tile.width; x += max_tile_width) {
            const TilePart part(program, tile, x, y);
            run_on(0, program, part.tile(), scratch,
                   values.reserve(results.size(), max_tile_width * max_tile_height));
            for (std::size_t root = 0; root < results.size(); ++root) {
                part.scatter(values[root], results[root], tile.width);
            }
        }
    }
}

void run(const Program& program, const Points& points, Scratch& scratch,
         std::span<double* const> results) {
    precondition(fits(program, points) && results.size() == program.root_count(), not_compiled_for);
    if (points.x.size() <= max_points) {
        run_on(0, program, points, scratch, results);
        return;
    }
    std::vector<double*> places(results.begin(), results.end());
    for (std::size_t begin = 0; begin < points.x.size(); begin += max_points) {
        const std::size_t count = std::min(max_points, points.x.size() - begin);
        std::vector<std::span<const double>> inputs(points.inputs.begin(), points.inputs.end());
        for (std::size_t k = 0; k < inputs.size(); ++k) {
            if (program.inputs()[k].rate != Rate::uniform) {
                inputs[k] = inputs[k].subspan(begin, count);
            }
        }
        run_on(
            0, program,
            {points.x.subspan(begin, count), points.y.subspan(begin, count), points.time, inputs},
            scratch, places);
        for (double*& place : places) {
            place += count;
        }
    }
}

}  // namespace balcony::program
