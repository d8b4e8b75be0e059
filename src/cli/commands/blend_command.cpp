// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "balcony/blend.hpp"
#include "balcony/output_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/options/photo_options.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct BlendOptions {
    PhotoRequest photo;  ///< Without its camera.
    std::vector<std::string> cameras;
    std::string folder;
    double gamma = 2.2;
    std::size_t columns = 65;
    bool only_mesh = false;
    Manner manner;
};

struct Outputs {
    std::string name;  ///< Of the projector.
    fs::path mask, mesh;
};

/// Files named after the cameras, none of which may be one that was read.
std::vector<Outputs> outputs_of(const BlendOptions& options,
                                const std::vector<bridge::SourceCamera>& projectors,
                                const lang::Workspace& workspace, Answer& answer) {
    std::vector<Outputs> all;
    for (const bridge::SourceCamera& each : projectors) {
        const std::string& name = each.rays.name();
        if (std::any_of(all.begin(), all.end(), [&](const Outputs& o) { return o.name == name; })) {
            answer.add({error(Kind::usage, fmt::format("two projectors have the name '{}'", name),
                              "give each a camera with a name of its own")});
        }
        const fs::path base = fs::path(options.folder) / name;
        all.push_back({name, fs::path(base) += ".png", fs::path(base) += ".data"});
        for (const fs::path& file : {all.back().mask, all.back().mesh}) {
            answer.add(OutputFile::check(file));
            answer.add(app::check_overwrites(file, workspace.files()));
        }
    }
    return all;
}

void write_projector(const BlendOptions& options, const bridge::Blend& blend, std::size_t number,
                     const bridge::StMap& film, const Outputs& outputs, Answer& answer,
                     const std::stop_token& stop) {
    const bridge::RayGrid& rays = blend.rays(number);
    const auto rows = static_cast<std::size_t>(
        std::max(2.0, std::round(1.0 + static_cast<double>(options.columns - 1) *
                                           static_cast<double>(rays.height()) /
                                           static_cast<double>(rays.width()))));
    const bridge::WarpMesh mesh =
        warp_mesh(blend, number, film, options.columns, rows,
                  options.only_mesh ? std::optional(options.gamma) : std::nullopt);
    nlohmann::json facts{{"camera", outputs.name},
                         {"width", rays.width()},
                         {"height", rays.height()},
                         {"mesh", outputs.mesh.string()},
                         {"mask", nullptr}};
    std::string files = outputs.mesh.string();
    if (!answer.add(write_whole(outputs.mesh, to_text(mesh)))) {
        return;
    }
    if (!options.only_mesh) {
        const auto mask = write_mask(blend, number, options.gamma, outputs.mask, stop);
        if (!answer.add(mask.problems)) {
            return;
        }
        facts["mask"] = outputs.mask.string();
        facts["blended"] = mask.overlap;
        files += fmt::format(" and {}, {} of {} pixels blended", outputs.mask.string(),
                             mask.overlap, rays.size());
    }
    answer.facts["projectors"].push_back(std::move(facts));
    answer.text += printable(files) + "\n";
}

void make_files(const BlendOptions& options, Answer& answer) {
    const Interruptible work;
    lang::Workspace workspace;
    workspace.stop_with(work.token());
    std::vector<bridge::SourceCamera> projectors;
    for (const std::string& camera : options.cameras) {
        PhotoRequest request = options.photo;
        request.camera = camera;
        auto made = make_wanted(request, workspace);
        if (!answer.add(made.diagnostics)) {
            return;
        }
        projectors.push_back(std::move(*made));
    }
    const auto source = make_source(options.photo, workspace);
    if (!answer.add(source.diagnostics)) {
        return;
    }
    const std::vector<Outputs> outputs = outputs_of(options, projectors, workspace, answer);
    const bridge::Parallax parallax =
        options.photo.allow_parallax ? bridge::Parallax::ignore : bridge::Parallax::refuse;
    std::vector<bridge::StMap> films;
    for (const bridge::SourceCamera& each : projectors) {
        auto film = bridge::StMap::make(each.rays, *source, parallax);
        if (!answer.add(film.diagnostics)) {
            return;
        }
        films.push_back(std::move(*film));
    }
    if (!answer.is_done()) {
        return;
    }
    const auto blend = bridge::Blend::make(projectors, parallax, work.token());
    if (!answer.add(blend.diagnostics)) {
        return;
    }
    for (std::size_t i = 0; i < outputs.size() && answer.is_done(); ++i) {
        write_projector(options, *blend, i, films[i], outputs[i], answer, work.token());
    }
}

ExitCode blend(const BlendOptions& options) {
    Answer answer;
    answer.facts["projectors"] = nlohmann::json::array();
    make_files(options, answer);
    return give(answer, options.manner);
}

}  // namespace

void add_blend_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, BlendOptions& options) {
        app::Options<BlendOptions> all{
            {app::words({.name = "CAMERA",
                         .placeholder = "FILE[:NAME]",
                         .meaning = "camera of each projector: what the audience's eye sees where "
                                    "the light of a pixel falls",
                         .required = true,
                         .type = OptionType::camera},
                        &BlendOptions::cameras),
             output_option(&BlendOptions::folder,
                           "folder for a mesh NAME.data and a mask NAME.png of each projector",
                           true)}};
        all.add(&BlendOptions::photo, photo_options());
        all.add({{option({.name = "--gamma",
                          .placeholder = "G",
                          .meaning = "light of a projector is its pixel to the power of G"},
                         app::number(0.1, 10.0, "give a number from 0.1 to 10, such as 2.2"),
                         &BlendOptions::gamma),
                  option({.name = "--columns",
                          .placeholder = "COUNT",
                          .meaning = "number of nodes along the width of a mesh"},
                         app::count(2, 4096), &BlendOptions::columns),
                  flag({.name = "--only-mesh",
                        .meaning = "blend by the intensities of the mesh and write no masks"},
                       true, &BlendOptions::only_mesh)}});
        all.add(manner_options(&BlendOptions::manner));
        command.add(std::move(all), options);
        command.footer(
            "Examples:\n"
            "  balcony blend dome.cam:left dome.cam:right --from fulldome --size 1920x1080 -o out");
    };
    add_command<BlendOptions>(app, code, "blend",
                              "makes warp meshes and blending masks for several projectors", blend,
                              describe);
}

}  // namespace balcony::cli
