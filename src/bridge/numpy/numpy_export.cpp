// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as one Python function that computes many rays at a time with NumPy.

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "bridge/numpy/inverse_text.hpp"
#include "bridge/text/targets.hpp"
#include "bridge/text/text_export.hpp"

namespace balcony::bridge {

namespace {

constexpr std::string_view minimum_helper =
    "def _minimum(a, b):\n    return np.where(b < a, b, a)\n\n";
constexpr std::string_view maximum_helper =
    "def _maximum(a, b):\n    return np.where(a < b, b, a)\n\n";

constexpr Spellings numpy_spellings = spellings({
    function(Op::modulo, "_modulo", "def _modulo(a, b):\n    return a - b * np.floor(a / b)\n\n"),
    function(Op::minimum, "_minimum", minimum_helper),
    function(Op::maximum, "_maximum", maximum_helper),
    standard(Op::power, "power"),
    standard(Op::arcsine, "arcsin"),
    standard(Op::arccosine, "arccos"),
    standard(Op::arctangent, "arctan"),
    standard(Op::arctangent2, "arctan2"),
    standard(Op::inverse_hyperbolic_sine, "arcsinh"),
    standard(Op::inverse_hyperbolic_cosine, "arccosh"),
    standard(Op::inverse_hyperbolic_tangent, "arctanh"),
    symbol(Op::logical_and, "&"),
    symbol(Op::logical_or, "|"),
    standard(Op::logical_not, "logical_not"),
    standard(Op::is_finite, "isfinite"),
    standard(Op::select, "where"),
});

// Looks into a table as expr::Table does, for arrays of positions.
constexpr std::string_view lookup_helper = R"(
def _lookup(coefficients, axes, *at):
    """A piecewise polynomial over the cells of a box; axes: (first, last, cells, degree) each."""
    cell, steps = 0, []
    for (first, last, cells, _), a in zip(axes, at):
        position = (a - first) * (cells / (last - first))
        number = np.clip(np.nan_to_num(np.floor(position)), 0.0, cells - 1.0)
        cell = cell * cells + number.astype(int)
        steps.append(position - number)
    values = coefficients.reshape([-1] + [degree + 1 for *_, degree in axes])[cell]
    for step in reversed(steps):
        step = step[(...,) + (np.newaxis,) * (values.ndim - 1 - np.ndim(step))]
        value = values[..., -1]
        for power in range(values.shape[-1] - 2, -1, -1):
            value = value * step + values[..., power]
        values = value
    return values

)";

std::string number(double value) {
    return std::isfinite(value) ? decimal(value)
           : std::isnan(value)  ? "np.nan"
           : value > 0.0        ? "np.inf"
                                : "-np.inf";
}

const std::set<std::string_view> python_words{
    "False",   "None",     "True",     "and",    "as",        "assert", "async",  "await",
    "break",   "class",    "continue", "def",    "del",       "elif",   "else",   "except",
    "finally", "for",      "from",     "global", "if",        "import", "in",     "is",
    "lambda",  "nonlocal", "not",      "or",     "pass",      "raise",  "return", "try",
    "while",   "with",     "yield",    "np",     "x",         "y",      "t",      "width",
    "height",  "lens_x",   "lens_y",   "origin", "direction", "valid",  "slopes", "slope_0",
    "slope_1", "slope_2",  "slope_3"};

class NumpyExport : TextExport {
public:
    NumpyExport(const ExportSource& source, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), python_words) {}

    std::string text() {
        const Dialect dialect{.spellings = numpy_spellings,
                              .number = number,
                              .number_of_condition = "np.where({0}, 1.0, 0.0)",
                              .condition_of_number = "(({0}) != 0.0)",
                              .before_standard = "np."};
        const InputText input = [this](std::string_view name) { return input_name(name); };
        std::optional<Listing> slopes;
        if (formulas_.roots.size() > RayRoots::end_of_ray) {
            Names own = names_;
            slopes = listing_of(formulas_, dialect, own, "_slopes_", input);
            formulas_.roots.resize(RayRoots::end_of_ray);
        }
        const Listing made = listing_of(formulas_, dialect, names_, "_", input);
        std::string text = commented(opening_lines(source_), "#") + "\nimport numpy as np\n\n\n";
        std::vector<std::string> helpers = made.helpers;
        if (slopes) {
            helpers.insert(helpers.end(), slopes->helpers.begin(), slopes->helpers.end());
        }
        for (auto helper = helpers.begin(); helper != helpers.end(); ++helper) {
            text += std::find(helpers.begin(), helper, *helper) == helper ? *helper + "\n" : "";
        }
        text += made.tables.empty() && (!slopes || slopes->tables.empty())
                    ? std::string_view()
                    : lookup_helper.substr(1);
        text += tables(made) + (slopes ? tables(*slopes) : "") + function(made);
        return slopes ? text + inverse(*slopes) : text;
    }

private:
    // A table is an array of coefficients, and a function that looks into it.
    [[nodiscard]] static std::string tables(const Listing& listing) {
        std::string text;
        for (const ListedTable& listed : listing.tables) {
            std::string axes;
            for (const expr::Table::Axis& axis : listed.table->axes) {
                axes += fmt::format("({}, {}, {}, {}), ", number(axis.first), number(axis.last),
                                    axis.cells, axis.degree);
            }
            std::vector<std::string> values;
            for (const double value : listed.table->coefficients) {
                values.push_back(number(value));
            }
            text += fmt::format(
                "\n_coefficients{0} = np.array([{1}])\n\n\n"
                "def {0}(*at):\n    return _lookup(_coefficients{0}, ({2}), *at)\n\n",
                listed.name, wrapped(values, 4), axes);
        }
        return text.empty() ? text : text + "\n";
    }

