// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// measure_plates: prints the measured properties of the plates as JSON, for the page.
//
// An object by plate numbers of lists of {"what", "value", "at_least", "at_most", "met"}; bounds
// that there are not are missing. The exit code is 1 if a property is not met.

#include <charconv>
#include <cmath>
#include <cstdio>
#include <exception>
#include <set>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "measure/property.hpp"

namespace {

using namespace balcony;
using nlohmann::json;

json to_json(const plates::Measurement& measurement) {
    json written = {
        {"what", measurement.what}, {"value", measurement.value}, {"met", measurement.met()}};
    if (std::isfinite(measurement.at_least)) {
        written["at_least"] = measurement.at_least;
    }
    if (std::isfinite(measurement.at_most)) {
        written["at_most"] = measurement.at_most;
    }
    return written;
}

int measure(const std::set<int>& wanted) {
    plates::Studio studio;
    json measured = json::object();
    bool all = true;
    for (const plates::Property& property : plates::properties()) {
        if (!wanted.empty() && !wanted.contains(property.plate)) {
            continue;
        }
        const plates::Measurements measurements = property.measure(studio, {});
        all = all && all_met(measurements);
        json& list = measured[std::to_string(property.plate)] = json::array();
        for (const plates::Measurement& measurement : measurements) {
            list.push_back(to_json(measurement));
        }
    }
    fmt::print("{}\n", measured.dump(1));
    return all ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
    std::set<int> wanted;
    for (int i = 1; i < argc; ++i) {
        const std::string_view text = argv[i];
        int number = 0;
        const auto [end, problem] = std::from_chars(text.data(), text.data() + text.size(), number);
        if (problem != std::errc() || end != text.data() + text.size()) {
            fmt::print(stderr, "Usage: measure_plates [NUMBER...]\n");
            return 2;
        }
        wanted.insert(number);
    }
    try {
        return measure(wanted);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "{}\n", problem.what());
        return 3;
    }
}
