// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Cryptomatte: Friedman and Jones, "Fully automatic ID mattes with support for motion blur and
// transparency" (SIGGRAPH 2015 posters), and its specification, version 1.2
// (github.com/Psyop/Cryptomatte).

#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "balcony/film.hpp"

namespace balcony::render {

/// The hash of a name: MurmurHash3_x86_32 (Appleby, 2011) with the seed 0.
[[nodiscard]] std::uint32_t matte_hash(std::string_view name);

/// The float with the bits of a hash, with one bit changed if it would be infinite, NaN or
/// denormalised.
[[nodiscard]] float matte_float(std::uint32_t hash);

/// Writes hash and coverage of each rank, the largest coverage first. A nameless thing is called
/// after its id.
void read_matte(const Matte& matte, std::span<const std::string> names, std::uint32_t samples,
                float* channels);

/// The attributes of an EXR file for a layer: its name, hash, conversion and manifest.
[[nodiscard]] std::map<std::string, std::string> matte_attributes(
    std::string_view layer, std::span<const std::string> names);

}  // namespace balcony::render
