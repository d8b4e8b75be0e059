// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Picture: the result of the picture arranger: several cameras clipped, placed and blended into one
// picture. A single camera is a picture of one layer.

#include <array>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "balcony/camera.hpp"
#include "balcony/names.hpp"

namespace balcony::camera {

/// How a layer's colour s (source) is combined with the backdrop colour d, before the layer's
/// coverage interpolates between d and the result. The names and formulas are those of the W3C's
/// "Compositing and Blending Level 1", in linear light.
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

[[nodiscard]] Names<BlendMode> blend_modes();

/// What happens to a picture that is shown in a place of another aspect. Aspects that differ by at
/// most a pixel of the place are the same.
enum class Fit : std::uint8_t {
    fit,      ///< It becomes as large as the place permits and stands in the middle.
    fill,     ///< It covers the place, centred; what is beyond the place is cut off.
    stretch,  ///< It is stretched.
};

[[nodiscard]] Names<Fit> fits();

/// A rectangle in a picture: two corners, as fractions from the picture's top left corner.
struct PictureRegion {
    std::array<Scalar, 2> from{}, to{};
};

/// A drawn line: its width as a fraction of the whole picture's height, its colour in linear light.
struct Stroke {
    Scalar width = 0.004;
    std::array<Scalar, 3> color{1.0, 1.0, 1.0};
};

/// A bar with the length of something in the scene.
struct ScaleBar {
    Scalar length = 1.0;  ///< In scene units.
    /// The middle of its left end, as fractions of the layer's own picture from its top left.
    std::array<Scalar, 2> at{0.03, 0.95};
    Scalar height = 0.015;  ///< As a fraction of the height of this picture.
};

/// Lines from an inset to a region of the picture below. The region is outlined too. Of the four
/// lines from corner to corner, the two that cross neither rectangle are drawn.
struct Leader {
    /// In the whole picture. Without it, what the layer shows, where the layer `source_of` shows
    /// it; without such a layer, the same region of the whole picture.
    std::optional<PictureRegion> region{};
    Stroke stroke{};
};

/// Red, green and blue of a colour in linear light, each as weights of the red, green and blue of
/// another.
using ColorMatrix = std::array<std::array<double, 3>, 3>;

/// A name of objects of a scene, or a pattern for several: `*` stands for any characters, `?` for
/// one.
struct ObjectPattern {
    std::string text;
    SourceSpan written{};  ///< Where a file has it, for problems with the scene.
};

/// The objects that the rays of a camera meet first, those of the patterns or all others. What a
/// ray meets once it is reflected or refracted does not depend on it, nor do lights and shadows.
struct ObjectChoice {
    bool shows = true;  ///< Otherwise these are hidden.
    std::vector<ObjectPattern> patterns;
};

/// All choices together; without any, all objects. Only without a choice that shows some, rays that
/// meet none of the objects show the environment.
using ObjectFilter = std::vector<ObjectChoice>;

/// What a layer is composited by.
enum class Compositing : std::uint8_t {
    order,  ///< It covers the layers behind it.
    /// The depth of what it shows, along the rays of the master, which is the layer behind it, or
    /// that one's master. A point's depth is that of its foot on the master's ray at the same point
    /// of the picture. The nearest of such layers is in front, the foremost layer among equals.
    /// What is behind the origin of the ray is not drawn; where the master has no ray, their order
    /// counts.
    depth,
    /// Its weight as a part of the sum of those of all layers by weight that follow each other.
    weight,
};

class Picture;

/// One layer of a picture. Its window is the part of the picture that it covers; the clip is a
/// shape in the window and determines the coverage. The frame, the leader lines and the scale bar
/// are drawn opaque for any alpha, the leader lines below the layer and the others above it.
struct Layer {
    std::string name;
    std::variant<Camera, std::shared_ptr<const Picture>> content;
    /// From the whole picture to the window, outermost first; none: the window is the whole
    /// picture.
    std::vector<PictureArrangerPointer> arrangers{};
    /// From the window to what it shows, outermost first. They leave clip, frame and leaders alone.
    std::vector<PictureArrangerPointer> inner_arrangers{};
    Fit fit = Fit::fit;  ///< Of what it shows in the window, which `fit` makes smaller.
    std::optional<PictureRegion> show{};  ///< The region of its own picture that fills the window.
    ClipShapePointer clip{};              ///< Null: the whole window.
    Scalar softness = 0.0;  ///< Width of the clip's edge, as a fraction of the window's height.
    Scalar alpha = 1.0;
    std::optional<ColorMatrix> channels{};  ///< Of what it shows; its own colours without it.
    ObjectFilter objects{};                 ///< Of all cameras that it shows.
    Compositing compositing = Compositing::order;
    /// Of Compositing::weight, by the point of the picture in fractions from its top left corner;
    /// 0 where it is negative or not finite.
    std::optional<Formula> weight{};
    BlendMode blend = BlendMode::normal;
    std::optional<Stroke> frame{};  ///< Along the clip, inside its edge.
    std::vector<Leader> leaders{};
    /// On what it shows, which must have a scale.
    std::optional<ScaleBar> scale_bar{};
};

/// A picture as expressions of picture x, picture y and time, for points in the picture and on its
/// border. A filter that extends beyond it uses the nearest of these.
struct PictureExpressions {
    /// The elements in the order of drawing; each is a ray, a paint or a group.
    struct Element {
        std::string name;  ///< For a ray: the layer's name, prefixed by those of its groups.
        /// From 0 (invisible) to 1, including alpha. NaN counts as 0.
        Expr coverage;
        std::optional<ColorMatrix> channels;  ///< Applied before the coverage and the blend mode.
        BlendMode blend = BlendMode::normal;
        std::optional<RayExpressions> ray;
        Axes axes = Axes::z_up;  ///< Origin of the ray.
        ObjectFilter objects{};  ///< Of the ray.
        std::optional<std::array<Expr, 3>> paint;
        std::vector<Element> group;  ///< Composited separately first, then as one.
        /// How those of the group are composited: by order, or rays by depth, of which the first
        /// one is the master.
        Compositing compositing = Compositing::order;
    };
    std::vector<Element> elements;
};

/// The aspect of pictures that have none of their own.
inline constexpr double default_aspect = 16.0 / 9.0;
/// The maximum nesting depth of pictures.
inline constexpr std::size_t max_nested_pictures = 16;
/// The maximum number of layers of a picture, including those of nested pictures at each
/// occurrence.
inline constexpr std::size_t max_layers = 1000;

/// An immutable value, like a camera.
class Picture {
public:
    struct Parts {
        std::string name;
        std::vector<Layer> layers;  ///< From back to front.
        /// Its default size in pixels; without it, only the aspect is known.
        std::optional<std::array<std::size_t, 2>> size{};
        /// Width divided by height. It follows from a size; with neither, the picture adapts to any
        /// aspect.
        std::optional<double> aspect{};
        /// Width and height in scene units, if it has a scale.
        std::optional<std::array<double, 2>> sides{};
        Fit fit = Fit::fit;  ///< Of the whole in a picture of another aspect.
    };

