// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "app/options/word_parts.hpp"
#include "balcony/options.hpp"

namespace balcony::app {

namespace {

std::vector<std::string> names_of(const std::vector<OptionChoice>& choices) {
    std::vector<std::string> names;
    for (const OptionChoice& one : choices) {
        names.push_back(one.name);
    }
    return names;
}

}  // namespace

Names<OptionType> option_types() {
    static constexpr std::array rows{
        Named{OptionType::flag, "flag"},      Named{OptionType::count, "count"},
        Named{OptionType::number, "number"},  Named{OptionType::angle, "angle"},
        Named{OptionType::color, "color"},    Named{OptionType::choice, "choice"},
        Named{OptionType::size, "size"},      Named{OptionType::text, "text"},
        Named{OptionType::file, "file"},      Named{OptionType::folder, "folder"},
        Named{OptionType::scene, "scene"},    Named{OptionType::camera, "camera"},
        Named{OptionType::setting, "setting"}};
    return Names<OptionType>(rows);
}

Diagnostic refused(std::string_view option, std::string_view word, std::string remedy) {
    return error(Kind::usage, fmt::format("{} cannot be '{}'", option, word), std::move(remedy));
}

template <class Number>
std::optional<Number> number_of(std::string_view word) {
    Number number{};
    if (word.starts_with('+') && !word.starts_with("+-")) {
        word.remove_prefix(1);
    }
    const char* end = word.data() + word.size();
    const auto [read_to, failed] = std::from_chars(word.data(), end, number);
    if (failed != std::errc() || read_to != end) {
        return std::nullopt;
    }
    if constexpr (std::is_floating_point_v<Number>) {
        return std::isfinite(number) ? std::optional(number) : std::nullopt;
    }
    return number;
}
template std::optional<double> number_of(std::string_view);
template std::optional<float> number_of(std::string_view);
template std::optional<std::size_t> number_of(std::string_view);

Value<std::size_t> count(std::size_t minimum, std::size_t maximum) {
    Value<std::size_t> made;
    made.info.type = OptionType::count;
    made.info.minimum = static_cast<double>(minimum);
    made.info.maximum = static_cast<double>(maximum);
    made.read = [minimum, maximum](std::string_view word) {
        const auto count = number_of<std::size_t>(word);
        return count && minimum <= *count && *count <= maximum ? count : std::nullopt;
    };
    made.write = [](std::size_t count) { return fmt::format("{}", count); };
    made.remedy = [minimum, maximum](std::string_view) {
        return fmt::format("give a whole number from {} to {}", minimum, maximum);
    };
    return made;
}

template <class Number>
Value<Number> number(Number minimum, Number maximum, std::string remedy, std::string unit) {
    Value<Number> made;
    made.info.type = OptionType::number;
    made.info.unit = std::move(unit);
    made.info.minimum = static_cast<double>(minimum);
    made.info.maximum = static_cast<double>(maximum);
    made.read = [minimum, maximum](std::string_view word) {
        const auto number = number_of<Number>(word);
        return number && minimum <= *number && *number <= maximum ? number : std::nullopt;
    };
    made.write = [](Number number) { return fmt::format("{}", number); };
    made.remedy = [remedy = std::move(remedy)](std::string_view) { return remedy; };
    return made;
}
template Value<double> number(double, double, std::string, std::string);
template Value<float> number(float, float, std::string, std::string);

Value<double> degrees(double minimum, double maximum) {
    Value<double> in_degrees = number(
        minimum, maximum, fmt::format("give degrees from {} to {}", minimum, maximum), "deg");
    in_degrees.info.type = OptionType::angle;
    in_degrees.read = [read = in_degrees.read](std::string_view word) {
        return read(word.ends_with("deg") ? word.substr(0, word.size() - 3) : word);
    };
    return converted<double>(
        std::move(in_degrees), [](double angle) { return degree * angle; },
        [](double angle) { return angle / degree; });
}

std::optional<Imath::V3d> point_of(std::string_view word) {
    const std::vector<std::string_view> parts = parts_of(word, ",");
    Imath::V3d point;
    for (std::size_t i = 0; i < 3; ++i) {
        const auto number = parts.size() == 3 ? number_of<double>(parts[i]) : std::nullopt;
        if (!number) {
            return std::nullopt;
        }
        point[static_cast<int>(i)] = *number;
    }
    return point;
}

Value<Imath::Color3f> color(float maximum, std::string remedy) {
    Value<Imath::Color3f> made;
    made.info.type = OptionType::color;
    made.info.minimum = 0.0;
    made.info.maximum = static_cast<double>(maximum);
    made.read = [maximum](std::string_view word) -> std::optional<Imath::Color3f> {
        const std::vector<std::string_view> parts = parts_of(word, ",");
        Imath::Color3f color;
        for (std::size_t i = 0; i < 3; ++i) {
            const auto level = number_of<float>(parts[parts.size() == 3 ? i : 0]);
            if (!level || *level < 0.0F || *level > maximum || parts.size() % 2 == 0) {
                return std::nullopt;
            }
            color[static_cast<int>(i)] = *level;
        }
        return parts.size() > 3 ? std::nullopt : std::optional(color);
    };
    made.write = [](const Imath::Color3f& color) {
        return color.x == color.y && color.y == color.z
                   ? fmt::format("{}", color.x)
                   : fmt::format("{},{},{}", color.x, color.y, color.z);
    };
    made.remedy = [remedy = std::move(remedy)](std::string_view) { return remedy; };
    return made;
}

Value<std::string> text(OptionType type) {
    Value<std::string> made;
    made.info.type = type;
    made.read = [](std::string_view word) { return std::optional<std::string>(word); };
    made.write = [](const std::string& word) { return word; };
    made.remedy = [](std::string_view) { return std::string(); };
    return made;
}

Value<std::string> choice(std::vector<OptionChoice> choices, std::string remedy) {
    Value<std::string> made = text(OptionType::choice);
    made.read = [names = names_of(choices)](std::string_view word) {
        const auto found = std::find(names.begin(), names.end(), word);
        return found != names.end() ? std::optional(*found) : std::nullopt;
    };
    made.remedy = [names = names_of(choices), remedy](std::string_view word) {
        return !remedy.empty()
                   ? remedy
                   : did_you_mean(word, names, fmt::format("write {}", fmt::join(names, " or ")));
    };
    made.info.choices = std::move(choices);
    return made;
}

std::string described(const std::vector<OptionChoice>& choices, std::string_view join) {
    std::vector<std::string> texts;
    for (const OptionChoice& one : choices) {
        texts.push_back(fmt::format("{} ({})", one.name, one.meaning));
    }
    return fmt::format("{}", fmt::join(texts, join));
}

}  // namespace balcony::app
