// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a picture depends on, by which a render knows whether it continues another one.

#include <cstdint>
#include <filesystem>
#include <span>

#include "balcony/checkpoint.hpp"
#include "balcony/request.hpp"

namespace balcony::app {

/// What is to be the same.
enum class FactsOf : std::uint8_t {
    sums,     ///< The sums of a film, whatever its layers.
    exr,      ///< An EXR file.
    display,  ///< A file for displays.
};

/// The options that matter, as words. The times of frames depend on the frame rate.
[[nodiscard]] render::RenderFacts facts_of(const Request& request, FactsOf what,
                                           bool is_frame = false);

/// Of a film of the request that is in memory.
[[nodiscard]] render::FilmFacts film_facts(const Request& request);

/// The hashes of files.
[[nodiscard]] render::RenderFacts facts_of(std::span<const std::filesystem::path> files);

}  // namespace balcony::app
