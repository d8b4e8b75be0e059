// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <string>

#include "balcony/st_maps.hpp"
#include "cli/exit_code.hpp"

namespace balcony::cli {

/// What came of an STMap, which was written or by which a photo was warped.
struct StMapOutcome {
    ExitCode code = ExitCode::done;
    Diagnostics diagnostics{};
    std::optional<bridge::StMap> map{};
    bridge::StMapWritten written{};

    /// Adds findings; errors among them decide the exit code.
    void add(const Diagnostics& found, ExitCode code_of_errors);
    /// Takes over what is known of the written file.
    void add(const bridge::StMapWritten& file);
};

/// Tells about the output file of an outcome and returns its code.
ExitCode report_st_map(const StMapOutcome& outcome, const std::string& output, bool quiet,
                       bool as_json);

}  // namespace balcony::cli
