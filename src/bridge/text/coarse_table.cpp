// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/coarse_table.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace balcony::bridge {

namespace {

using expr::Table;

// Cubic pieces with the values and slopes of a table at equal steps.
Table resampled(const Table& table, const Table& derivative, std::size_t cells) {
    const Table::Axis& axis = table.axes.front();
    std::vector<double> values;
    std::vector<double> slopes;
    for (std::size_t i = 0; i <= cells; ++i) {
        const double x = axis.first + (axis.last - axis.first) * static_cast<double>(i) /
                                          static_cast<double>(cells);
        values.push_back(table(x));
        slopes.push_back(derivative(x));
    }
    return expr::hermite_table(axis.first, axis.last, values, slopes);
}

double largest_value(const Table& table, std::size_t samples) {
    const Table::Axis& axis = table.axes.front();
    double largest = 0.0;
    for (std::size_t i = 0; i <= samples; ++i) {
        largest = std::max(
            largest, std::abs(table(axis.first + (axis.last - axis.first) * static_cast<double>(i) /
                                                     static_cast<double>(samples))));
    }
    return largest;
}

double largest_difference(const Table& a, const Table& b, std::size_t samples) {
    const Table::Axis& axis = a.axes.front();
    double largest = 0.0;
    for (std::size_t i = 0; i < samples; ++i) {
        const double x = axis.first + (axis.last - axis.first) * (static_cast<double>(i) + 0.5) /
                                          static_cast<double>(samples);
        largest = std::max(largest, std::abs(a(x) - b(x)));
    }
    return largest;
}

}  // namespace

std::shared_ptr<const Table> coarse_table(const std::shared_ptr<const Table>& table) {
    if (table->axes.size() != 1 || table->axes.front().degree == 0) {
        return table;
    }
    const Table derivative = table->derivative(0);
    const std::size_t samples = 4 * table->axes.front().cells;
    const double tolerance = 4.0 * static_cast<double>(std::numeric_limits<float>::epsilon()) *
                             largest_value(*table, samples);
    std::shared_ptr<const Table> coarse = table;
    for (std::size_t cells = table->axes.front().cells / 2; cells >= 1; cells /= 2) {
        Table fewer = resampled(*table, derivative, cells);
        if (!(largest_difference(*table, fewer, samples) <= tolerance)) {
            break;
        }
        coarse = std::make_shared<const Table>(std::move(fewer));
    }
    return coarse;
}

}  // namespace balcony::bridge
