// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Measures how far away the objects are on which lenses focus.

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "balcony/film.hpp"
#include "balcony/picture.hpp"
#include "render/tracing/scene_tracer.hpp"

namespace balcony::render {

class PictureRays;

/// What the lenses of a picture need to know about the scene.
struct LensFocus {
    bool any_lens = false;
    std::vector<std::string> objects{};  ///< On which lenses focus, each once.
    std::vector<double> distances{};     ///< By camera layer and object, along the layer's rays.

    [[nodiscard]] std::span<const double> distances_of(std::size_t layer) const {
        return std::span(distances).subspan(layer * objects.size(), objects.size());
    }
};

/// The lenses of a picture, without distances. An object that the scene does not have is an error
/// at the lens.
[[nodiscard]] Result<LensFocus> lenses_of(const camera::Picture& picture,
                                          const scene::Scene& scene);

/// Measures the distances of their objects: the median length of the rays of a coarse grid that
/// meet the object first; if none does, that of the ray which passes nearest to its middle, as an
/// angle seen from the ray's origin. The rays are the central ones, which need no distances.
[[nodiscard]] std::vector<double> distances_to(const std::vector<std::string>& objects,
                                               const TracedScene& traced, PictureRays& central,
                                               const Film& film, double time);

}  // namespace balcony::render
