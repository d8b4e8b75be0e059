// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as one C99 function.

#include <cmath>

#include <fmt/format.h>

#include "bridge/text/c_like.hpp"
#include "bridge/text/targets.hpp"

namespace balcony::bridge {

namespace {

// In these texts @ is the camera's name, ~ the suffix of functions in single precision, and REAL
// the type of numbers.
constexpr Spellings c_spellings{
    structure(Op::constant),
    structure(Op::input),
    structure(Op::variable),
    symbol(Op::negate, "-"),
    symbol(Op::add, "+"),
    symbol(Op::subtract, "-"),
    symbol(Op::multiply, "*"),
    symbol(Op::divide, "/"),
    function(Op::modulo, "@_modulo",
             "static REAL @_modulo(REAL a, REAL b) { return a - b * floor~(a / b); }\n"),
    function(Op::minimum, "@_minimum",
             "static REAL @_minimum(REAL a, REAL b) { return b < a ? b : a; }\n"),
    function(Op::maximum, "@_maximum",
             "static REAL @_maximum(REAL a, REAL b) { return a < b ? b : a; }\n"),
    function(Op::absolute, "fabs~"),
    function(Op::sign, "@_sign",
             "static REAL @_sign(REAL a) { return a > 0 ? 1 : a < 0 ? -1 : a; }\n"),
    function(Op::floor, "floor~"),
    function(Op::square_root, "sqrt~"),
    function(Op::power, "pow~"),
    function(Op::exponential, "exp~"),
    function(Op::logarithm, "log~"),
    function(Op::sine, "sin~"),
    function(Op::cosine, "cos~"),
    function(Op::tangent, "tan~"),
    function(Op::arcsine, "asin~"),
    function(Op::arccosine, "acos~"),
    function(Op::arctangent, "atan~"),
    function(Op::arctangent2, "atan2~"),
    function(Op::hyperbolic_sine, "sinh~"),
    function(Op::hyperbolic_cosine, "cosh~"),
    function(Op::hyperbolic_tangent, "tanh~"),
    function(Op::inverse_hyperbolic_sine, "asinh~"),
    function(Op::inverse_hyperbolic_cosine, "acosh~"),
    function(Op::inverse_hyperbolic_tangent, "atanh~"),
    symbol(Op::less, "<"),
    symbol(Op::less_equal, "<="),
    symbol(Op::equal, "=="),
    symbol(Op::logical_and, "&&"),
    symbol(Op::logical_or, "||"),
    symbol(Op::logical_not, "!"),
    function(Op::is_finite, "isfinite"),
    pattern(Op::select, "({0} ? {1} : {2})"),
    structure(Op::call),
    structure(Op::result),
};
static_assert(complete(c_spellings));

std::string double_literal(double value) {
    return std::isfinite(value) ? decimal(value)
           : std::isnan(value)  ? "NAN"
           : value > 0.0        ? "INFINITY"
                                : "(-INFINITY)";
}

std::string float_literal(double value) {
    const double rounded = static_cast<double>(static_cast<float>(value));
    return std::isfinite(rounded) ? single_decimal(value) + "f" : double_literal(rounded);
}

template <bool single>
std::string c_array(std::string_view name, const std::vector<std::string>& values) {
    return fmt::format("static const {} {}[{}] = {{{}}};", single ? "float" : "double", name,
                       values.size(), wrapped(values, 8));
}

// Words of C, and names that the text needs itself.
const std::set<std::string_view> c_words{
    "auto",     "break",  "case",      "char",      "const",    "continue", "default",  "do",
    "double",   "else",   "enum",      "extern",    "float",    "for",      "goto",     "if",
    "inline",   "int",    "long",      "register",  "restrict", "return",   "short",    "signed",
    "sizeof",   "static", "struct",    "switch",    "typedef",  "union",    "unsigned", "void",
    "volatile", "while",  "x",         "y",         "t",        "width",    "height",   "lens_x",
    "lens_y",   "origin", "direction", "parameters"};

class CExport {
public:
    CExport(const ExportSource& source, const ExportOptions& options)
        : source_(source),
          single_(options.single),
          axes_(options.axes.value_or(source.camera.parts().axes)),
          name_(Names().unique(source.camera.name())),
          members_(source.parameters, names_) {}

