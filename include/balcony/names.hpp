// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Names: of values, and in messages.

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace balcony {

/// 'a', 'b' or 'c'; the empty string for no names.
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);
/// 'a', 'b' and 'c'.
[[nodiscard]] std::string all_of(const std::vector<std::string>& names);

/// "1 mesh", "3 meshes"; the noun is regular.
[[nodiscard]] std::string counted(std::size_t count, std::string_view noun);

/// The remedy for an unknown name: the nearest one that is known, or `otherwise`.
[[nodiscard]] std::string did_you_mean(std::string_view name, const std::vector<std::string>& known,
                                       std::string otherwise);
/// The same with `otherwise` before all the known names.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                                     std::string_view otherwise);

/// A value with the name that files and options have for it, and one line for documentation.
template <class Value>
struct Named {
    Value value{};
    std::string_view name{};
    std::string_view meaning{};
};
template <class Value>
Named(Value, std::string_view) -> Named<Value>;
template <class Value>
Named(Value, std::string_view, std::string_view) -> Named<Value>;

/// The values of an enumeration with their names, in the order in which documentation lists them.
template <class Value>
class Names {
public:
    /// Refers to the rows, one for each value.
    constexpr explicit Names(std::span<const Named<Value>> rows) : rows_(rows) {}

    [[nodiscard]] auto begin() const { return rows_.begin(); }
    [[nodiscard]] auto end() const { return rows_.end(); }

    [[nodiscard]] const Named<Value>& operator[](Value value) const {
        const auto row =
            std::find_if(begin(), end(), [value](const auto& one) { return one.value == value; });
        assert(row != end());
        return *row;
    }
    [[nodiscard]] std::optional<Value> find(std::string_view name) const {
        const auto row =
            std::find_if(begin(), end(), [name](const auto& one) { return one.name == name; });
        return row != end() ? std::optional(row->value) : std::nullopt;
    }
    [[nodiscard]] std::vector<std::string> all() const {
        std::vector<std::string> names;
        for (const Named<Value>& row : rows_) {
            names.emplace_back(row.name);
        }
        return names;
    }

private:
    std::span<const Named<Value>> rows_;
};

/// The names in a table whose rows begin with them.
template <class Value, class Row, std::size_t count>
[[nodiscard]] constexpr std::array<Named<Value>, count> names_in(
    const std::array<Row, count>& rows) {
    std::array<Named<Value>, count> names{};
    for (std::size_t i = 0; i < count; ++i) {
        names[i] = rows[i];
    }
    return names;
}

}  // namespace balcony
