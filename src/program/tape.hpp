// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <deque>
#include <memory>
#include <vector>

#include "balcony/program.hpp"
#include "program/kernel.hpp"
#include "program/shortening.hpp"

namespace balcony::program {

/// How a native function is called: with registers for its arguments and for all of its results.
struct NativeCall {
    std::shared_ptr<const expr::Native> function;
    std::vector<Operand> arguments;
    std::vector<std::uint32_t> results;  ///< Offsets.
};

/// A compiled program: four lists of instructions over one block of registers, all positions in
/// doubles from its start. Uniform values are replicated over register_alignment doubles; column
/// values hold one double for each column of a tile, row values one for each row, pixel values one
/// for each point of the current row. A row value that pixel instructions read is replicated anew
/// for each row. In a tape for points all registers are uniform or pixel, and the points are one
/// row.
struct Tape {
    struct Constant {
        std::uint32_t offset;
        double value;
    };
    struct Replication {
        std::uint32_t row_value;
        std::uint32_t replicated;
    };
    /// A register that the runner fills in.
    struct Input {
        /// Which input: one that every graph has, or a declared one by its place in the interface.
        enum Source : std::uint32_t { x, y, time, first_declared };
        std::uint32_t source;
        Rate rate;
        std::uint32_t offset;
    };
    struct Root {
        Rate rate;
        std::uint32_t offset;
        bool made_in_place;  ///< Whether its instruction writes directly to the caller's array.
    };

    Interface interface;
    std::array<std::vector<Instruction>, 4> sections;  ///< Indexed by Rate, in running order.
    std::vector<Constant> constants;
    std::vector<Input> inputs;  ///< Those that the program reads.
    std::vector<Replication> replications;
    std::vector<Root> roots;
    std::uint32_t repeated = 0;  ///< Where arguments of natives that do not vary are repeated.
    std::size_t register_doubles = 0;

    std::vector<std::shared_ptr<const expr::Table>> tables;
    std::deque<TableView> table_views;    ///< One for each table; instructions point to them.
    std::deque<NativeCall> native_calls;  ///< One for each call; instructions point to them.

    std::shared_ptr<const Shortening> shortening;  ///< Null if no tile has a shorter tape.

    [[nodiscard]] const std::vector<Instruction>& section(Rate rate) const {
        return sections[static_cast<std::size_t>(rate)];
    }
};

/// Compiles roots without simplifying them. They have no free variable, and the
/// interface declares every input that they depend on.
[[nodiscard]] std::shared_ptr<Tape> compile(std::span<const expr::Expr> roots,
                                            const Interface& interface);

/// Whether a program can run over it: for what it is compiled, with which inputs.
[[nodiscard]] bool fits(const Program& program, const Tile& tile);
[[nodiscard]] bool fits(const Program& program, const Points& points);

/// The rates of a graph's inputs by the interface.
[[nodiscard]] expr::Rates rates_of(const expr::Graph& graph, const Interface& interface);

}  // namespace balcony::program
