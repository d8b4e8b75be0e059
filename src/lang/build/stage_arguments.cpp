// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Which parameter an argument of a stage is for, and where what camera::bind finds is reported.

#include <algorithm>

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::ArgumentError;
using camera::Arguments;
using camera::StageEntry;
using camera::StageParameter;

bool is_formula(const StageParameter& parameter) {
    return parameter.as<camera::FormulaParameter>() != nullptr;
}

bool takes_the_rest(const StageParameter& parameter) {
    const auto* nested = parameter.as<camera::NestedStageParameter>();
    return nested != nullptr && nested->several;
}

const StageParameter* find_parameter(const StageEntry& row, std::string_view name) {
    const auto found =
        std::find_if(row.parameters.begin(), row.parameters.end(),
                     [name](const StageParameter& parameter) { return parameter.name == name; });
    return found != row.parameters.end() ? &*found : nullptr;
}

// The formula parameter that receives a formula given as an argument; null if the row has none, in
// which case the formula is a stage.
const StageParameter* parameter_of_formula(const StageEntry& row, const Expression& value) {
    const StageParameter* found =
        value.kind == ExpressionKind::formula ? find_parameter(row, value.name.text) : nullptr;
    return found != nullptr && is_formula(*found) ? found : nullptr;
}

bool is_stage_formula(const camera::Catalogue& catalogue, std::string_view name) {
    return std::any_of(catalogue.begin(), catalogue.end(),
                       [name](const StageEntry& row) { return row.shape && row.name == name; });
}

// The parameters in the order of positional arguments: formulas are named by themselves,
// and a parameter that takes all remaining arguments is the last.
class Positions {
public:
    explicit Positions(const StageEntry& row) {
        for (const StageParameter& parameter : row.parameters) {
            if (!is_formula(parameter)) {
                parameters_.push_back(&parameter);
            }
        }
    }
    [[nodiscard]] std::size_t count() const { return parameters_.size(); }
    [[nodiscard]] std::span<const StageParameter* const> rest() const {
        return std::span(parameters_).subspan(at_);
    }
    /// Null if there are no more.
    const StageParameter* next() {
        if (at_ == parameters_.size()) {
            return nullptr;
        }
        const StageParameter* parameter = parameters_[at_];
        at_ += takes_the_rest(*parameter) ? 0 : 1;
        return parameter;
    }

private:
    std::vector<const StageParameter*> parameters_;
    std::size_t at_ = 0;
};

// A number that is written as one, with or without a sign.
bool is_literal(const SyntaxTree& tree, const Expression& node) {
    const bool sign = node.kind == ExpressionKind::operation && node.arguments.size() == 1;
    return node.kind == ExpressionKind::number ||
           (sign && is_literal(tree, tree[node.arguments.front().value]));
}

// The remedy for a plain number where an angle is needed.
std::string angle_remedy(const SourceSpan& place) {
    const std::string_view written =
        place.source->text().substr(place.begin, place.end - place.begin);
    const bool literal = written.find_first_not_of("0123456789.") == std::string::npos;
    return literal ? fmt::format("write {0}deg or {0}rad", written)
                   : "multiply it by 1rad if it is in radians, or by 1deg if it is in degrees";
}

}  // namespace

std::optional<Arguments> StageBuilder::arguments(const StageEntry& row, const Expression& call) {
    if (row.shape && call.kind == ExpressionKind::formula) {
        Located made = formula(row.name, *row.shape, call);
        return bind(row, {{{row.name, std::move(made.value)}, std::move(made.place)}}, call.span);
    }
    if (!row.shape && call.kind == ExpressionKind::formula) {
        error(call.span, fmt::format("'{}' does not take a formula", row.name),
              fmt::format("the syntax is {}", signature(row)));
        return std::nullopt;
    }
    if (tuple_is_spread(row, call)) {
        return std::nullopt;
    }
    std::vector<Given> values;
    if (!row.shape) {
        for (const Assigned& assigned : assign(row, call)) {
            values.push_back(given(assigned));
        }
    }
    return bind(row, values, row.shape ? call.span : call.name.span);
}

