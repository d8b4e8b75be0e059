// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/format.h>

#include "balcony/studies.hpp"

namespace balcony::app {

std::size_t CameraCheck::defect_count() const {
    auto count = static_cast<std::size_t>(
        std::count_if(report.findings.begin(), report.findings.end(),
                      [](const analyse::Finding& finding) { return finding.defect; }));
    if (in_scene) {
        count += in_scene->miss ? 1U : 0U;
        count += static_cast<std::size_t>(
            std::count_if(in_scene->starts_inside.begin(), in_scene->starts_inside.end(),
                          [](const StartInside& start) { return !start.is_around_all; }));
    }
    return count;
}

std::string CameraCheck::title() const {
    std::string text = report.camera + (by_itself && !layers.empty() ? ", and" : "");
    for (std::size_t i = 0; i < layers.size(); ++i) {
        text += fmt::format("{} layer {} of {}", i > 0 || !by_itself ? "," : "", layers[i].number,
                            layers[i].picture);
    }
    return text;
}

}  // namespace balcony::app