    // The parameters behind x and y, and the same as arguments.
    [[nodiscard]] std::string given() const {
        std::string text = "width, height, t=0.0";
        text += formulas_.lens ? ", lens_x=0.0, lens_y=0.0" : "";
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            text += fmt::format(", {}={}", parameters_[i], number(source_.parameters[i].value));
        }
        return text;
    }
    [[nodiscard]] std::string inputs() const {
        std::string text = "width, height, t";
        text += formulas_.lens ? ", lens_x, lens_y" : "";
        for (const std::string& parameter : parameters_) {
            text += ", " + parameter;
        }
        return text;
    }

    [[nodiscard]] std::string function(const Listing& listing) const {
        const std::string head = fmt::format(
            "def {}_ray(x, y, {}):\n"
            "    \"\"\"The rays of points (x, y) of a picture of width x height pixels, at time "
            "t.\n"
            "\n"
            "    x is to the right and y down from the top left corner, with pixel centres at .5; "
            "both are\n"
            "    numbers or arrays. Returns origins and unit directions, arrays of shape (..., 3), "
            "and\n"
            "    whether there is a ray. {}\n{}"
            "    \"\"\"\n",
            name_, given(), world(formulas_.axes),
            formulas_.lens
                ? "    A ray passes the point (lens_x, lens_y) of the lens, each from -1 to 1.\n"
                : "");
        return head + body(listing) + "    return origin, direction, valid\n";
    }

    // The definitions of a function, and the ray.
    [[nodiscard]] std::string body(const Listing& listing) const {
        // NumPy's numbers are divided by 0 without an exception.
        std::string text = fmt::format(
            "    x, y = np.broadcast_arrays(np.asarray(x, float), np.asarray(y, float))\n"
            "    {0} = (np.asarray(a, float) for a in ({0}))\n"
            "    with np.errstate(all=\"ignore\"):\n",
            inputs());
        for (const ListedSection& section : listing.sections) {
            text += fmt::format("        # {}\n", comment_line(section.comment));
            for (const ListedLine& line : section.lines) {
                text += fmt::format("        {} = {}\n", line.name, line.text);
            }
            text += section.lines.empty() ? "" : "\n";
        }
        return text + vector(listing, "origin", RayRoots::origin) +
               vector(listing, "direction", RayRoots::direction) +
               fmt::format("        valid = ({}) & np.ones(x.shape, bool)\n",
                           listing.roots[RayRoots::valid].text);
    }

    // The rays with their derivatives, and the search that uses them.
    [[nodiscard]] std::string inverse(const Listing& slopes) const {
        std::string text = fmt::format(
            "\n\ndef {}_slopes(x, y, {}):\n"
            "    \"\"\"Rays, and the derivatives of origin by x and by y and of direction by x and "
            "by y.\"\"\"\n",
            name_, given());
        text += body(slopes);
        for (std::size_t i = 0; i < 4; ++i) {
            text += vector(slopes, fmt::format("slope_{}", i), RayRoots::origin_by_x + 3 * i);
        }
        text +=
            "        slopes = np.stack([slope_0, slope_1, slope_2, slope_3], axis=-2)\n"
            "    return origin, direction, valid, slopes\n";
        return text + replaced(std::string(numpy_inverse), "@", name_);
    }

    [[nodiscard]] static std::string vector(const Listing& listing, std::string_view name,
                                            std::size_t first) {
        std::string text = fmt::format("        {} = np.stack(np.broadcast_arrays(\n", name);
        for (std::size_t i = 0; i < 3; ++i) {
            text += fmt::format("            {},\n", listing.roots[first + i].text);
        }
        return text + "            x)[:3], axis=-1)\n";
    }
};

Result<std::string> write_numpy(const ExportSource& source, const ExportOptions&,
                                CameraFormulas formulas) {
    return NumpyExport(source, std::move(formulas)).text();
}

}  // namespace

ExportTarget numpy_target() {
    return {.name = "numpy",
            .meaning = "one Python function that computes many rays at a time with NumPy",
            .ending = ".py",
            .write = write_numpy,
            .has_inverse = true};
}

}  // namespace balcony::bridge
