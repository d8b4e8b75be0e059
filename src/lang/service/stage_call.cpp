// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "lang/service/stage_call.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "camera/catalogue/parameter_text.hpp"
#include "camera/catalogue/stage_text.hpp"
#include "lang/service/own_names.hpp"
#include "lang/syntax/parser.hpp"

namespace balcony::lang {

namespace {

using camera::Range;
using camera::StageEntry;
using camera::StageParameter;
using camera::Unit;

constexpr int deepest_calls = 3;

std::string within(const Range& range, Unit unit) {
    const double usual = unit == Unit::angle ? 30.0 * radians_per_degree : 1.0;
    const double low =
        range.excludes_minimum && usual <= range.minimum
            ? range.minimum +
                  (std::isfinite(range.maximum) ? 0.5 * (range.maximum - range.minimum) : 1.0)
            : range.minimum;
    return camera::number_text(std::min(std::max(usual, low), range.maximum), unit);
}

// surface(u, v) = [0, 0, 0]
std::string formula_text(std::string_view name, const camera::FormulaShape& shape) {
    const std::string names = !shape.names.empty()    ? std::string(shape.names)
                              : shape.parameters == 2 ? "u, v"
                              : shape.parameters == 3 ? "x, y, z"
                                                      : "u";
    return fmt::format("{}({}) = [{}]", name, names,
                       fmt::join(std::vector<std::string_view>(shape.min_results, "1"), ", "));
}

struct SimplestValue {
    std::string operator()(const camera::NumberParameter& type) const {
        return within(type.range, type.unit);
    }
    std::string operator()(const camera::CountParameter& type) const {
        return within(type.range, Unit::number);
    }
    std::string operator()(const camera::PairParameter& type) const {
        const std::string one = within(type.range, type.unit);
        return fmt::format("({}, {})", one, one);
    }
    std::string operator()(const camera::TripleParameter&) const { return "(1, 0, 0)"; }
    std::string operator()(const camera::ChoiceParameter& type) const {
        return std::string(type.choices.front());
    }
    std::string operator()(const camera::PointsParameter& type) const {
        std::vector<std::string> points;
        for (std::size_t i = 0; i < std::max<std::size_t>(type.min_points, 2); ++i) {
            const std::string numbers =
                fmt::format("{}", fmt::join(std::vector(type.coordinates.front(), i), ", "));
            points.push_back(camera::is_numbers(type) ? numbers : fmt::format("({})", numbers));
        }
        return fmt::format("[{}]", fmt::join(points, ", "));
    }
    std::string operator()(const camera::NestedStageParameter& type) const;
    std::string operator()(const camera::FormulaParameter& type) const {
        return formula_text(name, type.shape);
    }
    std::string operator()(const camera::NameParameter&) const { return "\"name\""; }
    std::string operator()(const camera::ImageParameter&) const { return "\"image.png\""; }
    std::string operator()(const camera::MeshParameter&) const { return "\"mesh.obj\""; }
    std::string operator()(const camera::MapParameter&) const { return "\"map.exr\""; }
    std::string operator()(const camera::CalibrationParameter&) const {
        return "\"calibration.yml\"";
    }
    std::string operator()(const camera::PrescriptionParameter&) const { return "\"lens.dat\""; }

    std::string_view name;
    const camera::Catalogue& catalogue;
    int depth;
};

// Parts of the text of an example, which outlives the row.
struct Example {
    Example() = default;
    Example(const StageEntry& row, const camera::Catalogue& catalogue) {
        Reporter ignored;
        tree = parse(std::make_shared<const SourceText>("example", std::string(row.example)),
                     catalogue, ignored);
        names = own_names(tree);
        for (const Expression& node : tree.expressions) {
            const bool is_call =
                node.kind == ExpressionKind::call || node.kind == ExpressionKind::formula;
            if (is_call && node.name.text == row.name && call == nullptr) {
                call = &node;
            }
        }
    }

    // Whether a part means the same elsewhere: it uses no name that the example declares.
    [[nodiscard]] bool stands_alone(const Expression& node, ExpressionId last) const {
        for (std::size_t i = node.first.value(); i <= last.value(); ++i) {
            const Expression& part = tree.expressions[i];
            const bool names_value =
                part.kind == ExpressionKind::name || part.kind == ExpressionKind::call;
            if (names_value &&
                find_name(names, part.name.text, part.span.begin, false) != nullptr) {
                return false;
            }
        }
        return true;
    }

    [[nodiscard]] std::string_view given(const StageEntry& row,
                                         const StageParameter& parameter) const {
        if (call == nullptr || call->kind != ExpressionKind::call) {
            return {};
        }
        std::size_t position = 0;
        for (const StageParameter& one : row.parameters) {
            if (&one == &parameter) {
                break;
            }
            position += one.as<camera::FormulaParameter>() != nullptr ? 0 : 1;
        }
        const bool is_formula = parameter.as<camera::FormulaParameter>() != nullptr;
        std::size_t unnamed = 0;
        for (const Argument& argument : call->arguments) {
            const Expression& value = tree[argument.value];
            const bool formula =
                value.kind == ExpressionKind::formula && value.name.text == parameter.name;
            const bool fits = is_formula      ? formula
                              : argument.name ? argument.name->text == parameter.name
                                              : unnamed == position && !formula;
            unnamed += argument.name || value.kind == ExpressionKind::formula ? 0 : 1;
            if (fits && stands_alone(value, argument.value)) {
                return tree.text(value.span);
            }
        }
        return {};
    }

