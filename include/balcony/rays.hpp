// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Rays: a compiled camera or picture that computes rays as numbers, for all users of rays: the
// renderer, the analysis, bridges to other renderers.
//
//     compile(camera, width, height, options) ─▶ RayProgram ─▶ run(tile or points) ─▶ RayBatch
//     compile(picture, width, height, options) ─▶ CompiledPicture: a RayProgram per camera layer
//                                                 and the coverages of the layers
//
// Compiled objects are immutable and may be shared by threads; a Scratch and a RayBatch belong to
// one thread.

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

#include <Imath/ImathVec.h>

#include "balcony/base.hpp"
#include "balcony/camera.hpp"
#include "balcony/picture.hpp"
#include "balcony/program.hpp"
#include "balcony/ray_roots.hpp"

namespace balcony::rays {

using Imath::V2d;
using Imath::V3d;
using program::Input;
using program::Points;
using program::Scratch;
using program::Tile;

/// Options of compilation.
struct CompileOptions {
    /// The axes of the rays; by default each camera's own.
    std::optional<Axes> axes{};
    bool footprints = false;  ///< Include the derivatives with respect to picture x and y.
    bool parameters = true;   ///< Include (u, v) of the eye object.
    bool tiles = true;        ///< Allow running over tiles.
    bool points = false;      ///< Allow running over lists of points.
    /// Whether bent rays are followed, by RayBatch::part(). Otherwise a camera with a bend is an
    /// error, because all else is that of the first straight part of its rays.
    bool bends = false;
    /// Inputs of the rays besides picture x and y and time, such as a parameter that a live view
    /// moves. Tile and Points carry the values, in this order. With both inputs of a lens
    /// (camera::lens_input_x and _y), the rays of cameras with a lens pass through that point of
    /// the lens; without them, through its middle.
    std::vector<Input> inputs{};
};

/// A ray at a point of the picture.
struct Ray {
    V3d origin{0.0};
    V3d direction{0.0};  ///< Unit length where valid.
    bool valid = false;
    V2d parameters{0.0};         ///< (u, v) of the eye object; 0 if not requested.
    std::optional<double> time;  ///< When it meets the scene, if the camera says so.
    /// The exact derivatives with respect to picture x and y, per pixel; 0 if not requested.
    V3d origin_by_x{0.0}, origin_by_y{0.0};
    V3d direction_by_x{0.0}, direction_by_y{0.0};
};

/// The rays of a tile, row by row, or of a list of points. Runs reuse its memory.
class RayBatch {
public:
    [[nodiscard]] std::size_t size() const { return size_; }
    [[nodiscard]] bool has_footprints() const { return roots_.footprints; }
    [[nodiscard]] bool has_parameters() const { return roots_.parameters; }
    /// Whether each ray has a time of its own. Otherwise all have that of the run.
    [[nodiscard]] bool has_times() const { return roots_.times; }

    [[nodiscard]] bool valid(std::size_t i) const { return values_[RayRoots::valid][i] == 1.0; }
    /// Whether there is no ray because a lens lets no light through: the picture is dark there.
    [[nodiscard]] bool blocked(std::size_t i) const {
        return values_[RayRoots::valid][i] == RayRoots::is_blocked;
    }
    [[nodiscard]] V3d origin(std::size_t i) const { return vector(RayRoots::origin, i); }
    [[nodiscard]] V3d direction(std::size_t i) const { return vector(RayRoots::direction, i); }
    [[nodiscard]] V2d parameters(std::size_t i) const {
        const std::size_t u = roots_.parameter_u();
        return {values_[u][i], values_[u + 1][i]};
    }
    [[nodiscard]] double time(std::size_t i) const { return values_[roots_.time()][i]; }
    [[nodiscard]] V3d origin_by_x(std::size_t i) const { return vector(RayRoots::origin_by_x, i); }
    [[nodiscard]] V3d origin_by_y(std::size_t i) const { return vector(RayRoots::origin_by_y, i); }
    [[nodiscard]] V3d direction_by_x(std::size_t i) const {
        return vector(RayRoots::direction_by_x, i);
    }
    [[nodiscard]] V3d direction_by_y(std::size_t i) const {
        return vector(RayRoots::direction_by_y, i);
    }
    [[nodiscard]] Ray operator[](std::size_t i) const;

    /// How many straight parts each ray has: 1, or more if the camera bends its rays.
    [[nodiscard]] std::size_t part_count() const { return roots_.knots + 1; }
    struct Part {
        V3d origin;
        V3d direction;  ///< Unit length; undefined if the part has no length.
        double length;  ///< Infinite for the last part.
    };
    [[nodiscard]] Part part(std::size_t i, std::size_t number) const;
    /// A part with a length as a ray that begins where the part does; part 0 is the ray itself.
    [[nodiscard]] Ray ray_of_part(std::size_t i, std::size_t number) const;

