// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <memory>
#include <numbers>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "balcony/data.hpp"
#include "balcony/input_file.hpp"
#include "balcony/inputs.hpp"
#include "balcony/motion.hpp"
#include "balcony/names.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/lens_report.hpp"

namespace balcony::cli {

namespace {

struct InfoOptions {
    std::string scene;
    bool objects = false;
    Manner manner;
};

// "Door, perspective, 60 x 36 degrees"
std::string camera_text(const scene::Camera& camera) {
    const double half_width = camera.half_height * camera.aspect;
    if (camera.projection == scene::Projection::orthographic) {
        return fmt::format("{}, orthographic, {:.4g} x {:.4g} units", printable(camera.name),
                           2.0 * half_width, 2.0 * camera.half_height);
    }
    const auto field = [](double half) { return 2.0 * std::atan(half) * 180.0 / std::numbers::pi; };
    return fmt::format("{}, perspective, {:.4g} x {:.4g} degrees", printable(camera.name),
                       field(half_width), field(camera.half_height));
}

nlohmann::json cameras_json(const scene::Scene& scene) {
    nlohmann::json cameras = nlohmann::json::array();
    const auto numbers = [](const scene::V3d& v) { return nlohmann::json{v.x, v.y, v.z}; };
    for (const scene::Camera& camera : scene.cameras) {
        const bool perspective = camera.projection == scene::Projection::perspective;
        cameras.push_back({{"name", camera.name},
                           {"projection", perspective ? "perspective" : "orthographic"},
                           {"position", numbers(camera.position)},
                           {"forward", numbers(camera.forward)},
                           {"up", numbers(camera.up)},
                           {"half_height", camera.half_height},
                           {"aspect", camera.aspect},
                           {"near", camera.near}});
    }
    return cameras;
}

std::vector<scene::Animation> animations_of(const scene::Scene& scene) {
    return scene.motion ? scene.motion->animations : std::vector<scene::Animation>();
}

nlohmann::json animations_json(const scene::Scene& scene) {
    nlohmann::json animations = nlohmann::json::array();
    for (const scene::Animation& animation : animations_of(scene)) {
        animations.push_back({{"name", animation.name},
                              {"duration", animation.duration},
                              {"channels", animation.channels}});
    }
    return animations;
}

// Whether light may be added to that of the scene.
bool may_need_light(const scene::Scene& scene) {
    return scene.default_light ||
           std::any_of(scene.lights.begin(), scene.lights.end(), [](const scene::Light& light) {
               return light.kind == scene::LightKind::directional;
           });
}

constexpr std::string_view unknown_light = "unknown";

// What lights a scene in the picture of its default camera; empty if only the scene itself does,
// and unknown if there is no such picture.
std::string default_light(const std::shared_ptr<const scene::Scene>& scene) {
    const auto renderer = render::Renderer::make(scene, {.textures_on_demand = true});
    const auto picture =
        renderer ? app::default_picture(*scene, *renderer) : Result<camera::Picture>();
    auto film = render::make_film({.width = 64, .height = 36});
    const auto job =
        picture && film
            ? render::Job::make(
                  *renderer, *picture,
                  {.samples = 1, .integrator = "path", .light = {.sky_beside_suns = true}},
                  std::make_shared<render::Film>(std::move(*film)))
            : Result<render::Job>();
    if (!job) {
        return std::string(unknown_light);
    }
    const auto substitute = job->substitute();
    return substitute && *substitute != render::SubstituteLight::none ? job->light() : "";
}

nlohmann::json scene_json(const scene::Scene& scene, const std::string& light) {
    const auto bounds = scene.bounds();
    nlohmann::json objects = nlohmann::json::array();
    for (const scene::Object& object : scene.objects) {
        objects.push_back(object.name);
    }
    return {
        {"format", scene.format},
        {"axes", app::axes_text(scene.axes)},
        {"meters_per_unit", scene.meters_per_unit},
        {"triangles", scene.triangle_count()},
        {"meshes", scene.meshes.size()},
        {"instances", scene.instances.size()},
        {"materials", scene.materials.size()},
        {"textures", scene.textures.size()},
        {"lights", scene.lights.size()},
        {"emission_scale", scene.emission_scale},
        {"default_light", light.empty() ? nlohmann::json(nullptr) : nlohmann::json(light)},
        {"cameras", cameras_json(scene)},
        {"animations", animations_json(scene)},
        {"bounds",
         {{bounds.min.x, bounds.min.y, bounds.min.z}, {bounds.max.x, bounds.max.y, bounds.max.z}}},
        {"objects", objects}};
}

std::string lights_text(const scene::Scene& scene, const std::string& light) {
    const std::string_view besides = light.empty()            ? ""
                                     : light == unknown_light ? "; other light "
                                                              : "; lit by ";
    const std::string emission =
        scene.emission_scale == 1.0F
            ? std::string()
            : fmt::format("; emission x {:g}, to the units of Blender's lamps",
                          scene.emission_scale);
    return fmt::format("{}{}{}{}", scene.lights.size(), besides, light, emission);
}

std::string scene_text(const scene::Scene& scene, const std::string& light, bool objects) {
    const auto bounds = scene.bounds();
    const auto size = bounds.size();
    std::string text = fmt::format("{}\n", printable(scene.name));
    const auto line = [&text](std::string_view name, const std::string& value) {
        text += fmt::format("  {:<10} {}\n", name, value);
    };
    line("format", scene.format);
    line("axes",
         fmt::format("{}; a unit is {} m", app::axes_text(scene.axes), scene.meters_per_unit));
    line("extent", fmt::format("{:.4g} x {:.4g} x {:.4g} units", size.x, size.y, size.z));
    line("bounds",
         fmt::format("({:.4g}, {:.4g}, {:.4g}) .. ({:.4g}, {:.4g}, {:.4g})", bounds.min.x,
                     bounds.min.y, bounds.min.z, bounds.max.x, bounds.max.y, bounds.max.z));
    line(
        "triangles",
        fmt::format("{} in {}, {}", count_text(static_cast<double>(scene.triangle_count())),
                    counted(scene.objects.size(), "object"), counted(scene.meshes.size(), "mesh")));
    line("materials",
         fmt::format("{}, {}", scene.materials.size(), counted(scene.textures.size(), "texture")));
    line("lights", lights_text(scene, light));
    line("cameras", std::to_string(scene.cameras.size()));
    for (const scene::Camera& camera : scene.cameras) {
        text += fmt::format("  camera     {}\n", camera_text(camera));
    }
    for (const scene::Animation& animation : animations_of(scene)) {
        text += fmt::format("  animation  {}, {:.4g} s\n", printable(animation.name),
                            animation.duration);
    }
    if (objects) {
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            text += fmt::format("  object {:<4} {}\n", i + 1, printable(scene.objects[i].name));
        }
    }
    return text;
}

bool is_lens(const std::string& file) {
    const std::string extension = extension_of(file);
    return extension == ".dat" || extension == ".zmx";
}

ExitCode lens_info(const InfoOptions& options) {
    const auto file = data::find_file(options.scene, std::filesystem::path("."));
    const auto lens = file ? data::read_prescription(*file) : file.diagnostics;
    Answer answer;
    if (answer.add(lens.diagnostics)) {
        const std::vector<camera::FieldSpots> fields = camera::field_spots(**lens);
        answer.facts["lens"] = to_json(**lens, fields);
        answer.text = to_text(**lens, fields);
    }
    return give(answer, options.manner);
}

ExitCode info(const InfoOptions& options) {
    if (is_lens(options.scene)) {
        return lens_info(options);
    }
    auto loaded = app::load_scene(options.scene);
    Answer answer;
    if (answer.add(loaded.diagnostics)) {
        const auto scene = std::make_shared<const scene::Scene>(std::move(*loaded));
        const std::string light = may_need_light(*scene) ? default_light(scene) : "";
        answer.facts["scene"] = scene_json(*scene, light);
        answer.text = scene_text(*scene, light, options.objects);
    }
    return give(answer, options.manner);
}

}  // namespace

void add_info_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, InfoOptions& options) {
        command.add<InfoOptions>(
            {{scene_argument(&InfoOptions::scene,
                             scene_files_text() +
                                 ", or lens of glass (.dat, .zmx), built-in ones too; for "
                                 "cameras, see 'list' and 'explain'"),
              flag({.name = "--objects",
                    .meaning = "list the objects with their ids in the object layer"},
                   true, &InfoOptions::objects),
              json_flag(&InfoOptions::manner, "print the facts and all objects as JSON")}},
            options);
        command.footer("Examples:\n  balcony info room.glb --objects\n  balcony info dgauss.dat");
    };
    add_command<InfoOptions>(app, code, "info", "describes a scene file or a lens", info, describe);
}

}  // namespace balcony::cli
