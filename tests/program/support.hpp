// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "balcony/program.hpp"

namespace balcony::program {

/// The results of a program over a tile or some points, one array a root. Every array has a rim on
/// both sides that a runner must leave alone.
class Results {
public:
    Results(const Program& program, const Tile& tile)
        : Results(program, tile.width * tile.height) {}
    Results(const Program& program, std::size_t points)
        : points_(points),
          arrays_(program.root_count(), std::vector<double>(points_ + 2 * rim, untouched)) {
        for (std::vector<double>& array : arrays_) {
            pointers_.push_back(array.data() + rim);
        }
    }

    Results(Results&&) = default;
    Results& operator=(Results&&) = default;

    [[nodiscard]] std::span<double* const> pointers() const { return pointers_; }
    [[nodiscard]] const double* operator[](std::size_t root) const { return pointers_[root]; }

    [[nodiscard]] bool rim_intact() const {
        for (const std::vector<double>& array : arrays_) {
            for (std::size_t i = 0; i < rim; ++i) {
                if (array[i] != untouched || array[rim + points_ + i] != untouched) {
                    return false;
                }
            }
        }
        return true;
    }

private:
    static constexpr std::size_t rim = 17;  // more than a vector, and odd: arrays are unaligned
    static constexpr double untouched = -12345.6789;

    std::size_t points_;
    std::vector<std::vector<double>> arrays_;
    std::vector<double*> pointers_;
};

/// The same bits, or both NaN (which NaN is not specified).
inline bool identical(double a, double b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

/// How many doubles lie between two; infinite if one is NaN or infinite and the other is not.
inline double ulps_between(double a, double b) {
    if (a == b || (std::isnan(a) && std::isnan(b))) {
        return 0.0;
    }
    if (!std::isfinite(a) || !std::isfinite(b)) {
        return std::numeric_limits<double>::infinity();
    }
    const auto place = [](double x) {
        const auto bits = std::bit_cast<std::int64_t>(x);
        return bits < 0 ? std::numeric_limits<std::int64_t>::min() - bits : bits;
    };
    // Unsigned, as two places can lie further apart than the largest signed integer.
    const auto first = static_cast<std::uint64_t>(place(a));
    const auto second = static_cast<std::uint64_t>(place(b));
    return static_cast<double>(a < b ? second - first : first - second);
}

}  // namespace balcony::program
