// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a file of marks demands of the picture.

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "app/solving/yaml_entries.hpp"

namespace balcony::app {

/// How much a miss of a constraint counts: deviation, weight and tolerance.
void read_measure(const std::vector<YamlEntry>& entries, YamlEntries& yaml,
                  solve::Constraint& made);

/// Reads the rows of 'constraints'.
class ConstraintReader {
public:
    static constexpr std::string_view remedy =
        "write a constraint as {at: MARK, position: [x, y]} or {level: [MARK, MARK]}";

    /// All of these must outlive it: the names of the marks and of the outlines, by index, and
    /// where the position [0, 0] is, from the corner of the picture.
    ConstraintReader(YamlEntries& yaml, const std::vector<std::string>& marks,
                     const std::vector<std::string>& outlines, const solve::V2d& from_corner)
        : yaml_(yaml), marks_(marks), outlines_(outlines), from_corner_(from_corner) {}

    /// With what reports call each: one, or those of a shape all over a box. None after a mistake.
    [[nodiscard]] std::vector<std::pair<solve::Constraint, std::string>> read(
        const YAML::Node& row) const;

private:
    std::optional<solve::V2d> position(const YAML::Node& node) const;
    double from_corner_of(solve::ConstraintKind kind) const;
    void subject(const YamlEntry& entry, const solve::ConstraintKindInfo& kind,
                 solve::Constraint& made, std::string& label) const;
    std::optional<std::size_t> index_of(const YAML::Node& node, bool is_outline,
                                        const solve::ConstraintKindInfo& kind) const;
    std::vector<solve::V2d> positions(const YamlEntry& entry) const;
    std::optional<std::array<solve::V2d, 2>> corners(const YAML::Node& node,
                                                     std::string_view what) const;
    void details(const std::vector<YamlEntry>& entries, const solve::ConstraintKindInfo& kind,
                 solve::Constraint& made) const;

    YamlEntries& yaml_;
    const std::vector<std::string>& marks_;
    const std::vector<std::string>& outlines_;
    const solve::V2d& from_corner_;
};

}  // namespace balcony::app
