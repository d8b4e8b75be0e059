// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/yaml_entries.hpp"

#include <algorithm>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "app/words.hpp"
#include "balcony/names.hpp"
#include "balcony/options.hpp"
#include "camera/catalogue/parameter_text.hpp"
#include "data/yaml_places.hpp"

namespace balcony::app {

SourceSpan YamlEntries::at(const YAML::Node& node) const { return data::place_of(source_, node); }

void YamlEntries::error(SourceSpan span, std::string message, std::string remedy) {
    found_.push_back(balcony::error(std::move(message), std::move(span), std::move(remedy)));
}

bool YamlEntries::goes_on() const {
    constexpr std::size_t most = 20;
    return found_.size() < most;
}

std::vector<YamlEntry> YamlEntries::map(const YAML::Node& node, std::string_view what,
                                        std::string_view remedy) {
    std::vector<YamlEntry> made;
    if (!node.IsMap()) {
        error(at(node), fmt::format("{} has no entries", what), std::string(remedy));
        return made;
    }
    std::set<std::string> names;
    for (const auto& pair : node) {
        const std::string name = pair.first.IsScalar() ? pair.first.Scalar() : "";
        if (name.empty()) {
            error(at(pair.first), fmt::format("an entry of {} has no name", what),
                  std::string(remedy));
        } else if (!names.insert(name).second) {
            error(at(pair.first), fmt::format("'{}' is given twice", name),
                  "remove one of the two");
        } else {
            made.push_back({name, at(pair.first), pair.second});
        }
    }
    return made;
}

std::vector<YamlEntry> YamlEntries::map(const YAML::Node& node, std::string_view what,
                                        std::string_view remedy,
                                        const std::vector<std::string>& known) {
    std::vector<YamlEntry> made;
    for (YamlEntry& entry : map(node, what, remedy)) {
        if (std::find(known.begin(), known.end(), entry.name) == known.end()) {
            error(entry.written, fmt::format("{} has no entry '{}'", what, entry.name),
                  suggestion(entry.name, known, "its entries are"));
        } else {
            made.push_back(std::move(entry));
        }
    }
    return made;
}

std::vector<YAML::Node> YamlEntries::list(const YAML::Node& node) const {
    if (!node.IsSequence()) {
        return {node};
    }
    std::vector<YAML::Node> made;
    for (const YAML::Node& one : node) {
        made.push_back(one);
    }
    return made;
}

std::optional<std::string> YamlEntries::word(const YAML::Node& node, std::string_view remedy) {
    if (node.IsScalar() && !node.Scalar().empty()) {
        return node.Scalar();
    }
    error(at(node), "this is not a name", std::string(remedy));
    return std::nullopt;
}

std::optional<std::size_t> YamlEntries::index_of(const YAML::Node& node,
                                                 const std::vector<std::string>& known,
                                                 std::string_view what) {
    const auto name = word(node, fmt::format("write the name of a {}", what));
    if (!name) {
        return std::nullopt;
    }
    const auto found = std::find(known.begin(), known.end(), *name);
    if (found == known.end()) {
        error(at(node), fmt::format("there is no {} '{}'", what, *name),
              known.empty() ? fmt::format("add it to '{}s'", what)
                            : suggestion(*name, known, fmt::format("the {}s are", what)));
        return std::nullopt;
    }
    return static_cast<std::size_t>(found - known.begin());
}

std::optional<Marks::Number> YamlEntries::number(const YAML::Node& node, std::string_view remedy) {
    std::string_view text = node.IsScalar() ? std::string_view(node.Scalar()) : "";
    const SourceSpan place = at(node);
    const bool in_degrees = text.ends_with("deg");
    const bool is_angle = in_degrees || text.ends_with("rad");
    text.remove_suffix(is_angle ? 3 : 0);
    text.remove_suffix(text.ends_with(' ') ? 1 : 0);
    const std::optional<double> value = number_of<double>(text);
    if (!value) {
        error(place,
              node.IsScalar() ? fmt::format("'{}' is not a finite number", node.Scalar())
                              : std::string("this is not a number"),
              std::string(remedy));
        return std::nullopt;
    }
    constexpr double radians = std::numbers::pi / 180.0;
    return Marks::Number{in_degrees ? *value * radians : *value, is_angle, place};
}

std::optional<double> YamlEntries::plain_number(const YAML::Node& node, std::string_view remedy) {
    const std::optional<Marks::Number> read = number(node, remedy);
    if (read && read->is_angle) {
        error(read->written, "this number must have no unit", std::string(remedy));
        return std::nullopt;
    }
    return read ? std::optional(read->value) : std::nullopt;
}

std::optional<double> YamlEntries::positive(const YamlEntry& entry) {
    const std::string remedy = fmt::format("write a number above 0, such as {}: 0.5", entry.name);
    const std::optional<double> value = plain_number(entry.value, remedy);
    if (value && !(*value > 0.0)) {
        error(at(entry.value), fmt::format("'{}' must be above 0", entry.name), remedy);
        return std::nullopt;
    }
    return value;
}

bool YamlEntries::is_in_deviation_range(const SourceSpan& written, std::string_view what,
                                        double value, std::string remedy) {
    const camera::Range& range = solve::deviation_range;
    const bool fits = camera::contains(range, value);
    if (!fits) {
        error(written,
              fmt::format("a {} of {:g} is not between {:g} and {:g}", what, value, range.minimum,
                          range.maximum),
              std::move(remedy));
    }
    return fits;
}

std::optional<std::size_t> YamlEntries::count(const YamlEntry& entry, std::size_t most) {
    const auto value =
        entry.value.IsScalar() ? whole_number_of(entry.value.Scalar()) : std::nullopt;
    if (!value || *value < 1 || *value > most) {
        error(at(entry.value),
              fmt::format("'{}' must be a whole number from 1 to {}", entry.name, most),
              fmt::format("write {}: 9", entry.name));
        return std::nullopt;
    }
    return value;
}

template <std::size_t count>
std::optional<std::array<double, count>> YamlEntries::numbers(const YAML::Node& node,
                                                              std::string_view remedy) {
    if (!node.IsSequence() || node.size() != count) {
        error(at(node), fmt::format("expected {} numbers in brackets", count), std::string(remedy));
        return std::nullopt;
    }
    std::array<double, count> made{};
    for (std::size_t i = 0; i < count; ++i) {
        const std::optional<double> value = plain_number(node[i], remedy);
        if (!value) {
            return std::nullopt;
        }
        made[i] = *value;
    }
    return made;
}

std::optional<Imath::V2d> YamlEntries::position(const YAML::Node& node) {
    const auto read =
        numbers<2>(node, "a position is written [x, y], in pixels from the upper left corner");
    return read ? std::optional(Imath::V2d((*read)[0], (*read)[1])) : std::nullopt;
}

std::optional<Imath::V3d> YamlEntries::vector(const YAML::Node& node, std::string_view remedy) {
    const auto read = numbers<3>(node, remedy);
    return read ? std::optional(Imath::V3d((*read)[0], (*read)[1], (*read)[2])) : std::nullopt;
}

}  // namespace balcony::app