std::optional<Arguments> StageBuilder::arguments(const StageEntry& row,
                                                 std::span<const ExpressionId> values, Span span) {
    assert(values.size() <= row.parameters.size());
    std::vector<Given> all;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (values[i].valid()) {
            const StageParameter& parameter = row.parameters[i];
            all.push_back(given({parameter.name, &parameter, span, {values[i]}, std::nullopt}));
        }
    }
    return bind(row, all, span);
}

// -------------------------------------------------------------------------------------- errors

std::optional<Arguments> StageBuilder::bind(const StageEntry& row, const std::vector<Given>& given,
                                            Span whole) {
    std::vector<camera::NamedValue> values;
    for (const Given& one : given) {
        values.push_back(one.named);
    }
    camera::Binding bound = camera::bind(row, values);
    for (ArgumentError& wrong : bound.errors) {
        Diagnostic& diagnostic = wrong.diagnostic;
        if (!wrong.value) {
            diagnostic.span = tree_.at(whole);
            reporter_.add(std::move(diagnostic));
            continue;
        }
        const Given& about = given[*wrong.value];
        const bool of_name = wrong.kind == ArgumentError::Kind::unknown_name ||
                             wrong.kind == ArgumentError::Kind::given_twice;
        const Written* place = &about.place;
        for (const std::size_t i : wrong.element) {
            place = i < place->parts.size() ? &place->parts[i] : place;
        }
        diagnostic.span = of_name ? tree_.at(about.name) : place->span;
        if (wrong.kind == ArgumentError::Kind::number_for_angle) {
            diagnostic.remedy = angle_remedy(diagnostic.span);
        } else if (wrong.kind == ArgumentError::Kind::wrong_coordinates &&
                   diagnostic.span.source != tree_.source) {
            diagnostic.remedy = "each line of a table is a point; remove other columns";
        }
        if (wrong.earlier) {
            diagnostic.notes.push_back({given[*wrong.earlier].place.span, "first given here"});
        }
        report({std::move(diagnostic)}, of_name ? about.name : about.expression);
    }
    return std::move(bound.arguments);
}

// -------------------------------------------------------------- parameters of the arguments

// plane(1, 0, 0) instead of plane((1, 0, 0)): one message instead of three.
bool StageBuilder::tuple_is_spread(const StageEntry& row, const Expression& call) {
    Positions positions(row);
    for (std::size_t i = 0; i < call.arguments.size() && !call.arguments[i].name; ++i) {
        const StageParameter* parameter = positions.next();
        if (parameter == nullptr) {
            return false;
        }
        const auto* pair = parameter->as<camera::PairParameter>();
        const auto* triple = parameter->as<camera::TripleParameter>();
        const std::size_t count = triple != nullptr && !triple->names_axes ? 3
                                  : pair != nullptr && !pair->one_for_both ? 2
                                                                           : 1;
        const auto first = call.arguments.begin() + static_cast<std::ptrdiff_t>(i);
        if (count == 1 || call.arguments.size() < i + count ||
            !std::all_of(first, first + static_cast<std::ptrdiff_t>(count),
                         [this](const Argument& one) {
                             return !one.name && is_literal(tree_, tree_[one.value]);
                         })) {
            continue;
        }
        const Span span = {tree_[first->value].span.begin,
                           tree_[call.arguments[i + count - 1].value].span.end};
        error(span,
              fmt::format("the {} numbers of '{}' of '{}' must be in parentheses",
                          count == 2 ? "two" : "three", parameter->name, row.name),
              fmt::format("write ({})", tree_.text(span)));
        return true;
    }
    return false;
}