    /// The values of all rays in parallel arrays, by axis; `valid` is 1 where there is a ray.
    struct Arrays {
        std::array<const double*, 3> origin;
        std::array<const double*, 3> direction;
        const double* valid;
        const double* time;  ///< Null if all rays have the time of the run.
    };
    [[nodiscard]] Arrays arrays() const {
        return {vectors(RayRoots::origin), vectors(RayRoots::direction), values_[RayRoots::valid],
                has_times() ? values_[roots_.time()] : nullptr};
    }

    /// Likewise, their derivatives. Only with footprints.
    struct FootprintArrays {
        std::array<const double*, 3> origin_by_x, origin_by_y;
        std::array<const double*, 3> direction_by_x, direction_by_y;
    };
    [[nodiscard]] FootprintArrays footprint_arrays() const {
        return {vectors(RayRoots::origin_by_x), vectors(RayRoots::origin_by_y),
                vectors(RayRoots::direction_by_x), vectors(RayRoots::direction_by_y)};
    }

private:
    friend class RayProgram;

    /// Which roots there are behind those of the ray: its footprints, its time, its parameters.
    struct Roots {
        bool footprints = false;
        bool times = false;
        bool parameters = false;
        std::size_t knots = 0;  // Of a bend, which has at least one.

        [[nodiscard]] std::size_t time() const {
            return footprints ? RayRoots::end_of_footprints : RayRoots::end_of_ray;
        }
        [[nodiscard]] std::size_t parameter_u() const { return time() + (times ? 1 : 0); }
        [[nodiscard]] std::size_t bend() const { return parameter_u() + (parameters ? 2 : 0); }
        /// The roots of a bend's last direction and knots, and as many of their derivatives by x
        /// and by y.
        [[nodiscard]] std::size_t bend_size() const { return knots == 0 ? 0 : 3 * (1 + knots); }
        [[nodiscard]] std::size_t count() const {
            return bend() + (footprints ? 3 : 1) * bend_size();
        }
    };
    /// What a bend has at one of its knots, from 1 on: 0 is its last direction.
    enum class Slope : std::size_t { none, by_x, by_y };
    [[nodiscard]] V3d of_bend(std::size_t i, std::size_t knot, Slope slope = Slope::none) const {
        return vector(
            roots_.bend() + static_cast<std::size_t>(slope) * roots_.bend_size() + 3 * knot, i);
    }

    [[nodiscard]] V3d vector(std::size_t root, std::size_t i) const {
        return {values_[root][i], values_[root + 1][i], values_[root + 2][i]};
    }
    [[nodiscard]] std::array<const double*, 3> vectors(std::size_t root) const {
        return {values_[root], values_[root + 1], values_[root + 2]};
    }
    std::span<double* const> reserve(std::size_t size, const Roots& roots);

    std::size_t size_ = 0;
    Roots roots_;
    program::ResultArrays values_;
};

/// The rays of one camera.
class RayProgram {
public:
    /// All expressions must be in one graph. It is an error if they depend on an input that the
    /// options do not declare. Throws expr::GraphTooLarge if the derivatives do not fit into
    /// the graph, and expr::GraphStopped; compile() converts them to diagnostics.
    [[nodiscard]] static Result<RayProgram> make(const camera::RayExpressions& ray,
                                                 Axes axes_of_ray, const CompileOptions& options);

    [[nodiscard]] bool has_footprints() const { return roots_.footprints; }
    [[nodiscard]] bool has_parameters() const { return roots_.parameters; }
    /// Whether each ray has a time of its own.
    [[nodiscard]] bool has_times() const { return roots_.times; }
    /// Whether the rays depend on the inputs of a lens.
    [[nodiscard]] bool has_lens() const { return lens_; }
    /// As RayBatch::part_count().
    [[nodiscard]] std::size_t part_count() const { return roots_.knots + 1; }
    /// What a ray costs by itself, in instructions.
    [[nodiscard]] std::size_t instruction_count() const;

    /// Computes rays over a tile of any size or at any number of points, according to the options.
    void run(const Tile& tile, Scratch& scratch, RayBatch& rays) const;
    void run(const Points& points, Scratch& scratch, RayBatch& rays) const;

private:
    RayProgram(const RayBatch::Roots& roots, bool lens) : roots_(roots), lens_(lens) {}

