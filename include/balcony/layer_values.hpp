// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Layer values: the layers of a film as numbers, for programs that read them from memory.

#include <cstddef>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/film.hpp"
#include "balcony/layers.hpp"

namespace balcony::render {

/// Row by row from the top left of the film's window, with the channels of a pixel side by side:
/// those of LayerInfo, level by level.
struct LayerValues {
    std::size_t channels = 0;
    std::vector<float> values;
};

/// The values of a layer, as an EXR file of the film has them. A film without it is an error of
/// Kind::usage.
[[nodiscard]] Result<LayerValues> layer_values(const Film& film, LayerId layer);

/// The radiance of the picture, as an EXR file has it: red, green, blue and alpha, linear and
/// premultiplied.
[[nodiscard]] LayerValues color_values(const Film& film);

}  // namespace balcony::render
