// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>

namespace balcony::expr {

/// Nodes are few if the graph has this many times as many: searching among them is then faster than
/// an array with a place for every node of the graph.
inline constexpr std::size_t few_of_a_graph = 64;

}  // namespace balcony::expr
