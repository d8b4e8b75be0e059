// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/parameter_range.hpp"

#include <algorithm>
#include <array>

namespace balcony::bridge {

// A stage that takes a number from a to b writes min(max(number, a), b).
ParameterRange range_of(const CameraFormulas& formulas, std::string_view input) {
    const expr::Graph& graph = *formulas.graph;
    ParameterRange range;
    std::vector<bool> limited(graph.size(), false);
    for (const expr::NodeId id : expr::reachable(graph, formulas.roots)) {
        const expr::Node& node = graph[id];
        if (node.op == Op::input) {
            limited[id.value()] = graph.input_names()[node.detail] == input;
        }
        if (node.op != Op::minimum && node.op != Op::maximum) {
            continue;
        }
        const std::array operands{node.operands[0], node.operands[1]};
        for (std::size_t i = 0; i < operands.size(); ++i) {
            const expr::Node& limit = graph[operands[1 - i]];
            if (!limited[operands[i].value()] || limit.op != Op::constant) {
                continue;
            }
            limited[id.value()] = true;
            if (node.op == Op::maximum) {
                range.minimum = std::max(range.minimum.value_or(limit.value), limit.value);
            } else {
                range.maximum = std::min(range.maximum.value_or(limit.value), limit.value);
            }
        }
    }
    return range;
}

}  // namespace balcony::bridge
