// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as one C99 function.

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "bridge/c/inverse_text.hpp"
#include "bridge/text/targets.hpp"
#include "bridge/text/text_export.hpp"

namespace balcony::bridge {

namespace {

// In these texts @ is the camera's name, ~ the suffix of functions in single precision, and REAL
// the type of numbers.
constexpr Spellings c_spellings = spellings({
    function(Op::modulo, "@_modulo",
             "static REAL @_modulo(REAL a, REAL b) { return a - b * floor~(a / b); }\n"),
    function(Op::minimum, "@_minimum",
             "static REAL @_minimum(REAL a, REAL b) { return b < a ? b : a; }\n"),
    function(Op::maximum, "@_maximum",
             "static REAL @_maximum(REAL a, REAL b) { return a < b ? b : a; }\n"),
    standard(Op::absolute, "fabs"),
    function(Op::sign, "@_sign",
             "static REAL @_sign(REAL a) { return a > 0 ? 1 : a < 0 ? -1 : a; }\n"),
    function(Op::is_finite, "isfinite"),
});

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
    "auto",     "break",  "case",      "char",       "const",    "continue", "default",  "do",
    "double",   "else",   "enum",      "extern",     "float",    "for",      "goto",     "if",
    "inline",   "int",    "long",      "register",   "restrict", "return",   "short",    "signed",
    "sizeof",   "static", "struct",    "switch",     "typedef",  "union",    "unsigned", "void",
    "volatile", "while",  "x",         "y",          "t",        "width",    "height",   "lens_x",
    "lens_y",   "origin", "direction", "parameters", "slopes"};

class CExport : TextExport {
public:
    CExport(const ExportSource& source, const ExportOptions& options, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), c_words), single_(options.single) {}

    std::string text() {
        const Dialect dialect{
            .spellings = c_spellings,
            .number = number_,
            .number_of_condition = "(REAL)({0})",
            .condition_of_number = "(({0}) != 0)",
            .single = single_,
            .behind_standard = suffix_,
            .words = {{"@", name_}, {"~", std::string(suffix_)}, {"REAL", std::string(real_)}}};
        const InputText input = [this](std::string_view name) { return input_text(name); };
        const CLike language{real_,
                             "int",
                             "const ",
                             "static ",
                             single_ ? "floorf" : "floor",
                             "(int){0}",
                             number_,
                             single_ ? c_array<true> : c_array<false>};
        std::optional<Listing> slopes;
        if (formulas_.roots.size() > RayRoots::end_of_ray) {
            Names own = names_;
            slopes = listing_of(formulas_, dialect, own, name_ + "_slopes_", input);
            formulas_.roots.resize(RayRoots::end_of_ray);
        }
        const Listing made = listing(dialect, input);
        std::string text =
            comment(
                {"x to the right and y down from the top left corner, pixel centres at .5. It "
                 "returns 1 with the",
                 "ray's origin and its direction of unit length, or 0 where there is no ray."}) +
            "\n#include <math.h>\n\n" + parameter_struct();
        text += functions(language, made);
        text += "int " + signature("ray", "") + " {\n" + unused_inputs(made) +
                definitions(language, made) + results(made) + "}\n";
        return slopes ? text + inverse(language, dialect, made, std::move(*slopes)) : text;
    }

private:
    [[nodiscard]] std::string input_text(std::string_view input) const {
        return (parameters_.of_input(input) ? "parameters->" : "") + input_name(input);
    }

    [[nodiscard]] std::string parameter_struct() const {
        if (source_.parameters.empty()) {
            return {};
        }
        std::string text = "// Angles are in radians.\ntypedef struct {\n";
        std::vector<std::string> values;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            const ExportParameter& parameter = source_.parameters[i];
            text += fmt::format("    {} {};  // {}\n", real_, parameters_[i],
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

    // Of a function that begins like the one of the ray.
    [[nodiscard]] std::string signature(std::string_view function, std::string_view more) const {
        return fmt::format(
            "{0}_{4}({1} x, {1} y, {1} width, {1} height, {1} t,{2}{3}\n"
            "        {1} origin[3], {1} direction[3]{5})",
            name_, real_, formulas_.lens ? fmt::format(" {0} lens_x, {0} lens_y,", real_) : "",
            source_.parameters.empty()
                ? ""
                : fmt::format("\n        const {}_parameters* parameters,", name_),
            function, more);
    }

    // The ray with its derivatives, and the search that uses them.
    [[nodiscard]] std::string inverse(const CLike& language, const Dialect& dialect,
                                      const Listing& ray, Listing slopes) const {
        std::erase_if(slopes.helpers, [&ray](const std::string& helper) {
            return std::find(ray.helpers.begin(), ray.helpers.end(), helper) != ray.helpers.end();
        });
        std::string text =
            "\n// The same with the derivatives of origin and direction by x and by y: origin by "
            "x, "
            "origin by y,\n// direction by x, direction by y.\n" +
            functions(language, slopes) + "static int " +
            signature("slopes", fmt::format(",\n        {} slopes[4][3]", real_)) + " {\n" +
            unused_inputs(slopes) + definitions(language, slopes) + "\n";
        for (std::size_t i = 0; i < 12; ++i) {
            text += fmt::format("    slopes[{}][{}] = {};\n", i / 3, i % 3,
                                slopes.roots[RayRoots::origin_by_x + i].text);
        }
        const std::string parameters = source_.parameters.empty() ? "" : ", parameters";
        std::string search = dialect.spelled(c_inverse);
        for (const auto& [word, by] : std::initializer_list<std::pair<std::string, std::string>>{
                 {"GIVEN",
                  fmt::format("{0} width, {0} height, {0} t{1}", real_,
                              source_.parameters.empty()
                                  ? ""
                                  : fmt::format(", const {}_parameters* parameters", name_))},
                 {"PASSED_ON", "width, height, t" + parameters},
                 {"PASSED",
                  fmt::format("width, height, t{}{}", formulas_.lens ? ", 0, 0" : "", parameters)},
                 {"TOLERANCE", single_ ? "1e-2" : "1e-7"},
                 {"ROUNDING", single_ ? "1e-5" : "1e-10"}}) {
            search = replaced(std::move(search), word, by);
        }
        return text + results(slopes).substr(1) + "}\n" + search;
    }

    // Compilers warn of parameters that a function does not use.
    [[nodiscard]] std::string unused_inputs(const Listing& listing) const {
        std::vector<std::string> inputs{"x", "y", "width", "height", "t"};
        if (formulas_.lens) {
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
            text +=
                fmt::format("    origin[{}] = {};\n", i, listing.roots[RayRoots::origin + i].text);
        }
        for (std::size_t i = 0; i < 3; ++i) {
            text += fmt::format("    direction[{}] = {};\n", i,
                                listing.roots[RayRoots::direction + i].text);
        }
        return text + fmt::format("    return {};\n", listing.roots[RayRoots::valid].text);
    }

    const bool single_;
    const std::string_view real_ = single_ ? "float" : "double";
    const std::string_view suffix_ = single_ ? "f" : "";
    std::string (*const number_)(double) = single_ ? float_literal : double_literal;
};

Result<std::string> write_c(const ExportSource& source, const ExportOptions& options,
                            CameraFormulas formulas) {
    return CExport(source, options, std::move(formulas)).text();
}

}  // namespace

ExportTarget c_target() {
    return {.name = "c",
            .meaning = "one C99 function, in double or single precision",
            .ending = ".c",
            .write = write_c,
            .has_inverse = true};
}

}  // namespace balcony::bridge
