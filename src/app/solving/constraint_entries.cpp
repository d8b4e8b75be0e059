// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "app/solving/constraint_entries.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "balcony/names.hpp"

namespace balcony::app {

namespace {

using solve::Constraint;
using solve::ConstraintKind;
using solve::ConstraintKindInfo;
using solve::V2d;
using solve::ValueUse;

const ConstraintKindInfo* kind_named(std::string_view name) {
    const auto& kinds = solve::constraint_kinds();
    const auto found = std::find_if(kinds.begin(), kinds.end(), [&](const ConstraintKindInfo& one) {
        return one.name == name;
    });
    return found != kinds.end() ? &*found : nullptr;
}

std::vector<std::string> names_of_kinds() {
    std::vector<std::string> names;
    for (const ConstraintKindInfo& kind : solve::constraint_kinds()) {
        names.emplace_back(kind.name);
    }
    return names;
}

bool is_of_position(const ConstraintKindInfo& kind) {
    return kind.marks == 0 && !kind.is_of_outline;
}

}  // namespace

void read_measure(const std::vector<YamlEntry>& entries, YamlEntries& yaml, Constraint& made) {
    const auto entry = [&](std::string_view name) -> const YamlEntry* {
        for (const YamlEntry& one : entries) {
            if (one.name == name) {
                return &one;
            }
        }
        return nullptr;
    };
    const YamlEntry* const deviation = entry("deviation");
    if (deviation != nullptr) {
        made.deviation = yaml.positive(*deviation).value_or(1.0);
    }
    const YamlEntry* const weight = entry("weight");
    if (weight != nullptr) {
        made.deviation /= std::sqrt(yaml.positive(*weight).value_or(1.0));
    }
    if (const YamlEntry* const written = weight != nullptr ? weight : deviation) {
        yaml.is_in_deviation_range(yaml.at(written->value), "deviation", made.deviation,
                                   "write another number; a weight divides the deviation by "
                                   "its square root");
    }
    if (const YamlEntry* const tolerance = entry("tolerance")) {
        made.tolerance = yaml.positive(*tolerance);
        if (made.tolerance) {
            yaml.is_in_deviation_range(yaml.at(tolerance->value), "tolerance", *made.tolerance);
        }
    }
}

std::vector<std::pair<Constraint, std::string>> ConstraintReader::read(
    const YAML::Node& row) const {
    std::vector<std::string> known = names_of_kinds();
    known.insert(known.end(), {"position", "value", "distance", "box", "line", "deviation",
                               "weight", "tolerance", "picture"});
    const std::vector<YamlEntry> entries = yaml_.map(row, "the constraint", remedy, known);
    const YamlEntry* kind_entry = nullptr;
    for (const YamlEntry& one : entries) {
        if (kind_named(one.name) == nullptr) {
            continue;
        }
        if (kind_entry != nullptr) {
            yaml_.error(
                one.written,
                fmt::format("a constraint is not both '{}' and '{}'", kind_entry->name, one.name),
                "write two rows");
            return {};
        }
        kind_entry = &one;
    }
    if (kind_entry == nullptr) {
        if (row.IsMap() && (!has_errors(yaml_.found()) || !entries.empty())) {
            yaml_.error(yaml_.at(row), "this constraint does not say what it demands",
                        fmt::format("begin it with one of {}", one_of(names_of_kinds())));
        }
        return {};
    }
    const ConstraintKindInfo& kind = *kind_named(kind_entry->name);
    const std::size_t before = yaml_.found().size();
    Constraint made;
    made.kind = kind.kind;
    made.written = kind_entry->written;
    std::string label(kind.name);
    subject(*kind_entry, kind, made, label);
    details(entries, kind, made);
    std::vector<std::pair<Constraint, std::string>> rows;
    if (is_of_position(kind)) {
        for (const V2d& at : positions(*kind_entry)) {
            rows.emplace_back(made, fmt::format("{} ({:g}, {:g})", label, at.x, at.y));
            rows.back().first.position = at;
        }
    } else {
        rows.emplace_back(std::move(made), std::move(label));
    }
    if (yaml_.found().size() != before) {
        rows.clear();
    }
    return rows;
}

std::optional<V2d> ConstraintReader::position(const YAML::Node& node) const {
    const auto read = yaml_.position(node);
    return read ? std::optional(*read + from_corner_) : std::nullopt;
}

// Of the values of a kind that are coordinates.
double ConstraintReader::from_corner_of(ConstraintKind kind) const {
    switch (kind) {
        case ConstraintKind::left:
        case ConstraintKind::right: return from_corner_.x;
        case ConstraintKind::top:
        case ConstraintKind::bottom: return from_corner_.y;
        default: return 0.0;
    }
}

// The index of a mark or an outline.
std::optional<std::size_t> ConstraintReader::index_of(const YAML::Node& node, bool is_outline,
                                                      const ConstraintKindInfo& kind) const {
    const auto& others = is_outline ? marks_ : outlines_;
    const auto& meant = is_outline ? outlines_ : marks_;
    const std::string name = node.IsScalar() ? node.Scalar() : "";
    const bool is_other = std::find(meant.begin(), meant.end(), name) == meant.end() &&
                          std::find(others.begin(), others.end(), name) != others.end();
    if (is_other) {
        yaml_.error(
            yaml_.at(node),
            fmt::format("'{}' is {}", name, is_outline ? "a mark, not an outline" : "an outline"),
            fmt::format("'{}' means that {}", kind.name, kind.meaning));
        return std::nullopt;
    }
    return yaml_.index_of(node, meant, is_outline ? "outline" : "mark");
}

// The marks of a constraint, or its outline.
void ConstraintReader::subject(const YamlEntry& entry, const ConstraintKindInfo& kind,
                               Constraint& made, std::string& label) const {
    if (kind.is_of_outline) {
        made.outline = index_of(entry.value, true, kind);
        label += made.outline ? fmt::format(" {}", outlines_[*made.outline]) : "";
        return;
    }
    if (kind.marks == 0) {
        return;
    }
    const std::vector<YAML::Node> named = yaml_.list(entry.value);
    if (named.size() != kind.marks) {
        yaml_.error(yaml_.at(entry.value),
                    fmt::format("'{}' takes {}, not {}", kind.name, counted(kind.marks, "mark"),
                                named.size()),
                    fmt::format("it means that {}", kind.meaning));
        return;
    }
    for (const YAML::Node& one : named) {
        if (const auto mark = index_of(one, false, kind)) {
            made.marks.push_back(*mark);
            label += fmt::format("{}{}", label == kind.name ? " " : ", ", marks_[*mark]);
        }
    }
}

// Where a shape is measured: at a position, or all over a box.
std::vector<V2d> ConstraintReader::positions(const YamlEntry& entry) const {
    constexpr int across = 5;
    if (!(entry.value.IsSequence() && entry.value.size() > 0 && entry.value[0].IsSequence())) {
        return {position(entry.value).value_or(V2d(0.0))};
    }
    const auto box = corners(entry.value, "box");
    std::vector<V2d> made;
    for (int i = 0; box && i < across * across; ++i) {
        const V2d part = V2d(i % across, i / across) / (across - 1.0);
        made.push_back((*box)[0] + part * ((*box)[1] - (*box)[0]));
    }
    return made;
}

// The upper left and the lower right corner of a "box", or two points of a "line".
std::optional<std::array<V2d, 2>> ConstraintReader::corners(const YAML::Node& node,
                                                            std::string_view what) const {
    const bool is_box = what == "box";
    const std::string how =
        is_box ? "write the upper left and the lower right corner: [[100, 50], [540, 310]]"
               : "write two positions on it: [[0, 240], [640, 200]]";
    const std::vector<YAML::Node> two = yaml_.list(node);
    if (!node.IsSequence() || two.size() != 2) {
        yaml_.error(yaml_.at(node), fmt::format("this is no {}", what), how);
        return std::nullopt;
    }
    const std::optional<V2d> first = position(two[0]);
    const std::optional<V2d> last = position(two[1]);
    if (!first || !last) {
        return std::nullopt;
    }
    const bool is_empty = is_box ? !(first->x < last->x && first->y < last->y) : *first == *last;
    if (is_empty) {
        yaml_.error(yaml_.at(node), fmt::format("this is no {}", what), how);
    }
    return std::array{*first, *last};
}

void ConstraintReader::details(const std::vector<YamlEntry>& entries,
                               const ConstraintKindInfo& kind, Constraint& made) const {
    bool has_position = false;
    bool has_value = false;
    bool has_corners = false;
    for (const YamlEntry& one : entries) {
        const auto only_of = [&](bool fits) {
            if (!fits) {
                yaml_.error(one.written, fmt::format("'{}' has no {}", kind.name, one.name),
                            fmt::format("remove it; '{}' means that {}", kind.name, kind.meaning));
            }
            return fits;
        };
        if (one.name == "position" && only_of(kind.kind == ConstraintKind::at)) {
            made.position = position(one.value).value_or(V2d(0.0));
            has_position = true;
        } else if (one.name == "value" && only_of(kind.value != ValueUse::none)) {
            made.value = yaml_.plain_number(one.value, "write a number").value_or(0.0);
            has_value = true;
        } else if ((one.name == "box" || one.name == "line") && only_of(one.name == kind.corners)) {
            made.corners = corners(one.value, kind.corners);
            has_corners = true;
        } else if (one.name == "distance" && only_of(is_of_position(kind))) {
            made.distance = yaml_.positive(one);
        }
    }
    made.value += from_corner_of(kind.kind);
    read_measure(entries, yaml_, made);
    if (kind.kind == ConstraintKind::at && !has_position) {
        yaml_.error(made.written, "'at' has no position", "add position: [x, y] in pixels");
    }
    if (!kind.corners.empty() && !kind.may_lack_corners && !has_corners) {
        yaml_.error(made.written, fmt::format("'{}' has no {}", kind.name, kind.corners),
                    fmt::format("add {}: [[x, y], [x, y]]", kind.corners));
    }
    if (kind.value == ValueUse::must && !has_value) {
        yaml_.error(made.written, fmt::format("'{}' has no value", kind.name),
                    fmt::format("add value: NUMBER; '{}' means that {}", kind.name, kind.meaning));
    } else if (kind.kind == ConstraintKind::magnification && !(made.value > 0.0)) {
        yaml_.error(made.written, "a magnification must be above 0", "write value: 500");
    }
}

}  // namespace balcony::app
