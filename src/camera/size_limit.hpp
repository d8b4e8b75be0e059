// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "balcony/expr.hpp"

namespace balcony::camera {

/// The most operations of a camera, and of a picture. Derivatives multiply them, and a graph of
/// more than 4 million is refused.
inline constexpr std::size_t most_operations_of_camera = 250'000;
inline constexpr std::size_t most_operations_of_picture = 500'000;

/// Says so if `emit(graph)` writes more than so many operations, as repetitions of repetitions do.
template <class Emit>
[[nodiscard]] std::optional<Diagnostic> too_large(const std::string& what, std::size_t maximum,
                                                  Emit emit) {
    std::size_t operations = maximum + 1;
    try {
        expr::Graph graph;
        emit(graph);
        operations = graph.size();
    } catch (const std::length_error&) {
        // It did not even fit into a graph.
    }
    if (operations <= maximum) {
        return std::nullopt;
    }
    return error(
        fmt::format("{} is too large: its formulas have more than {} operations", what, maximum),
        {}, "repeat fewer stages");
}

}  // namespace balcony::camera
