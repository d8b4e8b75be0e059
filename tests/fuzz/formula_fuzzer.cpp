// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Any bytes, as choices → a formula → the graph, the simplifier and the runners of all instruction
// sets, against the plain definitions of its operations.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

#include "../expr/formula_trial.hpp"
#include "../program/support.hpp"
#include "balcony/program.hpp"
#include "demand.hpp"

namespace {

using namespace balcony;
using program::Program;
using program::Sampling;

// Numbers below a count from the next bytes, as few as the count needs; 0 behind the last one.
class Choices {
public:
    Choices(const std::uint8_t* bytes, std::size_t count) : next_(bytes), end_(bytes + count) {}

    std::size_t operator()(std::size_t count) {
        std::size_t value = 0;
        for (std::size_t most = count - 1; most > 0; most >>= 8U) {
            value = (value << 8U) | (next_ == end_ ? 0U : *next_++);
        }
        return value % count;
    }

private:
    const std::uint8_t* next_;
    const std::uint8_t* end_;
};

// A tile of picture points with values for lens, one in all, and shutter, one for each point.
class Grid {
public:
    explicit Grid(const expr::Choice& below)
        : lens_(number(below)), shutter_(width * (6 + below(3))) {
        std::generate(shutter_.begin(), shutter_.end(), [&] { return number(below); });
        tile_ = {number(below), number(below),           number(below),
                 width,         shutter_.size() / width, number(below)};
        for (std::size_t i = 0; i < shutter_.size(); ++i) {
            x_.push_back(tile_.column(i % width));
            y_.push_back(tile_.row(i / width));
            values_.push_back({expr::InputValue{"lens", lens_}, {"shutter", shutter_[i]}});
        }
        inputs_ = {std::span(&lens_, 1), shutter_};
    }
    Grid(const Grid&) = delete;
    Grid& operator=(const Grid&) = delete;

    [[nodiscard]] std::size_t size() const { return shutter_.size(); }
    [[nodiscard]] expr::Point point(std::size_t i) const {
        return {x_[i], y_[i], tile_.time, {}, values_[i]};
    }
    // What a program gives on an instruction set, over the tile or for its points.
    [[nodiscard]] program::Results run(const Program& made, std::size_t set) const {
        program::Results results(made, size());
        program::Scratch scratch;
        if (made.sampling() == Sampling::grid) {
            program::Tile tile = tile_;
            tile.inputs = inputs_;
            program::run_on(set, made, tile, scratch, results.pointers());
        } else {
            run_points(set, made, scratch, results.pointers().front());
        }
        return results;
    }

private:
    void run_points(std::size_t set, const Program& made, program::Scratch& scratch,
                    double* values) const {
        for (std::size_t begin = 0; begin < size(); begin += program::max_points) {
            const std::size_t count = std::min(program::max_points, size() - begin);
            const auto part = [&](std::span<const double> all) {
                return all.subspan(begin, count);
            };
            const std::array inputs{inputs_[0], part(inputs_[1])};
            const std::array places{values + begin};
            program::run_on(set, made, {part(x_), part(y_), tile_.time, inputs}, scratch, places);
        }
    }

    // More than a register of any instruction set, and no multiple of one; with its rows, enough
    // points for a program to be shortened.
    static constexpr std::size_t width = 11;

    static double number(const expr::Choice& below) {
        constexpr std::size_t steps = 256;
        return 6.0 * static_cast<double>(below(steps)) / static_cast<double>(steps) - 3.0;
    }

    double lens_;
    std::vector<double> shutter_;
    program::Tile tile_;
    std::vector<double> x_;
    std::vector<double> y_;
    std::vector<std::array<expr::InputValue, 2>> values_;
    std::array<std::span<const double>, 2> inputs_;
};

Program compiled(expr::Expr root, Sampling sampling) {
    Result<Program> made =
        Program::make(std::span(&root, 1),
                      {sampling, {{"lens", expr::Rate::uniform}, {"shutter", expr::Rate::pixel}}});
    demand(made.value.has_value(), "a formula is not compiled");
    return std::move(*made);
}

// As compiled() simplifies it for a tile.
expr::Expr simplified(expr::Expr root) {
    expr::Rates rates;
    rates.declare(expr::InputId(root.graph().input("shutter").node().detail), expr::Rate::pixel);
    return expr::simplify(std::span(&root, 1), rates).front();
}

void try_runners(const expr::Formula& formula, const Grid& grid) {
    expr::Graph graph;
    const expr::Expr root = expr::build(graph, formula);
    const expr::Expr simple = simplified(root);
    const Program over_tile = compiled(root, Sampling::grid);
    const Program for_points = compiled(root, Sampling::points);
    for (std::size_t set = 0; set < program::instruction_sets().size(); ++set) {
        const program::Results tile = grid.run(over_tile, set);
        const program::Results points = grid.run(for_points, set);
        demand(tile.rim_intact() && points.rim_intact(), "a runner writes beside its results");
        for (std::size_t i = 0; i < grid.size(); ++i) {
            demand(program::identical(tile[0][i], points[0][i]), "tile and points differ");
            const expr::Bounded wanted = expr::evaluate_bounded(simple, grid.point(i));
            // The bound is of first order: twice as much leaves room for the second.
            demand(!expr::has_enough_digits(wanted.value, wanted.error) ||
                       std::fabs(tile[0][i] - wanted.value) <= 2.0 * wanted.error,
                   "a runner gives another value");
        }
    }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count) {
    Choices choices(bytes, count);
    const expr::Choice below = [&choices](std::size_t most) { return choices(most); };
    const expr::Trial trial(below);
    const Grid grid(below);
    const expr::Formula formula = expr::grown_formula(below, 1 + below(40));
    demand_no(trial(formula).failure);
    try_runners(formula, grid);
    return 0;
}
