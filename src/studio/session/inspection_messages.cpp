// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/inspection_messages.hpp"

#include <string>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "lsp/rpc.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

constexpr std::size_t most_cells = 256;  // Of a grid, in each direction.

json told_of(const Imath::V3d& v) { return {v.x, v.y, v.z}; }

json told_of(const std::optional<live::Sight>& sight) {
    if (!sight) {
        return {{"ray", nullptr}, {"hit", nullptr}};
    }
    json made{{"ray",
               {{"layer", sight->layer},
                {"origin", told_of(sight->origin)},
                {"direction", told_of(sight->direction)},
                {"u", sight->parameters.x},
                {"v", sight->parameters.y}}},
              {"hit", nullptr}};
    if (sight->hit) {
        made["hit"] = {
            {"object", sight->hit->object},          {"material", sight->hit->material},
            {"distance", sight->hit->distance},      {"point", told_of(sight->hit->point)},
            {"normal", told_of(sight->hit->normal)}, {"magnification", sight->hit->magnification}};
        if (const auto& metric = sight->hit->metric) {
            made["hit"]["metric"] = {metric->xx, metric->xy, metric->yy};
        }
    }
    return made;
}

template <class T>
const T& required(const Result<T>& made) {
    if (!made) {
        throw lsp::Refusal{lsp::request_failed, to_text(made.diagnostics)};
    }
    return *made;
}

}  // namespace

json sight_answer(live::Inspector& inspector, const json& asked, const std::stop_token& stop) {
    const Imath::V2d point{asked.at("x").get<double>(), asked.at("y").get<double>()};
    return told_of(required(inspector.at(point, stop)));
}

json grid_answer(live::Inspector& inspector, const json& asked, const std::stop_token& stop) {
    const std::size_t columns = count_of(asked.at("columns"), most_cells, "a number of columns");
    const std::size_t rows = count_of(asked.at("rows"), most_cells, "a number of rows");
    json places = json::array();
    const auto found = inspector.grid(columns, rows, stop);
    for (const std::optional<live::Sight>& one : required(found)) {
        places.push_back(told_of(one));
    }
    return {{"places", std::move(places)}};
}

json remarks_answer(live::Inspector& inspector, const json& /*asked*/,
                    const std::stop_token& stop) {
    json remarks = json::array();
    const auto found = inspector.check(stop);
    for (const live::Remark& one : required(found)) {
        json boxes = json::array();
        for (const Imath::Box2d& box : one.areas) {
            boxes.push_back({box.min.x, box.min.y, box.max.x, box.max.y});
        }
        remarks.push_back(
            {{"camera", one.camera},
             {"name", one.name},
             {"defect", one.defect},
             {"message", one.message},
             {"remedy", one.remedy},
             {"boxes", std::move(boxes)},
             {"at", one.example ? json{one.example->x, one.example->y} : json(nullptr)}});
    }
    return {{"remarks", std::move(remarks)}};
}

json export_answer(live::Inspector& inspector, const json& asked, const std::stop_token& stop) {
    const std::string language = asked.at("language").get<std::string>();
    const bridge::ExportTarget* const target = bridge::find_export_target(language);
    if (target == nullptr) {
        throw lsp::Refusal{lsp::invalid_params,
                           fmt::format("cameras are not exported to '{}'", language)};
    }
    const std::string camera = inspector.camera();
    const auto made = inspector.export_camera(
        {.target = target, .title = asked["file"].get<std::string>() + ":" + camera}, stop);
    return {{"text", required(made).text},
            {"file", fmt::format("{}{}", camera, target->ending)},
            {"diagnostics", told_of(made.diagnostics)}};
}

json places_answer(live::Inspector& inspector, const json& asked, const std::stop_token& stop) {
    json places = json::array();
    const auto found = inspector.places_of(point_of(asked.at("point")), stop);
    for (const live::Appearance& one : required(found)) {
        places.push_back({{"x", one.position.x},
                          {"y", one.position.y},
                          {"layer", one.layer},
                          {"origin", told_of(one.origin)},
                          {"distance", one.distance},
                          {"hiddenBy", one.hidden_by ? json(*one.hidden_by) : json(nullptr)}});
    }
    return {{"places", std::move(places)}};
}

}  // namespace balcony::studio
