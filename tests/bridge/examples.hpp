// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

#include "balcony/camera.hpp"
#include "balcony/export.hpp"

namespace balcony::bridge::test {

/// A camera that every exporter is tested with.
struct Example {
    std::string name;  ///< The name of the camera, too; a word of all languages.
    camera::Camera camera;
    std::string shown{};    ///< For people: "torus, an object generator".
    bool of_stage = false;  ///< It is the example of a stage.
};

/// The example of every stage in the catalogue that is a camera, the built-in cameras, and those of
/// the plates.
[[nodiscard]] const std::vector<Example>& examples();

/// Whether a camera has a formula at all: that of a mesh has none.
[[nodiscard]] bool has_formulas(const Example& example);

// The picture in which rays are compared, and the points.
inline constexpr double width = 160.0;
inline constexpr double height = 90.0;
struct PicturePoint {
    double x, y;
};
[[nodiscard]] std::vector<PicturePoint> points();

/// Origin, direction and validity of a ray.
struct ExportedRay {
    std::array<double, 3> origin{};
    std::array<double, 3> direction{};
    bool valid = false;
};

/// How the rays of an exported text differ from our own, over all points.
struct Comparison {
    std::size_t rays = 0;
    std::size_t lost = 0;  ///< There in one of the two only.
    double largest = 0.0;  ///< In pixels, by rays::pixels_between() at a distance of 10.
};
[[nodiscard]] Comparison compare(const Example& example, const std::vector<ExportedRay>& exported);

}  // namespace balcony::bridge::test
