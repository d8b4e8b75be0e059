// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Reads members of a glTF file's JSON, which may contain anything anywhere. An absent member
// gives the fallback; one of the wrong kind throws PartError.

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "balcony/scene.hpp"
#include "scene/part_error.hpp"

namespace balcony::scene {

using Json = nlohmann::json;

/// Null if the value is not an object or has no such member.
[[nodiscard]] const Json& member(const Json& value, std::string_view key);

/// The element of a top-level array such as "meshes". Throws PartError past its end.
[[nodiscard]] const Json& element(const Json& root, std::string_view array, std::size_t index);

/// The number of elements of an array member; 0 if it is not an array.
[[nodiscard]] std::size_t array_size(const Json& value, std::string_view key);

/// A non-negative integer: an index, a count, an offset.
[[nodiscard]] std::optional<std::size_t> index_in(const Json& value, std::string_view key);
[[nodiscard]] std::size_t count_in(const Json& value, std::string_view key, std::size_t fallback);

/// The indices in an array such as "children"; empty if absent.
[[nodiscard]] std::vector<std::size_t> indices_in(const Json& value, std::string_view key);

[[nodiscard]] double number_in(const Json& value, std::string_view key, double fallback);
[[nodiscard]] std::vector<double> numbers_in(const Json& value, std::string_view key,
                                             std::vector<double> fallback);

/// Quantities of light are in 0 .. max_quantity; a PartError names the key of an invalid one.
[[nodiscard]] float to_quantity(double number, std::string_view key);
[[nodiscard]] float quantity_in(const Json& value, std::string_view key, float fallback);
/// The same for a quantity that may be negative.
[[nodiscard]] float signed_quantity_in(const Json& value, std::string_view key, float fallback);
[[nodiscard]] Color3f to_color(const std::array<double, 3>& numbers, std::string_view key);
[[nodiscard]] Color3f color_in(const Json& value, std::string_view key, const Color3f& fallback);
/// A colour times an intensity.
[[nodiscard]] Color3f scaled(const Color3f& color, float intensity, std::string_view key);

/// A text, which may be long, in place.
[[nodiscard]] std::string_view text_view_in(const Json& value, std::string_view key);
[[nodiscard]] std::string text_in(const Json& value, std::string_view key,
                                  std::string_view fallback = {});
[[nodiscard]] bool flag_in(const Json& value, std::string_view key);

}  // namespace balcony::scene
