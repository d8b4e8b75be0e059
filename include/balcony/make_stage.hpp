// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Stages from a row of the catalogue and values, checked as those in a .cam file are:
//
//     auto torus = make_stage<ObjectGenerator>("torus", {{"major", 10.0}, {"minor", 2.0}});
//     auto turn = make_stage<ObjectTransformer>("rotate", {{"axis", "z"}, {"angle", degrees(30)}});
//
// Both are Results: a value out of its range, of another unit, of an unknown name, ... is an error.

#include <concepts>
#include <initializer_list>

#include "balcony/catalogue.hpp"

namespace balcony::camera {

// -------------------------------------------------------------------------------- values

[[nodiscard]] Scalar degrees(double number);
[[nodiscard]] Scalar radians(double number);

/// Numbers that belong together: (a, b).
using Tuple = std::vector<Scalar>;
/// Points, each with its co-ordinates; numbers are points of one: {{0.0}, {0.5}, {1.0}}.
using Points = std::vector<Tuple>;

/// In the place of a value: something that no parameter takes, in words ("a file's name").
struct Unsuitable {
    std::string what;
};

/// In the place of a value that is known to be wrong: it counts as given and is not judged.
struct Failed {};

/// A value for a parameter before it is checked. A text is a choice, a name, or an axis: "z", "-x".
struct ArgumentValue {
    using Stages = std::vector<std::shared_ptr<const Stage>>;
    using Form =
        std::variant<Scalar, Tuple, Points, std::string, std::shared_ptr<const Stage>, Stages,
                     Formula, std::shared_ptr<const GreyImage>, std::shared_ptr<const TexturedMesh>,
                     std::shared_ptr<const PixelMap>, std::shared_ptr<const CalibrationFile>,
                     std::shared_ptr<const Prescription>, Unsuitable, Failed>;

    template <class Value>
    requires(!std::same_as<std::remove_cvref_t<Value>, ArgumentValue> &&
             std::constructible_from<Form, Value>) ArgumentValue(Value&& value)
        : form(std::forward<Value>(value)) {}
    ArgumentValue(std::initializer_list<Scalar> numbers) : form(Tuple(numbers)) {}

    Form form;
};

struct NamedValue {
    std::string_view name;
    ArgumentValue value;
};

// ------------------------------------------------------------------------------- binding

/// What is wrong with the values for a stage, and with which of them.
struct ArgumentError {
    enum class Kind : std::uint8_t {
        unknown_name,
        given_twice,
        missing,
        wrong_form,         ///< Two numbers in the place of one, a stage of another kind, ...
        angle_for_number,   ///< An angle in the place of a plain number.
        number_for_angle,   ///< A plain number in the place of an angle.
        changes_with_time,  ///< It must not.
        out_of_range,
        wrong_coordinates,  ///< A point with more or fewer numbers than it may have.
    };

    Kind kind;
    Diagnostic diagnostic;               ///< Without a place.
    std::optional<std::size_t> value{};  ///< Which of the values; none: the stage as a whole.
    /// Which part of the value: the number of a tuple or stage, or the point and its co-ordinate.
    std::vector<std::size_t> element{};
    std::optional<std::size_t> earlier{};  ///< Of a value given twice, which was the first.
};

/// What a maker needs, or why there is none.
struct Binding {
    std::optional<Arguments> arguments;
    std::vector<ArgumentError> errors;
};

/// Checks values against a row: names, forms, units, ranges, kinds of nested stages, numbers of
/// points, constancy in time; and adds the defaults. A number that changes with time is held within
/// its range. A stage that is a formula takes one value of its own name. There are arguments if
/// there are no errors and no value has failed. The row must outlive the arguments.
[[nodiscard]] Binding bind(const StageEntry& row, std::span<const NamedValue> values);

/// What is wrong with a formula of so many parameters and results for a shape; `name` is that of
/// the parameter or the stage.
[[nodiscard]] std::optional<Diagnostic> shape_error(std::string_view name,
                                                    const FormulaShape& shape,
                                                    std::size_t parameters, std::size_t results);

// -------------------------------------------------------------------------------- making

/// The stage that a row's maker makes from checked arguments.
[[nodiscard]] StageResult make_stage(const StageEntry& row, const Arguments& arguments);

/// The same from values.
[[nodiscard]] StageResult make_stage(const StageEntry& row, std::span<const NamedValue> values);

/// The same by the stage's kind and name, of which an unknown one is an error.
[[nodiscard]] StageResult make_stage(StageKind kind, std::string_view name,
                                     std::initializer_list<NamedValue> values = {},
                                     const Catalogue& known = catalogue());

/// The port of each kind.
template <class... Ports>
struct PortsByKind {
    template <class Port>
    [[nodiscard]] static consteval StageKind kind_of() {
        static_assert((std::same_as<Port, Ports> || ...));
        std::uint8_t kind = 0;
        (void)((std::same_as<Port, Ports> || (++kind, false)) || ...);
        return static_cast<StageKind>(kind);
    }
    [[nodiscard]] static bool fits(const Stage& stage, StageKind kind) {
        return ((kind == kind_of<Ports>() && dynamic_cast<const Ports*>(&stage) != nullptr) || ...);
    }
};
/// In the order of StageKind.
using StagePorts =
    PortsByKind<PictureArranger, PictureMapper, ParameterTransformer, ObjectGenerator,
                ObjectTransformer, DirectionRule, StereoView, Lens, FocusSurface, Bend, ClipShape>;

template <class Port>
consteval StageKind kind_of() {
    return StagePorts::kind_of<Port>();
}

/// The same as a stage of its port.
template <class Port>
[[nodiscard]] Result<std::shared_ptr<const Port>> make_stage(
    std::string_view name, std::initializer_list<NamedValue> values = {},
    const Catalogue& known = catalogue()) {
    StageResult made = make_stage(kind_of<Port>(), name, values, known);
    if (!made) {
        return std::move(made.diagnostics);
    }
    return {std::static_pointer_cast<const Port>(*made), std::move(made.diagnostics)};
}

/// Whether a stage fits the port of a kind.
[[nodiscard]] bool is_of_kind(const Stage& stage, StageKind kind);
/// A parameter transformer, an object generator.
[[nodiscard]] std::string with_article(std::string_view noun);

}  // namespace balcony::camera
