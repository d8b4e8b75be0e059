// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/catalogue.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "balcony/make_stage.hpp"
#include "camera/catalogue/families.hpp"
#include "camera/catalogue/parameter_text.hpp"

namespace balcony::camera {

std::string_view name_of(StageKind kind) {
    switch (kind) {
        case StageKind::picture_arranger: return "picture arranger";
        case StageKind::picture_mapper: return "picture mapper";
        case StageKind::parameter_transformer: return "parameter transformer";
        case StageKind::object_generator: return "object generator";
        case StageKind::object_transformer: return "object transformer";
        case StageKind::direction_rule: return "direction rule";
        case StageKind::stereo_view: return "stereo view";
        case StageKind::lens: return "lens";
        case StageKind::focus: return "focus";
        case StageKind::bend: return "bend";
        case StageKind::clip_shape: return "clip shape";
    }
    assert(false);
    return {};
}

std::string plural_of(StageKind kind) {
    const std::string_view name = name_of(kind);
    return fmt::format("{}{}", name, name.ends_with('s') ? "es" : "s");
}

std::string signature(std::string_view name, const FormulaShape& shape) {
    static constexpr std::array<std::string_view, 3> space = {"x", "y", "z"};
    static constexpr std::array<std::string_view, 2> parameter = {"u", "v"};
    std::string names(shape.names);
    for (std::size_t i = 0; shape.names.empty() && i < shape.parameters; ++i) {
        const bool in_space = shape.parameters > parameter.size();
        names += fmt::format("{}{}", i == 0 ? "" : ", ",
                             in_space ? space[std::min(i, space.size() - 1)] : parameter[i]);
    }
    static constexpr std::array<std::string_view, 4> forms = {"[]", "[a]", "[a, b]", "[a, b, c]"};
    const auto form = [](std::size_t count) { return forms[std::min(count, forms.size() - 1)]; };
    std::string text = fmt::format("{}({}) = {}", name, names, form(shape.min_results));
    if (shape.max_results > shape.min_results) {
        text += fmt::format(" or {}", form(shape.max_results));
    }
    return text;
}

std::string signature(const StageEntry& row) {
    if (row.shape) {
        return signature(row.name, *row.shape);
    }
    std::vector<std::string> parts;
    for (const StageParameter& parameter : row.parameters) {
        if (const auto* formula = parameter.as<FormulaParameter>()) {
            parts.push_back(signature(parameter.name, formula->shape));
            continue;
        }
        parts.emplace_back(parameter.name);
        const auto* nested = parameter.as<NestedStageParameter>();
        if (nested != nullptr && nested->several) {
            parts.emplace_back("...");
        }
    }
    return fmt::format("{}({})", row.name, fmt::join(parts, ", "));
}

// ---------------------------------------------------------------------------------- the rows

namespace {

using Rows = std::vector<StageEntry>;

void sort_by_kind(Rows& rows) {
    std::stable_sort(rows.begin(), rows.end(),
                     [](const StageEntry& a, const StageEntry& b) { return a.kind < b.kind; });
}

std::shared_ptr<const Rows> built_in_rows() {
    static const std::shared_ptr<const Rows> rows = [] {
        Rows all;
        for (const Family& family : families) {
            for (StageEntry& row : family.rows()) {
                row.kind = family.kind.value_or(row.kind);
                row.section = family.section;
                all.push_back(std::move(row));
            }
        }
        sort_by_kind(all);
        return std::make_shared<const Rows>(std::move(all));
    }();
    return rows;
}

bool is_name(std::string_view text) {
    const auto is_letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    return !text.empty() && is_letter(text.front()) &&
           std::all_of(text.begin(), text.end(), [&is_letter](char c) {
               return is_letter(c) || (c >= '0' && c <= '9') || c == '_';
           });
}

// What contradicts itself in the type of a parameter; empty if nothing does.
struct Contradiction {
    std::string operator()(const NumberParameter& type) const {
        return type.default_value ? of(type.range, std::span(&*type.default_value, 1))
                                  : of(type.range, {});
    }
    std::string operator()(const CountParameter& type) const {
        if (!(type.range.minimum >= 0.0 && type.range.maximum <= max_count)) {
            return fmt::format("its range must lie within 0 to {}", max_count);
        }
        if (type.default_value && std::floor(*type.default_value) != *type.default_value) {
            return "its default value must be a whole number";
        }
        return type.default_value ? of(type.range, std::span(&*type.default_value, 1))
                                  : of(type.range, {});
    }
    std::string operator()(const PairParameter& type) const {
        return type.default_value ? of(type.range, *type.default_value) : of(type.range, {});
    }
    std::string operator()(const TripleParameter& type) const {
        return type.default_value ? of(type.range, *type.default_value) : of(type.range, {});
    }
    std::string operator()(const ChoiceParameter& type) const {
        return type.choices.empty() ? "it has no choices" : "";
    }
    std::string operator()(const PointsParameter& type) const {
        const auto& counts = type.coordinates;
        const bool good =
            !counts.empty() && std::find(counts.begin(), counts.end(), 0U) == counts.end();
        return good ? "" : "its points have no co-ordinates";
    }
    std::string operator()(const NestedStageParameter& type) const {
        return type.dimension && type.kind != StageKind::object_generator
                   ? "only object generators have a dimension"
                   : "";
    }
    std::string operator()(const FormulaParameter& type) const { return of(type.shape); }
    template <class Other>
    std::string operator()(const Other&) const {
        return {};
    }

