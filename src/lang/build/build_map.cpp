// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// map u = first .. last, v = square: the picture mapper of a camera or of one of its paths.

#include "lang/build/build_map.hpp"

#include <array>

#include <fmt/format.h>

namespace balcony::lang {

namespace {

/// Its ranges; null where there is none.
struct Ranges {
    const MapRange* u = nullptr;
    const MapRange* v = nullptr;
};

// Nothing after an error.
std::optional<Ranges> ranges_of(const Statement& map, const SyntaxTree& tree, Reporter& reporter) {
    Ranges found;
    for (const MapRange& range : map.ranges()) {
        const std::string_view name = range.coordinate.text;
        if (name != "u" && name != "v") {
            reporter.error(tree.at(range.coordinate.span),
                           fmt::format("map takes ranges for u and v, not for '{}'", name),
                           "for example map u = -1 .. 1, v = square");
            return std::nullopt;
        }
        const MapRange*& slot = name == "u" ? found.u : found.v;
        if (slot != nullptr) {
            report_duplicate(range.coordinate, tree.at(range.coordinate.span),
                             tree.at(slot->coordinate.span), reporter);
            return std::nullopt;
        }
        slot = &range;
    }
    if (found.u == nullptr || found.v == nullptr) {
        const char* missing = found.u == nullptr ? "u" : "v";
        reporter.error(
            tree.at(map.span), fmt::format("this map has no range for '{}'", missing),
            fmt::format("add {0} = -1 .. 1, or {0} = square for square pixels", missing));
        return std::nullopt;
    }
    return found;
}

void warn_of_empty(const MapRange& range, const SyntaxTree& tree, StageBuilder& stages,
                   Reporter& reporter) {
    const auto first = stages.known_number(range.first);
    const auto last = stages.known_number(range.last);
    if (first && first == last) {
        reporter.warning(tree.at({tree[range.first].span.begin, tree[range.last].span.end}),
                         "this range starts and ends at the same value",
                         "the picture does not change in this direction");
    }
}

}  // namespace

camera::PictureMapperPointer build_map(const Statements& statements, const SyntaxTree& tree,
                                       StageBuilder& stages, Reporter& reporter) {
    const Statement* map = statements.find(StatementKind::map);
    const auto ranges = map != nullptr ? ranges_of(*map, tree, reporter) : std::nullopt;
    if (!ranges) {
        return nullptr;
    }
    const bool u_square = !ranges->u->first.valid();
    const bool v_square = !ranges->v->first.valid();
    if (u_square && v_square) {
        reporter.error(
            tree.at(map->span), "u and v cannot both be square",
            "give one of them a range; the other follows from the picture's aspect ratio");
        return nullptr;
    }
    std::vector<ExpressionId> values;
    for (const MapRange* range : {ranges->u, ranges->v}) {
        if (range->first.valid()) {
            values.push_back(range->first);
            values.push_back(range->last);
        }
    }
    const char* name = u_square ? "square_u" : v_square ? "square_v" : "range";
    auto made = stages.make<camera::PictureMapper>(name, values, map->span);
    for (const MapRange* range : {ranges->u, ranges->v}) {
        if (made && range->first.valid()) {
            warn_of_empty(*range, tree, stages, reporter);
        }
    }
    return made;
}

}  // namespace balcony::lang
