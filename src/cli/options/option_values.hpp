// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads the values of options. An invalid value is reported with its option and a suggested fix.

#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include <Imath/ImathColor.h>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/base.hpp"
#include "balcony/names.hpp"

namespace balcony::cli {

/// The whole text as a finite number, or nothing. The number may have a sign.
template <class Number>
[[nodiscard]] std::optional<Number> number_of(std::string_view text) {
    Number number{};
    if (text.starts_with('+') && !text.starts_with("+-")) {
        text.remove_prefix(1);
    }
    const char* end = text.data() + text.size();
    const auto [read_to, failed] = std::from_chars(text.data(), end, number);
    if (failed != std::errc() || read_to != end) {
        return std::nullopt;
    }
    if constexpr (std::is_floating_point_v<Number>) {
        if (!std::isfinite(number)) {
            return std::nullopt;
        }
    }
    return number;
}

/// One radiance value, or three separated by commas.
[[nodiscard]] inline std::optional<Imath::Color3f> color_of(std::string_view text) {
    const std::size_t first = text.find(',');
    if (first == std::string_view::npos) {
        const auto level = number_of<float>(text);
        return level ? std::optional(Imath::Color3f(*level)) : std::nullopt;
    }
    const std::size_t second = text.find(',', first + 1);
    if (second == std::string_view::npos) {
        return std::nullopt;
    }
    const auto red = number_of<float>(text.substr(0, first));
    const auto green = number_of<float>(text.substr(first + 1, second - first - 1));
    const auto blue = number_of<float>(text.substr(second + 1));
    return red && green && blue ? std::optional(Imath::Color3f(*red, *green, *blue)) : std::nullopt;
}

inline void refuse(Diagnostics& diagnostics, std::string_view option, std::string_view text,
                   std::string remedy) {
    diagnostics.push_back(
        error(fmt::format("{} cannot be '{}'", option, text), {}, std::move(remedy)));
}

/// Refuses a name that is not known.
inline void check_name(std::string_view option, const std::string& text,
                       const std::vector<std::string>& known, Diagnostics& diagnostics) {
    if (std::find(known.begin(), known.end(), text) == known.end()) {
        refuse(diagnostics, option, text,
               did_you_mean(text, known, fmt::format("write {}", fmt::join(known, " or "))));
    }
}

template <class Number>
[[nodiscard]] Number read_number(std::string_view option, const std::string& text, Number minimum,
                                 Number maximum, std::string remedy, Diagnostics& diagnostics) {
    const auto number = number_of<Number>(text);
    if (!number || *number < minimum || *number > maximum) {
        refuse(diagnostics, option, text, std::move(remedy));
        return Number{};
    }
    return *number;
}

/// A whole number; the minimum if it cannot be read.
[[nodiscard]] inline std::size_t read_count(std::string_view option, const std::string& text,
                                            std::size_t minimum, std::size_t maximum,
                                            Diagnostics& diagnostics) {
    const auto count = number_of<std::size_t>(text);
    if (!count || *count < minimum || *count > maximum) {
        refuse(diagnostics, option, text,
               fmt::format("give a whole number from {} to {}", minimum, maximum));
        return minimum;
    }
    return *count;
}

}  // namespace balcony::cli
