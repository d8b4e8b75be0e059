// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as functions for the user_defined camera of POV-Ray 3.8.

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bridge/pov_functions/function_chain.hpp"
#include "bridge/pov_functions/spline_table.hpp"
#include "bridge/text/c_like.hpp"
#include "bridge/text/middle_of_lens.hpp"
#include "bridge/text/targets.hpp"

namespace balcony::bridge {

namespace {

// In these texts @ is the camera's name. POV-Ray computes infinities and NaN as IEEE 754 does, has
// conditions that are 1 or 0, and of the arguments of select() only those that it needs. Its own
// min(), mod() and comparisons > and >= differ from the graph's for NaN or negative numbers.
constexpr Spellings pov_spellings = spellings({
    function(Op::modulo, "@_modulo",
             "#declare @_modulo = function(x, y) { x - y * floor(x / y) }\n"),
    function(Op::minimum, "@_minimum",
             "#declare @_minimum = function(x, y) { select(-(y < x), y, x) }\n"),
    function(Op::maximum, "@_maximum",
             "#declare @_maximum = function(x, y) { select(-(x < y), y, x) }\n"),
    function(Op::sign, "@_sign",
             "#declare @_sign = function(x) { select(-(x = x), select(x, -1, 0, 1), x) }\n"),
    standard(Op::logarithm, "ln"),
    symbol(Op::equal, "="),
    symbol(Op::logical_and, "&"),
    symbol(Op::logical_or, "|"),
    pattern(Op::logical_not, "(1 - {0})"),
    function(Op::is_finite, "@_finite", "#declare @_finite = function(x) { x - x = 0 }\n"),
    pattern(Op::select, "select(-{0}, {1}, {2})"),
});

// POV-Ray has no literals for what is not finite.
std::string pov_number(double value) {
    return std::isfinite(value) ? decimal(value)
           : std::isnan(value)  ? "(1e308 * 10 - 1e308 * 10)"
           : value > 0.0        ? "(1e308 * 10)"
                                : "(-1e308 * 10)";
}

// POV-Ray keeps words without capital letters for itself.
std::string capitalised(std::string name) {
    if (name.front() >= 'a' && name.front() <= 'z') {
        name.front() = static_cast<char>(name.front() - 'a' + 'A');
    }
    return name.front() == '_' ? "Camera" + name : name;
}

// POV-Ray's limits: MAX_FUNCTION_PARAMETER_LIST, and MAX_CALL_STACK_SIZE less the functions that
// the last step calls, such as those of a line and of a table in it.
constexpr std::size_t max_parameters = 56;
constexpr std::size_t max_steps = 1024 - 8;

// POV-Ray reads and writes them as text: some 20 bytes each.
constexpr std::size_t max_table_size = 100'000;

constexpr std::string_view pov_axis = "axis";

constexpr std::string_view order_comment = R"(
// The order of evaluation, from the last function to the first: each passes on what it was given
// and what it computes, so that everything is computed once for each coordinate.
)";

/// The text of a listing.
class PovText {
public:
    /// `parameters` are their names in the scene; `names` are taken.
    PovText(const ExportSource& source, const std::vector<std::string>& parameters,
            std::string name, Axes axes, const Listing& listing, Names& names)
        : source_(source),
          parameters_(parameters),
          names_(names),
          name_(std::move(name)),
          axes_(axes),
          listing_(listing),
          dependence_(listing),
          location_(dependence_.chain(std::span(listing.roots).subspan(RayRoots::origin, 3))),
          direction_(dependence_.chain(std::span(listing.roots).subspan(RayRoots::direction))) {
        for (const ListedLine* line : dependence_.uniform()) {
            uniform_.insert(line->name);
        }
    }

    [[nodiscard]] std::size_t max_parameters() const {
        return 1 + std::max(location_.max_parameters(), direction_.max_parameters());
    }
    [[nodiscard]] std::size_t steps() const {
        return std::max(location_.steps.size(), direction_.steps.size());
    }

