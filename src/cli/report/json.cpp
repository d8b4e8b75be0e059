// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/json.hpp"

#include <nlohmann/json.hpp>

namespace balcony::cli {

nlohmann::json to_json(const Diagnostics& diagnostics) {
    nlohmann::json list = nlohmann::json::array();
    for (const Diagnostic& diagnostic : diagnostics) {
        nlohmann::json entry{
            {"severity", diagnostic.severity == Severity::error ? "error" : "warning"},
            {"message", diagnostic.message}};
        if (diagnostic.severity == Severity::error) {
            entry["kind"] = name_of(diagnostic.kind);
        }
        if (!diagnostic.remedy.empty()) {
            entry["remedy"] = diagnostic.remedy;
        }
        if (diagnostic.span.source) {
            const LineColumn place = diagnostic.span.source->locate(diagnostic.span.begin);
            entry["file"] = diagnostic.span.source->name();
            entry["line"] = place.line;
            entry["column"] = place.column;
        }
        list.push_back(std::move(entry));
    }
    return list;
}

}  // namespace balcony::cli
