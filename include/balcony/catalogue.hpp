// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Catalogue: one table with the makers of all stages. The language's checks, `balcony list`
// and docs/stages use it.

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

#include "balcony/camera.hpp"

namespace balcony::camera {

enum class StageKind : std::uint8_t {
    picture_arranger,
    picture_mapper,
    parameter_transformer,
    object_generator,
    object_transformer,
    direction_rule,
    clip_shape,
};

[[nodiscard]] std::string_view name_of(StageKind kind);

enum class ParameterType : std::uint8_t {
    number,   ///< One Scalar.
    count,    ///< A whole number, constant.
    pair,     ///< Two, written (a, b).
    size,     ///< Two, written (a, b) or as one number for both.
    triple,   ///< Three, written (a, b, c).
    axis,     ///< Three, written (a, b, c) or x, y, z.
    choice,   ///< One of several names.
    points,   ///< A PointList, constant: [(a, b), (c, d)], [1, 2, 3] or "table.csv".
    curve,    ///< An object generator of dimension 1.
    stage,    ///< A stage of stage_kind.
    stages,   ///< One or more stages; takes all remaining arguments.
    formula,  ///< A formula with the parameter's name and shape: weight(u, v) = [u*v].
    image,    ///< A GreyImage: "mask.png".
    mesh,     ///< A TexturedMesh: "vase.obj".
};

/// The unit of a number. Angles are written with deg or rad and stored in radians.
enum class Unit : std::uint8_t {
    number,     ///< A length in scene units, a ratio, ...; an angle is an error.
    angle,      ///< An angle; a plain number other than 0 is an error.
    parameter,  ///< A coordinate of parameter space, whose unit depends on the object: accepts
                ///< both.
};

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

struct StageParameter {
    std::string_view name;
    ParameterType type = ParameterType::number;
    Unit unit = Unit::number;
    std::vector<double>
        default_value{};  ///< Empty if the argument is required (curve, or no default).
    double minimum = -std::numeric_limits<double>::infinity();
    double maximum = std::numeric_limits<double>::infinity();
    bool excludes_minimum = false;                       ///< The minimum itself is excluded.
    std::vector<std::string_view> choices{};             ///< The first is the default.
    StageKind stage_kind = StageKind::object_generator;  ///< For stage and stages.
    std::vector<std::size_t>
        coordinates{};  ///< The allowed numbers of coordinates per point, in ascending order.
    std::size_t min_points = 1;  ///< The minimum number of points.
    FormulaShape shape{};        ///< The form of a formula parameter.
    /// It is optional without a default value; the maker calls has().
    bool optional = false;
    /// It cannot change with time, because tables are computed from it.
    bool constant = false;
    std::string_view meaning;
};

/// The arguments of a stage, by parameter name. The language has checked them against the row.
class Arguments {
public:
    using StagePointer = std::shared_ptr<const Stage>;
    using Value = std::variant<std::vector<Scalar>, std::string, PointList, StagePointer,
                               std::vector<StagePointer>, Formula, std::shared_ptr<const GreyImage>,
                               std::shared_ptr<const TexturedMesh>>;

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
    [[nodiscard]] const std::shared_ptr<const GreyImage>& image(std::string_view name) const;
    [[nodiscard]] const std::shared_ptr<const TexturedMesh>& mesh(std::string_view name) const;
    /// The formula of a stage that is itself a formula.
    [[nodiscard]] const Formula& formula() const { return *formula_; }

private:
    [[nodiscard]] const Value* find(std::string_view name) const;
    [[nodiscard]] const Value& value(std::string_view name) const;

    std::vector<std::pair<std::string_view, Value>> values_;
    std::optional<Formula> formula_;
};

/// One row of the catalogue: all facts for the language, the command and the documentation.
struct StageEntry {
    StageKind kind;
    std::string_view name;
    std::string_view meaning;
    std::vector<StageParameter> parameters;
    Result<std::shared_ptr<const Stage>> (*make)(const Arguments& arguments);
    std::optional<FormulaShape> formula{};
    int dimension = 0;  ///< The dimension of an object generator.
    /// A .cam text with one camera or picture that shows the effect of the stage; docs/stages has
    /// its picture, and a test runs it.
    std::string_view example{};
};

/// All stages, sorted by kind.
[[nodiscard]] const std::vector<StageEntry>& catalogue();
[[nodiscard]] const StageEntry* find_stage(StageKind kind, std::string_view name);

}  // namespace balcony::camera
