// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "balcony/make_stage.hpp"

namespace balcony::camera {

/// What every number of a parameter must be.
struct NumberRules {
    Unit unit = Unit::number;
    Range range{};
    bool constant = false;
    bool whole = false;
    std::optional<double> default_value{};  // Of a parameter that is one number.
};

/// Checks the values for one stage against its row and collects the errors.
class Binder {
public:
    Binder(const StageEntry& row, std::span<const NamedValue> values)
        : row_(row), given_(values), any_failed_(has_failed(values)) {}

    [[nodiscard]] Binding run();

private:
    using Kind = ArgumentError::Kind;
    /// More errors about one stage help nobody.
    static constexpr std::size_t max_errors = 64;

    /// The value that is being judged, if it has this form.
    template <class Form>
    [[nodiscard]] const Form* given() const {
        return std::get_if<Form>(&given_[*at_].value.form);
    }
    [[nodiscard]] bool failed() const { return given<Failed>() != nullptr; }
    [[nodiscard]] static bool has_failed(std::span<const NamedValue> values);
    [[nodiscard]] std::string what() const {
        return fmt::format("'{}' of '{}'", parameter_->name, row_.name);
    }

    void bind_parameters();
    void set_default();
    void report(Kind kind, std::string message, std::string remedy);
    /// For a stage that is itself a formula: it takes one value, named like the stage.
    void bind_formula();

    // ------------------------------------------------------------------------------- numbers
    void set(const NumberParameter& type);
    void set(const CountParameter& type);
    void set(const PairParameter& type);
    void set(const TripleParameter& type);
    [[nodiscard]] const Scalar* one_number(std::string_view form);
    [[nodiscard]] const Tuple* numbers(std::size_t count, std::string_view form);
    void wrong_form(std::string_view form);
    void set_numbers(std::span<const Scalar> numbers, const NumberRules& rules);
    [[nodiscard]] std::optional<Scalar> checked(const Scalar& number, const NumberRules& rules);
    bool fits(const Scalar& number, Unit unit, bool constant);
    bool in_range(double value, const NumberRules& rules);

    // -------------------------------------------------------------------------------- points
    void set(const PointsParameter& type);
    bool enough_points(const PointsParameter& type, std::size_t count);
    void add_point(const PointsParameter& type, const Tuple& point, PointList& points);
    bool has_coordinates(const PointsParameter& type, std::size_t count, const PointList& points);

    // ----------------------------------------------------- words, stages, formulas and files
    void set(const ChoiceParameter& type);
    void set(const NestedStageParameter& type);
    void set_stage_of_number(const NestedStageParameter& type, const Scalar& number);
    bool stage_fits(const NestedStageParameter& type, const Stage* stage);
    void set(const FormulaParameter& type);
    bool has_shape(std::string_view name, const FormulaShape& shape, const Formula& value);
    void set(const NameParameter&);
    void set(const ImageParameter&);
    void set(const MeshParameter&);
    void set(const MapParameter& type);
    [[nodiscard]] static bool fits(const PixelMap& map, std::size_t channels);
    void set(const CalibrationParameter&);
    void set(const PrescriptionParameter&);
    template <class Data>
    void set_file(std::string_view noun, std::string_view example);

    const StageEntry& row_;
    std::span<const NamedValue> given_;
    const bool any_failed_;
    Arguments arguments_;
    std::vector<ArgumentError> errors_;
    // The value that is being checked.
    const StageParameter* parameter_ = nullptr;
    std::optional<std::size_t> at_;
    std::vector<std::size_t> element_;
};

/// 0 has every unit.
[[nodiscard]] bool is_angle(const Scalar& given);
/// A value in the words of a message.
[[nodiscard]] std::string described(const ArgumentValue& given);

}  // namespace balcony::camera
