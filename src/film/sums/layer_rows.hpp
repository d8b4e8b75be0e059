// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include "balcony/film.hpp"

namespace balcony::render {

/// A layer with its place in the film.
struct LayerRow {
    LayerInfo info;
    /// Gives the layer its vector in the film, if it has one; must be called once.
    void (*allocate)(Film& film);
    /// Whether the film has the values of all its pixels.
    bool (*complete)(const Film& film);
    /// Writes the channels of a pixel of the window, level by level.
    void (*read)(const Film& film, std::size_t x, std::size_t y, float* channels);
};

/// In the order of LayerId.
[[nodiscard]] std::span<const LayerRow> layer_rows();

/// A set with all layers from which its layers are computed.
[[nodiscard]] LayerSet with_needs(LayerSet wanted);

}  // namespace balcony::render
