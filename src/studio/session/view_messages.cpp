// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/view_messages.hpp"

#include <cmath>
#include <memory>
#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/exports/parameter_json.hpp"
#include "lsp/answers.hpp"
#include "lsp/rpc.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

constexpr std::size_t largest_side = 8192;
constexpr std::size_t most_pixels = 16'777'216;
constexpr std::size_t most_pulls = 64;
constexpr double latest_time = 1e9;  // In seconds.

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

json told_of_parameters(const std::vector<lang::OpenParameter>& all) {
    json made = json::array();
    for (const lang::OpenParameter& one : all) {
        made.push_back(app::told_of(one));
    }
    return made;
}

json told_of(const std::vector<live::Value>& values) {
    json made = json::array();
    for (const live::Value& one : values) {
        made.push_back({{"parameter", one.parameter}, {"value", one.value}});
    }
    return made;
}

// Nothing is one eye.
std::optional<camera::StereoFormat> stereo_of(const json& asked) {
    if (asked.is_null()) {
        return std::nullopt;
    }
    const auto format = camera::stereo_formats().find(asked.get<std::string>());
    if (!format) {
        throw lsp::Refusal{lsp::invalid_params, "a stereo format is one of stereoFormats, or null"};
    }
    return format;
}

Imath::V2d position_of(const json& asked) {
    return {asked.at(0).get<double>(), asked.at(1).get<double>()};
}

live::Pull pull_of(const json& asked) {
    return {point_of(asked.at("point")), asked.value("infinite", false),
            position_of(asked.at("from")), position_of(asked.at("to"))};
}

}  // namespace

Imath::V3d point_of(const json& asked) {
    return {asked.at(0).get<double>(), asked.at(1).get<double>(), asked.at(2).get<double>()};
}

std::size_t index_of(const json& asked) {
    if (!asked.is_number_unsigned()) {
        throw lsp::Refusal{lsp::invalid_params, "an index is a whole number from 0"};
    }
    return asked.get<std::size_t>();
}

std::size_t count_of(const json& asked, std::size_t most, std::string_view what) {
    if (!asked.is_number_unsigned() || asked < 1 || asked > most) {
        throw lsp::Refusal{lsp::invalid_params,
                           fmt::format("{} is a whole number from 1 to {}", what, most)};
    }
    return asked.get<std::size_t>();
}

json told_of(const Diagnostics& found) {
    static const SourceText elsewhere("", "");
    json made = json::array();
    for (const Diagnostic& one : found) {
        const bool is_here = one.span.source && one.span.source->name() == live::text_name;
        made.push_back(lsp::diagnostic_of(is_here ? *one.span.source : elsewhere, one));
    }
    return made;
}

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
    if (asked.contains("time")) {
        change.time = asked["time"].get<double>();
        if (!(std::abs(*change.time) <= latest_time)) {
            throw lsp::Refusal{lsp::invalid_params, "a time is a number of seconds"};
        }
    }
    if (asked.contains("stereo")) {
        change.stereo.emplace(stereo_of(asked["stereo"]));
    }
    change.choose_exposure = asked.value("exposure", false);
    return change;
}

live::Drag drag_of(const json& asked) {
    const json& pulls = asked.at("pulls");
    if (!pulls.is_array() || pulls.size() > most_pulls) {
        throw lsp::Refusal{lsp::invalid_params,
                           fmt::format("a hand pulls at most {} points", most_pulls)};
    }
    live::Drag drag;
    for (const json& one : pulls) {
        drag.pulls.push_back(pull_of(one));
    }
    if (asked.contains("parameters")) {
        drag.parameters = asked["parameters"].get<std::vector<std::string>>();
    }
    if (asked.contains("layer")) {
        drag.layer = index_of(asked["layer"]);
    }
    return drag;
}

json told_of(const live::Dragged& dragged) {
    json points = json::array();
    for (const live::Dragged::Point& one : dragged.points) {
        points.push_back({{"at", one.at ? json{one.at->x, one.at->y} : json(nullptr)},
                          {"miss", one.miss},
                          {"follows", one.follows}});
    }
    return {{"change", dragged.change},
            {"values", told_of(dragged.values)},
            {"points", std::move(points)},
            {"diagnostics", told_of(dragged.diagnostics)},
            {"seconds", dragged.seconds}};
}

json told_of(const live::CameraState& state) {
    json made{{"change", state.change},
              {"name", state.name},
              {"time", state.time},
              {"diagnostics", told_of(state.diagnostics)},
              {"open", told_of_parameters(state.open)},
              {"closed", told_of_parameters(state.closed)},
              {"moving", told_of_parameters(state.moving)}};
    if (state.aspect) {
        made["aspect"] = *state.aspect;
    }
    if (state.stereo) {
        made["stereo"] = camera::stereo_formats()[*state.stereo].name;
    }
    return made;
}

json told_of(const live::SceneState& state) {
    if (state.step) {
        return {{"state", "loading"},
                {"message",
                 *state.step == app::Step::reading ? "reading the scene" : "preparing the scene"}};
    }
    json made{{"state", has_errors(state.diagnostics) ? "failed" : "ready"},
              {"duration", state.duration}};
    if (!state.diagnostics.empty()) {
        made["message"] = to_text(state.diagnostics);
    }
    return made;
}

}  // namespace balcony::studio
