// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <exception>

#include <fmt/format.h>

#include "cli/command.hpp"
#include "cli/interruption.hpp"

int main(int argc, char** argv) {
    using balcony::cli::ExitCode;
    // Before any thread exists, so that all of them leave the signals to one.
    const balcony::cli::Interruption interruption;

    CLI::App app{
        "Balcony renders 3D scenes through extended cameras: any function from a point of\n"
        "the picture to a ray, described in a .cam file.\n"};
    app.set_version_flag("--version", "balcony " BALCONY_VERSION);
    app.require_subcommand(1);
    app.failure_message([](const CLI::App* failed, const CLI::Error& problem) {
        const bool in_subcommand = failed->get_subcommands().empty() == false;
        const std::string name =
            in_subcommand ? "balcony " + failed->get_subcommands().front()->get_name() : "balcony";
        return fmt::format("error: {}\n  help: {} --help\n", problem.what(), name);
    });
    app.footer(
        "First steps:\n"
        "  balcony info scene.glb                         what is in a scene\n"
        "  balcony render scene.glb -o picture.png        a picture of it\n"
        "  balcony render scene.glb --camera superelliptic -o walls.png\n"
        "  balcony list cameras                           the cameras that come along\n"
        "\n"
        "Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 environment (disk full, ...),\n"
        "130 interrupted, with what was rendered so far saved.");

    ExitCode code = ExitCode::done;
    balcony::cli::add_render_command(app, code);
    balcony::cli::add_check_command(app, code);
    balcony::cli::add_list_command(app, code);
    balcony::cli::add_info_command(app, code);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& problem) {
        return app.exit(problem) == 0 ? 0 : static_cast<int>(ExitCode::wrong_usage);
    } catch (const std::exception& problem) {
        fmt::print(stderr, "error: {}\n", problem.what());
        return static_cast<int>(ExitCode::environment);
    }
    return static_cast<int>(code);
}