    [[nodiscard]] std::string text() const {
        std::string made = head() + inputs();
        for (const std::string& helper : listing_.helpers) {
            made += helper;
        }
        for (const ListedTable& table : listing_.tables) {
            made += spline_table(table, pov_number);
        }
        return made + lines() + std::string(order_comment) +
               chain_text("location", location_, coordinate(RayRoots::origin)) + "\n" +
               chain_text("direction", direction_, valid_direction()) + camera_text();
    }

private:
    [[nodiscard]] std::string in_scene(std::string_view name) const {
        return fmt::format("{}_{}", name_, name);
    }

    // The text of a line, in which lines that are numbers have their names in the scene.
    [[nodiscard]] std::string spelled(const std::string& text) const {
        const auto in_word = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        };
        std::string made;
        for (std::size_t i = 0; i < text.size();) {
            std::size_t end = i;
            while (end < text.size() && in_word(text[end])) {
                ++end;
            }
            const std::string word = text.substr(i, end - i);
            made += uniform_.contains(word) ? in_scene(word) : word;
            for (i = end; i < text.size() && !in_word(text[i]); ++i) {
                made += text[i];
            }
        }
        return made;
    }

    [[nodiscard]] std::string head() const {
        std::vector<std::string> lines = opening_lines(source_);
        lines.insert(
            lines.end(),
            {"",
             "For POV-Ray 3.8. Include this file at the top of a scene, before the scene declares "
             "names of its",
             fmt::format("own, and write  camera {{ {} }}", name_), "",
             fmt::format("{0}_location(axis, column, row) and {0}_direction(axis, column, row)",
                         name_),
             "give the coordinates of a ray, axis 0, 1 and 2, at a point of the picture in pixels "
             "from its top",
             "left corner. The direction has unit length; where there is no ray, it is 0.",
             axes_ == Axes::y_up
                 ? "The world is left-handed, with y up: Balcony's (x, y, z) with z up is <x, z, "
                   "y>."
                 : "The world is left-handed, with z up: Balcony's (x, y, z) with z up is <x, -y, "
                   "z>.",
             "A condition is 1 or 0, and select(-condition, a, b) is a where it holds, or b."});
        return commented(lines);
    }

