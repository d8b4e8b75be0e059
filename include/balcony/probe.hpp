// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Probe: which objects of a scene a camera sees, whether rays start inside an object, what hides a
// point from a camera, why a camera sees nothing, and where one stands well.
//
// A probe looks at the scene of a renderer as it stands, and builds nothing of its own. A stop is
// an error of Kind::interrupted.

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <Imath/ImathBox.h>
#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/picture.hpp"
#include "balcony/progress.hpp"
#include "balcony/rays.hpp"
#include "balcony/render.hpp"
#include "balcony/scene.hpp"

namespace balcony::render {

/// What is out of range is an error of Kind::usage.
struct ProbeSettings {
    std::size_t width = 1280;  ///< Of the picture in pixels: 1 to 2^20.
    std::size_t height = 720;
    std::size_t step = 4;            ///< Pixels between rays, at least 1.
    bool searches = true;            ///< For objects that are not seen at this step, in all pixels.
    double time = 0.0;               ///< The value of t in the camera's formulas.
    camera::ObjectFilter objects{};  ///< What the rays of the camera meet, as those of a layer.
};

/// The visibility of an object of the scene from a camera.
struct ObjectSight {
    bool has_surface = false;  ///< It has triangles that the rays may meet.
    bool seen = false;
    /// The number of rays at the step that start inside. Only an object whose surface is closed and
    /// faces outwards has an inside.
    std::size_t rays_from_inside = 0;
    Imath::V2d inside_at{0.0};  ///< A picture point, in pixels, whose ray starts inside.
};

struct Probe {
    std::size_t rays = 0;                     ///< The number of rays at the step.
    std::vector<ObjectSight> objects;         ///< In the order of Scene::objects.
    std::optional<double> median_distance{};  ///< From origin to first hit, in scene units.
};

/// How long a pixel is on the surfaces that a camera sees, in scene units: between neighbours of a
/// coarse grid. A hundredth of the picture has less than the least, and a hundredth more than the
/// most, as edges do behind which the surface goes on.
struct SurfaceScale {
    struct Range {
        double least = 0.0, median = 0.0, most = 0.0;
    };
    Range across{};   ///< Of a row.
    Range upwards{};  ///< Of a column.
};

/// Nothing if hardly any neighbours meet something. The step and the search do not matter.
[[nodiscard]] Result<std::optional<SurfaceScale>> measure_scale(const Renderer& renderer,
                                                                const camera::Camera& camera,
                                                                const ProbeSettings& settings,
                                                                const std::stop_token& stop = {});

/// By how much a pixel is longer on the surfaces than it should be, at the points of a grid of the
/// picture, row by row: 0.1 is a tenth. In each point, the direction in the picture with the
/// largest error counts. `pixel` is the length that is right, in scene units. Nothing where a ray
/// or its neighbours in the grid meet nothing.
[[nodiscard]] Result<std::vector<std::optional<double>>> scale_errors(
    const Renderer& renderer, const camera::Camera& camera, const ProbeSettings& settings,
    const rays::Tile& grid, double pixel, const std::stop_token& stop = {});

/// Transparent surfaces count as visible, and so do those behind them.
[[nodiscard]] Result<Probe> probe(const Renderer& renderer, const camera::Camera& camera,
                                  const ProbeSettings& settings, const PartDone& progress = {},
                                  const std::stop_token& stop = {});

/// A change of all rays of a camera.
enum class RayChange : std::uint8_t {
    reversed,    ///< The opposite directions.
    other_axes,  ///< As if the camera declared the other vertical axis.
    scaled,      ///< Origins multiplied by a factor that gives them about the size of the scene.
};

/// Why no or hardly any ray of a camera meets anything.
struct Miss {
    /// With this change, the rays would meet so many objects.
    struct Attempt {
        RayChange change = RayChange::reversed;
        double factor = 1.0;  ///< Of RayChange::scaled.
        std::size_t objects = 0;
        double share = 0.0;  ///< Of the rays, which meet them.
    };

