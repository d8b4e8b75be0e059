// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The spaces that a camera leads through, from the picture by way of parameters to the scene: their
// points as expressions.

#include "balcony/expr.hpp"

namespace balcony::camera {

using expr::Expr;

/// DCS, device coordinates: pixels, x to the right, y down, pixel centres at .5.
struct DevicePoint {
    Expr x, y;
};

/// PCS, parameter coordinates of a projection object.
struct ParameterPoint {
    Expr u, v;
};

/// OCS, object coordinates: the world of the scene, in the camera's axes.
struct ObjectPoint {
    Expr x, y, z;
};

/// A difference of two points of OCS.
struct ObjectVector {
    Expr x, y, z;
};

ObjectVector operator-(const ObjectPoint& a, const ObjectPoint& b);
ObjectPoint operator+(const ObjectPoint& a, const ObjectVector& b);
ObjectVector operator+(const ObjectVector& a, const ObjectVector& b);
ObjectVector operator-(const ObjectVector& a);
ObjectVector operator*(Expr factor, const ObjectVector& a);
Expr dot(const ObjectVector& a, const ObjectVector& b);
ObjectVector cross(const ObjectVector& a, const ObjectVector& b);

/// The size of a picture in pixels; expressions, because an arranger may give a camera only a part.
struct PictureSize {
    Expr width, height;
};

/// A point in a camera's own image, and the size of that image.
struct PicturePoint {
    DevicePoint point;
    PictureSize size;
};

/// A rectangle of parameter space: u from the left to the right edge of a picture, v from its
/// bottom to its top.
struct ParameterRectangle {
    double u_first = 0.0, u_last = 1.0;
    double v_first = 0.0, v_last = 1.0;
};

}  // namespace balcony::camera
