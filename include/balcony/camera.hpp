// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Camera: the abstract camera machine of "Ray Tracing with Extended Cameras" (1996), section 2. It
// joins stages (stages.hpp) to the ray of a point of the picture. It knows no film, file format,
// evaluator or scene.

#include <array>
#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"
#include "balcony/formula.hpp"
#include "balcony/stages.hpp"

namespace balcony::camera {

/// getEyePnt or getDirPnt: from a point of the picture to a point of an object.
struct Path {
    PictureMapperPointer mapper;
    std::vector<ParameterTransformerPointer> parameter_transformers;
    ObjectGeneratorPointer generator;
    std::vector<ObjectTransformerPointer> object_transformers;

    [[nodiscard]] PathPoint emit(const PicturePoint& picture, Emitter& emit,
                                 bool with_second_derivative = false) const;
};

/// The inputs of a lens: a point of the square from (-1, -1) to (1, 1), which the lens maps to its
/// aperture. (0, 0) is the central ray.
inline constexpr std::string_view lens_input_x = "lens_x";
inline constexpr std::string_view lens_input_y = "lens_y";

/// A ray through a lens, as expressions of the lens inputs and what else a ray depends on.
struct LensExpressions {
    LensRay ray;
    std::vector<expr::Substitution> fixed{};  ///< As those of LensRays.
};

/// How a bent ray goes on: from its origin straight to the first knot, from knot to knot, and from
/// the last knot without end.
struct BendExpressions {
    std::vector<ObjectPoint> knots;  ///< At least one.
    ObjectVector direction;          ///< Behind the last knot; unit length where valid.
};

/// The ray of a picture point, as expressions of picture x, picture y and time. If there is a lens,
/// the ray is the one through its middle.
struct RayExpressions {
    ObjectPoint origin;
    ObjectVector direction;     ///< Unit length where valid.
    Expr valid;                 ///< 1 where there is a ray with six finite values, otherwise 0.
    ParameterPoint parameters;  ///< (u, v) of the eye object; a point or curve may ignore them.
    std::optional<LensExpressions> lens{};
    /// When the ray meets the scene, if that is not at time t; finite where valid.
    std::optional<Expr> time{};
    /// As LensRay::blocked. Only of a ray through_lens().
    std::optional<Expr> blocked{};
    /// Of a ray that is bent; origin and direction are then those of its first straight part.
    std::optional<BendExpressions> bend{};
};

/// The change of a ray from pixel to pixel: its exact partial derivatives with respect to picture x
/// and y.
struct RayFootprint {
    ObjectVector origin_by_x, origin_by_y;
    ObjectVector direction_by_x, direction_by_y;  ///< Derivatives of the unit direction.
};

/// The change of a bent ray: of its knots and of its last direction.
struct BendFootprint {
    std::vector<ObjectVector> knots_by_x, knots_by_y;
    ObjectVector direction_by_x, direction_by_y;
};

/// The derivatives are computed from the ray's expressions on request.
[[nodiscard]] RayFootprint footprint(const RayExpressions& ray);
/// The same for the rest of a ray that is bent.
[[nodiscard]] BendFootprint footprint_of_bend(const RayExpressions& ray);

/// The ray through the point of the aperture that the lens inputs name, as a ray without a lens.
[[nodiscard]] RayExpressions through_lens(const RayExpressions& ray);
/// Its footprint. That of a thin lens is the footprint of the central ray in the sharp point.
[[nodiscard]] RayFootprint footprint_through_lens(const RayExpressions& ray);

/// A turn of all rays of a camera about a vertical axis, counterclockwise seen from above.
struct Turn {
    Scalar angle;                    ///< In radians.
    std::array<double, 3> center{};  ///< A point of the axis.
    Axes axes = Axes::z_up;          ///< Of the centre.
};

/// Where a camera stands: all of its rays are rotated, and then shifted. In axes with z up,
/// whatever the camera has.
struct Pose {
    /// Orthonormal, of determinant 1: place = rotation * point + position.
    std::array<std::array<double, 3>, 3> rotation{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
    std::array<double, 3> position{};
};

/// An extended camera. Its stages write their formulas once, when it is made.
class Camera {
public:
    struct Parts {
        std::string name;
        std::vector<PictureArrangerPointer> arrangers;  ///< Outermost first; may be empty.
        Path eye;
        std::optional<Path> toward;
        DirectionRulePointer look;
        StereoViewPointer stereo{};  ///< Null: the only view.
        LensPointer lens{};          ///< Null: a pinhole at the origin of each ray.
        BendPointer bend{};          ///< Null: rays are straight. Not together with a lens.
        std::optional<Pose> pose{};  ///< Of the rays that all of this makes.
        std::optional<Turn> turn{};  ///< Of the rays in this pose.
        /// When each ray meets the scene: a number of seconds as a formula of the point of the
        /// camera's own picture, in fractions from its top left corner. It replaces t in all other
        /// formulas of the camera. Without it, every ray meets the scene at time t.
        std::optional<Formula> time{};
        double aspect = 16.0 / 9.0;  ///< Width divided by height.
        /// Width and height of the picture in scene units, if it has a scale.
        std::optional<std::array<double, 2>> sides{};
        Axes axes = Axes::z_up;
        SourceSpan lens_span{};  ///< Where a file has the lens, for problems with the scene.
        SourceSpan bend_span{};  ///< Where a file has the bend, for its problems.
        /// How a file writes its stages, for texts about the camera.
        std::map<const Stage*, std::string> written{};
        /// Further inputs of its formulas, such as parameters that a program may move, with values
        /// for stages that choose their formula by trying it out.
        std::vector<KnownInput> inputs{};
    };

