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
    explicit Emitter(Graph& graph) : graph_(&graph), valid_(graph.constant(1.0)) {}

    [[nodiscard]] Graph& graph() const { return *graph_; }
    [[nodiscard]] Expr operator()(double value) const { return graph_->constant(value); }
    [[nodiscard]] Expr operator()(const Scalar& value) const { return value.emit(*graph_); }
    /// No ray where the condition does not hold.
    void require(Expr condition) { valid_ = valid_ && condition; }
    [[nodiscard]] Expr valid() const { return valid_; }

private:
    Graph* graph_;
    Expr valid_;
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
struct ArrangedPoint {
    DevicePoint point;
    PictureSize size;
};

/// DCS → DCS: gives a camera its place in the picture; outside it there is no ray.
class PictureArranger : public Stage {
public:
    [[nodiscard]] virtual ArrangedPoint arrange(const ArrangedPoint& picture,
                                                Emitter& emit) const = 0;
};

/// DCS → PCS, affine: scaling, reflection, translation.
class PictureMapper : public Stage {
public:
    [[nodiscard]] virtual ParameterPoint map(const ArrangedPoint& picture, Emitter& emit) const = 0;
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
};

/// OCS → OCS.
class ObjectTransformer : public Stage {
public:
    [[nodiscard]] virtual ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const = 0;
};

/// A point of an object as a path made it.
struct PathPoint {
    ObjectPoint point;
    ObjectVector along_u;  ///< Partial derivative by the object's own parameter u.
    ObjectVector along_v;  ///< The same by v.
    ObjectPoint center;    ///< Where the path's object transformers take the origin.
    ParameterPoint parameters;
};

/// getDirVec: the direction of the ray, of any length but 0.
class DirectionRule : public Stage {
public:
    [[nodiscard]] virtual bool needs_eye_surface() const { return false; }
    [[nodiscard]] virtual bool needs_direction_object() const { return false; }
    /// `toward` is null if the camera has no direction object.
    [[nodiscard]] virtual ObjectVector direction(const PathPoint& eye, const PathPoint* toward,
                                                 Emitter& emit) const = 0;
};

using PictureArrangerPointer = std::shared_ptr<const PictureArranger>;
using PictureMapperPointer = std::shared_ptr<const PictureMapper>;
using ParameterTransformerPointer = std::shared_ptr<const ParameterTransformer>;
using ObjectGeneratorPointer = std::shared_ptr<const ObjectGenerator>;
using ObjectTransformerPointer = std::shared_ptr<const ObjectTransformer>;
using DirectionRulePointer = std::shared_ptr<const DirectionRule>;

// ----------------------------------------------------------------------------------- machine

/// getEyePnt or getDirPnt: from a point of the picture to a point of an object.
struct Path {
    PictureMapperPointer mapper;
    std::vector<ParameterTransformerPointer> parameter_transformers;
    ObjectGeneratorPointer generator;
    std::vector<ObjectTransformerPointer> object_transformers;

    [[nodiscard]] PathPoint emit(const ArrangedPoint& picture, Emitter& emit) const;
};

/// The ray of a picture point, as expressions of picture x, picture y and time.
struct RayExpressions {
    ObjectPoint origin;
    ObjectVector direction;     ///< Unit length where valid.
    Expr valid;                 ///< 1 where there is a ray, finite in all six values; else 0.
    ParameterPoint parameters;  ///< (u, v) of the eye object; a point or curve may ignore them.
};

/// An extended camera.
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

    /// Checks that the parts fit together: all are there, and the rule gets what it needs. A
    /// direction object that the rule has no use for is left out with a warning.
    [[nodiscard]] static Result<Camera> make(Parts parts);

    [[nodiscard]] const std::string& name() const { return parts_->name; }
    [[nodiscard]] const Parts& parts() const { return *parts_; }

    /// getRay, for a picture of the given size in pixels.
    [[nodiscard]] RayExpressions emit(Graph& graph, double width, double height) const;

private:
    explicit Camera(Parts parts) : parts_(std::make_shared<const Parts>(std::move(parts))) {}
    std::shared_ptr<const Parts> parts_;
};

// --------------------------------------------------------------------------------- catalogue

enum class StageKind : std::uint8_t {
    picture_arranger,
    picture_mapper,
    parameter_transformer,
    object_generator,
    object_transformer,
    direction_rule,
};

[[nodiscard]] std::string_view name_of(StageKind kind);

enum class ParameterType : std::uint8_t {
    number,  ///< One Scalar.
    pair,    ///< Two, written (a, b).
    size,    ///< Two, written (a, b) or as one number for both.
    triple,  ///< Three, written (a, b, c).
    axis,    ///< Three, written (a, b, c) or x, y, z.
    choice,  ///< One of some words.
    curve,   ///< An object generator of dimension 1.
};

/// What a number counts. Angles are written with deg or rad and are radians inside.
enum class Unit : std::uint8_t {
    number,     ///< A length in scene units, a ratio, ...: an angle here is an error.
    angle,      ///< A plain number other than 0 here is an error.
    parameter,  ///< Of parameter space, whose unit the object decides: both will do.
};

struct StageParameter {
    std::string_view name;
    ParameterType type = ParameterType::number;
    Unit unit = Unit::number;
    std::vector<double> default_value{};  ///< Empty: must be given (curve, or no default).
    double least = -std::numeric_limits<double>::infinity();
    double most = std::numeric_limits<double>::infinity();
    bool above_least = false;                 ///< The least value itself is excluded.
    std::vector<std::string_view> choices{};  ///< The first is the default.
    std::string_view meaning;
};

/// What a stage is made from, by parameter name. The language has checked it against the row.
class Arguments {
public:
    using Value = std::variant<std::vector<Scalar>, std::string, ObjectGeneratorPointer>;

    /// In the place of an earlier value; the name must outlive this, as a row's does.
    void set(std::string_view name, Value value);
    void set_formula(Formula formula) { formula_ = std::move(formula); }

    [[nodiscard]] Scalar number(std::string_view name) const;
    [[nodiscard]] std::array<Scalar, 2> pair(std::string_view name) const;
    [[nodiscard]] std::array<Scalar, 3> triple(std::string_view name) const;
    [[nodiscard]] const std::string& choice(std::string_view name) const;
    [[nodiscard]] const ObjectGeneratorPointer& curve(std::string_view name) const;
    [[nodiscard]] const Formula& formula() const { return *formula_; }

private:
    [[nodiscard]] const Value& value(std::string_view name) const;

    std::vector<std::pair<std::string_view, Value>> values_;
    std::optional<Formula> formula_;
};

/// A stage that a formula makes: name(p1, p2) = [r1, r2, r3].
struct FormulaShape {
    std::size_t parameters = 0;
    std::size_t results_least = 0;
    std::size_t results_most = 0;
};

/// One row of the catalogue: all that the language, the command and the documentation know.
struct StageEntry {
    StageKind kind;
    std::string_view name;
    std::string_view meaning;
    std::vector<StageParameter> parameters;
    Result<std::shared_ptr<const Stage>> (*make)(const Arguments& arguments);
    std::optional<FormulaShape> formula{};
    int dimension = 0;  ///< Of an object generator.
};

/// Every stage there is, by kind.
[[nodiscard]] const std::vector<StageEntry>& catalogue();
[[nodiscard]] const StageEntry* find_stage(StageKind kind, std::string_view name);

}  // namespace balcony::camera
