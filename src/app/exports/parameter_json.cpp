// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/exports/parameter_json.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

namespace balcony::app {

using nlohmann::json;

void tell_limits(const camera::Range& limits, json& told) {
    if (std::isfinite(limits.minimum)) {
        told["min"] = limits.minimum;
    }
    if (std::isfinite(limits.maximum)) {
        told["max"] = limits.maximum;
    }
    if (limits.excludes_minimum) {
        told["minExcluded"] = true;
    }
}

json told_of(const lang::OpenParameter& parameter) {
    json made{{"name", parameter.name},
              {"value", parameter.value},
              {"written", parameter.written},
              {"unit", parameter.is_angle ? "angle" : "number"}};
    tell_limits(parameter.limits, made);
    return made;
}

}  // namespace balcony::app
