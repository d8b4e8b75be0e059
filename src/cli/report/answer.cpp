// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/answer.hpp"

#include "cli/report/json.hpp"

namespace balcony::cli {

bool Answer::add(const Diagnostics& found) {
    diagnostics.insert(diagnostics.end(), found.begin(), found.end());
    return !has_errors(found);
}

nlohmann::json to_json(const Answer& answer) {
    nlohmann::json document = answer.facts;
    document["diagnostics"] = to_json(answer.diagnostics);
    return document;
}

ExitCode give(const Answer& answer, const Manner& manner) {
    if (manner.json) {
        print_json(to_json(answer));
    } else {
        report(answer.diagnostics);
        if (!manner.quiet && !answer.text.empty()) {
            answer.print(answer.text);
        }
    }
    return exit_code_of(answer.diagnostics, answer.interrupted);
}

}  // namespace balcony::cli
