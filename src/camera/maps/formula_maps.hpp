// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The maps with formulas of their own, one file a family. A new one is a function and a row there.

#include <string_view>
#include <vector>

#include "camera/maps/inverse_map.hpp"

namespace balcony::camera::maps {

/// A projection by its name in PROJ.
struct FormulaMapRow {
    std::string_view name;
    /// Null if the parameters are of a variant without an inverse here.
    InverseMapPointer (*make)(const Definition& definition, const ForwardMap& map);
};

[[nodiscard]] std::vector<FormulaMapRow> stretched_maps();
[[nodiscard]] std::vector<FormulaMapRow> perspective_maps();
[[nodiscard]] std::vector<FormulaMapRow> polyhedral_maps();
[[nodiscard]] std::vector<FormulaMapRow> two_point_maps();
[[nodiscard]] std::vector<FormulaMapRow> conformal_maps();
[[nodiscard]] std::vector<FormulaMapRow> oblique_cylinders();
[[nodiscard]] std::vector<FormulaMapRow> elliptic_maps();
[[nodiscard]] std::vector<FormulaMapRow> searched_maps();

}  // namespace balcony::camera::maps
