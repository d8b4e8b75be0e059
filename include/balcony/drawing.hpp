// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Drawing: a camera itself, that is, its projection objects with the picture on them and some of
// its rays, as a picture and as a scene.
//
//     picture or camera ─▶ draw ─▶ Drawing ─▶ to_svg, rasterise
//                       └▶ model ─▶ scene::Scene
//
// A drawing of a picture shows the cameras of all layers, each once for the same parameters and in
// its own colour. It ignores arrangement (place, clip), which does not change the cameras.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/image.hpp"
#include "balcony/picture.hpp"
#include "balcony/progress.hpp"
#include "balcony/scene.hpp"

namespace balcony::analyse {

using Imath::V2d;
using Imath::V3d;

using DrawingColor = std::array<std::uint8_t, 3>;  ///< sRGB.

/// The visible parts of a camera.
struct Depiction {
    std::size_t rays = 9;  ///< Arrows along the longer side of the camera's picture; 0: none.
    /// The length of the arrows in scene units. By default a ray ends a little beyond the point of
    /// the direction object that it passes through; if there is none, its length depends on the
    /// objects.
    std::optional<double> length{};
    /// The colour of the arrows. By default orange, or that of each of several cameras.
    std::optional<DrawingColor> color{};
    bool eye = true;     ///< The eye object.
    bool toward = true;  ///< The direction object.
    bool frame = true;   ///< The border of the picture, with its top left corner marked.
    bool axes = true;    ///< The camera's axes; only in a picture.
    double time = 0.0;
    /// From and to: the drawings of all times between have one frame of reference. It shows what
    /// can be seen at 17 of them, evenly spaced.
    std::optional<std::array<double, 2>> film{};
};

/// The view of a drawing and its size.
struct DrawingView {
    double azimuth = -0.8726646259971648;   ///< Around z from x, in radians; -50 degrees.
    double elevation = 0.4363323129985824;  ///< 25 degrees.
    std::size_t width = 960;                ///< In pixels, from 16 to 16384, like the height.
    std::size_t height = 720;
    /// Lines of text at the right of the figure, as large as there is room. ASCII.
    std::vector<std::string> notes{};
};

/// The part of a camera that a shape of a drawing belongs to or, in a drawing of its picture, a
/// mark that is shown, by what it is missed, and how uncertain projections are.
enum class DrawingPart : std::uint8_t { eye, toward, frame, ray, axis, mark, miss, uncertainty };

[[nodiscard]] std::string_view name_of(DrawingPart part);

/// An area, or a line with round ends and joins.
struct DrawingShape {
    DrawingPart part = DrawingPart::eye;
    std::vector<V2d> points;  ///< Pixels from the top left.
    DrawingColor color{};
    double line_width = 0.0;  ///< In pixels; 0 for an area.
    double opacity = 1.0;     ///< Lines are opaque.
    std::size_t camera = 0;   ///< The number of one of several cameras, from 1; otherwise 0.
};

/// A line of text.
struct DrawingLabel {
    std::string text;
    V2d position;       ///< The left end of its baseline, in pixels from the top left.
    double size = 0.0;  ///< The height of a capital letter, in pixels.
    DrawingColor color{};
    bool monospaced = false;  ///< All letters are 6/7 of the size wide.
};

/// Shapes on a white background, in the order of drawing.
struct Drawing {
    std::string name;  ///< The picture's or the camera's.
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<DrawingShape> shapes;
    std::vector<DrawingLabel> labels{};  ///< Layers and names, for several cameras, and notes.
    /// What rasterise() has in place of the white, of the same size. An SVG file stays white.
    std::optional<Image> background{};
};

/// Numbers over a picture, at the middles of a grid of cells.
struct NumberMap {
    std::string title;      ///< ASCII, with the unit.
    std::size_t width = 0;  ///< Of the picture in pixels, at least 1, as the others.
    std::size_t height = 0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    /// Row by row; nothing where there is none, infinite where it is not known.
    std::vector<std::optional<double>> numbers;
    std::string missing{"no ray"};  ///< What the legend says of these.
    std::string unknown{"not determined"};
};

/// A map in colours with lines of equal numbers, which are round and written beside them, and a
/// legend below. It has the size of the picture, and at least 800 pixels in a row.
[[nodiscard]] Image paint(const NumberMap& map);

/// Draws the cameras of a picture, or a single camera. It is an error if none of them has a valid
/// point, and a warning if some have none. As model() and rasterise(), an error of
/// Kind::interrupted if it is stopped.
[[nodiscard]] Result<Drawing> draw(const camera::Picture& picture, const Depiction& depiction = {},
                                   const DrawingView& view = {}, const PartDone& progress = {},
                                   std::stop_token stop = {});

[[nodiscard]] std::string to_svg(const Drawing& drawing);

/// Antialiased with 16 samples per pixel.
[[nodiscard]] Image rasterise(const Drawing& drawing);
[[nodiscard]] Result<Image> rasterise(const Drawing& drawing, const PartDone& progress,
                                      std::stop_token stop);

/// A camera as a scene in its own axes: objects `surface` (the eye object, with its
/// normals and (u, v) as texture coordinates), `target` (the direction object), `rays` (arrows),
/// `frame`; each with a material of the same name. Empty objects are omitted. Several
/// cameras use the axes of the first, and prefixes with layers and names: `layer 2, closeup: rays`.
[[nodiscard]] Result<scene::Scene> model(const camera::Picture& picture,
                                         const Depiction& depiction = {},
                                         const PartDone& progress = {}, std::stop_token stop = {});

}  // namespace balcony::analyse