    /// Checks that there is a layer, that sizes, opacities, widths, regions and nesting are within
    /// limits, that layers that are composited by depth are cameras and have a master, and
    /// that those by weight have one.
    [[nodiscard]] static Result<Picture> make(Parts parts);
    /// A picture that shows a single camera.
    Picture(Camera camera);
    /// The same, with another treatment of pictures of another aspect.
    [[nodiscard]] Picture with_fit(Fit fit) const;
    /// The same, with another default size in pixels.
    [[nodiscard]] Picture with_size(const std::array<std::size_t, 2>& size) const;
    /// The same, with all its cameras in another pose.
    [[nodiscard]] Picture with_pose(const Pose& pose) const;
    /// The same, with another turn of all its cameras.
    [[nodiscard]] Picture with_turn(const Turn& turn) const;
    /// The same with all its cameras as views of a stereo pair. It is an error if one of them is
    /// one already. Layers that share a camera still do.
    [[nodiscard]] Result<Picture> with_stereo(const StereoViewPointer& view) const;

    [[nodiscard]] const std::string& name() const { return parts_->name; }
    [[nodiscard]] const Parts& parts() const { return *parts_; }
    /// The aspect that it is made for: 16/9 if it adapts to any.
    [[nodiscard]] double aspect() const { return parts_->aspect.value_or(default_aspect); }

    /// Its width and height in scene units: its own, or those of a back layer that fills a picture
    /// without an aspect. Nothing if it has no scale.
    [[nodiscard]] std::optional<std::array<double, 2>> sides() const;

    /// The single camera from which it was made; null if it was made from layers.
    [[nodiscard]] const Camera* only_camera() const;
    /// The aspect without which it is stretched; nothing if it adapts to any.
    [[nodiscard]] std::optional<double> fixed_aspect() const;

    [[nodiscard]] PictureExpressions emit(Graph& graph, double width, double height) const;

private:
    using MovedCameras = std::map<const Camera::Parts*, Camera>;
    template <class Move>
    [[nodiscard]] Picture moved(const Move& move, MovedCameras& cameras) const;

    explicit Picture(Parts parts) : parts_(std::make_shared<const Parts>(std::move(parts))) {}
    std::shared_ptr<const Parts> parts_;
    bool of_layers_ = true;
};

/// What a layer shows, as a view of a stereo pair.
[[nodiscard]] Result<decltype(Layer::content)> with_stereo(const decltype(Layer::content)& content,
                                                           const StereoViewPointer& view);

/// The front one of the layers behind a layer that show the same camera or picture, with the same
/// parameters; nothing if none does. The region that the layer shows is one of this layer's
/// picture.
[[nodiscard]] std::optional<std::size_t> source_of(const Picture::Parts& parts, std::size_t layer);

/// A camera that a picture shows, with all layers that share it: copies of one camera, as the
/// language makes them for the same parameters.
struct ShownCamera {
    struct LayerUse {
        std::string layer;  ///< Its number from 1 at the back, "3.1" in the picture of the third.
        std::size_t index = 0;  ///< Which camera layer of all this is, the back one 0.
        std::vector<PictureArrangerPointer>
            arrangers;           ///< From the whole picture, outermost first.
        ObjectFilter objects{};  ///< That of the layer and those around it.
    };
    Camera camera;
    std::vector<LayerUse> uses;
};

/// From back to front, including those of nested pictures.
[[nodiscard]] std::vector<ShownCamera> shown_cameras(const Picture& picture);

/// Width and height in pixels of a layer's own picture, in a whole picture of a size in pixels.
[[nodiscard]] std::array<double, 2> size_of(const ShownCamera::LayerUse& use, double width,
                                            double height, double time = 0.0);

}  // namespace balcony::camera
