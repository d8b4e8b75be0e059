// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Values for the parameters of a stage: which value is for which, and words, stages, formulas and
// files. Numbers and points are in bind_numbers.cpp.

#include <algorithm>
#include <concepts>
#include <numbers>

#include <fmt/format.h>

#include "balcony/names.hpp"
#include "camera/catalogue/binder.hpp"
#include "camera/catalogue/parameter_text.hpp"

namespace balcony::camera {

namespace {

// A result of a formula for its unit: a number only if it is known, since 0 has every unit.
Scalar result_of(const Formula& value, std::size_t i) {
    return {value.constant(i).value_or(1.0), value.unit(i)};
}

}  // namespace

std::string described(const ArgumentValue& given) {
    struct Words {
        std::string operator()(const Scalar&) const { return "a number"; }
        std::string operator()(const Tuple&) const { return "a tuple"; }
        std::string operator()(const Points&) const { return "a list"; }
        std::string operator()(const std::string&) const { return "a word"; }
        std::string operator()(const std::shared_ptr<const Stage>&) const { return "a stage"; }
        std::string operator()(const ArgumentValue::Stages&) const { return "several stages"; }
        std::string operator()(const Formula&) const { return "a formula"; }
        std::string operator()(const std::shared_ptr<const GreyImage>&) const { return "an image"; }
        std::string operator()(const std::shared_ptr<const TexturedMesh>&) const {
            return "a mesh";
        }
        std::string operator()(const std::shared_ptr<const PixelMap>&) const { return "a map"; }
        std::string operator()(const std::shared_ptr<const CalibrationFile>&) const {
            return "a calibration";
        }
        std::string operator()(const std::shared_ptr<const Prescription>&) const {
            return "a prescription of a lens";
        }
        std::string operator()(const Unsuitable& other) const { return other.what; }
        std::string operator()(const Failed&) const { return {}; }
    };
    return std::visit(Words{}, given.form);
}

bool Binder::has_failed(std::span<const NamedValue> values) {
    return std::any_of(values.begin(), values.end(), [](const NamedValue& one) {
        return std::holds_alternative<Failed>(one.value.form);
    });
}

Binding Binder::run() {
    if (row_.shape) {
        bind_formula();
    } else {
        bind_parameters();
    }
    Binding made;
    if (errors_.empty() && !any_failed_) {
        made.arguments = std::move(arguments_);
    }
    made.errors = std::move(errors_);
    return made;
}

void Binder::bind_parameters() {
    std::vector<std::string> names;
    for (const StageParameter& parameter : row_.parameters) {
        names.emplace_back(parameter.name);
    }
    std::vector<std::optional<std::size_t>> values(row_.parameters.size());
    for (at_ = 0; *at_ < given_.size(); ++*at_) {
        const std::string_view name = given_[*at_].name;
        const auto found = std::find(names.begin(), names.end(), name);
        if (found == names.end()) {
            if (failed()) {
                continue;
            }
            report(Kind::unknown_name, fmt::format("'{}' has no argument '{}'", row_.name, name),
                   names.empty() ? fmt::format("'{}' takes no arguments", row_.name)
                                 : suggestion(name, names, "its arguments are"));
            continue;
        }
        std::optional<std::size_t>& slot = values[static_cast<std::size_t>(found - names.begin())];
        if (slot) {
            report(Kind::given_twice, fmt::format("'{}' is given twice", name),
                   fmt::format("remove one; positional arguments have the order of {}",
                               signature(row_)));
            errors_.back().earlier = slot;
        } else {
            slot = at_;
        }
    }
    for (std::size_t i = 0; i < values.size(); ++i) {
        parameter_ = &row_.parameters[i];
        at_ = values[i];
        element_.clear();
        if (!at_) {
            set_default();
        } else if (!failed()) {
            std::visit([this](const auto& type) { set(type); }, parameter_->type);
        }
    }
}

void Binder::set_default() {
    const auto number = [this](const auto& type) {
        using Type = std::remove_cvref_t<decltype(type)>;
        std::vector<Scalar> values;
        if constexpr (std::same_as<Type, NumberParameter> || std::same_as<Type, CountParameter>) {
            values.assign(type.default_value ? 1 : 0, type.default_value.value_or(0.0));
        } else if constexpr (std::same_as<Type, PairParameter> ||
                             std::same_as<Type, TripleParameter>) {
            if (type.default_value) {
                values.assign(type.default_value->begin(), type.default_value->end());
            }
        } else if constexpr (std::same_as<Type, ChoiceParameter>) {
            arguments_.set(parameter_->name, std::string(type.choices.front()));
            return true;
        }
        const bool known = !values.empty();
        if (known) {
            arguments_.set(parameter_->name, std::move(values));
        }
        return known;
    };
    // An error in another value may be the reason why this one seems to be missing.
    if (!std::visit(number, parameter_->type) && !parameter_->optional && errors_.empty() &&
        !any_failed_) {
        report(Kind::missing,
               fmt::format("'{}' needs its argument '{}' ({})", row_.name, parameter_->name,
                           parameter_->meaning),
               fmt::format("the syntax is {}", signature(row_)));
    }
}

void Binder::report(Kind kind, std::string message, std::string remedy) {
    if (errors_.size() < max_errors) {
        errors_.push_back(
            {kind, error(std::move(message), {}, std::move(remedy)), at_, element_, std::nullopt});
    }
}

void Binder::bind_formula() {
    if (!given_.empty()) {
        at_ = 0;
    }
    const auto* value =
        given_.size() == 1 && given_[0].name == row_.name ? given<Formula>() : nullptr;
    if (value == nullptr) {
        if (!any_failed_) {
            report(Kind::wrong_form, fmt::format("'{}' needs a formula", row_.name),
                   fmt::format("the syntax is {}", signature(row_)));
        }
        return;
    }
    if (!has_shape(row_.name, *row_.shape, *value)) {
        return;
    }
    for (std::size_t i = 0; i < value->result_count(); ++i) {
        if (row_.kind != StageKind::parameter_transformer && is_angle(result_of(*value, i))) {
            element_ = {i};
            report(
                Kind::angle_for_number,
                fmt::format("the results of '{}' must be lengths, but this is an angle", row_.name),
                "divide it by 1rad to get the number of radians");
        }
    }
    arguments_.set_formula(*value);
}

void Binder::set(const ChoiceParameter& type) {
    const std::vector<std::string> words(type.choices.begin(), type.choices.end());
    const auto* word = given<std::string>();
    if (word == nullptr) {
        report(Kind::wrong_form, fmt::format("{} takes a name", what()),
               fmt::format("write {}", one_of(words)));
    } else if (std::find(words.begin(), words.end(), *word) == words.end()) {
        report(Kind::out_of_range, fmt::format("{} cannot be '{}'", what(), *word),
               suggestion(*word, words, "it is"));
    } else {
        arguments_.set(parameter_->name, *word);
    }
}

void Binder::set(const NestedStageParameter& type) {
    if (const auto* number = given<Scalar>(); number != nullptr && !type.of_number.empty()) {
        set_stage_of_number(type, *number);
        return;
    }
    ArgumentValue::Stages stages;
    if (const auto* several = given<ArgumentValue::Stages>(); several != nullptr && type.several) {
        stages = *several;
    } else if (const auto* one = given<std::shared_ptr<const Stage>>()) {
        stages = {*one};
    } else {
        report(Kind::wrong_form,
               fmt::format("{} takes {}, but this is {}", what(), with_article(noun_of(type)),
                           described(given_[*at_].value)),
               stage_remedy(type));
        return;
    }
    bool good = !stages.empty();
    for (std::size_t i = 0; i < stages.size(); ++i) {
        element_ = {i};
        good = stage_fits(type, stages[i].get()) && good;
    }
    if (!good) {
        return;
    }
    if (type.several) {
        arguments_.set(parameter_->name, std::move(stages));
    } else {
        arguments_.set(parameter_->name, std::move(stages.front()));
    }
}

// A plain number is judged as the argument of the stage that it is short for.
void Binder::set_stage_of_number(const NestedStageParameter& type, const Scalar& number) {
    const StageEntry* row = catalogue().find(type.kind, type.of_number);
    assert(row != nullptr && row->parameters.size() == 1 && "it is a stage of one number");
    const StageParameter& only = row->parameters.front();
    const auto* rules = only.as<NumberParameter>();
    if (const auto value = checked(number, {rules->unit, rules->range, rules->constant})) {
        Arguments arguments;
        arguments.set(only.name, std::vector{*value});
        arguments_.set(parameter_->name, *make_stage(*row, arguments));
    }
}

bool Binder::stage_fits(const NestedStageParameter& type, const Stage* stage) {
    if (stage == nullptr || !is_of_kind(*stage, type.kind)) {
        report(Kind::wrong_form,
               fmt::format("{} takes {}, but this is {}", what(), with_article(noun_of(type)),
                           stage == nullptr ? "no stage" : "a stage of another kind"),
               stage_remedy(type));
        return false;
    }
    const auto* object = dynamic_cast<const ObjectGenerator*>(stage);
    if (type.dimension && object != nullptr && object->dimension() != *type.dimension) {
        report(Kind::wrong_form,
               fmt::format("{} takes {}, but this is {}", what(), with_article(noun_of(type)),
                           with_article(object_noun(object->dimension()))),
               stage_remedy(type));
        return false;
    }
    return true;
}

void Binder::set(const FormulaParameter& type) {
    const auto* value = given<Formula>();
    if (value == nullptr) {
        report(Kind::wrong_form, fmt::format("{} takes a formula", what()),
               fmt::format("the syntax is {}", signature(parameter_->name, type.shape)));
    } else if (has_shape(parameter_->name, type.shape, *value)) {
        const std::size_t errors_before = errors_.size();
        for (std::size_t i = 0; i < value->result_count(); ++i) {
            element_ = {i};
            (void)fits(result_of(*value, i), Unit::number, false);
        }
        if (errors_.size() == errors_before) {
            arguments_.set(parameter_->name, *value);
        }
    }
}

bool Binder::has_shape(std::string_view name, const FormulaShape& shape, const Formula& value) {
    auto trouble = shape_error(name, shape, value.parameter_count(), value.result_count());
    if (trouble) {
        report(Kind::wrong_form, std::move(trouble->message), std::move(trouble->remedy));
    }
    return !trouble;
}

template <class Data>
void Binder::set_file(std::string_view noun, std::string_view example) {
    const auto* data = given<std::shared_ptr<const Data>>();
    if (data == nullptr || *data == nullptr) {
        report(Kind::wrong_form, fmt::format("{} takes {}", what(), noun),
               fmt::format("write a file name in quotation marks, for example \"{}\"", example));
    } else {
        arguments_.set(parameter_->name, *data);
    }
}

void Binder::set(const NameParameter&) {
    const auto* name = given<std::string>();
    if (name == nullptr || name->empty()) {
        report(Kind::wrong_form, fmt::format("{} takes a name", what()),
               fmt::format("write it in quotation marks; {}",
                           purpose(*parameter_, std::nullopt, Unit::number)));
    } else {
        arguments_.set(parameter_->name, *name);
    }
}

void Binder::set(const ImageParameter&) { set_file<GreyImage>("an image", "mask.png"); }

void Binder::set(const MeshParameter&) { set_file<TexturedMesh>("a mesh", "vase.obj"); }

void Binder::set(const MapParameter& type) {
    const bool rays = type.content == MapParameter::Content::rays;
    const auto* map = given<std::shared_ptr<const PixelMap>>();
    if (map != nullptr && *map != nullptr && !fits(**map, type.channels())) {
        report(Kind::wrong_form,
               fmt::format("{} takes a map with {} channels", what(), type.channels()),
               "give each channel and `valid` a value for each pixel");
        return;
    }
    set_file<PixelMap>(rays ? "a ray map" : "an STMap", rays ? "rays.exr" : "lens.exr");
}

// A map may come from a program.
bool Binder::fits(const PixelMap& map, std::size_t channels) {
    const std::size_t size = map.width * map.height;
    return size > 0 && map.valid.size() == size && map.channels.size() == channels &&
           std::all_of(map.channels.begin(), map.channels.end(),
                       [size](const auto& channel) { return channel.size() == size; });
}

void Binder::set(const CalibrationParameter&) {
    set_file<CalibrationFile>("a calibration", "calibration.yml");
}

void Binder::set(const PrescriptionParameter&) {
    set_file<Prescription>("a prescription of a lens", "dgauss.dat");
}

Scalar degrees(double number) { return {number * (std::numbers::pi / 180.0), Unit::angle}; }

Scalar radians(double number) { return {number, Unit::angle}; }

Binding bind(const StageEntry& row, std::span<const NamedValue> values) {
    try {
        return Binder(row, values).run();
    } catch (const expr::GraphTooLarge&) {
        return {std::nullopt,
                {{ArgumentError::Kind::out_of_range,
                  error(fmt::format("the formulas given for '{}' are too large", row.name), {},
                        "give it shorter ones")}}};
    }
}

std::optional<Diagnostic> shape_error(std::string_view name, const FormulaShape& shape,
                                      std::size_t parameters, std::size_t results) {
    const std::string written = fmt::format("the syntax is {}", signature(name, shape));
    if (!shape.takes(parameters)) {
        return error(fmt::format("the formula '{}' has {}{} parameter{}, but this one has {}", name,
                                 shape.may_have_fewer ? "1 to " : "", shape.parameters,
                                 shape.parameters == 1 ? "" : "s", parameters),
                     {}, written);
    }
    if (results < shape.min_results || results > shape.max_results) {
        const std::string expected =
            shape.min_results == shape.max_results
                ? fmt::format("{}", shape.min_results)
                : fmt::format("{} or {}", shape.min_results, shape.max_results);
        return error(fmt::format("the formula '{}' has {} result{}, but this one has {}", name,
                                 expected, shape.max_results == 1 ? "" : "s", results),
                     {}, written);
    }
    return std::nullopt;
}

}  // namespace balcony::camera
