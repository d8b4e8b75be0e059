// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "bridge/text/array_python.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "bridge/text/array_inverse.hpp"

namespace balcony::bridge {

namespace {

// Looks into a table as expr::Table does, for arrays of positions.
constexpr std::string_view lookup_helper = R"(
def _lookup(coefficients, axes, *at):
    """A piecewise polynomial over the cells of a box; axes: (first, last, cells, degree) each."""
    at = _arrays(*at)
    cell, steps = 0, []
    for (first, last, cells, _), a in zip(axes, at):
        position = (a - first) * (cells / (last - first))
        number = LIB.nan_to_num(LIB.floor(position)).clip(0.0, cells - 1.0)
        cell = cell * cells + numberWHOLE
        steps.append(position - number)
    values = coefficientsLIKE.reshape([-1] + [degree + 1 for *_, degree in axes])[cell]
    for step in reversed(steps):
        step = step[(...,) + (None,) * (values.ndim - 1 - step.ndim)]
        value = values[..., -1]
        for power in range(values.shape[-1] - 2, -1, -1):
            value = value * step + values[..., power]
        values = value
    return values

)";

std::set<std::string_view> reserved_names(const ArrayLibrary& library) {
    std::set<std::string_view> names = python_words();
    names.insert({library.name, "functools", "live"});
    return names;
}

class ArrayExport : TextExport {
public:
    ArrayExport(const ArrayLibrary& library, const ExportSource& source, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), reserved_names(library)), library_(library) {}

    std::string text() {
        const Dialect dialect{.spellings = library_.spellings,
                              .number = python_number,
                              .number_of_condition = library_.number_of_condition,
                              .condition_of_number = "(({0}) != 0.0)",
                              .before_standard = standard_,
                              .guarded = library_.guarded,
                              .words = {{"LIB", std::string(library_.name)}}};
        const InputText input = [this](std::string_view name) { return input_name(name); };
        std::optional<Listing> slopes;
        if (formulas_.roots.size() > RayRoots::end_of_ray) {
            Names own = names_;
            slopes = listing_of(formulas_, dialect, own, "_slopes_", input);
            formulas_.roots.resize(RayRoots::end_of_ray);
        }
        const Listing made = listing_of(formulas_, dialect, names_, "_", input);
        std::string text = commented(opening_lines(source_), "#") + "\n" +
                           std::string(library_.imports) + "\n\n" + in_library(library_.helpers);
        std::vector<std::string> helpers = made.helpers;
        if (slopes) {
            helpers.insert(helpers.end(), slopes->helpers.begin(), slopes->helpers.end());
        }
        for (auto helper = helpers.begin(); helper != helpers.end(); ++helper) {
            text += std::find(helpers.begin(), helper, *helper) == helper ? *helper + "\n" : "";
        }
        if (!made.tables.empty() || (slopes && !slopes->tables.empty())) {
            text += lookup();
        }
        text += python_tables(made, library_.table) +
                (slopes ? python_tables(*slopes, library_.table) : "") + rays(made);
        return slopes ? text + inverse(*slopes) : text;
    }

private:
    [[nodiscard]] std::string in_library(std::string_view text) const {
        return replaced(std::string(text), "LIB", library_.name);
    }

    [[nodiscard]] std::string lookup() const {
        std::string text = in_library(lookup_helper.substr(1));
        text = replaced(std::move(text), "WHOLE", library_.whole);
        return replaced(std::move(text), "LIKE", filled(library_.like, {"at[0]"})) + "\n";
    }

