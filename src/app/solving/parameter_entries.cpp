// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/parameter_entries.hpp"

#include <fmt/format.h>

namespace balcony::app {

namespace {

std::vector<Marks::Parameter> names_in(const YAML::Node& node, std::string_view remedy,
                                       YamlEntries& yaml) {
    std::vector<Marks::Parameter> made;
    for (const YAML::Node& one : yaml.list(node)) {
        if (const auto name = yaml.word(one, remedy)) {
            made.push_back({*name, yaml.at(one), {}, {}, {}});
        }
    }
    return made;
}

void range(const YamlEntry& entry, Marks::Parameter& parameter, YamlEntries& yaml) {
    const std::string remedy = "write the smallest and the largest value: [20deg, 90deg]";
    const std::vector<YAML::Node> ends = yaml.list(entry.value);
    if (ends.size() != 2) {
        yaml.error(yaml.at(entry.value), "a range has two ends", remedy);
        return;
    }
    const auto first = yaml.number(ends[0], remedy);
    const auto last = yaml.number(ends[1], remedy);
    if (first && last && !(first->value < last->value)) {
        yaml.error(yaml.at(entry.value), "this range contains nothing", remedy);
    } else if (first && last) {
        parameter.range = {*first, *last};
    }
}

void describe(const YamlEntry& entry, Marks::Parameter& parameter, YamlEntries& yaml) {
    const std::string remedy = "write a number with the unit that the parameter has: 55deg";
    for (const YamlEntry& one :
         yaml.map(entry.value, fmt::format("'{}'", entry.name),
                  "write {start: 55deg, range: [20deg, 90deg], deviation: 5deg}, or leave out some "
                  "of these",
                  {"start", "range", "deviation"})) {
        if (one.name == "start") {
            parameter.start = yaml.number(one.value, remedy);
        } else if (one.name == "range") {
            range(one, parameter, yaml);
        } else {
            parameter.deviation = yaml.number(one.value, remedy);
            if (parameter.deviation) {
                yaml.is_in_deviation_range(parameter.deviation->written, "deviation",
                                           parameter.deviation->value);
            }
        }
    }
}

}  // namespace

std::vector<Marks::Parameter> read_unknowns(const YamlEntry& entry, YamlEntries& yaml) {
    constexpr std::string_view remedy =
        "write the names of parameters: [fov, yaw], or with more about them: {fov: {range: [20deg, "
        "90deg]}, yaw: {deviation: 5deg}}";
    if (!entry.value.IsMap()) {
        return names_in(entry.value, remedy, yaml);
    }
    std::vector<Marks::Parameter> made;
    for (const YamlEntry& one : yaml.map(entry.value, "'unknowns'", remedy)) {
        Marks::Parameter parameter{one.name, one.written, {}, {}, {}};
        if (!one.value.IsNull()) {
            describe(one, parameter, yaml);
        }
        made.push_back(std::move(parameter));
    }
    return made;
}

std::vector<Marks::Parameter> read_fixed(const YamlEntry& entry, YamlEntries& yaml) {
    return names_in(entry.value, "write the names of parameters: [roll, fov]", yaml);
}

}  // namespace balcony::app
