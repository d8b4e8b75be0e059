// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "balcony/scene.hpp"
#include "cli/command.hpp"
#include "cli/json.hpp"
#include "cli/report.hpp"

namespace balcony::cli {

namespace {

struct InfoOptions {
    std::string scene;
    bool objects = false;
    bool json = false;
};

std::string_view axes_text(Axes axes) { return axes == Axes::y_up ? "y up" : "z up"; }

nlohmann::json scene_json(const scene::Scene& scene) {
    const auto bounds = scene.bounds();
    nlohmann::json objects = nlohmann::json::array();
    for (const scene::Object& object : scene.objects) {
        objects.push_back(object.name);
    }
    return {
        {"format", scene.format},
        {"axes", axes_text(scene.axes)},
        {"meters_per_unit", scene.meters_per_unit},
        {"triangles", scene.triangle_count()},
        {"meshes", scene.meshes.size()},
        {"instances", scene.instances.size()},
        {"materials", scene.materials.size()},
        {"textures", scene.textures.size()},
        {"lights", scene.lights.size()},
        {"bounds",
         {{bounds.min.x, bounds.min.y, bounds.min.z}, {bounds.max.x, bounds.max.y, bounds.max.z}}},
        {"objects", objects}};
}

void print_scene(const scene::Scene& scene, bool objects) {
    const auto bounds = scene.bounds();
    const auto size = bounds.size();
    fmt::print("{}\n", scene.name);
    fmt::print("  format     {}\n", scene.format);
    fmt::print("  axes       {}; a unit is {} m\n", axes_text(scene.axes), scene.meters_per_unit);
    fmt::print("  extent     {:.4g} x {:.4g} x {:.4g} units\n", size.x, size.y, size.z);
    fmt::print("  bounds     ({:.4g}, {:.4g}, {:.4g}) .. ({:.4g}, {:.4g}, {:.4g})\n", bounds.min.x,
               bounds.min.y, bounds.min.z, bounds.max.x, bounds.max.y, bounds.max.z);
    fmt::print("  triangles  {} in {} objects, {} meshes\n",
               count_text(static_cast<double>(scene.triangle_count())), scene.objects.size(),
               scene.meshes.size());
    fmt::print("  materials  {}, textures {}\n", scene.materials.size(), scene.textures.size());
    fmt::print("  lights     {}{}\n", scene.lights.size(),
               scene.default_light ? "; nothing shines: lit from where the rays start" : "");
    if (objects) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            fmt::print("  object {:<4} {}\n", i + 1, scene.objects[i].name);
        }
    }
}

ExitCode info(const InfoOptions& options) {
    const auto scene = scene::load(options.scene);
    if (options.json) {
        nlohmann::json result{{"diagnostics", to_json(scene.diagnostics)}};
        if (scene) {
            result["scene"] = scene_json(*scene);
        }
        fmt::print("{}\n", result.dump(2));
    } else {
        report(scene.diagnostics);
        if (scene) {
            print_scene(*scene, options.objects);
        }
    }
    return scene ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

void add_info_command(CLI::App& app, ExitCode& code) {
    auto* command = app.add_subcommand("info", "says what is in a scene file");
    const auto options = std::make_shared<InfoOptions>();
    command->add_option("SCENE", options->scene, "a scene file (.glb, .gltf, .obj)")->required();
    command->add_flag("--objects", options->objects, "list the objects with their ids");
    command->add_flag("--json", options->json, "for programs");
    command->footer("Example:\n  balcony info gallery.glb --objects");
    command->callback([options, &code] { code = info(*options); });
}

}  // namespace balcony::cli
