// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Making a film and reading it.

#include "balcony/render.hpp"

namespace balcony::render {

/// The bytes that a film of these settings takes.
[[nodiscard]] double film_bytes(const Settings& settings);

/// An empty film.
[[nodiscard]] Film make_film(const Settings& settings, const scene::Scene& scene);

}  // namespace balcony::render
