// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Camera: the abstract camera machine of "Ray Tracing with Extended Cameras" (1996), section 2.
//
//     picture arranger ─▶ picture mapper ─▶ parameter transformers ─▶ object generator
//                                             ─▶ object transformers ─▶ direction rule ─▶ ray
//
// Each stage is a small immutable value that writes its formula into an expression graph. A camera
// knows no film, file format, evaluator or scene.

#include <array>
#include <cstdint>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"
#include "balcony/formula.hpp"

namespace balcony::camera {

// ------------------------------------------------------------------------------------ spaces

/// DCS, device coordinates: pixels, x to the right, y down, pixel centres at .5.
struct DevicePoint {
    Expr x, y;
};

/// PCS, parameter coordinates of a projection object.
struct ParameterPoint {
    Expr u, v;
};

/// OCS, object coordinates: the world of the scene, in the camera's axes.
struct ObjectPoint {
    Expr x, y, z;
};

/// A difference of two points of OCS.
struct ObjectVector {
    Expr x, y, z;
};

ObjectVector operator-(const ObjectPoint& a, const ObjectPoint& b);
ObjectPoint operator+(const ObjectPoint& a, const ObjectVector& b);
ObjectVector operator+(const ObjectVector& a, const ObjectVector& b);
ObjectVector operator-(const ObjectVector& a);
ObjectVector operator*(Expr factor, const ObjectVector& a);
Expr dot(const ObjectVector& a, const ObjectVector& b);
ObjectVector cross(const ObjectVector& a, const ObjectVector& b);

/// The size of a picture in pixels; expressions, because an arranger may give a camera only a part.
struct PictureSize {
    Expr width, height;
};

// ---------------------------------------------------------------------------- stage parameters

class RayTarget;
class Stage;

/// What a stage computes on the way to a ray, for programs that show a camera stage by stage.
struct StageValues {
    /// The path that the stage belongs to; the direction rule has its own.
    enum class Place : std::uint8_t { eye, toward, look };

    const Stage* stage = nullptr;
    Place place = Place::eye;
    /// The coordinates of a point of PCS (two) or of OCS, or the direction (three).
    std::vector<Expr> values;
};

/// The output of stages: a graph and the conditions under which there is a ray.
class Emitter {
public:
    /// What trial() takes for variables 0, 1, ... of the graph, and for inputs other than x, y
    /// and t.
    struct Trial {
        std::vector<double> variables{};
        std::vector<KnownInput> inputs{};
    };
    explicit Emitter(Graph& graph) : Emitter(graph, Trial()) {}
    Emitter(Graph& graph, Trial trial)
        : graph_(&graph), valid_(graph.constant(1.0)), trial_(std::move(trial)) {}

    [[nodiscard]] Graph& graph() const { return *graph_; }
    [[nodiscard]] Expr operator()(double value) const { return graph_->constant(value); }
    [[nodiscard]] Expr operator()(const Scalar& value) const { return value.emit(*graph_); }
    /// Requires a condition; where it is false, there is no ray.
    void require(Expr condition) { valid_ = valid_ && condition; }
    /// The same, with the error of a camera whose condition holds at no point of its picture.
    void require_somewhere(Expr condition, Diagnostic otherwise) {
        require(condition);
        needs_.push_back({condition, std::move(otherwise)});
    }
    /// The results of a function; no ray where it says that they do not hold.
    [[nodiscard]] std::vector<Expr> call(std::shared_ptr<const expr::Native> function,
                                         std::span<const Expr> at) {
        const std::optional<std::size_t> validity = function->validity();
        std::vector<Expr> results = graph_->call(std::move(function), at);
        if (validity) {
            require(results[*validity]);
        }
        return results;
    }
    [[nodiscard]] Expr valid() const { return valid_; }

    /// A problem that shows only while the formula is written. Camera::make reports it; an error
    /// means that there is no camera.
    void report(Diagnostic problem) { problems_.push_back(std::move(problem)); }
    [[nodiscard]] const Diagnostics& problems() const { return problems_; }
    /// A condition that holds somewhere in the picture, or else a diagnostic.
    struct Need {
        Expr condition;
        Diagnostic otherwise;
    };
    [[nodiscard]] const std::vector<Need>& needs() const { return needs_; }

    /// The values of expressions at a point of the picture, in pixels, at time 0: for a stage that
    /// chooses its formula by trying it out. A camera is emitted for pictures of any size; here its
    /// picture has the aspect that the camera is made for.
    [[nodiscard]] std::vector<double> trial(std::span<const Expr> expressions, double x,
                                            double y) const;