    [[nodiscard]] std::string inputs() const {
        std::string text = fmt::format(
            "\n#declare {0}_picture_width = image_width;\n"
            "#declare {0}_picture_height = image_height;\n",
            name_);
        if (!source_.parameters.empty()) {
            text +=
                "\n// Declare these before including this file to change them. Angles are in "
                "radians.\n";
        }
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            const ExportParameter& parameter = source_.parameters[i];
            text += fmt::format("#ifndef ({0}) #declare {0} = {1}; #end  // {2}\n", parameters_[i],
                                pov_number(parameter.value), comment_line(parameter.written));
        }
        return text + "\n";
    }

    // A list in parentheses, on several lines if it is long.
    [[nodiscard]] static std::string enclosed_list(const std::vector<std::string>& items) {
        constexpr std::size_t longest = 60;
        std::string text = fmt::format("({})", fmt::join(items, ", "));
        return text.size() <= longest ? text : fmt::format("({})", wrapped(items, 8));
    }

    // What every line computes, stage by stage.
    [[nodiscard]] std::string lines() const {
        std::string text;
        for (const ListedSection& section : listing_.sections) {
            text += fmt::format("\n// {}\n", comment_line(section.comment));
            for (const ListedLine& line : section.lines) {
                const std::string formula = spelled(line.text);
                text += uniform_.contains(line.name)
                            ? fmt::format("#declare {} = ({});\n", in_scene(line.name), formula)
                            : function_text(in_scene(line.name), dependence_.varying(line.uses),
                                            formula);
            }
        }
        return text;
    }

    [[nodiscard]] std::string coordinate(std::size_t first) const {
        return fmt::format(
            "select({} - 1, {}, {}, {})", pov_axis, spelled(listing_.roots[first].text),
            spelled(listing_.roots[first + 1].text), spelled(listing_.roots[first + 2].text));
    }

    [[nodiscard]] std::string valid_direction() const {
        return fmt::format("select(-({}),\n        {},\n        0)",
                           spelled(listing_.roots[RayRoots::valid].text),
                           coordinate(RayRoots::direction));
    }

    // Functions NAME, NAME_2, NAME_3, ..., each of which calls the next one; declared before they
    // are called.
    [[nodiscard]] std::string chain_text(std::string_view wanted, const FunctionChain& chain,
                                         const std::string& result) const {
        const auto parameters = [&](std::size_t step) {
            const std::vector<std::string> point{std::string(point_x), std::string(point_y)};
            return step == 0                   ? point
                   : step < chain.steps.size() ? chain.steps[step].parameters
                                               : chain.result_parameters;
        };
        const std::size_t last = chain.steps.size();
        std::vector<std::string> names{in_scene(wanted)};
        for (std::size_t i = 1; i <= last; ++i) {
            names.push_back(in_scene(names_.unique(fmt::format("{}_{}", wanted, i + 1))));
        }
        std::string text = function_text(names[last], with_axis(parameters(last)), result);
        for (std::size_t i = last; i-- > 0;) {
            std::vector<std::string> arguments = parameters(i + 1);
            for (std::string& value : arguments) {
                value = argument(chain.steps[i], value);
            }
            text += function_text(names[i], with_axis(parameters(i)),
                                  names[i + 1] + enclosed_list(with_axis(std::move(arguments))));
        }
        return text;
    }

    [[nodiscard]] static std::vector<std::string> with_axis(std::vector<std::string> values) {
        values.insert(values.begin(), std::string(pov_axis));
        return values;
    }

    [[nodiscard]] static std::string function_text(const std::string& name,
                                                   const std::vector<std::string>& parameters,
                                                   const std::string& body) {
        constexpr std::size_t longest = 100;
        const std::string head =
            fmt::format("#declare {} = function{}", name, enclosed_list(parameters));
        const std::size_t last_line = head.size() - (head.rfind('\n') + 1);
        const char* space = last_line + body.size() + 5 > longest ? "\n    " : " ";
        return fmt::format("{}{}{{ {} }}\n", head, space, body);
    }

    // A value for the next step: computed in this one, or passed on.
    [[nodiscard]] std::string argument(const ChainStep& step, const std::string& value) const {
        for (const ListedLine* line : step.lines) {
            if (line->name == value) {
                return in_scene(value) +
                       fmt::format("({})", fmt::join(dependence_.varying(line->uses), ", "));
            }
        }
        return value;
    }

    [[nodiscard]] std::string camera_text() const {
        std::string text = fmt::format(
            "\n// POV-Ray's x is from -0.5 to 0.5 to the right, and its y upwards.\n"
            "#declare {0}_column = function(x) {{ (x + 0.5) * {0}_picture_width }}\n"
            "#declare {0}_row = function(y) {{ (0.5 - y) * {0}_picture_height }}\n"
            "#declare {0} = camera {{\n"
            "    user_defined\n",
            name_);
        for (const std::string_view part : {"location", "direction"}) {
            text += fmt::format("    {} {{\n", part);
            for (int axis = 0; axis < 3; ++axis) {
                text +=
                    fmt::format("        function {{ {0}_{1}({2}, {0}_column(x), {0}_row(y)) }}\n",
                                name_, part, axis);
            }
            text += "    }\n";
        }
        return text + "}\n";
    }

    const ExportSource& source_;
    const std::vector<std::string>& parameters_;
    Names& names_;
    const std::string name_;
    const Axes axes_;
    const Listing& listing_;
    const LineDependence dependence_;
    const FunctionChain location_;
    const FunctionChain direction_;
    std::set<std::string> uniform_;  ///< The names of lines that are numbers.
};

// The functions of a user_defined camera know nothing of an aperture.
Result<camera::Camera> without_aperture(const camera::Camera& camera) {
    return with_middle_of_lens(camera,
                               "the user_defined camera of POV-Ray has one ray for each point of "
                               "the picture",
                               "use 'balcony pov', which knows lenses");
}