// An argument that has an error is not assigned to a parameter.
std::vector<StageBuilder::Assigned> StageBuilder::assign(const StageEntry& row,
                                                         const Expression& call) {
    std::vector<Assigned> made;
    bool named = false;
    std::size_t values =
        call.arguments.size();  // Including the numbers of tuples that are for several parameters.
    Positions positions(row);
    const bool takes_formulas =
        std::any_of(row.parameters.begin(), row.parameters.end(), is_formula);
    for (const Argument& argument : call.arguments) {
        const Expression& value = tree_[argument.value];
        const StageParameter* parameter = parameter_of_formula(row, value);
        if (argument.name) {
            named = true;
            made.push_back({argument.name->text,
                            find_parameter(row, argument.name->text),
                            argument.name->span,
                            {argument.value},
                            std::nullopt});
        } else if (call.words) {
            parameter = parameter_of_word(row, value.name);
            made.push_back({parameter != nullptr ? parameter->name : "",
                            parameter,
                            value.span,
                            {argument.value},
                            std::nullopt});
        } else if (parameter == nullptr && takes_formulas &&
                   value.kind == ExpressionKind::formula &&
                   !is_stage_formula(session_.catalogue(), value.name.text)) {
            made.push_back({value.name.text, nullptr, value.name.span, {}, std::nullopt});
        } else if (parameter != nullptr) {
            made.push_back(
                {parameter->name, parameter, value.span, {argument.value}, std::nullopt});
        } else if (named) {
            error(value.span, "a positional argument follows a named argument",
                  fmt::format("write positional arguments first, in the order of {}, or name them",
                              signature(row)));
            made.emplace_back();
        } else if (const auto tuple = tuple_for(argument.value, positions.rest())) {
            values += tuple->elements->size() - 1;
            for (const Element& element : *tuple->elements) {
                const StageParameter* next = positions.next();
                made.push_back({next->name, next, value.span, {argument.value}, element});
            }
        } else if (const StageParameter* next = positions.next()) {
            const auto rest = std::find_if(made.begin(), made.end(), [next](const Assigned& one) {
                return one.parameter == next && takes_the_rest(*next);
            });
            if (rest != made.end()) {
                rest->expressions.push_back(argument.value);
            } else {
                made.push_back({next->name, next, value.span, {argument.value}, std::nullopt});
            }
        } else {
            error(value.span,
                  fmt::format("'{}' takes {} argument{}, but {} are given", row.name,
                              positions.count(), positions.count() == 1 ? "" : "s", values),
                  fmt::format("the syntax is {}", signature(row)));
            made.emplace_back();
            break;
        }
    }
    return made;
}

// A tuple can replace as many numbers: translate(corner) is translate(x, y, z).
std::optional<Value> StageBuilder::tuple_for(ExpressionId value,
                                             std::span<const StageParameter* const> positions) {
    const auto is_number = [](const StageParameter* parameter) {
        return parameter->as<camera::NumberParameter>() != nullptr;
    };
    const auto numbers = static_cast<std::size_t>(
        std::find_if_not(positions.begin(), positions.end(), is_number) - positions.begin());
    if (numbers < 2) {
        return std::nullopt;
    }
    std::optional<Value> tuple = evaluate_compound(tree_, value, scope_, session_.context());
    const bool fits =
        tuple && tuple->form == Value::Form::tuple && tuple->elements->size() <= numbers;
    return fits ? std::move(tuple) : std::nullopt;
}

// The first parameter that has the word as a choice.
const StageParameter* StageBuilder::parameter_of_word(const StageEntry& row,
                                                      const Identifier& word) {
    std::vector<std::string> known;
    for (const StageParameter& parameter : row.parameters) {
        if (const auto* choice = parameter.as<camera::ChoiceParameter>()) {
            if (std::find(choice->choices.begin(), choice->choices.end(), word.text) !=
                choice->choices.end()) {
                return &parameter;
            }
            known.insert(known.end(), choice->choices.begin(), choice->choices.end());
        }
    }
    error(word.span, fmt::format("'{}' cannot be '{}'", row.name, word.text),
          known.empty() ? fmt::format("the syntax is {}", signature(row))
                        : suggestion(word.text, known, "the choices are"));
    return nullptr;
}

StageBuilder::Given StageBuilder::given(const Assigned& assigned) {
    const Span expression = assigned.expressions.empty() ? assigned.name_span
                                                         : tree_[assigned.expressions.front()].span;
    Given made{
        {assigned.name, camera::Failed{}}, {tree_.at(expression)}, assigned.name_span, expression};
    if (assigned.element) {
        made.named.value = scalar(assigned.element->value);
        made.place = {assigned.element->place};
    } else if (assigned.parameter != nullptr) {
        Located located = value(*assigned.parameter, assigned.expressions);
        made.named.value = std::move(located.value);
        made.place = std::move(located.place);
    } else if (!assigned.name.empty()) {
        made.named.value = camera::Unsuitable{};
    }
    return made;
}

}  // namespace balcony::lang
