// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>

#include "balcony/scene.hpp"

namespace balcony::scene {

/// The rotation between axes, for row vectors: p_to = p_from * M.
inline M44d turning(Axes from, Axes to) {
    M44d matrix;
    for (int axis = 0; axis < 3; ++axis) {
        V3d unit(0.0);
        unit[axis] = 1.0;
        const V3d row = turned(unit, from, to);
        std::copy_n(&row.x, 3, matrix[axis]);
    }
    return matrix;
}

}  // namespace balcony::scene
