// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/tables/grey_table.hpp"

#include <algorithm>
#include <array>
#include <cstddef>

namespace balcony::camera {

std::shared_ptr<const expr::Table> grey_table(const GreyImage& image, bool invert) {
    const auto grey = [&](std::size_t x, std::size_t y) {
        const std::size_t column = std::min(x, image.width - 1);
        const std::size_t row = std::min(y, image.height - 1);
        const double value = image.values[row * image.width + column];
        return invert ? 1.0 - value : value;
    };
    auto table = std::make_shared<expr::Table>();
    for (const std::size_t pixels : {image.width, image.height}) {
        const std::size_t cells = std::max<std::size_t>(pixels, 2) - 1;
        table->axes.push_back({0.0, static_cast<double>(cells), cells, 1});
    }
    for (std::size_t x = 0; x < table->axes[0].cells; ++x) {
        for (std::size_t y = 0; y < table->axes[1].cells; ++y) {
            const double here = grey(x, y);
            const double below = grey(x, y + 1) - here;
            const double right = grey(x + 1, y) - here;
            const double both = grey(x + 1, y + 1) - here - below - right;
            table->coefficients.insert(table->coefficients.end(), {here, below, right, both});
        }
    }
    return table;
}

expr::Expr grey_at(const std::shared_ptr<const expr::Table>& grey, expr::Expr x, expr::Expr y) {
    expr::Graph& graph = x.graph();
    const auto within = [&graph](expr::Expr fraction, const expr::Table::Axis& axis) {
        const double count = static_cast<double>(axis.cells) + 1.0;
        return min(max(fraction * count - 0.5, graph.constant(0.0)), graph.constant(count - 1.0));
    };
    const std::array at{within(x, grey->axes[0]), within(y, grey->axes[1])};
    return graph.lookup(grey, at);
}

}  // namespace balcony::camera
