// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The camera layers of a picture, each as a function from a point of the whole picture to a ray.

#include <optional>
#include <string>
#include <vector>

#include "balcony/picture.hpp"

namespace balcony::analyse {

struct PictureLayer {
    std::string name;
    Axes axes = Axes::z_up;      ///< Of the ray.
    camera::RayExpressions ray;  ///< Valid only where the layer covers something.
    /// 1 where layers and lines in front leave nothing of it, as the renderer has it: those in
    /// normal blend mode that cover the point wholly.
    expr::Expr hidden;
};

/// From the back to the front. A camera by itself is one layer that covers everything.
[[nodiscard]] std::vector<PictureLayer> picture_layers(const camera::Picture& picture,
                                                       expr::Graph& graph, double width,
                                                       double height);

/// The same ray in other axes.
[[nodiscard]] camera::RayExpressions turned(const camera::RayExpressions& ray, Axes from, Axes to);

}  // namespace balcony::analyse
