// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/export.hpp"

namespace balcony::bridge {

// Each language has its own folder with its row of the table. A new language needs a folder, a line
// here and a line in targets.cpp.
[[nodiscard]] ExportTarget c_target();
[[nodiscard]] ExportTarget numpy_target();
[[nodiscard]] ExportTarget torch_target();
[[nodiscard]] ExportTarget mitsuba_target();
[[nodiscard]] ExportTarget glsl_target();
[[nodiscard]] ExportTarget osl_target();
[[nodiscard]] ExportTarget pov_target();

}  // namespace balcony::bridge