    // The parameters of a function, and the same as arguments.
    [[nodiscard]] std::string given() const {
        std::string text = "x, y, width, height, t=0.0";
        text += formulas_.lens ? ", lens_x=0.0, lens_y=0.0" : "";
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            text +=
                fmt::format(", {}={}", parameters_[i], python_number(source_.parameters[i].value));
        }
        return text;
    }
    [[nodiscard]] std::string inputs() const { return python_inputs(formulas_.lens, parameters_); }

    // The function of the formulas, and the one that users call.
    [[nodiscard]] std::string rays(const Listing& listing) const {
        return formulas(listing, name_, "") +
               fmt::format(
                   "def {0}_ray({1}):\n"
                   "    \"\"\"The rays of points (x, y) of a picture of width x height pixels, at "
                   "time t.\n"
                   "\n"
                   "    x is to the right and y down from the top left corner, with pixel centres "
                   "at .5; both are\n"
                   "    numbers or {2}. Returns origins and unit directions, {2} of shape (..., "
                   "3), "
                   "and\n"
                   "    whether there is a ray. {3}\n{4}{5}"
                   "    \"\"\"\n"
                   "    return _rays(_{0}_formulas, {6})\n",
                   name_, given(), library_.arrays, world(formulas_.axes),
                   formulas_.lens ? "    A ray passes the point (lens_x, lens_y) of the lens, each "
                                    "from -1 to 1.\n"
                                  : "",
                   library_.derivatives, inputs());
    }

    // The formulas as a function; with more results behind those of a ray.
    [[nodiscard]] std::string formulas(const Listing& listing, std::string_view name,
                                       const std::string& more) const {
        const std::string text = fmt::format("{}def _{}_formulas({}{}):\n", library_.decorator,
                                             name, library_.parameters, inputs());
        return text + python_definitions(listing) + vector(listing, "origin", RayRoots::origin) +
               vector(listing, "direction", RayRoots::direction) +
               fmt::format("    valid = (x == x) & (y == y) & ({})\n",
                           listing.roots[RayRoots::valid].text) +
               more +
               fmt::format("    return origin, direction, valid{}\n\n\n",
                           more.empty() ? "" : ", slopes");
    }

    // The rays with their derivatives, and the search that uses them.
    [[nodiscard]] std::string inverse(const Listing& slopes) const {
        std::string more;
        for (std::size_t i = 0; i < 4; ++i) {
            more += vector(slopes, fmt::format("slope_{}", i), RayRoots::origin_by_x + 3 * i);
        }
        more += fmt::format("    slopes = {}.stack([slope_0, slope_1, slope_2, slope_3], -2)\n",
                            library_.name);
        std::string text =
            "\n\n" + formulas(slopes, name_ + "_slopes", more) +
            fmt::format(
                "def {0}_slopes({1}):\n"
                "    \"\"\"Rays, and the derivatives of origin by x and by y and of direction by x "
                "and by y.\"\"\"\n"
                "    return _rays(_{0}_slopes_formulas, {2})\n\n\n",
                name_, given(), inputs()) +
            in_library(library_.inverse_helpers);
        std::string search = in_library(array_inverse.substr(2));
        search = replaced(std::move(search), "SEARCH", library_.searching);
        search = replaced(std::move(search), "FIND", library_.finding);
        return text + replaced(search + std::string(library_.behind_inverse), "$", name_);
    }

    [[nodiscard]] static std::string vector(const Listing& listing, std::string_view name,
                                            std::size_t first) {
        std::string text = fmt::format("    {} = _vector(\n        x,\n", name);
        for (std::size_t i = 0; i < 3; ++i) {
            text +=
                fmt::format("        {}{}\n", listing.roots[first + i].text, i == 2 ? ")" : ",");
        }
        return text;
    }

    const ArrayLibrary& library_;
    const std::string standard_ = std::string(library_.name) + ".";
};

}  // namespace

std::string python_number(double value) {
    return std::isfinite(value) ? decimal(value)
           : std::isnan(value)  ? "float(\"nan\")"
           : value > 0.0        ? "float(\"inf\")"
                                : "float(\"-inf\")";
}

const std::set<std::string_view>& python_words() {
    static const std::set<std::string_view> words{
        "False",   "None",     "True",     "and",    "as",        "assert", "async",  "await",
        "break",   "class",    "continue", "def",    "del",       "elif",   "else",   "except",
        "finally", "for",      "from",     "global", "if",        "import", "in",     "is",
        "lambda",  "nonlocal", "not",      "or",     "pass",      "raise",  "return", "try",
        "while",   "with",     "yield",    "float",  "x",         "y",      "t",      "width",
        "height",  "lens_x",   "lens_y",   "origin", "direction", "valid",  "slopes", "slope_0",
        "slope_1", "slope_2",  "slope_3"};
    return words;
}

std::string python_definitions(const Listing& listing) {
    std::string text;
    for (const ListedSection& section : listing.sections) {
        text += fmt::format("    # {}\n", comment_line(section.comment));
        for (const ListedLine& line : section.lines) {
            text += fmt::format("    {} = {}\n", line.name, line.text);
        }
        text += section.lines.empty() ? "" : "\n";
    }
    return text;
}

std::string python_inputs(bool lens, const ParameterNames& parameters) {
    std::string text = "x, y, width, height, t";
    text += lens ? ", lens_x, lens_y" : "";
    for (const std::string& parameter : parameters) {
        text += ", " + parameter;
    }
    return text;
}

std::string python_tables(const Listing& listing, std::string_view array) {
    std::string text;
    for (const ListedTable& listed : listing.tables) {
        std::string axes;
        for (const expr::Table::Axis& axis : listed.table->axes) {
            axes += fmt::format("({}, {}, {}, {}), ", python_number(axis.first),
                                python_number(axis.last), axis.cells, axis.degree);
        }
        std::vector<std::string> values;
        for (const double value : listed.table->coefficients) {
            values.push_back(python_number(value));
        }
        text += fmt::format(
            "_coefficients{0} = {1}\n\n\n"
            "def {0}(*at):\n    return _lookup(_coefficients{0}, ({2}), *at)\n\n\n",
            listed.name, filled(array, {wrapped(values, 4)}), axes);
    }
    return text;
}

std::string array_module(const ArrayLibrary& library, const ExportSource& source,
                         CameraFormulas formulas) {
    return ArrayExport(library, source, std::move(formulas)).text();
}

}  // namespace balcony::bridge
