// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

namespace balcony::plates {

struct SceneOptions {
    bool pictures_and_walls = true;  ///< Without: only what is behind them (plates 3, 6 and 8).
    double texture_scale = 1.0;      ///< Of the pixels of painted textures along each side.

    bool operator==(const SceneOptions&) const = default;
};

}  // namespace balcony::plates
