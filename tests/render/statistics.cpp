// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "statistics.hpp"

#include <cmath>
#include <numbers>

namespace balcony::render::test {

double chi_square_probability(std::span<const double> counts, std::span<const double> expected) {
    constexpr double min_expected = 5.0;
    double statistic = 0.0;
    double cells = 0.0;
    double few_counts = 0.0;
    double few_expected = 0.0;
    const auto add_cell = [&](double count, double mean) {
        statistic += (count - mean) * (count - mean) / mean;
        cells += 1.0;
    };
    for (std::size_t i = 0; i < counts.size(); ++i) {
        if (expected[i] < min_expected) {
            few_counts += counts[i];
            few_expected += expected[i];
        } else {
            add_cell(counts[i], expected[i]);
        }
    }
    if (few_expected >= min_expected) {
        add_cell(few_counts, few_expected);
    }
    // Wilson and Hilferty (1931): the cube root of chi-square over its degrees of freedom is nearly
    // normal; at 30 degrees the error at this significance is below a tenth of it.
    const double freedom = cells - 1.0;
    const double spread = 2.0 / (9.0 * freedom);
    const double z = (std::cbrt(statistic / freedom) - (1.0 - spread)) / std::sqrt(spread);
    return 0.5 * std::erfc(z / std::numbers::sqrt2);
}

}  // namespace balcony::render::test
