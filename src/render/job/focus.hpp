// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Measures how far away the objects are on which lenses focus.

#include <string>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/picture.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

/// What the lenses of a picture need to know about the scene.
struct LensFocus {
    bool any_lens = false;
    std::vector<std::string> objects;  ///< On which lenses focus, each once.
    /// By camera layer and object, along the layer's rays.
    std::vector<std::vector<double>> distances;
};

/// The lenses of a picture with the distances of their objects: the median length of the rays of a
/// coarse grid that meet the object first; if none does, that of the ray which passes nearest to
/// its middle, as an angle seen from the ray's origin. An object that the scene does not have is an
/// error at the lens.
[[nodiscard]] Result<LensFocus> focus_of(const TracedScene& traced, const camera::Picture& picture,
                                         const Film& film, double time);

}  // namespace balcony::render
