// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "live/remarks.hpp"

#include <algorithm>
#include <string>
#include <utility>

namespace balcony::live {

void add_remarks(const app::CameraCheck& check, std::vector<Remark>& remarks) {
    const bool is_whole = check.layers.empty();
    const std::string camera = is_whole ? "" : check.title();
    for (const analyse::Finding& one : check.report.findings) {
        std::string name(analyse::name_of(one.kind));
        std::replace(name.begin(), name.end(), '_', ' ');
        Remark& made = remarks.emplace_back(
            Remark{camera, std::move(name), one.defect, one.message, one.remedy});
        if (is_whole) {
            made.areas = check.report.grid.cells_of(one.samples);
            made.example = one.place.point;
        }
    }
    if (!check.in_scene) {
        return;
    }
    for (const app::CameraCheck::InScene::Finding& one : check.in_scene->findings()) {
        Remark& made = remarks.emplace_back(
            Remark{camera, std::string(one.name), one.defect, one.message, one.remedy});
        if (is_whole) {
            made.example = one.at;
        }
    }
}

}  // namespace balcony::live
