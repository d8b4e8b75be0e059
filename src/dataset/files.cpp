// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/files.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace balcony::dataset {

using nlohmann::json;

std::string layer_file_in_scene(const Frame& frame, std::string_view layer) {
    const auto all = layers();
    const auto row = std::find_if(all.begin(), all.end(),
                                  [&](const LayerInfo& one) { return one.name == layer; });
    return fmt::format("{}/{}{}", layer, frame.name, row->ending);
}

std::string layer_file(const Plan& plan, const Frame& frame, std::string_view layer) {
    return plan.scenes[frame.scene].name + "/" + layer_file_in_scene(frame, layer);
}

json matrix_json(const camera::Pose& pose, const std::string& axes, Axes world) {
    const auto matrix = app::matrix_of(pose, axes, world);
    json rows = json::array();
    for (const auto& row : *matrix) {
        rows.push_back(row);
    }
    rows.push_back({0.0, 0.0, 0.0, 1.0});
    return rows;
}

std::string dumped(const json& object) {
    const auto text_of = [](const json& value) {
        constexpr bool ascii_only = true;
        return value.dump(-1, ' ', ascii_only, json::error_handler_t::replace);
    };
    std::string text;
    for (const auto& [name, value] : object.items()) {
        text += fmt::format("{}{}: ", text.empty() ? "{\n" : ",\n", text_of(name));
        if (!value.is_array()) {
            text += text_of(value);
            continue;
        }
        text += '[';
        for (std::size_t i = 0; i < value.size(); ++i) {
            text += fmt::format("{}\n {}", i > 0 ? "," : "", text_of(value[i]));
        }
        text += ']';
    }
    return text + "\n}\n";
}

}  // namespace balcony::dataset
