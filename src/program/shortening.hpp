// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Shorter programs for tiles. Where interval arithmetic over a tile decides a condition, a smaller
// or larger value, or that nothing wraps around, the other branches need no instructions, and what
// is left may vary by column or row alone. The values stay the same to the last bit. M. J. Keeter,
// "Massively Parallel Rendering of Complex Closed-Form Implicit Surfaces", 2020, shortens the
// formulas of surfaces in this way.

#include <array>
#include <cstdint>
#include <memory>
#include <shared_mutex>
#include <span>
#include <vector>

#include "balcony/program.hpp"

namespace balcony::program {

/// The formulas of a program for grids and the tapes that have been made of them for tiles. Many
/// threads may use it at a time.
class Shortening {
public:
    /// Null if no formula has a branch that changes within a tile, and for very large programs. The
    /// copy of the roots is not simplified.
    [[nodiscard]] static std::shared_ptr<const Shortening> make(std::span<const expr::Expr> roots,
                                                                const Interface& interface,
                                                                std::size_t instructions);

    /// A tape with fewer instructions at every point than the whole one has, which has this many;
    /// null if there is none for the tile.
    [[nodiscard]] std::shared_ptr<const Tape> tape_for(const Tile& tile) const;

private:
    /// What stands for a branching node in a tile: one of its arguments, or a constant.
    enum class Decision : std::uint8_t { open, argument_0, argument_1, argument_2, never, always };

    /// A node that branches depend on.
    struct Step {
        const expr::Node* node;
        std::array<std::uint32_t, expr::Node::max_operands> arguments;  ///< Earlier steps.
        bool branches;
    };

    /// The tape for the tiles with these decisions; null if it is not shorter.
    struct Shortened {
        std::vector<Decision> decisions;
        std::shared_ptr<const Tape> tape;
    };

    explicit Shortening(const Interface& interface, std::size_t instructions)
        : interface_(interface), instructions_(instructions) {}
    [[nodiscard]] bool may_branch(expr::NodeId id, const expr::Rates& rates) const;
    [[nodiscard]] expr::Range leaf_range(const expr::Node& leaf, const Tile& tile) const;
    [[nodiscard]] static Decision decision(expr::Op op, const expr::Range& range,
                                           const expr::Range* arguments);
    [[nodiscard]] std::vector<Decision> decide(const Tile& tile) const;
    [[nodiscard]] const Shortened* find(const std::vector<Decision>& decisions) const;
    [[nodiscard]] std::shared_ptr<const Tape> shortened(
        const std::vector<Decision>& decisions) const;

    expr::Graph graph_;
    std::vector<expr::Expr> roots_;
    Interface interface_;
    std::size_t instructions_;
    std::vector<Step> steps_;
    std::vector<expr::NodeId> branches_;  ///< In the order of the decisions.

    mutable std::shared_mutex mutex_;
    mutable std::vector<Shortened> made_;
};

}  // namespace balcony::program
