// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

#include "balcony/lang.hpp"
#include "balcony/live.hpp"
#include "studio/serve.hpp"

namespace balcony::studio {

/// The line for a shell that renders what a view shows, of the camera file as it is on the disk.
/// Values are those of parameters of the camera that was told.
[[nodiscard]] std::string command_line(const Options& options, const live::Shown& shown,
                                       const std::vector<lang::OpenParameter>& parameters);

}  // namespace balcony::studio
