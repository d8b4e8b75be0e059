// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The pictures of a rig in a file of marks: of one size, side by side in the picture of its camera.

#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "app/solving/yaml_entries.hpp"

namespace balcony::app {

class RigPictures {
public:
    /// Both must outlive it.
    RigPictures(YamlEntries& yaml, Marks& marks) : yaml_(yaml), marks_(marks) {}

    /// Reads 'pictures', after the size of one, and makes the picture as wide as all of them.
    void read(const YamlEntry& entry);

    /// From left to right; none without a rig.
    [[nodiscard]] const std::vector<std::string>& names() const { return names_; }
    /// The upper left corner of a picture, by its number.
    [[nodiscard]] solve::V2d corner_of(std::size_t picture) const;
    /// What labels of a picture end with.
    [[nodiscard]] std::string words_for(std::size_t picture) const;

    /// The number of the picture that a row is about, 0 without a rig; nothing after a mistake.
    [[nodiscard]] std::optional<std::size_t> of_row(const YAML::Node& row);
    /// Lets a constraint be about its marks as one picture shows them: a mark of the problem is
    /// seen in one place. False after a mistake.
    bool show(solve::Constraint& constraint, std::size_t picture);
    /// Lets the search for marks begin in their pictures.
    void begin_in_pictures();

private:
    std::size_t shown_in(std::size_t mark, std::size_t picture);

    YamlEntries& yaml_;
    Marks& marks_;
    std::vector<std::string> names_;
    std::size_t width_ = 0;  ///< Of one.
    /// The marks of pictures but the first, by the mark and the picture.
    std::map<std::pair<std::size_t, std::size_t>, std::size_t> copies_;
};

}  // namespace balcony::app
