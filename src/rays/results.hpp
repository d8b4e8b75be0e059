// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "balcony/expr.hpp"
#include "balcony/progress.hpp"

namespace balcony::rays {

/// The value of a result, if it has one; its diagnostics are appended to the others.
template <class Value>
[[nodiscard]] std::optional<Value> take(Result<Value> result, Diagnostics& diagnostics) {
    std::move(result.diagnostics.begin(), result.diagnostics.end(),
              std::back_inserter(diagnostics));
    return std::move(result.value);
}

/// The result of `make(graph)`, or an error if it writes more operations than a graph can contain,
/// after a stop, and of a picture without pixels.
template <class Made, class Make>
[[nodiscard]] Result<Made> within_limits(std::string_view what, const std::string& name,
                                         std::array<double, 2> size, const std::stop_token& stop,
                                         const Make& make) {
    const auto [width, height] = size;
    if (!(width > 0.0 && height > 0.0 && std::isfinite(width) && std::isfinite(height))) {
        return error(fmt::format("a picture of {} x {} pixels is empty", width, height), {},
                     "give a positive width and height");
    }
    expr::Graph graph(stop);
    try {
        return make(graph);
    } catch (const expr::GraphStopped&) {
        return stopped();
    } catch (const expr::GraphTooLarge&) {
        return error(fmt::format("{} '{}' is too large: its formulas and their derivatives have "
                                 "more operations than a graph can contain",
                                 what, name),
                     {}, "repeat fewer stages, or use simpler ones");
    }
}

}  // namespace balcony::rays
