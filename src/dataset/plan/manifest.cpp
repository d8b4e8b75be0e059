// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "dataset/plan/manifest.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "dataset/files.hpp"
#include "dataset/layouts/layout.hpp"
#include "dataset/picture_facts.hpp"

namespace balcony::dataset {

namespace {

using nlohmann::json;

std::string name_of(Axes axes) { return axes == Axes::y_up ? "y_up" : "z_up"; }

json facts_of(const Plan& plan) {
    const Recipe& recipe = plan.recipe;
    json facts = {{"version", BALCONY_VERSION}, {"seed", recipe.seed},
                  {"axes", recipe.axes},        {"layers", recipe.layers},
                  {"layouts", recipe.layouts},  {"render", picture_facts(recipe.picture)},
                  {"files", json::object()}};
    for (const auto& [file, hash] : plan.files) {
        facts["files"][file] = hash;
    }
    return facts;
}

json json_of(const Lens& lens, const std::string& axes) {
    json made = {{"model", lens.model},
                 {"camera_from_lens", matrix_json(lens.in_camera, axes, Axes::z_up)}};
    // Both sides in the axes of cameras, not of the world.
    const auto own = app::matrix_of({}, axes, Axes::z_up);
    const auto placed = app::matrix_of(lens.in_camera, axes, Axes::z_up);
    for (std::size_t i = 0; i < 3; ++i) {
        for (std::size_t j = 0; j < 4; ++j) {
            double sum = 0.0;
            for (std::size_t k = 0; k < 3; ++k) {
                sum += (*own)[k][i] * (*placed)[k][j];
            }
            made["camera_from_lens"][i][j] = sum;
        }
    }
    for (std::size_t i = 0; i < lens.names.size(); ++i) {
        made[std::string(lens.names[i])] = lens.numbers[i];
    }
    return made;
}

json json_of(const PlannedCamera& camera, const std::string& axes) {
    json made = {{"name", camera.name},
                 {"camera", camera.written},
                 {"set", camera.set},
                 {"text", camera.text},
                 {"parameters", json::object()},
                 {"width", camera.size[0]},
                 {"height", camera.size[1]},
                 {"single_viewpoint", camera.viewpoint.has_value()},
                 {"intrinsics", nullptr}};
    for (const auto& [name, value] : camera.parameters) {
        made["parameters"][name] = value;
    }
    if (camera.lens) {
        made["intrinsics"] = json_of(*camera.lens, axes);
    }
    return made;
}

json json_of(const Plan& plan, const Frame& frame) {
    const PlannedScene& scene = plan.scenes[frame.scene];
    const PlannedPose& pose = plan.pose_of(frame);
    json made = {
        {"index", frame.index},   {"name", frame.name},
        {"scene", scene.name},    {"camera", plan.camera_of(frame).name},
        {"pose", frame.pose},     {"group", pose.group},
        {"next", nullptr},        {"matrix", matrix_json(pose.pose, plan.recipe.axes, scene.axes)},
        {"files", json::object()}};
    if (pose.next) {
        made["next"] = frame.index - frame.pose + *pose.next;
    }
    for (const std::string& layer : plan.recipe.layers) {
        made["files"][layer] = layer_file(plan, frame, layer);
    }
    return made;
}

json parsed(const std::string& manifest) { return json::parse(manifest, nullptr, false); }

}  // namespace

std::vector<std::filesystem::path> files_of(const Plan& plan, const Frame& frame) {
    std::vector<std::filesystem::path> files;
    for (const std::string& layer : plan.recipe.layers) {
        files.emplace_back(layer_file(plan, frame, layer));
    }
    for (const std::string& name : plan.recipe.layouts) {
        for (const std::string& file : layout_of(name).frame_files(plan, frame)) {
            files.emplace_back(file);
        }
    }
    return files;
}

std::string manifest_of(const Plan& plan) {
    const auto all_axes = app::camera_axes();
    const auto axes = std::find_if(all_axes.begin(), all_axes.end(),
                                   [&](const auto& one) { return one.name == plan.recipe.axes; });
    json made = {{"made_by", fmt::format("Balcony {}", BALCONY_VERSION)},
                 {"axes", {{"cameras", axes->name}, {"meaning", axes->meaning}}},
                 {"pixels", "from the top left corner; the middle of the first one is (0.5, 0.5)"},
                 {"facts", facts_of(plan)},
                 {"layers", json::object()},
                 {"scenes", json::array()},
                 {"frames", json::array()}};
    for (const LayerInfo& one : layers()) {
        const auto& wanted = plan.recipe.layers;
        if (std::find(wanted.begin(), wanted.end(), one.name) != wanted.end()) {
            made["layers"][std::string(one.name)] = {{"shape", one.shape},
                                                     {"meaning", one.meaning}};
        }
    }
    for (const PlannedScene& scene : plan.scenes) {
        json one = {{"name", scene.name},          {"scene", scene.written},
                    {"axes", name_of(scene.axes)}, {"meters_per_unit", scene.meters_per_unit},
                    {"objects", scene.objects},    {"materials", scene.materials},
                    {"cameras", json::array()}};
        for (const PlannedCamera& camera : scene.cameras) {
            one["cameras"].push_back(json_of(camera, plan.recipe.axes));
        }
        made["scenes"].push_back(std::move(one));
    }
    for (const Frame& frame : plan.frames) {
        made["frames"].push_back(json_of(plan, frame));
    }
    return dumped(made);
}

std::optional<std::string> difference(const std::string& before, const std::string& now) {
    const json first = parsed(before);
    const json second = parsed(now);
    if (!first.is_object() || !first.contains("facts") || !first.contains("frames")) {
        return std::nullopt;
    }
    const json changes = json::diff(first, second);
    if (changes.empty()) {
        return "";
    }
    // What the recipe says comes before what follows from it.
    const auto of_facts = std::find_if(changes.begin(), changes.end(), [](const json& change) {
        return change.at("path").get<std::string>().starts_with("/facts/");
    });
    const json& change = of_facts != changes.end() ? *of_facts : changes.front();
    const json::json_pointer place(change.at("path").get<std::string>());
    const auto text_at = [&](const json& of) {
        return of.contains(place) ? of.at(place).dump() : std::string("nothing");
    };
    const std::string path = change.at("path").get<std::string>().substr(1);
    constexpr std::size_t longest = 60;
    return fmt::format("{}: {} there, {} now", path, text_at(first).substr(0, longest),
                       text_at(second).substr(0, longest));
}

std::vector<std::string> files_in(const std::string& manifest) {
    std::vector<std::string> files;
    const json made = parsed(manifest);
    for (const json& frame : made.value("frames", json::array())) {
        for (const json& file : frame.value("files", json::object())) {
            if (file.is_string()) {
                files.push_back(file.get<std::string>());
            }
        }
    }
    return files;
}

}  // namespace balcony::dataset
