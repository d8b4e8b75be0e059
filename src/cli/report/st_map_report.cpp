// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/st_map_report.hpp"

#include <fmt/format.h>

namespace balcony::cli {

void add_written(Answer& answer, const bridge::StMap& map, const bridge::StMapWritten& written,
                 const std::string& output) {
    answer.interrupted = answer.add(written.problems) && !written.complete;
    if (answer.is_done()) {
        answer.facts.update({{"output", output},
                             {"width", map.width()},
                             {"height", map.height()},
                             {"valid", written.valid}});
        answer.text = fmt::format("{}: {} x {} pixels, {} of them in the photo\n",
                                  printable(output), map.width(), map.height(), written.valid);
    }
}

}  // namespace balcony::cli
