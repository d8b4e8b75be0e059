// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The contents of a drawing in space, and their painting order.

#include <vector>

#include "analyse/draw/camera_geometry.hpp"
#include "analyse/draw/drawing_viewer.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

/// A shape of a drawing before it is projected.
struct DrawingItem {
    DrawingPart part = DrawingPart::eye;
    std::vector<V3d> points;
    DrawingColor color{};
    double line_width = 0.0;  ///< On a page of 960 x 720; 0 for an area.
    double opacity = 1.0;
    bool hull = false;       ///< The area is the convex hull of the points.
    double distance = 0.0;   ///< Far ones are painted first.
    std::size_t camera = 0;  ///< As in DrawingShape.
};

/// The colour of one of several cameras, numbered from 1.
[[nodiscard]] DrawingColor camera_color(std::size_t camera);

/// The depicted parts of a camera in a drawing of an extent, unsorted. `camera` is its number
/// among several, 0 for the only one.
[[nodiscard]] std::vector<DrawingItem> drawing_items(const CameraGeometry& geometry,
                                                     std::size_t camera, double extent,
                                                     const Depiction& depiction,
                                                     const DrawingViewer& viewer);

/// The axes of a camera: three lines from the origin, or from beside the objects if they are far
/// from it.
struct DrawnAxes {
    V3d origin;
    std::array<V3d, 3> tips;
};
[[nodiscard]] DrawnAxes drawn_axes(const PictureGeometry& geometry, const DrawingViewer& viewer);
[[nodiscard]] std::vector<DrawingItem> drawing_items(const DrawnAxes& axes,
                                                     const DrawingViewer& viewer);

}  // namespace balcony::analyse
