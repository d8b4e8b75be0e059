// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <cerrno>
#include <filesystem>
#include <string>

#include <fmt/format.h>

#include "balcony/app.hpp"
#include "balcony/names.hpp"
#include "base/installed_file.hpp"
#include "cli/commands/command.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/render_observer.hpp"
#include "cli/report/render_report.hpp"

namespace balcony::cli {

namespace {

namespace fs = std::filesystem;

struct DemoOptions {
    std::string output = "gallery.png";
    SizeRequest size;
    Manner manner;
};

app::Request walls_of(const fs::path& gallery, const DemoOptions& options) {
    app::Request request{.scene = gallery.string(), .camera = "superelliptic"};
    request.size = options.size;
    if (!options.size.width && !options.size.height) {
        request.size.width = 1500;
    }
    request.exposure = 0.8;
    request.denoise = true;
    request.job.checkpoint_every.reset();
    request.output = options.output;
    return request;
}

// The command as its user has typed it.
std::string next_steps(const fs::path& gallery) {
    return fmt::format(
        "\nThe same room as a planet, your own scene, the cameras that there are:\n"
        "  {0} render {1} --camera little_planet -o planet.png\n"
        "  {0} render room.glb --camera superelliptic -o walls.png\n"
        "  {0} list cameras\n",
        printable(program_invocation_name), printable(gallery.string()));
}

ExitCode demo(const DemoOptions& options) {
    Answer answer{app::check_output(options.output)};
    const auto gallery =
        installed_file(BALCONY_DATA_FOLDER, "gallery.glb", "is the scene of the demo");
    if (!answer.add(gallery.diagnostics) || has_errors(answer.diagnostics)) {
        return give(answer, options.manner);
    }
    const app::Request request = walls_of(*gallery, options);
    RenderObserver observer(options.manner);
    app::Session session;
    answer = answer_of(session.render(request, observer.observer(), observer.token()), request);
    answer.facts["scene"] = request.scene;
    if (answer.is_done()) {
        answer.text += next_steps(*gallery);
    }
    return give(answer, options.manner);
}

}  // namespace

void add_demo_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, DemoOptions& options) {
        app::Options<DemoOptions> all{
            {output_option(&DemoOptions::output, "output file: .png, .jpg, .webp, .tif, or .exr")}};
        all.add(&DemoOptions::size, app::size_options("size in pixels (default: 1500x300)"));
        all.add(manner_options(&DemoOptions::manner));
        command.add(std::move(all), options);
        command.footer("Example:\n  balcony demo -o walls.png");
    };
    add_command<DemoOptions>(app, code, "demo",
                             "renders a gallery, all walls in one picture, and says what is next",
                             demo, describe);
}

}  // namespace balcony::cli
