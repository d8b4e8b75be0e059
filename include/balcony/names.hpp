// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Lists of names in messages.

#include <string>
#include <string_view>
#include <vector>

namespace balcony {

/// 'a', 'b' or 'c'; the empty string for no names.
[[nodiscard]] std::string one_of(const std::vector<std::string>& names);
/// 'a', 'b' and 'c'.
[[nodiscard]] std::string all_of(const std::vector<std::string>& names);

/// The remedy for an unknown name: the nearest one there is, or `otherwise` and all of them.
[[nodiscard]] std::string suggestion(std::string_view name, const std::vector<std::string>& known,
                                     std::string_view otherwise);

}  // namespace balcony
