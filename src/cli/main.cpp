// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <csignal>
#include <exception>
#include <new>
#include <string>
#include <string_view>
#include <vector>

#include <fcntl.h>
#include <unistd.h>

#include "cli/commands/command.hpp"
#include "cli/interruption.hpp"
#include "cli/options/command_words.hpp"
#include "cli/report/completions.hpp"
#include "cli/report/manual.hpp"
#include "cli/report/report.hpp"
#include "cli/report/usage.hpp"

namespace {

namespace cli = balcony::cli;
using cli::ExitCode;

// If a standard stream is closed, the next file opened would get its descriptor and receive the
// stream's output. A substitute prevents this: writing results to it fails, other output is
// dropped.
void open_closed_streams() {
    for (const int stream : {STDIN_FILENO, STDOUT_FILENO, STDERR_FILENO}) {
        if (fcntl(stream, F_GETFD) < 0) {
            // open() returns the lowest free descriptor, which is this stream's.
            [[maybe_unused]] const int opened =
                open("/dev/null", stream == STDERR_FILENO ? O_WRONLY : O_RDONLY);
        }
    }
}

void describe(CLI::App& app, bool whole_help) {
    app.formatter(cli::help_layout(whole_help));
    app.set_help_flag("-h,--help", "show this help and exit");
    app.set_version_flag("-v,-V,--version", "balcony " BALCONY_VERSION,
                         "show the version and exit");
    app.option_defaults()->take_last();
    app.require_subcommand(1);
    app.footer(
        "First steps:\n"
        "  balcony info scene.glb                         describe a scene\n"
        "  balcony render scene.glb -o picture.png        render it\n"
        "  balcony render scene.glb --camera panorama -o all_round.png\n"
        "  balcony list cameras                           list the built-in cameras\n"
        "\n"
        "Exit codes: 0 success, 1 bad input, 2 wrong usage, 3 environment (disk full,\n"
        "...), 130 interrupted (the partial picture is saved).");
}

// The words in the form that the options parse. CLI11 expects them in reverse order.
balcony::Result<std::vector<std::string>> words_from_the_last(const CLI::App& app,
                                                              std::vector<std::string> words) {
    const std::vector<const CLI::App*> commands =
        app.get_subcommands([&words](const CLI::App* one) {
            return !words.empty() && one->get_name() == words.front();
        });
    const auto* command =
        commands.empty() ? nullptr : dynamic_cast<const cli::Command*>(commands.front());
    balcony::Result<std::vector<std::string>> own =
        command != nullptr ? command->in_own_words(words)
                           : balcony::Result<std::vector<std::string>>(std::move(words));
    if (own) {
        std::reverse(own->begin(), own->end());
    }
    return own;
}

ExitCode run(CLI::App& app, const std::vector<std::string>& line, int argc, char** argv) {
    ExitCode code = ExitCode::done;
#define BALCONY_ADD(NAME) cli::add_##NAME##_command(app, code);
    BALCONY_COMMANDS(BALCONY_ADD)
#undef BALCONY_ADD
    // Looked up before the command line is parsed, since parsing may fail.
    const bool as_json = std::any_of(
        argv, argv + argc, [](const char* word) { return std::string_view(word) == "--json"; });
    const auto refused = [as_json](const balcony::Diagnostic& diagnostic) {
        return cli::give({{diagnostic}}, {.json = as_json});
    };
    if (argc < 2) {
        cli::print_aside(app.help());
        return ExitCode::wrong_usage;
    }
    // For the scripts of the shells and for the installation.
    const std::vector<std::string> words(argv + 2, argv + argc);
    if (std::string_view(argv[1]) == "complete") {
        cli::print_file(cli::completions(app, words));
        return code;
    }
    if (std::string_view(argv[1]) == "manual" && words.size() == 1) {
        return cli::give({cli::write_manual(app, words.front())}, {});
    }
    auto from_the_last = words_from_the_last(app, line);
    if (!from_the_last) {
        return refused(from_the_last.diagnostics.front());
    }
    try {
        app.parse(*from_the_last);
    } catch (const CLI::CallForHelp&) {
        const std::vector<std::string> unknown = app.remaining();
        if (app.get_subcommands().empty() && !unknown.empty()) {
            return refused(cli::usage_error(app, CLI::ExtrasError("help", unknown)));
        }
        cli::print_result(app.help());
    } catch (const CLI::CallForVersion& version) {
        cli::print_result(std::string(version.what()) + "\n");
    } catch (const CLI::ParseError& problem) {
        return refused(cli::usage_error(app, problem));
    } catch (const std::bad_alloc&) {
        return refused(balcony::error(balcony::Kind::environment, "there is not enough memory",
                                      "make the picture smaller, or free some memory"));
    } catch (const std::exception& problem) {
        return refused(balcony::error(balcony::Kind::internal, problem.what()));
    }
    return code;
}

}  // namespace

int main(int argc, char** argv) {
    open_closed_streams();
    // A closed pipe must not end a render.
    std::signal(SIGPIPE, SIG_IGN);
    // Neither must a file that is larger than the user's limit: its writing fails.
    std::signal(SIGXFSZ, SIG_IGN);
    // Before any thread exists, so that all threads inherit the blocked signals.
    const cli::Interruption interruption;

    CLI::App app{
        "Balcony renders 3D scenes through extended cameras. A camera is any function\n"
        "from a point of the picture to a ray, described in a .cam file.",
        "balcony"};
    bool whole_help = false;
    const std::vector<std::string> line =
        cli::command_words(std::vector<std::string>(argv + 1, argv + argc), whole_help);
    describe(app, whole_help);
    ExitCode code = run(app, line, argc, argv);
    // A command that has failed in its environment has said so.
    if (!cli::finish_output() && code != ExitCode::environment) {
        const balcony::Diagnostics failed{
            balcony::error(balcony::Kind::environment, "standard output cannot be written to")};
        cli::report(failed);
        code = code == ExitCode::done ? cli::exit_code_of(failed) : code;
    }
    return static_cast<int>(code);
}
