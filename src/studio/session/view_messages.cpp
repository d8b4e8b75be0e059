// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/view_messages.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <nlohmann/json.hpp>

#include "lsp/answers.hpp"
#include "lsp/rpc.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

constexpr std::size_t largest_side = 8192;
constexpr std::size_t most_pixels = 16'777'216;

std::array<std::size_t, 2> size_of(const json& asked) {
    const auto side = [&asked](std::size_t index) -> std::size_t {
        const json& number = asked.at(index);
        const bool fits = number.is_number_unsigned() && number >= 1 && number <= largest_side;
        return fits ? number.get<std::size_t>() : 0;
    };
    const std::array<std::size_t, 2> size{side(0), side(1)};
    if (size[0] == 0 || size[1] == 0 || size[0] * size[1] > most_pixels) {
        throw lsp::Refusal{lsp::invalid_params,
                           "a size is a width and a height of 1 to 8192 pixels, with at most 16 "
                           "million of them"};
    }
    return size;
}

json told_of_parameter(const lang::OpenParameter& one) {
    json made{{"name", one.name},
              {"value", one.value},
              {"written", one.written},
              {"unit", one.is_angle ? "angle" : "number"}};
    if (std::isfinite(one.limits.minimum)) {
        made["min"] = one.limits.minimum;
    }
    if (std::isfinite(one.limits.maximum)) {
        made["max"] = one.limits.maximum;
    }
    if (one.limits.excludes_minimum) {
        made["minExcluded"] = true;
    }
    return made;
}

json told_of_parameters(const std::vector<lang::OpenParameter>& all) {
    json made = json::array();
    for (const lang::OpenParameter& one : all) {
        made.push_back(told_of_parameter(one));
    }
    return made;
}

}  // namespace

std::vector<live::Value> values_of(const json& asked) {
    std::vector<live::Value> values;
    for (const json& one : asked) {
        values.push_back({one.at("parameter").get<std::string>(), one.at("value").get<double>()});
    }
    return values;
}

live::Change change_of(const json& asked) {
    live::Change change;
    if (asked.contains("camera")) {
        change.camera = asked["camera"].get<std::string>();
    }
    if (asked.contains("values")) {
        change.values = values_of(asked["values"]);
    }
    if (asked.contains("size")) {
        change.size = size_of(asked["size"]);
    }
    change.choose_exposure = asked.value("exposure", false);
    return change;
}

json told_of(const live::CameraState& state) {
    static const SourceText elsewhere("", "");
    json diagnostics = json::array();
    for (const Diagnostic& one : state.diagnostics) {
        const bool is_here = one.span.source && one.span.source->name() == live::text_name;
        diagnostics.push_back(lsp::diagnostic_of(is_here ? *one.span.source : elsewhere, one));
    }
    json made{{"change", state.change},
              {"name", state.name},
              {"diagnostics", std::move(diagnostics)},
              {"open", told_of_parameters(state.open)},
              {"closed", told_of_parameters(state.closed)}};
    if (state.aspect) {
        made["aspect"] = *state.aspect;
    }
    return made;
}

json told_of(const live::SceneState& state) {
    if (state.step) {
        return {{"state", "loading"},
                {"message",
                 *state.step == app::Step::reading ? "reading the scene" : "preparing the scene"}};
    }
    json made{{"state", has_errors(state.diagnostics) ? "failed" : "ready"}};
    if (!state.diagnostics.empty()) {
        made["message"] = to_text(state.diagnostics);
    }
    return made;
}

}  // namespace balcony::studio
