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

StageBuilder::Located StageBuilder::image(ExpressionId given) {
    return file(
        given, [this](const data::File& found) -> const auto& {
            return session_.files().image(found);
        });
}

StageBuilder::Located StageBuilder::mesh(ExpressionId given) {
    return file(
        given, [this](const data::File& found) -> const auto& {
            return session_.files().mesh(found);
        });
}

StageBuilder::Located StageBuilder::map(camera::MapParameter::Content content, ExpressionId given) {
    return file(
        given, [ this, content ](const data::File& found) -> const auto& {
            return session_.files().map(found, content);
        });
}

StageBuilder::Located StageBuilder::calibration(ExpressionId given) {
    return file(
        given, [this](const data::File& found) -> const auto& {
            return session_.files().calibration(found);
        });
}

template <class Read>
StageBuilder::Located StageBuilder::file(ExpressionId given, Read read) {
    const Expression& node = tree_[given];
    if (node.kind != ExpressionKind::text) {
        return unsuitable(given);
    }
    Located made{Failed{}, {tree_.at(node.span)}};
    if (const auto found = file(node)) {
        const auto& data = read(*found);
        report(data.diagnostics, node.span);
        if (data) {
            made.value = *data;
        }
    }
    return made;
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