class PovExport {
public:
    PovExport(const ExportSource& source, CameraFormulas formulas)
        : source_(source),
          formulas_(std::move(formulas)),
          name_(capitalised(names_.unique(source.camera.name()))) {
        for (const ExportParameter& parameter : source.parameters) {
            const std::string name = fmt::format("{}_{}", name_, names_.unique(parameter.name));
            parameters_.push_back(names_.unique(name));
        }
    }

    Result<std::string> text() {
        if (Diagnostics found = large_tables(); !found.empty()) {
            return found;
        }
        turn_to_the_left();
        const Dialect dialect{.spellings = pov_spellings,
                              .number = pov_number,
                              .condition_of_number = "({0} != 0)",
                              .words = {{"@", name_}}};
        const Listing listing =
            listing_of(formulas_, dialect, names_, name_ + "_",
                       [this](std::string_view input) { return input_text(input); });
        const PovText text(source_, parameters_, name_, formulas_.axes, listing, names_);
        if (text.max_parameters() > max_parameters || text.steps() > max_steps) {
            return too_large(text);
        }
        return text.text();
    }

private:
    [[nodiscard]] Diagnostics large_tables() const {
        for (const expr::NodeId id : expr::reachable(*formulas_.graph, formulas_.roots)) {
            if ((*formulas_.graph)[id].op != Op::call) {
                continue;
            }
            const std::size_t size = formulas_.graph->call_of(id).table->coefficients.size();
            if (size > max_table_size) {
                const StageFormulas* stage = stage_with(formulas_, id);
                return {error(
                    fmt::format("'{}' of the camera '{}' cannot be exported to POV-Ray: it looks "
                                "into a table of {} numbers; at most {} are possible",
                                stage != nullptr ? stage->written : "a stage",
                                source_.camera.name(), size, max_table_size),
                    {},
                    "render the scene with 'balcony pov', which takes any camera, or replace the "
                    "stage by a smaller one")};
            }
        }
        return {};
    }

    [[nodiscard]] Diagnostics too_large(const PovText& text) const {
        return {error(
            fmt::format("the camera '{}' is too large for POV-Ray: it needs functions with {} "
                        "parameters, called {} deep; at most {} and {} are possible",
                        source_.camera.name(), text.max_parameters(), text.steps(), max_parameters,
                        max_steps),
            {},
            "render the scene with 'balcony pov', which takes any camera, or use fewer stages")};
    }

    // POV-Ray's axes are left-handed: the axis that is neither to the right nor up is reversed.
    void turn_to_the_left() {
        const std::size_t depth = formulas_.axes == Axes::y_up ? 2 : 1;
        for (const std::size_t first : {RayRoots::origin, RayRoots::direction}) {
            Expr& root = formulas_.roots[first + depth];
            root = -root;
        }
    }

    [[nodiscard]] std::string input_text(std::string_view input) const {
        if (input == "x" || input == "y") {
            return std::string(input == "x" ? point_x : point_y);
        }
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            if (source_.parameters[i].input == input) {
                return parameters_[i];
            }
        }
        return input == "t" ? "clock" : fmt::format("{}_picture_{}", name_, input);
    }

    const ExportSource& source_;
    CameraFormulas formulas_;
    Names names_{{point_x, point_y, pov_axis, "picture_width", "picture_height", "location",
                  "direction", "finite", "modulo", "minimum", "maximum", "sign"}};
    const std::string name_;
    std::vector<std::string> parameters_;  ///< Their names in the scene.
};

Result<std::string> write_pov(const ExportSource& source, const ExportOptions&,
                              CameraFormulas formulas) {
    return PovExport(source, std::move(formulas)).text();
}

}  // namespace

ExportTarget pov_target() {
    return {.name = "pov",
            .meaning = "functions for the user_defined camera of POV-Ray 3.8",
            .ending = ".inc",
            .write = write_pov,
            .axes = Axes::y_up,
            .adapted = without_aperture};
}

}  // namespace balcony::bridge
