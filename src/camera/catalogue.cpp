// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/camera.hpp"

#include <algorithm>

#include "camera/families.hpp"

namespace balcony::camera {

std::string_view name_of(StageKind kind) {
    switch (kind) {
        case StageKind::picture_arranger: return "picture arranger";
        case StageKind::picture_mapper: return "picture mapper";
        case StageKind::parameter_transformer: return "parameter transformer";
        case StageKind::object_generator: return "object generator";
        case StageKind::object_transformer: return "object transformer";
        case StageKind::direction_rule: return "direction rule";
    }
    assert(false);
    return {};
}

const std::vector<StageEntry>& catalogue() {
    static const std::vector<StageEntry> rows = [] {
        std::vector<StageEntry> all;
        for (const auto family : families) {
            for (StageEntry& row : family()) {
                all.push_back(std::move(row));
            }
        }
        std::stable_sort(all.begin(), all.end(),
                         [](const StageEntry& a, const StageEntry& b) { return a.kind < b.kind; });
        return all;
    }();
    return rows;
}

const StageEntry* find_stage(StageKind kind, std::string_view name) {
    const auto& rows = catalogue();
    const auto row = std::find_if(rows.begin(), rows.end(), [&](const StageEntry& entry) {
        return entry.kind == kind && entry.name == name;
    });
    return row != rows.end() ? &*row : nullptr;
}

void Arguments::set(std::string_view name, Value value) {
    const auto known = std::find_if(values_.begin(), values_.end(),
                                    [&](const auto& named) { return named.first == name; });
    if (known != values_.end()) {
        known->second = std::move(value);
    } else {
        values_.emplace_back(name, std::move(value));
    }
}

const Arguments::Value& Arguments::value(std::string_view name) const {
    const auto entry = std::find_if(values_.begin(), values_.end(),
                                    [&](const auto& named) { return named.first == name; });
    assert(entry != values_.end() && "a maker asks only for parameters of its row");
    return entry->second;
}

Scalar Arguments::number(std::string_view name) const {
    return std::get<std::vector<Scalar>>(value(name)).at(0);
}

std::array<Scalar, 2> Arguments::pair(std::string_view name) const {
    const auto& numbers = std::get<std::vector<Scalar>>(value(name));
    return {numbers.at(0), numbers.at(1)};
}

std::array<Scalar, 3> Arguments::triple(std::string_view name) const {
    const auto& numbers = std::get<std::vector<Scalar>>(value(name));
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

const std::string& Arguments::choice(std::string_view name) const {
    return std::get<std::string>(value(name));
}

const ObjectGeneratorPointer& Arguments::curve(std::string_view name) const {
    return std::get<ObjectGeneratorPointer>(value(name));
}

}  // namespace balcony::camera
