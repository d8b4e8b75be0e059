// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Catalogue: a row for every kind of stage there is, with its parameters and its maker. What a user
// may write, `balcony list` and docs/stages are derived from the rows. make_stage.hpp makes stages
// from them.

#include <array>
#include <cstdint>
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "balcony/stages.hpp"

namespace balcony::camera {

enum class StageKind : std::uint8_t {
    picture_arranger,
    picture_mapper,
    parameter_transformer,
    object_generator,
    object_transformer,
    direction_rule,
    stereo_view,
    lens,
    focus,
    bend,
    clip_shape,
};

[[nodiscard]] std::string_view name_of(StageKind kind);
/// Direction rules, lenses.
[[nodiscard]] std::string plural_of(StageKind kind);

/// A function that a stage offers to its formulas: a result of a native, called by name with plain
/// numbers.
struct FormulaFunction {
    std::string_view name;
    std::shared_ptr<const expr::Native> native;
    std::size_t result = 0;
};

/// The form of a formula: name(p1, p2) = [r1, r2, r3].
struct FormulaShape {
    std::size_t parameters = 0;
    std::size_t min_results = 0;
    std::size_t max_results = 0;
    std::vector<FormulaFunction> functions{};  ///< Beside those that all formulas can call.
    /// As texts write the parameters, with commas between them; (u, v) or (x, y, z) without it.
    std::string_view names{};
    bool may_have_fewer = false;  ///< A formula may leave out the last parameters.

    [[nodiscard]] bool takes(std::size_t count) const {
        return count == parameters || (may_have_fewer && count > 0 && count < parameters);
    }
};

/// Point arguments of a stage, such as control points or seeds; consecutive in `values`.
struct PointList {
    std::size_t coordinates = 0;  ///< Coordinates per point; 1 for a list of numbers.
    std::vector<double> values{};

    [[nodiscard]] std::size_t size() const {
        return coordinates == 0 ? 0 : values.size() / coordinates;
    }
    [[nodiscard]] std::span<const double> operator[](std::size_t i) const {
        return std::span(values).subspan(i * coordinates, coordinates);
    }
};

/// A grey image, row by row from the top left, from 0 (black) to 1.
struct GreyImage {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<float> values{};
};

/// A triangle mesh with texture coordinates, stored per corner, without shared vertices. In the
/// camera's axes: z up if its file is y_up.
struct TexturedMesh {
    struct Corner {
        std::array<double, 3> position{};
        std::array<double, 3> normal{};  ///< Unit length.
        std::array<double, 2> uv{};
    };
    std::vector<std::array<Corner, 3>> triangles{};
};

/// A map over a picture, such as that of the rays of its pixels: some numbers for each pixel, row
/// by row from the top left.
struct PixelMap {
    std::size_t width = 0;
    std::size_t height = 0;
    std::vector<std::vector<double>> channels{};  ///< Finite where valid.
    std::vector<std::uint8_t> valid{};            ///< 1 where the pixel has numbers.
};

/// The position and orientation of a calibrated camera: x_camera = rotation x_world + translation,
/// with camera axes x right, y down, z forward.
struct CameraPose {
    std::array<std::array<double, 3>, 3> rotation{};  ///< Row by row; orthonormal.
    std::array<double, 3> translation{};
};

/// A calibrated camera of a file: the name of an object generator, and numbers for its parameters.
struct Calibration {
    struct Number {
        std::string name;
        double value = 0.0;  ///< In radians if it is an angle.
    };
    std::optional<std::size_t> id{};  ///< Its number in a file of several cameras.
    std::string model{};  ///< Without a name, any model that has the numbers' parameters.
    std::vector<Number> numbers{};
    std::vector<double> distortion{};  ///< OpenCV's coefficients, in the order of the model.
    /// The control points of splines, (x, y) by (x, y).
    std::vector<std::array<double, 2>> points{};
    std::string origin{};  ///< The choice of the parameter of that name.
    std::optional<CameraPose> pose{};
};

/// A file of calibrated cameras, at least one.
struct CalibrationFile {
    std::string name;  ///< For messages.
    std::vector<Calibration> cameras{};
};

struct Prescription;  // prescription.hpp

// ---------------------------------------------------------------------- parameters of stages
// What a parameter takes is one of the types that follow. Without a default value it must be given,
// unless it is optional.

/// The values that a number may have.
struct Range {
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool excludes_minimum = false;  ///< The minimum itself is excluded.
};

/// One number.
struct NumberParameter {
    Unit unit = Unit::number;
    std::optional<double> default_value{};
    Range range{};
    bool constant = false;  ///< It cannot change with time, since tables are made from it.
};

/// A whole number; it cannot change with time.
struct CountParameter {
    std::optional<double> default_value{};
    Range range{};
};

/// Two numbers: (a, b).
struct PairParameter {
    Unit unit = Unit::number;
    std::optional<std::array<double, 2>> default_value{};
    Range range{};
    bool constant = false;
    bool one_for_both = false;  ///< One number is for both.
};

/// Three numbers: (a, b, c).
struct TripleParameter {
    std::optional<std::array<double, 3>> default_value{};
    Range range{};
    bool constant = false;
    bool names_axes = false;  ///< x, y, z, -x, -y and -z are unit vectors.
};

/// A word; the first of the choices is the default.
struct ChoiceParameter {
    std::vector<std::string_view> choices{};
};

/// A PointList: [(a, b), (c, d)], [1, 2, 3] or "table.csv"; it cannot change with time.
struct PointsParameter {
    Unit unit = Unit::number;
    std::vector<std::size_t> coordinates{};  ///< How many a point may have, the usual count first.
    std::size_t min_points = 1;
};

/// A stage, or one or more, which take all arguments that are left.
struct NestedStageParameter {
    StageKind kind = StageKind::object_generator;
    std::optional<int> dimension{};  ///< Of an object generator; 1 asks for a curve.
    bool several = false;
    /// The stage, with one number, that a plain number is short for; without it, a number is an
    /// error.
    std::string_view of_number{};
};

/// A formula of the parameter's name, whose results are plain numbers: weight(u, v) = [u*v].
struct FormulaParameter {
    FormulaShape shape{};
};

/// A name in the words of another file, such as that of an object of a scene: "Vase".
struct NameParameter {};

/// A GreyImage: "mask.png".
struct ImageParameter {};

/// A TexturedMesh: "vase.obj".
struct MeshParameter {};

/// A PixelMap of rays, origin and direction in six channels, or of positions in another picture:
/// s from its left to its right side and t from its bottom to its top. "rays.exr".
struct MapParameter {
    enum class Content : std::uint8_t { rays, positions };
    Content content = Content::rays;

