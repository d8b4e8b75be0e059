// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <stop_token>

#include "balcony/render.hpp"
#include "render/job/tile_worker.hpp"

namespace balcony::render {

/// Adds passes to the tiles of a film until each has its number of them: see Job::run().
[[nodiscard]] Summary run(const JobParts& parts, const PictureInputs& inputs,
                          Supersampling& supersampling, Film& film,
                          std::span<const std::uint32_t> passes, const ProgressCallback& progress,
                          std::stop_token stop);

}  // namespace balcony::render
