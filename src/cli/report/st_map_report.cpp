// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/st_map_report.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/report/json.hpp"
#include "cli/report/report.hpp"

namespace balcony::cli {

void StMapOutcome::add(const Diagnostics& found, ExitCode code_of_errors) {
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    code = has_errors(found) ? code_of_errors : code;
}

void StMapOutcome::add(const bridge::StMapWritten& file) {
    written = file;
    add(file.problems, ExitCode::environment);
    if (code == ExitCode::done && !file.complete) {
        code = ExitCode::interrupted;
    }
}

ExitCode report_st_map(const StMapOutcome& outcome, const std::string& output, bool quiet,
                       bool as_json) {
    const bool done = outcome.code == ExitCode::done;
    if (as_json) {
        nlohmann::json document{{"output", nullptr}, {"diagnostics", to_json(outcome.diagnostics)}};
        if (done) {
            document["output"] = output;
            document["width"] = outcome.map->width();
            document["height"] = outcome.map->height();
            document["valid"] = outcome.written.valid;
        }
        print_json(document);
        return outcome.code;
    }
    report(outcome.diagnostics);
    if (done && !quiet) {
        print_result(fmt::format("{}: {} x {} pixels, {} of them in the photo\n", printable(output),
                                 outcome.map->width(), outcome.map->height(),
                                 outcome.written.valid));
    }
    return outcome.code;
}

}  // namespace balcony::cli
