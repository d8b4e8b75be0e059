// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <iostream>
#include <variant>

#include <nlohmann/json.hpp>

#include "cli/commands/command.hpp"
#include "cli/lsp/messages.hpp"
#include "cli/options/command_rows.hpp"
#include "cli/report/report.hpp"
#include "lsp/server.hpp"

namespace balcony::cli {

namespace {

struct LspOptions {
    bool stdio = false;
};

// The end of the input without shutdown and exit is a failure, as the protocol says.
ExitCode serve(const LspOptions& /*options*/) {
    std::ios::sync_with_stdio(false);
    MessageWriter writer;
    lsp::LanguageServer server([&writer](const nlohmann::json& message) { writer.write(message); });
    while (!server.has_ended()) {
        const std::variant<std::string, NoMessage> read = read_message(std::cin);
        if (const auto* text = std::get_if<std::string>(&read)) {
            server.receive(*text);
            continue;
        }
        const NoMessage why = std::get<NoMessage>(read);
        if (why == NoMessage::end) {
            break;
        }
        writer.write(refusal_of(why));
        if (why == NoMessage::bad_header) {
            break;
        }
    }
    return server.has_ended() && server.was_shut_down() ? ExitCode::done : ExitCode::bad_input;
}

}  // namespace

void add_lsp_command(CLI::App& app, ExitCode& code) {
    const auto describe = [](Command& command, LspOptions& options) {
        command.add<LspOptions>(
            {{flag({.name = "--stdio",
                    .meaning = "use standard input and output, as it always does; some editors "
                               "add it"},
                   true, &LspOptions::stdio)}},
            options);
        command.footer(
            "Editors start it: docs/editors.md has the lines for Neovim, Helix, Kate and "
            "VS Code.");
    };
    add_command<LspOptions>(app, code, "lsp",
                            "serves editors of camera files: the Language Server Protocol", serve,
                            describe);
}

}  // namespace balcony::cli
