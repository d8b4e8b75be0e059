// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What a camera is made of as geometry, with z up: what its drawing and its model have in common.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyse/draw/projection_object.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

struct Arrow {
    V3d from, to;
};

/// A grid over the picture whose lines lie a little within its border, where pixel centres end too.
struct PictureGrid {
    std::size_t columns = 1;  ///< Of cells.
    std::size_t rows = 1;

    /// About so many cells, as square as the picture allows.
    [[nodiscard]] static PictureGrid of_cells(double count, double aspect);

    /// The crossing of the lines numbered, from 0 to columns and rows; between them for fractions.
    [[nodiscard]] V2d at(double column, double row) const;
};

/// Belongs to one thread.
struct CameraGeometry {
    double aspect = 1.0;
    std::unique_ptr<ProjectionObject> eye;
    std::unique_ptr<ProjectionObject> toward;  ///< Null if there is no direction object.
    std::vector<Arrow> rays;
    Box3d bounds;  ///< Of both objects and the rays.

    /// The object that carries the picture: the eye object if it is a surface, else the direction
    /// object if that is one, else null.
    [[nodiscard]] ProjectionObject* screen() const;
    /// How large the whole is.
    [[nodiscard]] double extent() const;
};

/// Parts that are not depicted are measured all the same. It is an error if there is no point.
[[nodiscard]] Result<CameraGeometry> measure_geometry(const camera::Camera& camera,
                                                      const Depiction& depiction);

/// The cameras of a picture, or one.
struct PictureGeometry {
    struct Part {
        std::string title;  ///< Its layers and its name; empty for a camera by itself.
        CameraGeometry geometry;
    };
    std::vector<Part> cameras;
    Axes axes = Axes::z_up;  ///< Of the first camera.
    Box3d bounds;

    [[nodiscard]] double extent() const { return bounds.size().length(); }
};

/// Cameras without a point are left out with a warning. It is an error if there is no other.
[[nodiscard]] Result<PictureGeometry> measure_geometry(const camera::Picture& picture,
                                                       const Depiction& depiction);

}  // namespace balcony::analyse
