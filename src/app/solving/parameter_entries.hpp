// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a file of marks says of the parameters of a camera.

#include <vector>

#include "app/solving/yaml_entries.hpp"

namespace balcony::app {

[[nodiscard]] std::vector<Marks::Parameter> read_unknowns(const YamlEntry& entry,
                                                          YamlEntries& yaml);
[[nodiscard]] std::vector<Marks::Parameter> read_fixed(const YamlEntry& entry, YamlEntries& yaml);

}  // namespace balcony::app
