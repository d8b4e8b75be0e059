// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <csignal>
#include <exception>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>
#include <nlohmann/json.hpp>

#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/report/json.hpp"
#include "cli/report/report.hpp"
#include "cli/report/usage.hpp"

namespace {

namespace cli = balcony::cli;
using cli::ExitCode;

// A stream that is closed would lend its number to the next file opened, and what is written to the
// stream would go there. Results cannot be written to what takes its place, the rest is dropped.
void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0) {
            // The lowest free number is given, which is this stream's.
            [[maybe_unused]] const int opened =
                open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

void describe(CLI::App& app) {
    app.formatter(cli::help_layout());
    app.set_help_flag("-h,--help", "show this and end");
    app.set_version_flag("-V,--version", "balcony " BALCONY_VERSION, "show the version and end");
    app.option_defaults()->take_last();
    app.require_subcommand(1);
    app.footer(
        "First steps:\n"
        "  balcony info scene.glb                         what is in a scene\n"
        "  balcony render scene.glb -o picture.png        a picture of it\n"
        "  balcony render scene.glb --camera superelliptic -o walls.png\n"
        "  balcony list cameras                           the cameras that come along\n"
        "\n"
        "Exit codes: 0 done, 1 bad input, 2 wrong usage, 3 environment (disk full, ...),\n"
        "130 interrupted, with what was rendered so far saved.");
}

void tell(const balcony::Diagnostic& said, bool as_json) {
    if (as_json) {
        cli::print_json(nlohmann::json::object({{"diagnostics", cli::to_json({said})}}));
    } else {
        cli::report({said});
    }
}

// CLI11 takes the last word first. `help render` is `render --help`.
std::vector<std::string> words_from_the_last(int argc, char** argv) {
    std::vector<std::string> words(argv + 1, argv + argc);
    if (words.front() == "help") {
        words.erase(words.begin());
        words.emplace_back("--help");
    }
    std::reverse(words.begin(), words.end());
    return words;
}

ExitCode run(CLI::App& app, int argc, char** argv) {
    ExitCode code = ExitCode::done;
    cli::add_render_command(app, code);
    cli::add_check_command(app, code);
    cli::add_explain_command(app, code);
    cli::add_fmt_command(app, code);
    cli::add_list_command(app, code);
    cli::add_locate_command(app, code);
    cli::add_info_command(app, code);
    cli::add_draw_command(app, code);
    // Asked for before the command line is understood, since that may fail.
    const bool as_json = std::any_of(
        argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    if (argc < 2) {
        cli::print_aside(app.help());
        return ExitCode::wrong_usage;
    }
    try {
        app.parse(words_from_the_last(argc, argv));
    } catch (const CLI::CallForHelp&) {
        cli::print_result(app.help());
    } catch (const CLI::CallForVersion& version) {
        cli::print_result(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& problem) {
        tell(cli::usage_error(app, problem), as_json);
        return ExitCode::wrong_usage;
    } catch (const std::exception& problem) {
        tell(balcony::error(problem.what()), as_json);
        return ExitCode::environment;
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    open_closed_streams();
    // Whoever reads no further from a pipe does not end a render.
    std::signal(SIGPIPE, SIG_IGN);
    // Before any thread exists, so that all of them leave the signals to one.
    const cli::Interruption interruption;

    CLI::App app{
        "Balcony renders 3D scenes through extended cameras: any function from a point of\n"
        "the picture to a ray, described in a .cam file.",
        "balcony"};
    describe(app);
    ExitCode code = run(app, argc, argv);
    if (!cli::finish_output()) {
        cli::report({balcony::error("standard output cannot be written to")});
        code = code == ExitCode::done ? ExitCode::environment : code;
    }
    return static_cast<int>(code);
}
