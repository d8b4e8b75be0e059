// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/options/amounts.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "balcony/options.hpp"

namespace balcony::app {

namespace {

constexpr std::string_view digits = "0123456789.";

struct Unit {
    std::string_view name;
    double seconds;
};

constexpr std::array units{Unit{"", 1.0},         Unit{"s", 1.0},     Unit{"sec", 1.0},
                           Unit{"m", 60.0},       Unit{"min", 60.0},  Unit{"h", 3600.0},
                           Unit{"hours", 3600.0}, Unit{"d", 86400.0}, Unit{"days", 86400.0}};

}  // namespace

std::optional<double> bytes_of(std::string_view word) {
    constexpr std::string_view prefixes = "kMGT";
    const std::size_t unit_begin = std::min(word.find_first_not_of(digits), word.size());
    const auto number = number_of<double>(word.substr(0, unit_begin));
    std::string_view unit = word.substr(unit_begin);
    unit.remove_suffix(unit.ends_with('B') ? 1 : 0);
    const bool binary = unit.ends_with('i');
    unit.remove_suffix(binary ? 1 : 0);
    const std::size_t prefix = unit.empty() || unit == "K" ? 0 : prefixes.find(unit);
    if (!number || unit.size() > 1 || prefix == std::string_view::npos ||
        (binary && unit.empty())) {
        return std::nullopt;
    }
    const double power = unit.empty() ? 0.0 : static_cast<double>(prefix + 1);
    return *number * std::pow(binary ? 1024.0 : 1000.0, power);
}

std::string bytes_word(double bytes) {
    constexpr std::array names{"TiB", "GiB", "MiB", "KiB"};
    double unit = 0x1p40;
    for (const char* name : names) {
        if (std::fmod(bytes, unit) == 0.0) {
            return fmt::format("{}{}", bytes / unit, name);
        }
        unit /= 1024.0;
    }
    return fmt::format("{:.0f}B", bytes);
}

std::optional<double> duration_of(std::string_view word) {
    double total = 0.0;
    bool any = false;
    while (!word.empty()) {
        const std::size_t unit_begin = std::min(word.find_first_not_of(digits), word.size());
        const auto number = number_of<double>(word.substr(0, unit_begin));
        word.remove_prefix(unit_begin);
        const std::size_t unit_end = std::min(word.find_first_of(digits), word.size());
        const auto* const unit = std::find_if(units.begin(), units.end(), [&](const Unit& one) {
            return one.name == word.substr(0, unit_end);
        });
        if (!number || unit == units.end()) {
            return std::nullopt;
        }
        word.remove_prefix(unit_end);
        total += *number * unit->seconds;
        any = true;
    }
    return any ? std::optional(total) : std::nullopt;
}

}  // namespace balcony::app
