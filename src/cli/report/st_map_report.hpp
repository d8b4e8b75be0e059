// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/st_maps.hpp"
#include "cli/report/answer.hpp"

namespace balcony::cli {

/// Adds what is known of the file of an STMap, or of a photo that was warped by it.
void add_written(Answer& answer, const bridge::StMap& map, const bridge::StMapWritten& written,
                 const std::string& output);

}  // namespace balcony::cli