    Result<std::string> run() {
        const Result<CameraFormulas> formulas = formulas_of(source_.camera, {axes_, false});
        if (!formulas) {
            return formulas.diagnostics;
        }
        lens_ = formulas->lens;
        const Dialect dialect{
            c_spellings,   number_,
            "(REAL)({0})", "(({0}) != 0)",
            single_,       {{"@", name_}, {"~", single_ ? "f" : ""}, {"REAL", std::string(real_)}}};
        const Listing listing =
            listing_of(*formulas, dialect, names_, name_ + "_",
                       [this](std::string_view input) { return input_text(input); });
        const CLike language{real_,
                             "int",
                             "const ",
                             "static ",
                             single_ ? "floorf" : "floor",
                             "(int){0}",
                             number_,
                             single_ ? c_array<true> : c_array<false>};
        std::string text = head() + "\n#include <math.h>\n\n" + parameter_struct();
        text += functions(language, listing);
        return text + signature() + " {\n" + unused_inputs(listing) +
               definitions(language, listing) + results(listing) + "}\n";
    }

private:
    [[nodiscard]] std::string input_text(std::string_view input) const {
        const auto parameter = members_.of_input(input);
        return parameter ? "parameters->" + members_[*parameter] : std::string(input);
    }

    [[nodiscard]] std::string head() const {
        std::vector<std::string> lines = opening_lines(source_);
        lines.insert(
            lines.end(),
            {"",
             fmt::format("{}_ray() gives the ray of a point (x, y) of a picture of width x "
                         "height pixels at time t:",
                         name_),
             "x to the right and y down from the top left corner, pixel centres at .5. It returns "
             "1 with the",
             "ray's origin and its direction of unit length, or 0 where there is no ray.",
             world(axes_)});
        if (lens_) {
            const std::vector<std::string> more = lens_lines();
            lines.insert(lines.end(), more.begin(), more.end());
        }
        return commented(lines);
    }

    [[nodiscard]] std::string parameter_struct() const {
        if (source_.parameters.empty()) {
            return {};
        }
        std::string text = "// Angles are in radians.\ntypedef struct {\n";
        std::vector<std::string> values;
        for (std::size_t i = 0; i < members_.size(); ++i) {
            const ExportParameter& parameter = source_.parameters[i];
            text += fmt::format("    {} {};  // {}\n", real_, members_[i],
                                comment_line(parameter.written));
            values.push_back(number_(parameter.value));
        }
        return text + fmt::format(
                          "}} {0}_parameters;\n\n"
                          "static inline {0}_parameters {0}_defaults(void) {{\n"
                          "    const {0}_parameters values = {{{1}}};\n"
                          "    return values;\n}}\n\n",
                          name_, fmt::join(values, ", "));
    }

    [[nodiscard]] std::string signature() const {
        return fmt::format(
            "int {0}_ray({1} x, {1} y, {1} width, {1} height, {1} t,{2}{3}\n"
            "        {1} origin[3], {1} direction[3])",
            name_, real_, lens_ ? fmt::format(" {0} lens_x, {0} lens_y,", real_) : "",
            source_.parameters.empty()
                ? ""
                : fmt::format("\n        const {}_parameters* parameters,", name_));
    }

    // Compilers warn of parameters that a function does not use.
    [[nodiscard]] std::string unused_inputs(const Listing& listing) const {
        std::vector<std::string> inputs{"x", "y", "width", "height", "t"};
        if (lens_) {
            inputs.insert(inputs.end(), {"lens_x", "lens_y"});
        }
        std::string text;
        for (const std::string& input : inputs) {
            if (!listing.uses(input)) {
                text += fmt::format("    (void){};\n", input);
            }
        }
        return text;
    }

    [[nodiscard]] static std::string results(const Listing& listing) {
        std::string text = "\n";
        for (std::size_t i = 0; i < 3; ++i) {
            text += fmt::format("    origin[{}] = {};\n", i,
                                listing.roots[CameraFormulas::origin + i].text);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            text += fmt::format("    direction[{}] = {};\n", i,
                                listing.roots[CameraFormulas::direction + i].text);
        }
        return text + fmt::format("    return {};\n", listing.roots[CameraFormulas::valid].text);
    }

    const ExportSource& source_;
    const bool single_;
    const std::string_view real_ = single_ ? "float" : "double";
    std::string (*const number_)(double) = single_ ? float_literal : double_literal;
    const Axes axes_;
    Names names_{c_words};
    const std::string name_;
    const ParameterNames members_;  ///< The names of the parameters in their structure.
    bool lens_ = false;
};

Result<std::string> write_c(const ExportSource& source, const ExportOptions& options) {
    return CExport(source, options).run();
}

}  // namespace

ExportTarget c_target() {
    return {"c", "one C99 function, in double or single precision", ".c", false, false, write_c};
}

}  // namespace balcony::bridge
