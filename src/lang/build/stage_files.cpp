// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Arguments that are files: tables of points, images, meshes, maps, calibrations.

#include <utility>

#include "lang/build/stages.hpp"

namespace balcony::lang {

using camera::Failed;

std::optional<data::File> StageBuilder::file(const Expression& node) {
    const auto folder = module_.built_in ? std::nullopt : std::optional(module_.folder);
    const Result<data::File>& found = session_.files().find(node.name.text, folder);
    report(found.diagnostics, node.span);
    return found.value;
}

// One point a line; a list of numbers may stand in one line or in several.
StageBuilder::Located StageBuilder::table(const camera::PointsParameter& type, ExpressionId given) {
    const Expression& node = tree_[given];
    Located made{Failed{}, {tree_.at(node.span)}};
    const data::NumberTable* read = session_.table(tree_, node.name);
    if (read == nullptr) {
        return made;
    }
    const bool numbers = type.coordinates == std::vector<std::size_t>{1};
    camera::Points points;
    for (const auto& line : read->rows) {
        Written place;
        camera::Tuple point;
        for (std::size_t i = 0; i < line.size(); ++i) {
            point.push_back({line[i].value, line[i].angle ? Unit::angle : Unit::number});
            place.parts.push_back({read->at(line[i])});
            if (numbers || i + 1 == line.size()) {
                place.span = join(place.parts.front().span, place.parts.back().span);
                points.push_back(std::exchange(point, {}));
                made.place.parts.push_back(std::exchange(place, {}));
            }
        }
    }
    made.value = std::move(points);
    return made;
}

}  // namespace balcony::lang
