// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/names.hpp"
#include "balcony/studies.hpp"

namespace balcony::app {

namespace {

// The first of many names, and how many others there are.
std::string list_text(const std::vector<std::string>& names) {
    constexpr std::size_t max_names = 10;
    const std::size_t shown = std::min(names.size(), max_names);
    const auto end = names.begin() + static_cast<std::ptrdiff_t>(shown);
    const std::string text = fmt::format("{}", fmt::join(names.begin(), end, ", "));
    return shown < names.size() ? fmt::format("{} and {} more", text, names.size() - shown) : text;
}

}  // namespace

std::vector<CameraCheck::InScene::Finding> CameraCheck::InScene::findings() const {
    std::vector<Finding> found;
    if (miss) {
        found.push_back(
            {"meets nothing", true, "no ray meets anything: " + miss->reason, miss->remedy});
    } else if (!never_seen.empty()) {
        found.push_back(
            {"never seen", false,
             fmt::format("{}: {}", counted(never_seen.size(), "object"), list_text(never_seen)),
             ""});
    }
    for (const StartInside& start : starts_inside) {
        Finding& one = found.emplace_back();
        one.name = "starts inside";
        one.defect = !start.is_around_all;
        one.message = fmt::format("{:.3g} % of the rays start inside '{}'", 100.0 * start.share,
                                  start.object);
        one.remedy = start.is_around_all
                         ? "if this object is not the room, move the camera"
                         : "move the camera, or make its eye object smaller or larger";
        if (one.defect) {
            one.at = start.point;
        }
    }
    return found;
}

std::size_t CameraCheck::defect_count() const {
    const auto count = [](const auto& findings) {
        return static_cast<std::size_t>(std::count_if(findings.begin(), findings.end(),
                                                      [](const auto& one) { return one.defect; }));
    };
    return count(report.findings) + (in_scene ? count(in_scene->findings()) : 0);
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