    static std::string of(const FormulaShape& shape) {
        return shape.min_results >= 1 && shape.min_results <= shape.max_results
                   ? ""
                   : "its formula must have results";
    }

private:
    static constexpr double max_count = 1e6;

    static std::string of(const Range& range, std::span<const double> default_value) {
        if (!(range.minimum <= range.maximum)) {
            return "its range is empty";
        }
        return std::all_of(default_value.begin(), default_value.end(),
                           [&range](double value) { return contains(range, value); })
                   ? ""
                   : "its default value is outside its range";
    }
};

}  // namespace

Diagnostics check(const StageEntry& row) {
    Diagnostics found;
    const auto report = [&found, &row](std::string_view parameter, std::string_view what) {
        found.push_back(error(parameter.empty() ? fmt::format("the row of '{}': {}", row.name, what)
                                                : fmt::format("the row of '{}', parameter '{}': {}",
                                                              row.name, parameter, what)));
    };
    if (!is_name(row.name)) {
        report("", "a name is made of letters, digits and _, and begins with a letter");
    }
    if (!row.make) {
        report("", "it has no maker");
    }
    if (row.shape && !row.parameters.empty()) {
        report("", "a stage that is a formula has no parameters");
    }
    if (row.shape && !Contradiction::of(*row.shape).empty()) {
        report("", Contradiction::of(*row.shape));
    }
    const StageParameter* takes_the_rest = nullptr;
    for (const StageParameter& parameter : row.parameters) {
        if (!is_name(parameter.name)) {
            report(parameter.name,
                   "a name is made of letters, digits and _, and begins with a letter");
        }
        const auto first = std::find_if(
            row.parameters.begin(), row.parameters.end(),
            [&parameter](const StageParameter& one) { return one.name == parameter.name; });
        if (&*first != &parameter) {
            report(parameter.name, "there are two parameters of this name");
        }
        if (const std::string what = std::visit(Contradiction{}, parameter.type); !what.empty()) {
            report(parameter.name, what);
        }
        if (takes_the_rest != nullptr && parameter.as<FormulaParameter>() == nullptr) {
            report(takes_the_rest->name, "what takes all arguments that are left must be the last");
        }
        const auto* nested = parameter.as<NestedStageParameter>();
        takes_the_rest = nested != nullptr && nested->several ? &parameter : takes_the_rest;
    }
    return found;
}

Catalogue::Catalogue() : rows_(built_in_rows()) {}

Diagnostics Catalogue::add(StageEntry row) {
    Diagnostics found = check(row);
    if (find(row.kind, row.name) != nullptr) {
        found.push_back(error(
            fmt::format("there is {} '{}' already", with_article(name_of(row.kind)), row.name), {},
            "give the new one another name"));
    }
    if (found.empty()) {
        auto rows = std::make_shared<Rows>(*rows_);
        rows->push_back(std::move(row));
        sort_by_kind(*rows);
        rows_ = std::move(rows);
    }
    return found;
}

const StageEntry* Catalogue::find(StageKind kind, std::string_view name) const {
    const auto row = std::find_if(rows_->begin(), rows_->end(), [&](const StageEntry& entry) {
        return entry.kind == kind && entry.name == name;
    });
    return row != rows_->end() ? &*row : nullptr;
}

const Catalogue& catalogue() {
    static const Catalogue built_in;
    return built_in;
}

// ----------------------------------------------------------------------------------- arguments

void Arguments::set(std::string_view name, Value value) {
    std::erase_if(values_, [&](const auto& named) { return named.first == name; });
    values_.emplace_back(name, std::move(value));
}

const Arguments::Value* Arguments::find(std::string_view name) const {
    const auto entry = std::find_if(values_.begin(), values_.end(),
                                    [&](const auto& named) { return named.first == name; });
    return entry != values_.end() ? &entry->second : nullptr;
}

const Arguments::Value& Arguments::value(std::string_view name) const {
    const Value* given = find(name);
    assert(given != nullptr && "a maker uses only parameters of its row");
    return *given;
}

bool Arguments::has(std::string_view name) const { return find(name) != nullptr; }

Scalar Arguments::number(std::string_view name) const {
    return std::get<std::vector<Scalar>>(value(name)).at(0);
}

double Arguments::constant(std::string_view name) const {
    const std::optional<double> known = number(name).constant();
    assert(known && "the row says that it is constant");
    return *known;
}

std::size_t Arguments::count(std::string_view name) const {
    return static_cast<std::size_t>(constant(name));
}

std::array<Scalar, 2> Arguments::pair(std::string_view name) const {
    const auto& numbers = std::get<std::vector<Scalar>>(value(name));
    return {numbers.at(0), numbers.at(1)};
}

std::array<Scalar, 3> Arguments::triple(std::string_view name) const {
    const auto& numbers = std::get<std::vector<Scalar>>(value(name));
    return {numbers.at(0), numbers.at(1), numbers.at(2)};
}

const std::string& Arguments::choice(std::string_view name) const {
    return std::get<std::string>(value(name));
}

const PointList& Arguments::points(std::string_view name) const {
    return std::get<PointList>(value(name));
}

ObjectGeneratorPointer Arguments::curve(std::string_view name) const {
    return stage<ObjectGenerator>(name);
}

const Formula& Arguments::formula(std::string_view name) const {
    return std::get<Formula>(value(name));
}

}  // namespace balcony::camera
