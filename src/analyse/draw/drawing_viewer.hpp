// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The position of a drawing's viewer, and the projection to the page.

#include <algorithm>
#include <cmath>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/drawing.hpp"

namespace balcony::analyse {

using Imath::Box2d;
using Imath::Box3d;

/// A mild perspective from outside, with z up.
class DrawingViewer {
public:
    DrawingViewer(const DrawingView& view, const Box3d& bounds)
        : center_(bounds.center()),
          far_(far_in_extents * std::max(bounds.size().length(), 1e-300)) {
        const double level = std::cos(view.elevation);
        towards_ = {level * std::cos(view.azimuth), level * std::sin(view.azimuth),
                    std::sin(view.elevation)};
        right_ = {-std::sin(view.azimuth), std::cos(view.azimuth), 0.0};
        up_ = towards_.cross(right_);
    }

    /// Depth along the line of sight; smaller is nearer.
    [[nodiscard]] double distance(const V3d& point) const {
        return far_ - (point - center_).dot(towards_);
    }

    /// The projection to a plane through the centre of the view, in its units, y down.
    [[nodiscard]] V2d project(const V3d& point) const {
        const V3d from_center = point - center_;
        const double nearest = 0.05 * far_;
        const double scale = far_ / std::max(distance(point), nearest);
        return {scale * from_center.dot(right_), -scale * from_center.dot(up_)};
    }

    [[nodiscard]] const V3d& towards() const { return towards_; }
    [[nodiscard]] const V3d& right() const { return right_; }
    [[nodiscard]] const V3d& up() const { return up_; }

private:
    static constexpr double far_in_extents = 2.5;

    V3d center_, towards_, right_, up_;
    double far_;
};

/// From the viewer's plane to pixels.
class Page {
public:
    /// Centres the box on the page, as large as the margin (in pixels) allows.
    Page(const DrawingView& view, const Box2d& box, double margin) : center_of_box_(box.center()) {
        const V2d page(static_cast<double>(view.width), static_cast<double>(view.height));
        const V2d size = box.size();
        const double minimum = std::max(1e-9 * std::max(size.x, size.y), 1e-300);
        scale_ = std::min((page.x - 2.0 * margin) / std::max(size.x, minimum),
                          (page.y - 2.0 * margin) / std::max(size.y, minimum));
        center_ = 0.5 * page;
    }

    [[nodiscard]] V2d operator()(const V2d& point) const {
        return scale_ * (point - center_of_box_) + center_;
    }

private:
    double scale_ = 1.0;
    V2d center_of_box_;
    V2d center_;
};

}  // namespace balcony::analyse
