// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// How GLSL ES 3.00 writes formulas.

#include <cmath>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "bridge/text/listing.hpp"

namespace balcony::bridge {

// In these texts @ is the prefix of the text's own functions. GLSL leaves pow() of a negative
// number undefined.
inline constexpr std::string_view glsl_power = R"(float @_power(float a, float b) {
    float size = a == 0.0 ? (b == 0.0 ? 1.0 : b > 0.0 ? 0.0 : @_infinity()) : pow(abs(a), b);
    float sign = b != floor(b) ? @_infinity() - @_infinity() : mod(b, 2.0) == 0.0 ? 1.0 : -1.0;
    return a < 0.0 ? sign * size : size;
}
)";

inline constexpr Spellings glsl_spellings = spellings({
    standard(Op::modulo, "mod"),
    function(Op::power, "@_power", glsl_power),
    standard(Op::arctangent2, "atan"),
    // Not by isinf() and isnan(), which drivers may take for false throughout.
    function(Op::is_finite, "@_is_finite",
             "bool @_is_finite(float a) { return abs(a) <= 3.4e38; }\n"),
});

inline std::string glsl_number(double value) {
    const double rounded = static_cast<double>(static_cast<float>(value));
    return std::isfinite(rounded) ? single_decimal(value)
           : std::isnan(rounded)  ? "uintBitsToFloat(0x7fc00000u)"
           : rounded > 0.0        ? "uintBitsToFloat(0x7f800000u)"
                                  : "uintBitsToFloat(0xff800000u)";
}

/// Functions of the text have names that begin with the prefix.
[[nodiscard]] inline Dialect glsl_dialect(const std::string& prefix) {
    return {.spellings = glsl_spellings,
            .number = glsl_number,
            .number_of_condition = "float({0})",
            .condition_of_number = "(({0}) != 0.0)",
            .single = true,
            .words = {{"@", prefix}}};
}

/// The helper that the spellings call for infinity.
[[nodiscard]] inline std::string glsl_infinity(const std::string& prefix) {
    return fmt::format("float {}_infinity() {{ return uintBitsToFloat(0x7f800000u); }}\n\n",
                       prefix);
}

}  // namespace balcony::bridge
