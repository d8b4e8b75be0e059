// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// What the calibrated cameras have in common: an image of so many pixels, a focal length and a
// centre, between the picture and the model of a lens.

#include <array>
#include <memory>
#include <optional>
#include <string_view>
#include <vector>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

/// The model of a lens: from a point of the image to a direction.
class ImageModel {
public:
    ImageModel() = default;
    ImageModel(const ImageModel&) = delete;
    ImageModel& operator=(const ImageModel&) = delete;
    virtual ~ImageModel() = default;

    /// The direction, of any length except 0, with x to the right, y down and z forward. The point
    /// is relative to the centre, in focal lengths, with x to the right and y down.
    [[nodiscard]] virtual ObjectVector direction(Expr x, Expr y, Emitter& emit) const = 0;
};

/// The image of a calibrated camera, in pixels.
struct ImageFrame {
    double width = 0.0, height = 0.0;
    double fx = 0.0, fy = 0.0;
    double cx = 0.0, cy = 0.0;  ///< From the top left corner of the image.
    double skew = 0.0;

    /// The point (u, v) relative to the centre, in focal lengths.
    template <class Number>
    [[nodiscard]] std::array<Number, 2> normalized(const Number& u, const Number& v) const {
        const Number y = (v - cy) / fy;
        return {(u - cx - skew * y) / fx, y};
    }
    /// The corners of the image, normalized.
    [[nodiscard]] std::array<std::array<double, 2>, 4> corners() const {
        return {normalized(0.0, 0.0), normalized(width, 0.0), normalized(0.0, height),
                normalized(width, height)};
    }
};

/// The parameters width, height, fx, fy, cx, cy, skew and origin, and their values.
[[nodiscard]] std::vector<StageParameter> frame_parameters();
[[nodiscard]] ImageFrame frame_of(const Arguments& a);

/// The last parameter of all calibrated cameras: how far from the camera its points are.
[[nodiscard]] StageParameter sphere_parameter();
/// A number of a model.
[[nodiscard]] StageParameter coefficient_parameter(std::string_view name, double value,
                                                   std::string_view meaning);

/// The camera with such an image: its own normals are the directions of its rays, by u and v in
/// pixels from the top left corner of the image.
[[nodiscard]] std::shared_ptr<const Stage> calibrated_camera(
    const Arguments& a, const ImageFrame& frame, std::shared_ptr<const ImageModel> model);

/// The row of a calibrated camera without what all of them have: the parameters are preceded by
/// those of the image and followed by `radius`.
[[nodiscard]] StageEntry calibrated_row(StageEntry row);

}  // namespace balcony::camera