    RayBatch::Roots roots_;
    bool lens_;
    std::optional<program::Program> for_tiles_;
    std::optional<program::Program> for_points_;
};

/// Compiles the rays of a single camera, in a picture of a positive size in pixels. It is an error
/// if the derivatives exceed the size limit of a graph, or if an input is not declared. Here and
/// below, a stop is an error of Kind::interrupted.
[[nodiscard]] Result<RayProgram> compile(const camera::Camera& camera, double width, double height,
                                         const CompileOptions& options,
                                         const std::stop_token& stop = {});

/// A compiled picture: the rays of each camera layer, and the coverage of each layer.
class CompiledPicture {
public:
    /// What is drawn, in the order of drawing: a camera layer, a paint or a group.
    struct Element {
        std::optional<camera::ColorMatrix> channels;
        camera::BlendMode blend = camera::BlendMode::normal;
        std::optional<std::size_t>
            coverage;                      ///< Index into the coverages; without it, 1 everywhere.
        std::optional<std::size_t> layer;  ///< Index into layers().
        std::optional<std::size_t> paint;  ///< The index of the first of three colour channels.
        std::vector<Element> group;
        /// Of the group: by depth, its elements are layers, of which the first one is the master.
        camera::Compositing compositing = camera::Compositing::order;
    };
    struct CameraLayer {
        std::string name;        ///< Prefixed by the names of the enclosing pictures.
        Axes axes = Axes::z_up;  ///< The axes of its rays.
        RayProgram rays;
        camera::ObjectFilter objects;  ///< What its rays meet first.
    };

    [[nodiscard]] const std::vector<Element>& elements() const { return elements_; }
    /// From back to front.
    [[nodiscard]] const std::vector<CameraLayer>& layers() const { return layers_; }
    /// The total number of coverages and paint channels; 0 if one camera covers everything.
    [[nodiscard]] std::size_t coverage_count() const;
    /// Computes coverages and paint channels over a tile: results[i] receives number i. A coverage
    /// is from 0 to 1, or NaN.
    void run_coverages(const Tile& tile, Scratch& scratch, std::span<double* const> results) const;

    /// One camera that covers everything, in its own colours, and shows all objects.
    [[nodiscard]] bool is_one_camera() const {
        return elements_.size() == 1 && elements_.front().layer && !coverages_ &&
               !elements_.front().channels && layers_.front().objects.empty();
    }

private:
    friend class PictureCompiler;
    std::vector<Element> elements_;
    std::vector<CameraLayer> layers_;
    std::optional<program::Program> coverages_;
};

/// Compiles a picture of a size in pixels, for tiles. It is an error if its formulas or their
/// derivatives exceed the size limit of a graph.
[[nodiscard]] Result<CompiledPicture> compile(const camera::Picture& picture, double width,
                                              double height, const CompileOptions& options,
                                              const std::stop_token& stop = {});

/// A camera layer of a picture as a function from points of the whole picture to rays, which are
/// valid only where its coverage is above 0.
struct VisibleLayer {
    std::string name;
    Axes axes = Axes::z_up;
    RayProgram rays;
    camera::ObjectFilter objects;  ///< What its rays meet first.
};

/// The layers of a picture, compiled for points.
class VisibleLayers {
public:
    /// From back to front. A camera by itself is one layer that covers everything.
    [[nodiscard]] const std::vector<VisibleLayer>& layers() const { return layers_; }
    /// Whether elements in front may hide any part of a layer.
    [[nodiscard]] bool any_hidden() const { return hidden_.has_value(); }
    /// hidden[l][i] receives 1 where layers and lines in front of layer l hide it completely at
    /// point i, by the renderer's rule: those in normal blend mode that cover the point completely.
    /// A layer of some objects, or one that is composited by depth, hides those that it meets
    /// nearer; without a scene it hides nothing.
    void run_hidden(const Points& points, Scratch& scratch, std::span<double* const> hidden) const;

private:
    friend class LayerFinder;
    std::vector<VisibleLayer> layers_;
    std::optional<program::Program> hidden_;
};

/// Compiles the layers of a picture for points.
[[nodiscard]] Result<VisibleLayers> compile_layers(const camera::Picture& picture, double width,
                                                   double height, const CompileOptions& options,
                                                   const std::stop_token& stop = {});

/// The first and the last of some times, in seconds.
struct RayTimes {
    double first = 0.0;
    double last = 0.0;
};

/// When the rays of a picture meet the scene while its own time t runs from the first to the last:
/// these times, and those of the cameras that give their rays times of their own, at a grid of
/// points that includes the borders of the picture. Inputs have the values of Parts::inputs.
[[nodiscard]] Result<RayTimes> ray_times(const camera::Picture& picture, const RayTimes& times,
                                         const std::stop_token& stop = {});

}  // namespace balcony::rays
