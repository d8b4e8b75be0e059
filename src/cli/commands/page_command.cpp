// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "balcony/output_file.hpp"
#include "balcony/page.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/render_observer.hpp"

namespace balcony::cli {

namespace {

struct PageOptions {
    page::PageRequest request;
    std::string parameters = "all";
    std::string output;
    Manner manner;
};

ExitCode write_page(const PageOptions& options) {
    Answer answer;
    answer.facts["output"] = nullptr;
    page::PageRequest request = options.request;
    request.open = open_names(options.parameters);
    if (!answer.add(OutputFile::check(options.output))) {
        return give(answer, options.manner);
    }
    RenderObserver observer(options.manner);
    const Result<page::Page> made = page::make_page(request, observer.observer(), observer.token());
    observer.clear();
    answer.interrupted = observer.token().stop_requested();
    if (answer.add(made.diagnostics) && answer.is_done() &&
        answer.add(write_whole(options.output, made->html))) {
        answer.facts = {{"output", options.output},
                        {"bytes", made->html.size()},
                        {"width", made->size[0]},
                        {"height", made->size[1]},
                        {"triangles", made->triangles},
                        {"textures", made->textures},
                        {"parameters", {{"open", made->open}, {"closed", made->closed}}}};
        answer.text = fmt::format(
            "{}: {:.1f} MB, {} triangles, {} sliders\n", printable(options.output),
            static_cast<double>(made->html.size()) / 1e6, made->triangles, made->open.size());
    }
    return give(answer, options.manner);
}

/// The options of a picture that a page has.
app::Options<app::Request> picture_rows() {
    app::Options<app::Request> made = app::scene_options();
    made.rows.push_back(app::time_option(1e9, &app::Request::settings, &render::Settings::time));
    made.add(&app::Request::size,
             app::size_options("size of the picture in pixels, where the window has room for it"));
    made.add(app::look_options());
    made.leave_out({"--solve", "--view-transform", "--ambient"});
    return made;
}

}  // namespace

void add_page_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, PageOptions& options) {
        app::Options<page::PageRequest> rows;
        rows.add(&page::PageRequest::picture,
                 {{scene_argument(&app::Request::scene, scene_files_text())}});
        rows.add(&page::PageRequest::picture, picture_rows());
        rows.add({{option({.name = "--title",
                           .placeholder = "TEXT",
                           .meaning = "title of the page (default: the names of the scene and the "
                                      "camera)"},
                          text(), &page::PageRequest::title),
                   option({.name = "--texture-side",
                           .placeholder = "PIXELS",
                           .meaning = "images with longer sides are reduced"},
                          app::count(1, 4096), &page::PageRequest::texture_side)}});
        app::Options<PageOptions> all{
            {output_option(&PageOptions::output, "output file: .html", true),
             option({.name = "--parameters",
                     .placeholder = "NAMES",
                     .meaning = "the camera's parameters that have sliders: all, none, or names "
                                "with commas between them"},
                    text(), &PageOptions::parameters)}};
        all.add(&PageOptions::request, std::move(rows));
        all.add(manner_options(&PageOptions::manner));
        command.add(std::move(all), options);
        command.show_first({"--output", "--camera", "--set", "--fit", "--fit-to", "--from",
                            "--parameters", "--title", "--size", "--exposure", "--quiet"});
        command.footer(
            "Examples:\n"
            "  balcony page room.glb --camera my.cam -o page.html\n"
            "  balcony page room.glb --camera panorama --fit -o panorama.html\n"
            "  balcony page room.glb --camera my.cam:closeup --parameters fov,tilt -o page.html\n"
            "\n"
            "The file needs no server and no network. docs/page.md says what it shows.");
    };
    add_command<PageOptions>(
        app, code, "page",
        "writes a page in which a browser looks through a camera, with its parameters as sliders",
        write_page, describe);
}

}  // namespace balcony::cli
