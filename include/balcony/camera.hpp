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
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "balcony/base.hpp"
#include "balcony/expr.hpp"

namespace balcony::camera {

using expr::Expr;
using expr::Graph;

// ------------------------------------------------------------------------------------ spaces

/// DCS, device co-ordinates: pixels, x to the right, y down, pixel centres at .5.
struct DevicePoint {
    Expr x, y;
};

/// PCS, parameter co-ordinates of a projection object.
struct ParameterPoint {
    Expr u, v;
};

/// OCS, object co-ordinates: the world of the scene, in the camera's axes.
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

/// The whole picture in pixels; expressions, since an arranger may give a camera a part of it.
struct PictureSize {
    Expr width, height;
};

// ---------------------------------------------------------------------------- stage parameters

/// A formula of its own: results as functions of parameters and time. Immutable, cheap to copy.
class Formula {
public:
    /// `parameters` are variables of `graph`, the only ones that `results` may use.
    Formula(std::shared_ptr<Graph> graph, std::vector<Expr> parameters, std::vector<Expr> results);

    [[nodiscard]] std::size_t parameter_count() const { return parameters_.size(); }
    [[nodiscard]] std::size_t result_count() const { return results_.size(); }
    /// The results in another graph, with arguments in the place of the parameters.
    [[nodiscard]] std::vector<Expr> emit(Graph& graph, std::span<const Expr> arguments) const;
    /// The value of the result numbered i if it depends on nothing.
    [[nodiscard]] std::optional<double> constant(std::size_t i) const;

private:
    std::shared_ptr<Graph> graph_;
    std::vector<Expr> parameters_;
    std::vector<Expr> results_;
};

/// What a stage is told as a number: a constant or a formula in time.
class Scalar {
public:
    Scalar(double value = 0.0) : value_(value) {}
    /// A formula without parameters and with one result.
    Scalar(Formula formula);

    [[nodiscard]] std::optional<double> constant() const;
    [[nodiscard]] Expr emit(Graph& graph) const;

private:
    std::variant<double, Formula> value_;
};

/// Where stages write: a graph and the conditions under which there is a ray.
class Emitter {
public:
    /// `variables` are the values that trial() takes for variables 0, 1, ... of the graph.
    explicit Emitter(Graph& graph, std::vector<double> variables = {})
        : graph_(&graph), valid_(graph.constant(1.0)), variables_(std::move(variables)) {}

    [[nodiscard]] Graph& graph() const { return *graph_; }
    [[nodiscard]] Expr operator()(double value) const { return graph_->constant(value); }
    [[nodiscard]] Expr operator()(const Scalar& value) const { return value.emit(*graph_); }
    /// No ray where the condition does not hold.
    void require(Expr condition) { valid_ = valid_ && condition; }
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

    /// The values of expressions at a point of the picture, in pixels, at time 0: for a stage that
    /// chooses its formula by trying it out. A camera is emitted for pictures of any size; here its
    /// picture has the aspect that the camera is made for.
    [[nodiscard]] std::vector<double> trial(std::span<const Expr> expressions, double x,
                                            double y) const {
        return expr::evaluate(expressions, {x, y, 0.0, variables_});
    }

private:
    Graph* graph_;
    Expr valid_;
    std::vector<double> variables_;
};

// ------------------------------------------------------------------------------------- ports

/// What fits into a port. Stages are immutable and shared.
class Stage {
public:
    Stage() = default;
    Stage(const Stage&) = delete;
    Stage& operator=(const Stage&) = delete;
    virtual ~Stage() = default;
};

/// A point of the picture as a camera's own picture sees it, and how large that picture is.
struct PicturePoint {
    DevicePoint point;
    PictureSize size;
};

/// DCS → DCS: where a point of the whole picture lies in the camera's own one. Outside its own
/// picture a camera does not show.
class PictureArranger : public Stage {
public:
    [[nodiscard]] virtual PicturePoint arrange(const PicturePoint& picture,
                                               Emitter& emit) const = 0;
};

/// DCS → PCS, affine: scaling, reflection, translation.
class PictureMapper : public Stage {
public:
    [[nodiscard]] virtual ParameterPoint map(const PicturePoint& picture, Emitter& emit) const = 0;
};

/// PCS → PCS.
class ParameterTransformer : public Stage {
public:
    [[nodiscard]] virtual ParameterPoint transform(const ParameterPoint& p,
                                                   Emitter& emit) const = 0;
};

/// PCS → OCS: a parametric point (dimension 0), curve in u (1) or surface (2).
class ObjectGenerator : public Stage {
public:
    [[nodiscard]] virtual int dimension() const = 0;
    [[nodiscard]] virtual ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const = 0;
    /// Normals that are not the cross product of the tangents along u and v, such as the smooth
    /// ones of a mesh; of any length but 0. Most surfaces have none of their own.
    [[nodiscard]] virtual std::optional<ObjectVector> normal(const ParameterPoint&,
                                                             Emitter&) const {
        return std::nullopt;
    }
    /// On which side of the whole surface the cross product of the tangents lies: positive on one
    /// side, negative on the other. It changes sign where a parametrisation goes on beyond a pole
    /// and the surface turns over; most never do.
    [[nodiscard]] virtual Expr orientation(const ParameterPoint&, Emitter& emit) const {
        return emit(1.0);
    }
};

/// OCS → OCS.
class ObjectTransformer : public Stage {
public:
    [[nodiscard]] virtual ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const = 0;
};

/// A point of an object as a path made it.
struct PathPoint {
    ObjectPoint point;
    ObjectVector along_u;           ///< Partial derivative by the object's own parameter u.
    ObjectVector along_v;           ///< The same by v.
    ObjectVector normal;            ///< The generator's own, moved with it; else along_u x along_v.
    ObjectVector one_sided_normal;  ///< The normal, turned round where the surface turns over.
    ObjectPoint center;             ///< Where the path's object transformers take the origin.
    ParameterPoint parameters;
    PictureSize size;  ///< Of the camera's picture, which the path covers.
};

/// getDirVec: the direction of the ray, of any length but 0.
class DirectionRule : public Stage {
public:
    /// The least dimension of eye object that it can work with.
    [[nodiscard]] virtual int min_eye_dimension() const { return 0; }
    [[nodiscard]] virtual bool needs_direction_object() const { return false; }
    /// `toward` is null if the camera has no direction object.
    [[nodiscard]] virtual ObjectVector direction(const PathPoint& eye, const PathPoint* toward,
                                                 Emitter& emit) const = 0;
};

/// Which part of a picture shows: a shape in the picture's rectangle.
class ClipShape : public Stage {
public:
    /// The distance in pixels from the shape's edge, negative inside; right to first order at the
    /// edge, and of the right sign everywhere.
    [[nodiscard]] virtual Expr distance(const PicturePoint& picture, Emitter& emit) const = 0;
    /// From 0, nothing shows, to 1. The edge is `softness` pixels wide, sharp if that is 0.
    [[nodiscard]] virtual Expr coverage(const PicturePoint& picture, Expr softness,
                                        Emitter& emit) const;
    /// How far from the middle of the picture to its corners the shape surely reaches, from 0 to 1:
    /// leader lines end there.
    [[nodiscard]] virtual double corner_reach() const { return 0.0; }
};

using PictureArrangerPointer = std::shared_ptr<const PictureArranger>;
using PictureMapperPointer = std::shared_ptr<const PictureMapper>;
using ParameterTransformerPointer = std::shared_ptr<const ParameterTransformer>;
using ObjectGeneratorPointer = std::shared_ptr<const ObjectGenerator>;
using ObjectTransformerPointer = std::shared_ptr<const ObjectTransformer>;
using DirectionRulePointer = std::shared_ptr<const DirectionRule>;
using ClipShapePointer = std::shared_ptr<const ClipShape>;

// ----------------------------------------------------------------------------------- machine

/// getEyePnt or getDirPnt: from a point of the picture to a point of an object.
struct Path {
    PictureMapperPointer mapper;
    std::vector<ParameterTransformerPointer> parameter_transformers;
    ObjectGeneratorPointer generator;
    std::vector<ObjectTransformerPointer> object_transformers;