    [[nodiscard]] std::size_t channels() const { return content == Content::rays ? 6 : 2; }
};

/// A CalibrationFile: "calibration.yml".
struct CalibrationParameter {};

/// A Prescription without errors: "dgauss.dat".
struct PrescriptionParameter {};

using ParameterType = std::variant<NumberParameter, CountParameter, PairParameter, TripleParameter,
                                   ChoiceParameter, PointsParameter, NestedStageParameter,
                                   FormulaParameter, NameParameter, ImageParameter, MeshParameter,
                                   MapParameter, CalibrationParameter, PrescriptionParameter>;

struct StageParameter {
    std::string_view name;
    ParameterType type;
    bool optional = false;  ///< It may be left out without a default value; the maker asks has().
    std::string_view meaning{};

    /// The type's own row, or null if the parameter is of another type.
    template <class Type>
    [[nodiscard]] const Type* as() const {
        return std::get_if<Type>(&type);
    }
};

/// What a stage is made from, by parameter name, checked against the row by bind().
class Arguments {
public:
    using StagePointer = std::shared_ptr<const Stage>;
    using Value =
        std::variant<std::vector<Scalar>, std::string, PointList, StagePointer,
                     std::vector<StagePointer>, Formula, std::shared_ptr<const GreyImage>,
                     std::shared_ptr<const TexturedMesh>, std::shared_ptr<const PixelMap>,
                     std::shared_ptr<const CalibrationFile>, std::shared_ptr<const Prescription>>;

    /// Replaces an earlier value; the name must outlive this object, as a row's does.
    void set(std::string_view name, Value value);
    void set_formula(Formula formula) { formula_ = std::move(formula); }

    /// Whether an optional parameter was given.
    [[nodiscard]] bool has(std::string_view name) const;

