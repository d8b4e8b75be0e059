// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// build_scene: writes the scene of a plate as a binary glTF file.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "balcony/output_file.hpp"
#include "scenes/catalogue.hpp"

namespace {

using namespace balcony;

enum ExitCode : int { done = 0, bad_input = 1, wrong_usage = 2, environment = 3 };

ExitCode report(const Diagnostics& diagnostics, ExitCode code) {
    fmt::print(stderr, "{}", to_text(diagnostics));
    return code;
}

std::string list_of_scenes() {
    std::string text = "Scenes:\n";
    for (const plates::SceneRow& scene : plates::scene_catalogue()) {
        text += fmt::format("  {:<16}{}\n", scene.name, scene.meaning);
    }
    return text;
}

int run(int argc, char** argv) {
    std::string name;
    std::filesystem::path output;
    bool without = false;

    CLI::App app{"Writes the scene of a plate as a binary glTF file.", "build_scene"};
    app.add_option("SCENE", name, "Name of the scene")->required();
    app.add_option("OUT.glb", output, "File to write")->required();
    app.add_flag("--without-pictures-and-walls", without,
                 "Leave only the grid of boxes and cylinders, and the lights (plates 3, 6 and 8)");
    app.footer(list_of_scenes());
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? done : wrong_usage;
    }
    const Result<scene::Scene> scene = plates::make_scene(name, {.pictures_and_walls = !without});
    if (!scene) {
        return report(scene.diagnostics, bad_input);
    }
    if (const Diagnostics said = write_whole(output, scene::to_glb(*scene)); !said.empty()) {
        return report(said, environment);
    }
    return done;
}

}  // namespace

int main(int argc, char** argv) {
    try {
        return run(argc, argv);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "error: {}\n", problem.what());
        return environment;
    }
}
