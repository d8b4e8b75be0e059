// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The interfaces of stages: small immutable values that write their formulas into an expression
// graph. camera.hpp joins them.
//
//     picture arranger ─▶ picture mapper ─▶ parameter transformers ─▶ object generator
//                                             ─▶ object transformers ─▶ direction rule ─▶ ray

#include <array>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "balcony/emitter.hpp"
#include "balcony/formula.hpp"
#include "balcony/spaces.hpp"

namespace balcony::camera {

class RayTarget;

/// Any stage. Stages are immutable and shared.
class Stage {
public:
    Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    virtual ~Stage() = default;
};

// ---------------------------------------------------------------------- picture and parameters

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

// ------------------------------------------------------------------------------------- objects

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

// ---------------------------------------------------------------------------------- directions

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

// --------------------------------------------------------------------------- stereo and lenses

/// A ray of a point of the picture, before a lens and stereo move it.
struct CentralRay {
    ObjectPoint origin;
    ObjectVector direction;     ///< Unit length.
    ParameterPoint parameters;  ///< (u, v) of the eye object.
    PicturePoint picture;       ///< Of the camera's own picture.

    /// All of it as a list in this order, the point of the picture before its size.
    using Values = std::array<Expr, 12>;
    [[nodiscard]] Values values() const;
    [[nodiscard]] static CentralRay of(std::span<const Expr> values);
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

/// A ray of a lens.
struct LensRay {
    ObjectPoint origin;
    ObjectVector direction;  ///< Of any length except 0.
    Expr inverse_length;     ///< 1 divided by its length.
    Expr valid;              ///< 1 where there is a ray with finite values, otherwise 0.
    /// 1 where the lens lets no light through, so that the picture is dark there. No ray is valid
    /// there, but not every ray that is not valid is blocked.
    std::optional<Expr> blocked{};
};

/// What a lens makes of a central ray.
struct LensRays {
    LensRay ray;  ///< Through a point of the aperture.
    /// Variables in its formulas, and what they are: parts that its footprint takes to be the same
    /// from pixel to pixel.
    std::vector<expr::Substitution> fixed{};
    /// Through the middle of the aperture, if that is not the central ray.
    std::optional<LensRay> middle{};
};

/// A lens in the place of a pinhole.
class Lens : public Stage {
public:
    /// The rays of a point of the picture. `square` is a point of the square from (-1, -1) to
    /// (1, 1), in which all points are equally likely.
    [[nodiscard]] virtual LensRays rays(const CentralRay& central, const AperturePoint& square,
                                        Emitter& emit) const = 0;
    [[nodiscard]] virtual const FocusSurface& focus() const = 0;
    /// Whether it is a pinhole: all rays are central ones.
    [[nodiscard]] virtual bool is_pinhole() const { return false; }
};

/// A lens whose aperture lies across each ray, with the origin of the ray in its centre. All rays
/// of a point of the picture meet where the lens is focused.
class ThinLens : public Lens {
public:
    /// In scene units; 0 is a pinhole.
    [[nodiscard]] virtual Scalar radius() const = 0;
    /// Maps the square from (-1, -1) to (1, 1) to the aperture, which is in a circle of radius 1:
    /// (0, 0) to its centre, and parts of equal area to parts of equal area.
    [[nodiscard]] virtual AperturePoint aperture(const AperturePoint& square,
                                                 Emitter& emit) const = 0;
    /// With the central ray's origin o and unit direction d, the offset a of a point of the
    /// aperture and the vergence q of the focus: the ray from o + a with the direction d - q a,
    /// which meets all others in o + d/q. In its footprint, a stays the same from pixel to pixel.
    [[nodiscard]] LensRays rays(const CentralRay& central, const AperturePoint& square,
                                Emitter& emit) const final;
    [[nodiscard]] bool is_pinhole() const final { return radius().constant() == 0.0; }
};

// --------------------------------------------------------------------------------------- bends

/// The path of a ray that is bent: straight from knot to knot, and straight on from the last one.
struct BentPath {
    std::vector<ObjectPoint>
        knots;               ///< At least two. Two that are equal have nothing between them.
    ObjectVector direction;  ///< Behind the last knot; of any length except 0.
};

/// How the rays of a camera go through space.
class Bend : public Stage {
public:
    /// The path of a ray that would be straight without it.
    [[nodiscard]] virtual BentPath path(const CentralRay& ray, Emitter& emit) const = 0;
};

// -------------------------------------------------------------------------------------- layers

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

// ------------------------------------------------------------------------------------ pointers

using PictureArrangerPointer = std::shared_ptr<const PictureArranger>;
using PictureMapperPointer = std::shared_ptr<const PictureMapper>;
using ParameterTransformerPointer = std::shared_ptr<const ParameterTransformer>;
using ObjectGeneratorPointer = std::shared_ptr<const ObjectGenerator>;
using ObjectTransformerPointer = std::shared_ptr<const ObjectTransformer>;
using DirectionRulePointer = std::shared_ptr<const DirectionRule>;
using ClipShapePointer = std::shared_ptr<const ClipShape>;
using FocusSurfacePointer = std::shared_ptr<const FocusSurface>;
using LensPointer = std::shared_ptr<const Lens>;
using BendPointer = std::shared_ptr<const Bend>;
using StereoViewPointer = std::shared_ptr<const StereoView>;

}  // namespace balcony::camera
