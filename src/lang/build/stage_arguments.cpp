// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Assigns arguments to the parameters of a stage, and reads arguments that are names or stages.

#include <algorithm>

#include <fmt/format.h>

#include "lang/build/stages.hpp"
#include "lang/names/evaluate.hpp"

namespace balcony::lang {

namespace {

using camera::Arguments;
using camera::ParameterType;
using camera::StageEntry;
using camera::StageKind;
using camera::StageParameter;

// The formula parameter that a formula among the arguments belongs to; null if there is none
// and the formula is a stage.
const StageParameter* parameter_of_formula(const StageEntry& row, const Expression& value) {
    const auto found = std::find_if(
        row.parameters.begin(), row.parameters.end(), [&value](const StageParameter& parameter) {
            return parameter.type == ParameterType::formula && parameter.name == value.name.text;
        });
    return value.kind == ExpressionKind::formula && found != row.parameters.end() ? &*found
                                                                                  : nullptr;
}

bool takes_formulas(const StageEntry& row) {
    return std::any_of(row.parameters.begin(), row.parameters.end(), [](const auto& parameter) {
        return parameter.type == ParameterType::formula;
    });
}

bool is_stage_formula(std::string_view name) {
    const auto& rows = camera::catalogue();
    return std::any_of(rows.begin(), rows.end(),
                       [name](const StageEntry& row) { return row.formula && row.name == name; });
}

// The parameters in the order of positional arguments: formulas are named by themselves,
// and a parameter that takes all remaining arguments is the last.
class Positions {
public:
    explicit Positions(const StageEntry& row) {
        for (const StageParameter& parameter : row.parameters) {
            if (parameter.type != ParameterType::formula) {
                parameters_.push_back(&parameter);
            }
        }
    }
    [[nodiscard]] std::size_t count() const { return parameters_.size(); }
    [[nodiscard]] std::span<const StageParameter* const> rest() const {
        return std::span(parameters_).subspan(at_);
    }
    void skip(std::size_t count) { at_ += count; }
    /// Null at the end.
    const StageParameter* next() {
        if (at_ == parameters_.size()) {
            return nullptr;
        }
        const StageParameter* parameter = parameters_[at_];
        at_ += parameter->type == ParameterType::stages ? 0 : 1;
        return parameter;
    }

private:
    std::vector<const StageParameter*> parameters_;
    std::size_t at_ = 0;
};

constexpr std::string_view curve_remedy =
    "write a curve, for example circle(1) or curve(u) = [cos(u), sin(u)]";

// A number literal, with or without a sign.
bool is_literal(const SyntaxTree& tree, const Expression& node) {
    const bool sign = node.kind == ExpressionKind::operation && node.arguments.size() == 1;
    return node.kind == ExpressionKind::number ||
           (sign && is_literal(tree, tree[node.arguments.front().value]));
}

bool may_be_stage(const Expression& node) {
    return node.kind == ExpressionKind::name || node.kind == ExpressionKind::call ||
           node.kind == ExpressionKind::formula;
}

// An example of a stage of a kind: the first one in the catalogue.
std::string example_of(StageKind kind) {
    for (const StageEntry& row : camera::catalogue()) {
        if (row.kind == kind && !row.formula) {
            return signature(row);
        }
    }
    return {};
}

}  // namespace

std::string_view described(const Expression& node) {
    switch (node.kind) {
        case ExpressionKind::tuple: return "a tuple";
        case ExpressionKind::list: return "a list";
        case ExpressionKind::text: return "a file name";
        case ExpressionKind::formula: return "a formula";
        default: return "a number";
    }
}

std::optional<Arguments> StageBuilder::arguments(const StageEntry& row, const Expression& call) {
    Arguments made;
    if (row.formula) {
        std::optional<camera::Formula> formula = stage_formula(row, call);
        if (!formula) {
            return std::nullopt;
        }
        made.set_formula(std::move(*formula));
        return made;
    }
    if (call.kind == ExpressionKind::formula) {
        error(call.span, fmt::format("'{}' does not take a formula", row.name),
              fmt::format("the syntax is {}", signature(row)));
        return std::nullopt;
    }
    if (tuple_is_spread(row, call)) {
        return std::nullopt;
    }
    std::vector<Given> given(row.parameters.size());
    bool good = assign(row, call, given);
    for (std::size_t i = 0; i < given.size(); ++i) {
        const StageParameter& parameter = row.parameters[i];
        if (const std::optional<Element>& element = given[i].element) {
            const auto value = number(row, parameter, element->value, element->place);
            good = value && good;
            if (value) {
                made.set(parameter.name, std::vector<camera::Scalar>{*value});
            }
        } else if (!given[i].empty()) {
            good = set_argument(row, parameter, given[i].expressions, made) && good;
        } else if (good) {
            good = set_default(row, parameter, call.name.span, made);
        }
    }
    return good ? std::optional(std::move(made)) : std::nullopt;
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
        const std::size_t count = parameter->type == ParameterType::triple ? 3
                                  : parameter->type == ParameterType::pair ? 2
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
              fmt::format("write ({})",
                          tree_.source->text().substr(span.begin, span.end - span.begin)));
        return true;
    }
    return false;
}

