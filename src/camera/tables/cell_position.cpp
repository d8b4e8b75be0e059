// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/tables/cell_position.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::camera {

bool CellPosition::equally_spaced(std::span<const double> breaks) {
    const auto cells = static_cast<double>(breaks.size() - 1);
    for (std::size_t i = 0; i < breaks.size(); ++i) {
        // Equally spaced knots differ by the rounding of their sums.
        if (std::fabs(breaks[i] * cells - static_cast<double>(i)) > 1e-12 * cells) {
            return false;
        }
    }
    return true;
}

double CellPosition::narrowest(std::span<const double> breaks) {
    double width = 1.0;
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        width = std::min(width, breaks[i + 1] - breaks[i]);
    }
    return width;
}

CellPosition::CellPosition(std::span<const double> breaks, bool closed)
    : cells_(static_cast<double>(breaks.size() - 1)), closed_(closed) {
    if (equally_spaced(breaks)) {
        return;
    }
    assert(narrowest(breaks) >= narrowest_cell);
    const auto buckets = static_cast<std::size_t>(std::ceil(1.0 / narrowest(breaks)));
    const double width = 1.0 / static_cast<double>(buckets);
    expr::Table at{{{0.0, 1.0, buckets, 0}}, {}};
    expr::Table before{{{0.0, 1.0, buckets, 1}}, {}};
    expr::Table behind{{{0.0, 1.0, buckets, 1}}, {}};
    std::size_t cell = 0;
    const auto add_line = [&](expr::Table& table, double begin, std::size_t number) {
        const double cell_width = breaks[number + 1] - breaks[number];
        table.coefficients.push_back(static_cast<double>(number) +
                                     (begin - breaks[number]) / cell_width);
        table.coefficients.push_back(width / cell_width);
    };
    for (std::size_t bucket = 0; bucket < buckets; ++bucket) {
        const double begin = static_cast<double>(bucket) * width;
        add_line(before, begin, cell);
        const bool ends_within = cell + 2 < breaks.size() && breaks[cell + 1] < begin + width;
        at.coefficients.push_back(breaks[cell + 1]);
        cell += ends_within ? 1 : 0;
        add_line(behind, begin, cell);
    }
    break_ = std::make_shared<const expr::Table>(std::move(at));
    before_ = std::make_shared<const expr::Table>(std::move(before));
    behind_ = std::make_shared<const expr::Table>(std::move(behind));
}

Expr CellPosition::operator()(Expr parameter, Emitter& emit) const {
    const Expr u = within_unit_range(parameter, closed_, emit);
    if (!break_) {
        return cells_ * u;
    }
    Graph& graph = emit.graph();
    return select(u < graph.lookup(break_, u), graph.lookup(before_, u), graph.lookup(behind_, u));
}

Expr within_unit_range(Expr parameter, bool closed, Emitter& emit) {
    if (closed) {
        return parameter - floor(parameter);
    }
    emit.require(0.0 <= parameter && parameter <= emit(1.0));
    return parameter;
}

}  // namespace balcony::camera
