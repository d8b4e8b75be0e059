// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The definition of a map projection in PROJ's words: "robin", "+proj=lcc +lat_1=30 +lat_2=60".

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/base.hpp"

namespace balcony::camera::maps {

/// The name of a projection and its parameters, of which none concerns the size or the shape of the
/// earth, the unit or the origin of the map.
struct Definition {
    struct Entry {
        std::string key;
        std::string value;  ///< Empty for a flag such as "south".
    };
    std::string projection{};
    std::vector<Entry> entries{};

    [[nodiscard]] const Entry* find(std::string_view key) const;
    [[nodiscard]] bool has(std::string_view key) const { return find(key) != nullptr; }
    /// A number, or a default value if it is missing or no number.
    [[nodiscard]] double number(std::string_view key, double otherwise) const;
    /// The same for an angle in degrees, in radians.
    [[nodiscard]] double angle(std::string_view key, double otherwise) const;
    /// Replaces an entry or adds one.
    void set(std::string_view key, std::string value);
    void remove(std::string_view key);
    /// As PROJ reads it, for a sphere of radius 1.
    [[nodiscard]] std::string text() const;
};

/// Reads a definition. What says nothing about the map of a unit sphere is left out, with a warning
/// if it would change PROJ's coordinates. Errors: no text, words that are no parameters, a
/// transformation of several steps, a definition by a code of a register.
[[nodiscard]] Result<Definition> read_definition(std::string_view text);

}  // namespace balcony::camera::maps