bool StageBuilder::assign(const StageEntry& row, const Expression& call,
                          std::vector<Given>& given) {
    bool good = true;
    bool named = false;
    std::size_t values =
        call.arguments.size();  // Including the numbers of tuples that are for several parameters.
    Positions positions(row);
    for (const Argument& argument : call.arguments) {
        const Expression& value = tree_[argument.value];
        const StageParameter* parameter = parameter_of_formula(row, value);
        if (argument.name) {
            named = true;
            parameter = named_parameter(row, *argument.name);
        } else if (call.words) {
            parameter = parameter_of_word(row, value.name);
        } else if (parameter == nullptr && value.kind == ExpressionKind::formula &&
                   takes_formulas(row) && !is_stage_formula(value.name.text)) {
            (void)named_parameter(row, value.name);
        } else if (parameter == nullptr && named) {
            error(value.span, "a positional argument follows a named argument",
                  fmt::format("write positional arguments first, in the order of {}, or name them",
                              signature(row)));
        } else if (parameter == nullptr) {
            if (const std::size_t count =
                    assign_tuple(row, argument.value, positions.rest(), given)) {
                positions.skip(count);
                values += count - 1;
                continue;
            }
            parameter = positions.next();
            if (parameter == nullptr) {
                error(value.span,
                      fmt::format("'{}' takes {} argument{}, but {} are given", row.name,
                                  positions.count(), positions.count() == 1 ? "" : "s", values),
                      fmt::format("the syntax is {}", signature(row)));
                return false;
            }
        }
        if (parameter == nullptr) {
            good = false;
            continue;
        }
        Given& slot = given[static_cast<std::size_t>(parameter - row.parameters.data())];
        const bool one_more = parameter->type == ParameterType::stages && !argument.name;
        if (!slot.empty() && !one_more) {
            Diagnostic diagnostic =
                balcony::error(fmt::format("'{}' is given twice", parameter->name),
                               tree_.at(argument.name ? argument.name->span : value.span),
                               fmt::format("remove one; positional arguments have the order "
                                           "of {}",
                                           signature(row)));
            diagnostic.notes.push_back({slot.element
                                            ? slot.element->place
                                            : tree_.at(tree_[slot.expressions.front()].span),
                                        "first given here"});
            reporter_.add(std::move(diagnostic));
            good = false;
        } else {
            slot.expressions.push_back(argument.value);
        }
    }
    return good;
}

// A tuple in place of the same number of number arguments stands for all of them:
// translate(corner) is translate(x, y, z). Returns their number; 0 if it does not.
std::size_t StageBuilder::assign_tuple(const StageEntry& row, ExpressionId value,
                                       std::span<const StageParameter* const> positions,
                                       std::vector<Given>& given) {
    const auto is_number = [](const StageParameter* parameter) {
        return parameter->type == ParameterType::number;
    };
    const auto numbers = static_cast<std::size_t>(
        std::find_if_not(positions.begin(), positions.end(), is_number) - positions.begin());
    if (numbers < 2) {
        return 0;
    }
    const auto tuple = evaluate_compound(tree_, value, scope_, *graph_, reporter_);
    if (!tuple || tuple->form != Value::Form::tuple || tuple->elements->size() > numbers) {
        return 0;
    }
    for (std::size_t i = 0; i < tuple->elements->size(); ++i) {
        given[static_cast<std::size_t>(positions[i] - row.parameters.data())].element =
            (*tuple->elements)[i];
    }
    return tuple->elements->size();
}

const StageParameter* StageBuilder::named_parameter(const StageEntry& row, const Identifier& name) {
    std::vector<std::string> known;
    for (const StageParameter& parameter : row.parameters) {
        if (parameter.name == name.text) {
            return &parameter;
        }
        known.emplace_back(parameter.name);
    }
    error(name.span, fmt::format("'{}' has no argument '{}'", row.name, name.text),
          known.empty() ? fmt::format("'{}' takes no arguments", row.name)
                        : suggestion(name.text, known, "its arguments are"));
    return nullptr;
}