    /// Checks that the parts fit together: all are there, the rule and the object transformers get
    /// what they need, and the formulas have at most max_operations_of_camera operations. A
    /// direction object that the rule has no use for is left out with a warning. A stop is an
    /// error of Kind::interrupted.
    [[nodiscard]] static Result<Camera> make(Parts parts, const std::stop_token& stop = {});
    /// The same camera as a view of a stereo pair. It is an error if it is one already.
    [[nodiscard]] Result<Camera> with_stereo(StereoViewPointer view) const;

    [[nodiscard]] const std::string& name() const { return emitted_->parts.name; }
    [[nodiscard]] const Parts& parts() const { return emitted_->parts; }
    /// The same camera in another pose.
    [[nodiscard]] Camera with_pose(const Pose& pose) const;
    /// The same camera with another turn.
    [[nodiscard]] Camera with_turn(const Turn& turn) const;
    /// The aspect without which its picture is stretched: that of its parts. Nothing if its maps
    /// adapt to any aspect; the map of a point does not matter.
    [[nodiscard]] std::optional<double> fixed_aspect() const;
    /// The number of nodes in the graph of its ray.
    [[nodiscard]] std::size_t operations() const { return emitted_->graph.size(); }

    /// getRay, for a picture of the given size in pixels.
    [[nodiscard]] RayExpressions emit(Graph& graph, double width, double height) const;
    /// The same for a point mapped by the arrangers of a larger picture.
    [[nodiscard]] RayExpressions emit(const PicturePoint& picture) const;
    /// What the stages compute for this point, in the order in which they apply: the nodes that its
    /// ray is made of.
    [[nodiscard]] std::vector<StageValues> emit_stages(const PicturePoint& picture) const;
    /// Whether its arrangers show a point of its own picture there: 1 or 0, and 1 without any.
    [[nodiscard]] Expr emit_arranged(const PicturePoint& picture) const;

private:
    /// The parts and the ray that they make in a picture of any size.
    struct Emitted {
        Emitted(Parts made_of, const std::stop_token& stop, std::size_t most_operations);

        Parts parts;
        Graph graph;
        PicturePoint picture;  ///< Picture x and y; the size is two variables.
        RayExpressions ray;    ///< Of this point of the camera's own picture.
        std::vector<StageValues> stages;
        Diagnostics problems;  ///< What the stages reported.
    };
    explicit Camera(std::shared_ptr<const Emitted> emitted) : emitted_(std::move(emitted)) {}
    [[nodiscard]] PicturePoint own_point(const PicturePoint& whole, Emitter& emit) const;
    /// Puts a point of the camera's own picture in the place of the one that was emitted.
    [[nodiscard]] std::array<expr::Substitution, 4> put(const PicturePoint& picture) const;

    std::shared_ptr<const Emitted> emitted_;
};

/// The most operations that a camera and a picture may have. Their derivatives have several times
/// as many, and a graph holds 4 million.
inline constexpr std::size_t max_operations_of_camera = 250'000;
inline constexpr std::size_t max_operations_of_picture = 500'000;

}  // namespace balcony::camera
