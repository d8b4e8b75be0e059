// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Picture: what the picture arranger makes, several cameras clipped, placed and blended into one
// picture. A camera by itself is a picture of one layer.

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "balcony/camera.hpp"

namespace balcony::camera {

/// How a layer's colour s (source) joins the colour d (below it), before the layer's coverage mixes
/// the result with d. The names and formulas are those of the W3C's "Compositing and Blending
/// Level 1", in linear light.
enum class BlendMode : std::uint8_t {
    normal,
    multiply,
    screen,
    overlay,
    darken,
    lighten,
    color_dodge,
    color_burn,
    hard_light,
    soft_light,
    difference,
    exclusion,
    add,
    subtract,
};

[[nodiscard]] std::string_view name_of(BlendMode mode);
/// One line for documentation.
[[nodiscard]] std::string_view meaning_of(BlendMode mode);
[[nodiscard]] std::optional<BlendMode> find_blend_mode(std::string_view name);
[[nodiscard]] std::vector<std::string> blend_mode_names();

/// A drawn line: its width as a fraction of the whole picture's height, its colour in linear light.
struct Stroke {
    Scalar width = 0.004;
    std::array<Scalar, 3> color{1.0, 1.0, 1.0};
};

/// Lines that lead from an inset to the region of the picture below that it shows: fractions of
/// that picture from its top left corner. The region gets a frame round it too. Of the four lines
/// from corner to corner those two are drawn that cross neither.
struct Leader {
    std::array<Scalar, 2> from{}, to{};
    Stroke stroke;
};

class Picture;

/// One layer of a picture. A point of the picture goes through the arrangers into the layer's own
/// picture; there the clip decides how much of it shows. The frame and the leader lines are drawn
/// opaque, whatever the layer's alpha, the frame above the layer and the leader lines below it.
struct Layer {
    std::string name;
    std::variant<Camera, std::shared_ptr<const Picture>> content;
    std::vector<PictureArrangerPointer> arrangers{};  ///< Outermost first; none: the whole picture.
    ClipShapePointer clip{};                          ///< Null: all of the layer's rectangle.
    Scalar softness = 0.0;  ///< Of the clip's edge, as a fraction of the layer's height.
    Scalar alpha = 1.0;
    BlendMode blend = BlendMode::normal;
    std::optional<Stroke> frame{};  ///< Round the clip, inside its edge.
    std::vector<Leader> leaders{};
};

/// A picture as expressions of picture x, picture y and time, for points in the picture and on its
/// border. A filter that reaches beyond it takes the nearest of these.
struct PictureExpressions {
    /// What is drawn, in the order of drawing; one of ray, paint and group.
    struct Element {
        std::string name;  ///< Of a ray: the layer's, behind those of the groups that it is in.
        /// From 0, nothing of it shows, to 1; alpha is in it. What is no number counts as 0.
        Expr coverage;
        BlendMode blend = BlendMode::normal;
        std::optional<RayExpressions> ray;
        Axes axes = Axes::z_up;  ///< Of the ray.
        std::optional<std::array<Expr, 3>> paint;
        std::vector<Element> group;  ///< Drawn by itself first, then as one.
    };
    std::vector<Element> elements;
};

/// How deep pictures may stand in pictures.
inline constexpr std::size_t max_nested_pictures = 16;
/// How many layers a picture may have, those of the pictures in it counted each time they stand
/// there.
inline constexpr std::size_t max_layers = 1000;

/// An immutable value, as a camera is.
class Picture {
public:
    struct Parts {
        std::string name;
        std::vector<Layer> layers;  ///< From the back to the front.
        /// Its size in pixels, unless the user asks for another; else only its aspect is known.
        std::optional<std::array<std::size_t, 2>> size;
        double aspect = 16.0 / 9.0;
    };

    /// Checks that there is a layer, that sizes, opacities, widths and nesting are within bounds.
    [[nodiscard]] static Result<Picture> make(Parts parts);
    /// A picture that shows one camera and nothing else.
    Picture(Camera camera);

    [[nodiscard]] const std::string& name() const { return parts_->name; }
    [[nodiscard]] const Parts& parts() const { return *parts_; }

    /// The camera that it was made of by itself; null if it was made of layers.
    [[nodiscard]] const Camera* only_camera() const;

    [[nodiscard]] PictureExpressions emit(Graph& graph, double width, double height) const;

private:
    explicit Picture(Parts parts) : parts_(std::make_shared<const Parts>(std::move(parts))) {}
    std::shared_ptr<const Parts> parts_;
    bool of_layers_ = true;
};

/// A camera that a picture shows, once for all layers that share it: copies of one camera, as the
/// language makes them for the same parameters.
struct ShownCamera {
    struct Place {
        std::string layer;  ///< Its number from 1 at the back, "3.1" in the picture of the third.
        std::size_t index = 0;  ///< Which camera layer of all this is, the back one 0.
        std::vector<PictureArrangerPointer>
            arrangers;  ///< From the whole picture, outermost first.
    };
    Camera camera;
    std::vector<Place> places;
};

/// From the back to the front, those of pictures in the picture among them.
[[nodiscard]] std::vector<ShownCamera> shown_cameras(const Picture& picture);

/// Width and height in pixels of a layer's own picture, in a whole picture of a size in pixels.
[[nodiscard]] std::array<double, 2> size_of(const ShownCamera::Place& place, double width,
                                            double height, double time = 0.0);

}  // namespace balcony::camera