// The first parameter that has the word as a choice.
const StageParameter* StageBuilder::parameter_of_word(const StageEntry& row,
                                                      const Identifier& word) {
    std::vector<std::string> known;
    for (const StageParameter& parameter : row.parameters) {
        for (const std::string_view choice : parameter.choices) {
            if (choice == word.text) {
                return &parameter;
            }
            known.emplace_back(choice);
        }
    }
    error(word.span, fmt::format("'{}' cannot be '{}'", row.name, word.text),
          known.empty() ? fmt::format("the syntax is {}", signature(row))
                        : suggestion(word.text, known, "the choices are"));
    return nullptr;
}

// -------------------------------------------------------------------- values of the arguments

bool StageBuilder::set_argument(const StageEntry& row, const StageParameter& parameter,
                                std::span<const ExpressionId> given, Arguments& arguments) {
    // `made` is an optional value or a pointer.
    const auto set = [&parameter, &arguments](auto made) {
        const bool good = static_cast<bool>(made);
        if constexpr (std::is_constructible_v<Arguments::Value, decltype(made)>) {
            if (good) {
                arguments.set(parameter.name, std::move(made));
            }
        } else if (good) {
            arguments.set(parameter.name, std::move(*made));
        }
        return good;
    };
    switch (parameter.type) {
        case ParameterType::choice: return set(choice(row, parameter, given.front()));
        case ParameterType::points: return set(points(row, parameter, given.front()));
        case ParameterType::image: return set(image(row, parameter, given.front()));
        case ParameterType::mesh: return set(mesh(row, parameter, given.front()));
        case ParameterType::curve: return set(curve(row, parameter, given.front()));
        case ParameterType::stage: return set(nested_stage(row, parameter, given.front()));
        case ParameterType::stages: return set(nested_stages(row, parameter, given));
        case ParameterType::formula: return set(formula_argument(row, parameter, given.front()));
        default: return set(numbers(row, parameter, given.front()));
    }
}

std::optional<std::string> StageBuilder::choice(const StageEntry& row,
                                                const StageParameter& parameter,
                                                ExpressionId given) {
    const Expression& node = tree_[given];
    const std::vector<std::string> words(parameter.choices.begin(), parameter.choices.end());
    if (node.kind != ExpressionKind::name) {
        error(node.span, fmt::format("'{}' of '{}' takes a name", parameter.name, row.name),
              fmt::format("write {}", one_of(words)));
        return std::nullopt;
    }
    if (std::find(words.begin(), words.end(), node.name.text) == words.end()) {
        error(node.span,
              fmt::format("'{}' of '{}' cannot be '{}'", parameter.name, row.name, node.name.text),
              suggestion(node.name.text, words, "it is"));
        return std::nullopt;
    }
    return std::string(node.name.text);
}

StageBuilder::Stage StageBuilder::nested_stage(const StageEntry& row,
                                               const StageParameter& parameter,
                                               ExpressionId given) {
    const Expression& node = tree_[given];
    if (!may_be_stage(node)) {
        const std::string_view kind = camera::name_of(parameter.stage_kind);
        error(node.span,
              fmt::format("'{}' of '{}' takes {}, but this is {}", parameter.name, row.name,
                          with_article(kind), described(node)),
              fmt::format("write {}, for example {}", with_article(kind),
                          example_of(parameter.stage_kind)));
        return nullptr;
    }
    return make_stage(parameter.stage_kind, given);
}

std::optional<std::vector<StageBuilder::Stage>> StageBuilder::nested_stages(
    const StageEntry& row, const StageParameter& parameter, std::span<const ExpressionId> given) {
    std::vector<Stage> made;
    for (const ExpressionId id : given) {
        if (Stage stage = nested_stage(row, parameter, id)) {
            made.push_back(std::move(stage));
        }
    }
    return made.size() == given.size() ? std::optional(std::move(made)) : std::nullopt;
}

StageBuilder::Stage StageBuilder::curve(const StageEntry& row, const StageParameter& parameter,
                                        ExpressionId given) {
    const Expression& node = tree_[given];
    if (!may_be_stage(node)) {
        error(node.span,
              fmt::format("'{}' of '{}' takes a curve, but this is {}", parameter.name, row.name,
                          described(node)),
              std::string(curve_remedy));
        return nullptr;
    }
    const auto made = make<camera::ObjectGenerator>(StageKind::object_generator, given);
    if (made && made->dimension() != 1) {
        error(node.span,
              fmt::format("'{}' of '{}' takes a curve, but '{}' is a {}", parameter.name, row.name,
                          node.name.text, made->dimension() == 0 ? "point" : "surface"),
              std::string(curve_remedy));
        return nullptr;
    }
    return made;
}

}  // namespace balcony::lang
