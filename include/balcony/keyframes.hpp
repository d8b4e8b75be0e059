// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Keyframes: values that are given at some times, or at some values of anything else, with easing
// in between.

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/expr.hpp"
#include "balcony/names.hpp"

namespace balcony::camera {

/// How a value goes from one key to the next. With the way s from 0 to 1 between the keys, the
/// value is a + (b - a) e(s), or a cubic whose slopes at the keys depend on their neighbours.
enum class Ease : std::uint8_t {
    linear,       ///< s
    hold,         ///< 0 until the next key
    smooth,       ///< 3s² - 2s³, at rest at both ends
    smoother,     ///< 10s³ - 15s⁴ + 6s⁵, also without acceleration at the ends
    ease_in,      ///< s²
    ease_out,     ///< 1 - (1 - s)²
    ease_in_out,  ///< 2s² up to the middle, then 1 - 2(1 - s)²
    overshoot,    ///< goes beyond the key by a tenth and returns to it
    elastic,      ///< swings around the key before it rests
    bounce,       ///< falls onto the key and bounces three times
    spline,       ///< the monotone cubic of Fritsch and Butland: smooth, never beyond the keys
    catmull_rom,  ///< the cubic of Catmull and Rom: smoother, may go beyond the keys
};

/// With their formulas as the meanings.
[[nodiscard]] Names<Ease> eases();

/// The value before the first key and after the last one.
enum class BeyondKeys : std::uint8_t {
    constant,  ///< That of the nearest key.
    repeat,    ///< From the first key again; a cubic then has equal slopes at both ends.
    mirror,    ///< Backwards, then forwards again.
};
[[nodiscard]] Names<BeyondKeys> beyond_keys();

struct Keyframes {
    std::vector<double> times;  ///< At least one; finite and increasing.
    /// By component, then by key: expressions of the graph of the time.
    std::vector<std::vector<expr::Expr>> values;
    Ease ease = Ease::linear;
    BeyondKeys beyond = BeyondKeys::constant;
};

/// The components at a time, exact at the keys. A few keys are a formula; many with constant values
/// are tables, whose cost does not depend on their number.
[[nodiscard]] std::vector<expr::Expr> between_keys(const Keyframes& keys, expr::Expr time);

}  // namespace balcony::camera