    SyntaxTree tree;
    std::vector<OwnName> names;
    const Expression* call = nullptr;
};

class Writer {
public:
    Writer(const StageEntry& row, const camera::Catalogue& catalogue, int depth)
        : row_(row), catalogue_(catalogue), depth_(depth) {
        if (depth == 0 && !row.example.empty()) {
            example_ = Example(row, catalogue);
        }
    }

    StageCall write() {
        made_.text = row_.name;
        // Values that belong together are taken from it together.
        example_is_whole_ =
            std::all_of(row_.parameters.begin(), row_.parameters.end(), [this](const auto& one) {
                return one.optional || !camera::default_text(one).empty() ||
                       !example_.given(row_, one).empty();
            });
        if (row_.shape) {
            write_formula();
            return std::move(made_);
        }
        bool is_first = true;
        for (const StageParameter& parameter : row_.parameters) {
            const std::string built_in = camera::default_text(parameter);
            if (parameter.optional || (built_in.empty() && is_choice(parameter))) {
                continue;
            }
            made_.text += is_first ? "(" : ", ";
            is_first = false;
            argument(parameter, built_in);
        }
        made_.text += is_first ? "" : ")";
        return std::move(made_);
    }

private:
    static bool is_choice(const StageParameter& parameter) {
        return parameter.as<camera::ChoiceParameter>() != nullptr;
    }

    void write_formula() {
        const Expression* call = example_.call;
        const bool is_usable = call != nullptr && call->kind == ExpressionKind::formula && [&] {
            for (const Argument& result : call->arguments) {
                if (!example_.stands_alone(example_.tree[result.value], result.value)) {
                    return false;
                }
            }
            return true;
        }();
        made_.text = is_usable ? std::string(example_.tree.text(call->span))
                               : formula_text(row_.name, *row_.shape);
        const std::size_t begin = made_.text.find('[') + 1;
        made_.blanks.push_back({begin, made_.text.size() - 1});
    }

    // Several stages have no name, nor has what stands before them.
    [[nodiscard]] bool is_unnamed(const StageParameter& parameter) const {
        return std::any_of(&parameter, row_.parameters.data() + row_.parameters.size(),
                           [](const StageParameter& one) {
                               const auto* nested = one.as<camera::NestedStageParameter>();
                               return nested != nullptr && nested->several;
                           });
    }

    void argument(const StageParameter& parameter, const std::string& built_in) {
        const bool is_formula = parameter.as<camera::FormulaParameter>() != nullptr;
        if (!is_formula && !is_unnamed(parameter)) {
            made_.text += fmt::format("{} = ", parameter.name);
        }
        std::string value = built_in;
        if (value.empty() && example_is_whole_) {
            value = example_.given(row_, parameter);
        }
        if (value.empty()) {
            value = std::visit(SimplestValue{parameter.name, catalogue_, depth_}, parameter.type);
        }
        made_.blanks.push_back({made_.text.size(), made_.text.size() + value.size()});
        made_.text += value;
    }

    const StageEntry& row_;
    const camera::Catalogue& catalogue_;
    const int depth_;
    Example example_;
    bool example_is_whole_ = false;
    StageCall made_;
};

// The stage of a kind with the shortest call that names no file.
std::string SimplestValue::operator()(const camera::NestedStageParameter& type) const {
    std::string shortest;
    for (const StageEntry& row : catalogue) {
        if (row.kind != type.kind || (type.dimension && row.dimension != *type.dimension) ||
            depth >= deepest_calls) {
            continue;
        }
        const bool nests = std::any_of(row.parameters.begin(), row.parameters.end(), [](auto& one) {
            return one.template as<camera::NestedStageParameter>() != nullptr;
        });
        if (nests || row.shape) {
            continue;
        }
        std::string text = Writer(row, catalogue, depth + 1).write().text;
        const bool is_short = shortest.empty() || text.size() < shortest.size();
        if (is_short && text.find('"') == std::string::npos) {
            shortest = std::move(text);
        }
    }
    return shortest;
}

}  // namespace

std::string argument_of(const StageParameter& parameter, const camera::Catalogue& catalogue) {
    std::string value = camera::default_text(parameter);
    if (value.empty()) {
        value = std::visit(SimplestValue{parameter.name, catalogue, 0}, parameter.type);
    }
    const bool names_itself = parameter.as<camera::FormulaParameter>() != nullptr;
    return names_itself ? value : fmt::format("{} = {}", parameter.name, value);
}

StageCall whole_call(const StageEntry& row, const camera::Catalogue& catalogue) {
    return Writer(row, catalogue, 0).write();
}

}  // namespace balcony::lang
