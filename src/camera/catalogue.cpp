// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/catalogue.hpp"

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
        case StageKind::clip_shape: return "clip shape";
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
    std::erase_if(values_, [&](const auto& named) { return named.first == name; });
    values_.emplace_back(name, std::move(value));
}

const Arguments::Value* Arguments::find(std::string_view name) const {
    const auto entry = std::find_if(values_.begin(), values_.end(),
                                    [&](const auto& named) { return named.first == name; });
    return entry != values_.end() ? &entry->second : nullptr;
}

const Arguments::Value& Arguments::value(std::string_view name) const {
    const Value* given = find(name);
    assert(given != nullptr && "a maker uses only parameters of its row");
    return *given;
}

bool Arguments::has(std::string_view name) const { return find(name) != nullptr; }

Scalar Arguments::number(std::string_view name) const {
    return std::get<std::vector<Scalar>>(value(name)).at(0);
}

double Arguments::constant(std::string_view name) const {
    const std::optional<double> known = number(name).constant();
    assert(known && "the row says that it is constant");
    return *known;
}

std::size_t Arguments::count(std::string_view name) const {
    return static_cast<std::size_t>(constant(name));
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

const PointList& Arguments::points(std::string_view name) const {
    return std::get<PointList>(value(name));
}

ObjectGeneratorPointer Arguments::curve(std::string_view name) const {
    return stage<ObjectGenerator>(name);
}

const Formula& Arguments::formula(std::string_view name) const {
    return std::get<Formula>(value(name));
}

const std::shared_ptr<const GreyImage>& Arguments::image(std::string_view name) const {
    return std::get<std::shared_ptr<const GreyImage>>(value(name));
}

const std::shared_ptr<const TexturedMesh>& Arguments::mesh(std::string_view name) const {
    return std::get<std::shared_ptr<const TexturedMesh>>(value(name));
}

}  // namespace balcony::camera
