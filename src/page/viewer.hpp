// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>

namespace balcony::page {

/// Where the viewer has the title, which is text, and the page's data, which are elements.
inline constexpr std::string_view title_mark = "<!--title-->";
inline constexpr std::string_view data_mark = "<!--data-->";

/// The page without a scene, which has both marks; empty if it was built without the viewer.
[[nodiscard]] std::string_view viewer();

}  // namespace balcony::page