    /// The size of the camera's own picture; none for a stage by itself.
    [[nodiscard]] const std::optional<PictureSize>& picture_size() const { return picture_size_; }
    void set_picture_size(const PictureSize& size) { picture_size_ = size; }

    /// Records what a stage computes.
    void record(StageValues values) { stages_.push_back(std::move(values)); }
    /// In the order in which the stages apply.
    [[nodiscard]] std::vector<StageValues>& stages() { return stages_; }

private:
    Graph* graph_;
    Expr valid_;
    Diagnostics problems_;
    std::vector<Need> needs_;
    Trial trial_;
    std::optional<PictureSize> picture_size_;
    std::vector<StageValues> stages_;
};

// ------------------------------------------------------------------------------------- ports

/// The interfaces of stages. Stages are immutable and shared.
class Stage {
public:
    Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    virtual ~Stage() = default;
};

/// A point in a camera's own image, and the size of that image.
struct PicturePoint {
    DevicePoint point;
    PictureSize size;
};

/// DCS → DCS: maps a point of the whole picture to the camera's own image. Outside its own
/// image, a camera is invisible.
class PictureArranger : public Stage {
public:
    [[nodiscard]] virtual PicturePoint arrange(const PicturePoint& picture,
                                               Emitter& emit) const = 0;
};

/// DCS → PCS, affine: scaling, reflection, translation.
class PictureMapper : public Stage {
public:
    [[nodiscard]] virtual ParameterPoint map(const PicturePoint& picture, Emitter& emit) const = 0;
    /// Whether u and v have the same units per pixel in a picture of any aspect.
    [[nodiscard]] virtual bool adapts_to_aspect() const { return false; }
};

/// PCS → PCS.
class ParameterTransformer : public Stage {
public:
    [[nodiscard]] virtual ParameterPoint transform(const ParameterPoint& p,
                                                   Emitter& emit) const = 0;
};

/// A rectangle of parameter space: u from the left to the right edge of a picture, v from its
/// bottom to its top.
struct ParameterRectangle {
    double u_first = 0.0, u_last = 1.0;
    double v_first = 0.0, v_last = 1.0;
};

/// PCS → OCS: a parametric point (dimension 0), curve in u (1) or surface (2).
class ObjectGenerator : public Stage {
public:
    [[nodiscard]] virtual int dimension() const = 0;
    [[nodiscard]] virtual ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const = 0;
    /// Normals other than the cross product of the tangents along u and v, such as the smooth
    /// ones of a mesh; of any length except 0. Most surfaces have no own normals.
    [[nodiscard]] virtual std::optional<ObjectVector> normal(const ParameterPoint&,
                                                             Emitter&) const {
        return std::nullopt;
    }
    /// The side of the surface on which the cross product of the tangents lies: positive on one
    /// side, negative on the other. The sign changes where a parametrisation continues beyond a
    /// pole, which reverses the cross product; most parametrisations do not.
    [[nodiscard]] virtual Expr orientation(const ParameterPoint&, Emitter& emit) const {
        return emit(1.0);
    }
    /// The part of parameter space that a picture shows if its camera has no map: of an object that
    /// is defined by a picture, with the same units for u and v.
    [[nodiscard]] virtual std::optional<ParameterRectangle> own_picture() const {
        return std::nullopt;
    }
    /// The whole surface for rays, or null if only its points are known, as of most surfaces.
    [[nodiscard]] virtual std::shared_ptr<const RayTarget> ray_target() const { return nullptr; }
};

/// A point of an object on its way through the object transformers.
struct ObjectElement {
    ObjectPoint point;  ///< A function of the parameters, with respect to which it has tangents.
    /// Of any length except 0; without a value it is the cross product of the tangents.
    std::optional<ObjectVector> own_normal;
    ParameterPoint parameters;  ///< Two variables.
};

/// The own normal, or the cross product of the tangents along u and v.
[[nodiscard]] ObjectVector normal_of(const ObjectElement& e);

/// OCS → OCS.
class ObjectTransformer : public Stage {
public:
    /// The minimum dimension of the object.
    [[nodiscard]] virtual int min_dimension() const { return 0; }
    [[nodiscard]] virtual ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const = 0;
    /// The same for a point and the normal there. Most transformers depend on the point alone and
    /// inherit this function, which transforms normals by the cofactors of the Jacobian.
    [[nodiscard]] virtual ObjectElement transform_element(const ObjectElement& e,
                                                          Emitter& emit) const;
};

/// A point of an object, computed by a path.
struct PathPoint {
    ObjectPoint point;
    ObjectVector along_u;  ///< Partial derivative with respect to the object's own parameter u.
    ObjectVector along_v;  ///< The same with respect to v.
    /// The second partial derivative with respect to u, if it was requested.
    std::optional<ObjectVector> along_u_by_u;
    ObjectVector normal;  ///< The generator's own normal, transformed; otherwise along_u x along_v.
    ObjectVector one_sided_normal;  ///< The normal, reversed where the orientation changes.
    ObjectPoint center;  ///< The image of the origin under the path's object transformers.
    Expr has_center;     ///< Whether they transform the origin.
    ParameterPoint parameters;
    PictureSize size;  ///< The size of the camera's image, which the path covers.
};

/// getDirVec: the direction of the ray, of any length except 0.
class DirectionRule : public Stage {
public:
    /// The minimum dimension of the eye object.
    [[nodiscard]] virtual int min_eye_dimension() const { return 0; }
    [[nodiscard]] virtual bool needs_direction_object() const { return false; }
    /// The minimum dimension of the direction object.
    [[nodiscard]] virtual int min_direction_dimension() const { return 0; }
    /// Whether it uses the eye object's second derivative.
    [[nodiscard]] virtual bool needs_second_derivative() const { return false; }
    /// `toward` is null if the camera has no direction object.
    [[nodiscard]] virtual ObjectVector direction(const PathPoint& eye, const PathPoint* toward,
                                                 Emitter& emit) const = 0;
};

/// A ray of a point of the picture, before a lens and stereo move it.
struct CentralRay {
    ObjectPoint origin;
    ObjectVector direction;     ///< Unit length.
    ParameterPoint parameters;  ///< (u, v) of the eye object.
    PicturePoint picture;       ///< Of the camera's own picture.
};

/// The central ray in the middle of the picture, which does not depend on the point of the picture.
[[nodiscard]] CentralRay middle_of(const CentralRay& ray);

/// The ray of one eye.
struct EyeRay {
    ObjectPoint origin;
    ObjectVector direction;  ///< Of any length except 0.
};

/// One view of a stereo pair: the same picture from an eye that stands beside the camera's own.
class StereoView : public Stage {
public:
    /// The ray of the eye, for the ray of the camera between the eyes. `up` is the upward direction
    /// of the camera's own axes after its moves, of unit length.
    [[nodiscard]] virtual EyeRay eye(const CentralRay& ray, const ObjectVector& up,
                                     Emitter& emit) const = 0;
};

/// Where the picture of a lens is sharp.
class FocusSurface : public Stage {
public:
    /// 1 divided by the distance from the origin of a central ray, along the ray, to the surface.
    /// A value that is not positive and finite focuses at infinity.
    [[nodiscard]] virtual Expr vergence(const CentralRay& ray, Emitter& emit) const = 0;
    /// The object of the scene that it needs the distance of, as the input distance_input().
    [[nodiscard]] virtual std::optional<std::string> object() const { return std::nullopt; }
};

/// The name of the input that has the distance of an object of the scene along the rays.
[[nodiscard]] std::string distance_input(std::string_view object);

/// A point of an aperture, in the plane across the central ray: x to the right in the picture, y
/// upwards.
struct AperturePoint {
    Expr x, y;
};

/// A thin lens. Its aperture lies across each ray, with the origin of the ray in its centre.
class Lens : public Stage {
public:
    /// In scene units; 0 is a pinhole.
    [[nodiscard]] virtual Scalar radius() const = 0;
    /// Maps the square from (-1, -1) to (1, 1) to the aperture, which is in a circle of radius 1:
    /// (0, 0) to its centre, and parts of equal area to parts of equal area.
    [[nodiscard]] virtual AperturePoint aperture(const AperturePoint& square,
                                                 Emitter& emit) const = 0;
    [[nodiscard]] virtual const FocusSurface& focus() const = 0;
};

/// The visible part of an image: a shape in the image's rectangle.
class ClipShape : public Stage {
public:
    /// The distance in pixels from the shape's edge, negative inside; correct to first order at the
    /// edge, and with the correct sign everywhere.
    [[nodiscard]] virtual Expr distance(const PicturePoint& picture, Emitter& emit) const = 0;
    /// The coverage, from 0 (invisible) to 1. The edge is `softness` pixels wide; 0 is sharp.
    [[nodiscard]] virtual Expr coverage(const PicturePoint& picture, Expr softness,
                                        Emitter& emit) const;
    /// The fraction of the way from the centre of the image to its corners that the shape covers,
    /// from 0 to 1: leader lines end there.
    [[nodiscard]] virtual double corner_reach() const { return 0.0; }
};

using PictureArrangerPointer = std::shared_ptr<const PictureArranger>;
using PictureMapperPointer = std::shared_ptr<const PictureMapper>;
using ParameterTransformerPointer = std::shared_ptr<const ParameterTransformer>;
using ObjectGeneratorPointer = std::shared_ptr<const ObjectGenerator>;
using ObjectTransformerPointer = std::shared_ptr<const ObjectTransformer>;
using DirectionRulePointer = std::shared_ptr<const DirectionRule>;
using ClipShapePointer = std::shared_ptr<const ClipShape>;
using FocusSurfacePointer = std::shared_ptr<const FocusSurface>;
using LensPointer = std::shared_ptr<const Lens>;
using StereoViewPointer = std::shared_ptr<const StereoView>;

// ----------------------------------------------------------------------------------- machine

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

/// A lens around a ray, as expressions of the lens inputs and what else a ray depends on.
struct LensExpressions {
    ObjectVector offset;  ///< From the ray's origin to the point of the aperture.
    Expr vergence;        ///< 1 divided by the distance along the ray of what is sharp.
    Expr valid;           ///< 1 where these are finite.
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
};

/// The change of a ray from pixel to pixel: its exact partial derivatives with respect to picture x
/// and y.
struct RayFootprint {
    ObjectVector origin_by_x, origin_by_y;
    ObjectVector direction_by_x, direction_by_y;  ///< Derivatives of the unit direction.
};

/// The derivatives are computed from the ray's expressions on request.
[[nodiscard]] RayFootprint footprint(const RayExpressions& ray);

/// The ray through the point of the aperture that the lens inputs name, as a ray without a lens:
/// with the central ray's origin o and unit direction d, the offset a and the vergence q, it starts
/// at o + a and has the direction d - q a. All of these meet in the point o + d/q, which is sharp.
[[nodiscard]] RayExpressions through_lens(const RayExpressions& ray);
/// Its footprint for an offset that stays the same from pixel to pixel: in the sharp point it is
/// that of the central ray.
[[nodiscard]] RayFootprint footprint_through_lens(const RayExpressions& ray);

/// A turn of all rays of a camera about a vertical axis, counterclockwise seen from above.
struct Turn {
    Scalar angle;                    ///< In radians.
    std::array<double, 3> center{};  ///< A point of the axis.
    Axes axes = Axes::z_up;          ///< Of the centre.
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
        std::optional<Turn> turn{};  ///< Of the rays that all of this makes.
        /// When each ray meets the scene: a number of seconds as a formula of the point of the
        /// camera's own picture, in fractions from its top left corner. It replaces t in all other
        /// formulas of the camera. Without it, every ray meets the scene at time t.
        std::optional<Formula> time{};
        double aspect = 16.0 / 9.0;  ///< Width divided by height.
        Axes axes = Axes::z_up;
        SourceSpan lens_span{};  ///< Where a file has the lens, for problems with the scene.
        /// How a file writes its stages, for texts about the camera.
        std::map<const Stage*, std::string> written{};
        /// Further inputs of its formulas, such as parameters that a program may move, with values
        /// for stages that choose their formula by trying it out.
        std::vector<KnownInput> inputs{};
    };

    /// Checks that the parts fit together: all are there, the rule and the object transformers get
    /// what they need, and the formulas have at most max_operations_of_camera operations. A
    /// direction object that the rule has no use for is left out with a warning.
    [[nodiscard]] static Result<Camera> make(Parts parts);
    /// The same camera as a view of a stereo pair. It is an error if it is one already.
    [[nodiscard]] Result<Camera> with_stereo(StereoViewPointer view) const;

    [[nodiscard]] const std::string& name() const { return emitted_->parts.name; }
    [[nodiscard]] const Parts& parts() const { return emitted_->parts; }
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

private:
    /// The parts and the ray that they make in a picture of any size.
    struct Emitted {
        explicit Emitted(Parts made_of);

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
