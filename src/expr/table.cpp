// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>

#include "balcony/expr.hpp"

namespace balcony::expr {

double Table::operator()(double x) const {
    const auto count = static_cast<double>(cells.size());
    const double position = (x - first) * (count / (last - first));
    // Written so that a NaN takes cell 0 and stays a NaN through s.
    const double floored = std::floor(position);
    const double cell = floored > 0.0 ? std::min(floored, count - 1.0) : 0.0;
    const double s = position - cell;
    const auto& c = cells[static_cast<std::size_t>(cell)];
    return ((c[3] * s + c[2]) * s + c[1]) * s + c[0];
}

Table Table::derivative() const {
    const double scale = static_cast<double>(cells.size()) / (last - first);
    Table slopes{first, last, {}};
    slopes.cells.reserve(cells.size());
    for (const auto& c : cells) {
        slopes.cells.push_back({c[1] * scale, 2.0 * c[2] * scale, 3.0 * c[3] * scale, 0.0});
    }
    return slopes;
}

Table hermite_table(double first, double last, std::span<const double> values,
                    std::span<const double> slopes) {
    assert(values.size() >= 2 && values.size() == slopes.size());
    Table table{first, last, {}};
    const std::size_t count = values.size() - 1;
    const double width = (last - first) / static_cast<double>(count);
    table.cells.reserve(count);
    for (std::size_t i = 0; i < count; ++i) {
        const double rise = values[i + 1] - values[i];
        const double m0 = slopes[i] * width;
        const double m1 = slopes[i + 1] * width;
        table.cells.push_back({values[i], m0, 3.0 * rise - 2.0 * m0 - m1, m0 + m1 - 2.0 * rise});
    }
    return table;
}

}  // namespace balcony::expr
