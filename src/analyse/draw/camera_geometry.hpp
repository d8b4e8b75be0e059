// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The geometry of a camera, with z up: the common part of its drawing and its model.

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "analyse/draw/projection_object.hpp"
#include "balcony/drawing.hpp"

namespace balcony::analyse {

struct Arrow {
    V3d from, to;
    bool has_head = true;
};

/// A grid over the picture whose lines are slightly inside its border, like the outermost pixel
/// centres.
struct PictureGrid {
    std::size_t columns = 1;  ///< Of cells.
    std::size_t rows = 1;

    /// A grid with about this number of cells, as square as possible.
    [[nodiscard]] static PictureGrid of_cells(double count, double aspect);

    /// The crossing of two lines, numbered from 0 to columns and rows; fractions interpolate.
    [[nodiscard]] V2d at(double column, double row) const;
};

/// Belongs to one thread.
struct CameraGeometry {
    std::string name;
    double aspect = 1.0;
    std::unique_ptr<ProjectionObject> eye;
    std::unique_ptr<ProjectionObject> toward;  ///< Null if there is no direction object.
    std::vector<Arrow> rays;
    bool far_rays = false;  ///< Some rays start beyond max_coordinate and are omitted.
    Box3d bounds;           ///< The bounds of both objects and the rays.

    /// The object on which the picture is drawn: the eye object if it is a surface, else the
    /// direction object if that is one, else null.
    [[nodiscard]] ProjectionObject* screen() const;
    /// The size of the whole geometry.
    [[nodiscard]] double extent() const;
};

/// The cameras of a picture, or a single camera.
struct PictureGeometry {
    struct Part {
        std::string title;  ///< Its layers and its name; empty for a single camera.
        CameraGeometry geometry;
    };
    std::vector<Part> cameras;
    Axes axes = Axes::z_up;  ///< Of the first camera.
    Box3d bounds;

    [[nodiscard]] double extent() const { return bounds.size().length(); }
};

/// Cameras without a valid point are omitted with a warning. It is an error if none remains. Parts
/// that are not depicted count for the bounds too. This and what computes points of the geometry
/// throw if the work is to stop.
[[nodiscard]] Result<PictureGeometry> measure_geometry(const camera::Picture& picture,
                                                       const Depiction& depiction,
                                                       const Work& work = {});

/// The geometry at times of Depiction::film at which there is any, each with the bounds of all;
/// none without a film.
[[nodiscard]] std::vector<PictureGeometry> measure_film(const camera::Picture& picture,
                                                        const Depiction& depiction,
                                                        const Work& work = {});

/// Warnings of the parts of objects and rays that have been omitted so far.
[[nodiscard]] Diagnostics omissions(const PictureGeometry& geometry);

}  // namespace balcony::analyse
