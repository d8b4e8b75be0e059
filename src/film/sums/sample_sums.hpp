// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Adds a row of samples to the sums of its pixels, in the widest registers of the machine.

#include <cstddef>

#include "balcony/film.hpp"

namespace balcony::render {

/// Adds each of `count` samples to its sum.
void add_samples(const Color4f* samples, std::size_t count, Color4d* sums);

/// The same for sums of 0, which are not read: they are written past the caches, since a film is
/// larger than they are. Other threads see them after finish_first_samples().
void set_first_samples(const Color4f* samples, std::size_t count, Color4d* sums);
void finish_first_samples();

}  // namespace balcony::render
