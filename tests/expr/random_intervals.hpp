// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <span>
#include <vector>

#include "balcony/operations.hpp"

namespace balcony::expr {

/// Numbers at which operations change their behaviour, and others as large.
inline constexpr std::array special_numbers{-std::numeric_limits<double>::infinity(),
                                            -1.7e308,
                                            -1e200,
                                            -720.0,
                                            -30.0,
                                            -3.5,
                                            -2.0,
                                            -1.0,
                                            -0.5,
                                            -1e-9,
                                            -1e-310,
                                            -0.0,
                                            0.0,
                                            1e-310,
                                            1e-9,
                                            0.5,
                                            1.0,
                                            1.5707,
                                            3.1416,
                                            4.72,
                                            6.2831,
                                            30.0,
                                            720.0,
                                            1e7,
                                            1e200,
                                            1.7e308,
                                            std::numeric_limits<double>::infinity()};

/// A random interval between such numbers, and numbers in it: its ends, 0 if it has that, and
/// others.
struct RandomInterval {
    Range range;
    std::vector<double> numbers;

    RandomInterval(std::mt19937_64& random, std::span<const double> among, std::size_t count) {
        std::uniform_real_distribution<double> beside(-0.1, 0.1);
        const auto any = [&] {
            const double number = among[random() % among.size()];
            return random() % 2 == 0 ? number : number + beside(random);
        };
        const double a = any();
        const double b = random() % 8 == 0 ? a : any();
        range = {std::min(a, b), std::max(a, b), false};
        numbers = {a, b};
        if (range.least < 0.0 && range.most > 0.0) {
            numbers.push_back(0.0);
        }
        std::uniform_real_distribution<double> share(0.0, 1.0);
        while (numbers.size() < count) {
            const double s = share(random);
            const double chosen = random() % 2 == 0 ? (1.0 - s) * a + s * b : any();
            numbers.push_back(chosen >= range.least && chosen <= range.most ? chosen : a);
        }
    }
};

}  // namespace balcony::expr
