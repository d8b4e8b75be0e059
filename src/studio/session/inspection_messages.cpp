// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "studio/session/inspection_messages.hpp"

#include <utility>

#include <nlohmann/json.hpp>

#include "lsp/rpc.hpp"
#include "studio/session/view_messages.hpp"

namespace balcony::studio {

using nlohmann::json;

namespace {

json told_of(const Imath::V3d& v) { return {v.x, v.y, v.z}; }

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
    const Result<std::optional<live::Sight>> found = inspector.at(point, stop);
    const std::optional<live::Sight>& sight = required(found);
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
    }
    return made;
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