    Imath::Box3d origins;           ///< Of the rays, in the scene's axes; empty without rays.
    Imath::Box3d bounds;            ///< Of the scene.
    std::vector<Attempt> attempts;  ///< Only those that meet objects.
};

/// Tries changes of the rays of a camera, on a coarse grid of its picture.
[[nodiscard]] Result<Miss> explain_miss(const Renderer& renderer, const camera::Camera& camera,
                                        const ProbeSettings& settings,
                                        const std::stop_token& stop = {});

/// A perspective camera for a scene that has none. It stands in front of the scene and slightly
/// above it, as near as shows all but its surroundings: a ground or a sky much larger than all
/// other objects together. If the scene is a closed room, it stands inside where it sees many
/// objects, each of them large. A scene without a finite size is an error.
[[nodiscard]] Result<scene::Camera> default_camera(const Renderer& renderer,
                                                   const std::stop_token& stop = {});

/// A surface of revolution, such as a vase, a column or a bent wall, in axes with z up.
struct Revolution {
    Imath::V3d axis{0.0, 0.0, 1.0};  ///< The direction of its axis, a unit vector, upwards.
    Imath::V3d center{0.0};          ///< On the axis, in the middle of its length.
    double length = 0.0;             ///< Of everything, along the axis.
    double radius = 0.0;             ///< The largest mean distance from the axis at a height.
    double reach = 0.0;              ///< The largest distance of anything.
    /// Which part of the way around the axis it takes: the middle, and the angle. Angles count from
    /// x, counter-clockwise, after the shortest turn of the axes that makes z the axis.
    double arc_middle = 3.141592653589793;
    double arc = 6.283185307179586;
    /// Distances from the axis and heights above the centre: of a surface of revolution that
    /// contains everything.
    std::vector<Imath::V2d> profile;
};

/// Where a scene or an object is and where one stands well in it, in axes with z up.
struct SceneExtent {
    /// Of all but its surroundings: a ground or a sky much larger than all other objects together.
    /// No side is shorter than a fiftieth of the radius.
    Imath::Box3d bounds;
    /// Of a scene: at eye level, 1.6 metres, above what is below, but not above the middle of a low
    /// scene; in the open, where much is seen and nothing is near. Of an object: where most of it
    /// is seen, if possible from in front of it and slightly above.
    Imath::V3d inside{0.0};
    /// Of the vertical cylinder around the centre of the bounds that contains everything.
    double radius = 0.0;
    /// Distances from the axis of this cylinder and heights above its centre, from bottom to top:
    /// of a surface of revolution that contains everything.
    std::vector<Imath::V2d> profile;
    /// That to which most of the surface is near, whatever its axis; nothing if there is none.
    std::optional<Revolution> revolution;
};

/// Measures a scene, or the first object of a name. An unknown name and what has no finite size are
/// errors.
[[nodiscard]] Result<SceneExtent> measure_scene(const Renderer& renderer,
                                                const std::string& object = {},
                                                const std::stop_token& stop = {});

/// An error for each name in the object filters of a picture that no object of a scene has. Jobs
/// report these errors, too.
[[nodiscard]] Diagnostics check_objects(const camera::Picture& picture, const scene::Scene& scene);

/// From the origin of a ray to a point that it may show.
struct SightLine {
    Imath::V3d from, to;
    const camera::ObjectFilter* objects = nullptr;  ///< What the ray meets; all if null.
};

/// An object that hides the end of a line from its start.
struct Obstacle {
    std::uint32_t object = 0;  ///< Index into Scene::objects.
    double distance = 0.0;     ///< From the start, in scene units.
};

/// The first opaque surface on each line; none if the point is visible. Lines start and end like
/// the renderer's rays: a surface at the start counts, the surface on which the end lies does not.
/// The end lies on a surface if it is in the plane of the triangle within float precision, or if
/// the distance to the surface is below 1e-5 of the line's length. `axes` are those of the lines.
[[nodiscard]] Result<std::vector<std::optional<Obstacle>>> find_obstacles(
    const Renderer& renderer, std::span<const SightLine> lines, Axes axes,
    const std::stop_token& stop = {});

}  // namespace balcony::render