    [[nodiscard]] Scalar number(std::string_view name) const;
    /// A parameter that is constant according to the row.
    [[nodiscard]] double constant(std::string_view name) const;
    [[nodiscard]] std::size_t count(std::string_view name) const;
    [[nodiscard]] std::array<Scalar, 2> pair(std::string_view name) const;
    [[nodiscard]] std::array<Scalar, 3> triple(std::string_view name) const;
    /// One of the words that the row lists, or a name, such as that of an object.
    [[nodiscard]] const std::string& choice(std::string_view name) const;
    [[nodiscard]] const PointList& points(std::string_view name) const;
    [[nodiscard]] ObjectGeneratorPointer curve(std::string_view name) const;
    template <class Port>
    [[nodiscard]] std::shared_ptr<const Port> stage(std::string_view name) const {
        return std::static_pointer_cast<const Port>(std::get<StagePointer>(value(name)));
    }
    template <class Port>
    [[nodiscard]] std::vector<std::shared_ptr<const Port>> stages(std::string_view name) const {
        std::vector<std::shared_ptr<const Port>> cast;
        for (const StagePointer& stage : std::get<std::vector<StagePointer>>(value(name))) {
            cast.push_back(std::static_pointer_cast<const Port>(stage));
        }
        return cast;
    }
    [[nodiscard]] const Formula& formula(std::string_view name) const;
    /// A GreyImage, a TexturedMesh, a PixelMap, a CalibrationFile or a Prescription.
    template <class Data>
    [[nodiscard]] const std::shared_ptr<const Data>& file(std::string_view name) const {
        return std::get<std::shared_ptr<const Data>>(value(name));
    }
    /// The formula of a stage that is itself a formula.
    [[nodiscard]] const Formula& formula() const { return *formula_; }

private:
    [[nodiscard]] const Value* find(std::string_view name) const;
    [[nodiscard]] const Value& value(std::string_view name) const;

    std::vector<std::pair<std::string_view, Value>> values_;
    std::optional<Formula> formula_;
};

/// The stage that a maker makes of arguments.
using StageResult = Result<std::shared_ptr<const Stage>>;

/// One row of the catalogue: all that the language, the command and the documentation know. Texts
/// are not copied: they must outlive the row, as literals do.
struct StageEntry {
    StageKind kind = StageKind::object_generator;
    std::string_view name{};
    std::string_view meaning{};
    /// What the stage does as mathematics, in lines of plain text without a margin.
    std::string_view formula{};
    std::vector<StageParameter> parameters{};
    std::function<StageResult(const Arguments& arguments)> make{};
    /// Of a stage that is itself a formula, such as surface(u, v) = [x, y, z]; it has no
    /// parameters.
    std::optional<FormulaShape> shape{};
    int dimension = 0;  ///< Of an object generator.
    /// The heading in docs/stages; empty is that of the stage's kind.
    std::string_view section{};
    /// A .cam text with one camera or picture that shows what the stage does; docs/stages has its
    /// picture, and a test runs it.
    std::string_view example{};
};

/// How a stage is written: circle(radius), surface(u, v) = [a, b, c].
[[nodiscard]] std::string signature(const StageEntry& row);
/// How a formula is written: weight(u, v) = [a].
[[nodiscard]] std::string signature(std::string_view name, const FormulaShape& shape);

/// What contradicts itself in a row: no maker, a default value outside its range, two parameters of
/// one name, ...
[[nodiscard]] Diagnostics check(const StageEntry& row);

/// The stages that there are: the built-in ones, and those that a program adds. Cheap to copy; a
/// copy that rows are added to leaves the others as they are.
class Catalogue {
public:
    using value_type = StageEntry;
    using const_iterator = std::vector<StageEntry>::const_iterator;

    /// The built-in stages.
    Catalogue();

    /// Adds a row, which the language then knows. Errors, with nothing added, if there is a stage
    /// of this kind and name, or if the row contradicts itself.
    [[nodiscard]] Diagnostics add(StageEntry row);

    /// The rows by kind; of one kind in the order in which they were added.
    [[nodiscard]] const_iterator begin() const { return rows_->begin(); }
    [[nodiscard]] const_iterator end() const { return rows_->end(); }
    [[nodiscard]] std::size_t size() const { return rows_->size(); }
    /// Null if there is none; valid until a row is added.
    [[nodiscard]] const StageEntry* find(StageKind kind, std::string_view name) const;

private:
    std::shared_ptr<const std::vector<StageEntry>> rows_;
};

/// The built-in stages.
[[nodiscard]] const Catalogue& catalogue();

}  // namespace balcony::camera
