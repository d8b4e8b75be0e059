// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// A point of a surface, with the direct light that it scatters.
struct BrightPoint {
    Imath::V3f position;
    Imath::V3f normal;  ///< Unit.
    float light = 0.0F;
};

/// Some points, and the box along the axes around them.
struct PointBox {
    std::vector<BrightPoint> points;
    Imath::V3f low;
    Imath::V3f high;
};

/// Points, at least one, in at most so many boxes: those of a surface that is plain and faces an
/// axis are flat.
[[nodiscard]] std::vector<PointBox> point_boxes(std::vector<BrightPoint> points, std::size_t most);

}  // namespace balcony::render
