// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/make_stage.hpp"

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::camera {

std::string with_article(std::string_view noun) {
    return fmt::format("{} {}", noun.starts_with('o') ? "an" : "a", noun);
}

bool is_of_kind(const Stage& stage, StageKind kind) { return StagePorts::fits(stage, kind); }

StageResult make_stage(const StageEntry& row, const Arguments& arguments) {
    try {
        StageResult made = row.make(arguments);
        if (made && (*made == nullptr || !is_of_kind(**made, row.kind))) {
            return error(fmt::format("the maker of '{}' does not return {}", row.name,
                                     with_article(name_of(row.kind))));
        }
        return made;
    } catch (const expr::GraphTooLarge&) {
        return error(
            fmt::format("'{}' is too large: its formulas do not fit into a graph", row.name), {},
            "make it of fewer parts");
    }
}

StageResult make_stage(const StageEntry& row, std::span<const NamedValue> values) {
    Binding bound = bind(row, values);
    if (bound.arguments) {
        return make_stage(row, *bound.arguments);
    }
    Diagnostics found;
    for (ArgumentError& one : bound.errors) {
        found.push_back(std::move(one.diagnostic));
    }
    if (found.empty()) {
        found.push_back(error(fmt::format("a value for '{}' has failed", row.name)));
    }
    return found;
}

StageResult make_stage(StageKind kind, std::string_view name,
                       std::initializer_list<NamedValue> values, const Catalogue& known) {
    if (const StageEntry* row = known.find(kind, name)) {
        return make_stage(*row, std::span(values.begin(), values.size()));
    }
    std::vector<std::string> names;
    for (const StageEntry& row : known) {
        if (row.kind == kind) {
            names.emplace_back(row.name);
        }
    }
    return error(fmt::format("there is no {} named '{}'", name_of(kind), name), {},
                 suggestion(name, names, "there are"));
}

}  // namespace balcony::camera