    [[nodiscard]] PathPoint emit(const PicturePoint& picture, Emitter& emit) const;
};

/// The ray of a picture point, as expressions of picture x, picture y and time.
struct RayExpressions {
    ObjectPoint origin;
    ObjectVector direction;     ///< Unit length where valid.
    Expr valid;                 ///< 1 where there is a ray, finite in all six values; else 0.
    ParameterPoint parameters;  ///< (u, v) of the eye object; a point or curve may ignore them.
};

/// How a ray changes from pixel to pixel: its partial derivatives by picture x and y, exact.
struct RayFootprint {
    ObjectVector origin_by_x, origin_by_y;
    ObjectVector direction_by_x, direction_by_y;  ///< Of the unit direction.
};

/// Costs nothing until it is asked for: the derivatives are made from the ray's own expressions.
[[nodiscard]] RayFootprint footprint(const RayExpressions& ray);

/// An extended camera. Its stages write their formulas once, when it is made.
class Camera {
public:
    struct Parts {
        std::string name;
        std::vector<PictureArrangerPointer> arrangers;  ///< Outermost first; may be empty.
        Path eye;
        std::optional<Path> toward;
        DirectionRulePointer look;
        double aspect = 16.0 / 9.0;  ///< Width by height of the picture it is made for.
        Axes axes = Axes::z_up;
    };

    /// Checks that the parts fit together: all are there, the rule gets what it needs, and the
    /// formulas have at most max_operations_of_camera operations. A direction object that the rule
    /// has no use for is left out with a warning.
    [[nodiscard]] static Result<Camera> make(Parts parts);

    [[nodiscard]] const std::string& name() const { return emitted_->parts.name; }
    [[nodiscard]] const Parts& parts() const { return emitted_->parts; }
    /// The number of nodes in the graph of its ray.
    [[nodiscard]] std::size_t operations() const { return emitted_->graph.size(); }

    /// getRay, for a picture of the given size in pixels.
    [[nodiscard]] RayExpressions emit(Graph& graph, double width, double height) const;
    /// The same for a point that arrangers have given a place in a larger picture.
    [[nodiscard]] RayExpressions emit(const PicturePoint& picture) const;

private:
    /// The parts and the ray that they make in a picture of any size.
    struct Emitted {
        explicit Emitted(Parts made_of);

        Parts parts;
        Graph graph;
        PicturePoint picture;  ///< Picture x and y; the size is two variables.
        RayExpressions ray;    ///< Of this point of the camera's own picture.
    };
    explicit Camera(std::shared_ptr<const Emitted> emitted) : emitted_(std::move(emitted)) {}
    std::shared_ptr<const Emitted> emitted_;
};

/// The most operations that a camera and a picture may have. Their derivatives have several times
/// as many, and a graph holds 4 million.
inline constexpr std::size_t max_operations_of_camera = 250'000;
inline constexpr std::size_t max_operations_of_picture = 500'000;

}  // namespace balcony::camera
