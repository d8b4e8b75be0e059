// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drawing: a camera itself, its projection objects with the picture on them and some of its rays,
// as a picture and as a scene.
//
//     picture or camera ─▶ draw ─▶ Drawing ─▶ to_svg, rasterise
//                       └▶ model ─▶ scene::Scene
//
// Of a picture the cameras of all layers are shown, each once for the same parameters and in a
// colour of its own. Arrangement (place, clip) is left aside: it does not change the cameras.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/image.hpp"
#include "balcony/picture.hpp"
#include "balcony/scene.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

/// What of a camera is shown.
struct Depiction {
    std::size_t rays = 9;  ///< Arrows along the longer side of the camera's picture; 0: none.
    /// Of the arrows, in scene units. If not given a ray goes a little beyond the point of the
    /// direction object that it passes through; where there is none, its length suits the objects.
    std::optional<double> length{};
    bool eye = true;     ///< The eye object.
    bool toward = true;  ///< The direction object.
    bool frame = true;   ///< The border of the picture, with its top left corner marked.
    bool axes = true;    ///< The camera's own; only in a picture.
    double time = 0.0;
};

/// From where the drawing is seen and how large it is.
struct DrawingView {
    double azimuth = -0.8726646259971648;   ///< Round z from x, in radians; -50 degrees.
    double elevation = 0.4363323129985824;  ///< 25 degrees.
    std::size_t width = 960;                ///< In pixels, from 16 to 16384, as the height.
    std::size_t height = 720;
};

/// What a shape of a drawing belongs to.
enum class DrawingPart : std::uint8_t { eye, toward, frame, ray, axis };

[[nodiscard]] std::string_view name_of(DrawingPart part);

using DrawingColor = std::array<std::uint8_t, 3>;  ///< sRGB.

/// An area, or a line of round ends and joins.
struct DrawingShape {
    DrawingPart part = DrawingPart::eye;
    std::vector<V2d> points;  ///< Pixels from the top left.
    DrawingColor color{};
    double line_width = 0.0;  ///< Pixels; 0 is an area.
    double opacity = 1.0;     ///< Lines are opaque.
    std::size_t camera = 0;   ///< Of several cameras the number, from 1; 0 for what is of none.
};

/// A line of text.
struct DrawingLabel {
    std::string text;
    V2d position;       ///< The left end of its baseline, in pixels from the top left.
    double size = 0.0;  ///< The height of a capital, in pixels.
    DrawingColor color{};
};

/// Shapes on white, in the order of drawing.
struct Drawing {
    std::string name;  ///< The picture's or the camera's.
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<DrawingShape> shapes;
    std::vector<DrawingLabel> labels{};  ///< Of several cameras: their layers and names.
};

/// Draws the cameras of a picture, or one. It is an error if none of them has a point anywhere, and
/// a warning if some have not.
[[nodiscard]] Result<Drawing> draw(const camera::Picture& picture, const Depiction& depiction = {},
                                   const DrawingView& view = {});

[[nodiscard]] std::string to_svg(const Drawing& drawing);

/// Antialiased by 16 points a pixel.
[[nodiscard]] Image rasterise(const Drawing& drawing);

/// A camera as a scene in its own axes: objects `surface` (the eye object, with its
/// normals and (u, v) as texture co-ordinates), `target` (the direction object), `rays` (arrows),
/// `frame`; each with a material of its name. What there is nothing of is left out. Of several
/// cameras in the axes of the first, with layers and names before theirs: `layer 2, closeup: rays`.
[[nodiscard]] Result<scene::Scene> model(const camera::Picture& picture,
                                         const Depiction& depiction = {});

}  // namespace balcony::analyse
