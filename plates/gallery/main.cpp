// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// build_gallery: writes the scene of plates 1 to 3 as a binary glTF file.

#include <cstdio>
#include <exception>
#include <filesystem>
#include <system_error>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "balcony/output_file.hpp"
#include "gallery/gallery.hpp"

namespace {

using namespace balcony;

enum ExitCode : int { done = 0, wrong_usage = 2, environment = 3 };

int report(const Diagnostics& diagnostics) {
    fmt::print(stderr, "{}", to_text(diagnostics));
    return environment;
}

int write_paintings(const std::filesystem::path& folder) {
    std::error_code failure;
    std::filesystem::create_directories(folder, failure);
    int number = 0;
    for (const plates::Hanging& hanging : plates::hangings()) {
        const auto file = folder / fmt::format("picture-{}.png", ++number);
        const std::vector<std::uint8_t> png = to_png(plates::paint_hanging(hanging));
        if (const Diagnostics said = write_whole(file, png); !said.empty()) {
            return report(said);
        }
    }
    return done;
}

int run(int argc, char** argv) {
    std::filesystem::path output;
    std::filesystem::path paintings;
    plates::GalleryContent content;
    bool without = false;

    CLI::App app{"Writes the gallery of plates 1 to 3 as a binary glTF file.", "build_gallery"};
    app.add_option("OUT.glb", output, "File to write");
    app.add_flag("--without-pictures-and-walls", without,
                 "Leave only the grid of boxes and cylinders, and the lights (plate 3)");
    app.add_option("--paintings", paintings, "Also write each painting as a PNG file to a folder")
        ->type_name("DIR");
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? done : wrong_usage;
    }
    if (output.empty() && paintings.empty()) {
        fmt::print(stderr, "error: name a file to write, or a folder with --paintings\n");
        return wrong_usage;
    }

    if (!paintings.empty()) {
        if (const int code = write_paintings(paintings); code != done) {
            return code;
        }
    }
    if (!output.empty()) {
        content.pictures_and_walls = !without;
        const Result<scene::Scene> gallery = plates::make_gallery(content);
        if (!gallery) {
            return report(gallery.diagnostics);
        }
        const std::vector<std::uint8_t> glb = scene::to_glb(*gallery);
        if (const Diagnostics said = write_whole(output, glb); !said.empty()) {
            return report(said);
        }
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
