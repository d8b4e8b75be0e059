// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as an OSL shader for Cycles, as Blender 4.5 and later take it (Blender manual, "Custom
// Camera").

#include <cmath>

#include <fmt/format.h>

#include "bridge/text/blender_lens.hpp"
#include "bridge/text/parameter_range.hpp"
#include "bridge/text/targets.hpp"
#include "bridge/text/text_export.hpp"

namespace balcony::bridge {

namespace {

// In these texts @ is the camera's name. OSL returns 0 for a division by 0 and for the square root
// and the logarithm of a negative number. The ray would seem valid where it is not, so these
// functions give infinities. There is no literal of one.
constexpr std::string_view osl_divide = R"(float @_divide(float a, float b) {
    return b == 0.0 ? a * 1e38 * 1e38 : a / b;
}
)";
constexpr std::string_view osl_root = R"(float @_sqrt(float a) {
    return a < 0.0 ? a * 1e38 * 1e38 : sqrt(a);
}
)";
constexpr std::string_view osl_log = R"(float @_log(float a) {
    return a > 0.0 ? log(a) : (a - 1.0) * 1e38 * 1e38;
}
)";
constexpr std::string_view osl_asin = R"(float @_asin(float a) {
    return abs(a) > 1.0 ? a * 1e38 * 1e38 : asin(a);
}
)";
constexpr std::string_view osl_acos = R"(float @_acos(float a) {
    return abs(a) > 1.0 ? a * 1e38 * 1e38 : acos(a);
}
)";
constexpr std::string_view osl_power = R"(float @_power(float a, float b) {
    int undefined = (a == 0.0 && b < 0.0) || (a < 0.0 && b != floor(b));
    return undefined ? 1e38 * (1e38 + abs(a)) : pow(a, b);
}
)";
constexpr std::string_view osl_modulo = R"(float @_modulo(float a, float b) {
    return b == 0.0 ? a * 1e38 * 1e38 : a - b * floor(a / b);
}
)";
constexpr std::string_view osl_is_finite = R"(int @_is_finite(float a) {
    return abs(a) <= 3.4e38;
}
)";
constexpr std::string_view osl_asinh = R"(float @_asinh(float a) {
    float size = abs(a);
    return sign(a) * log(size + sqrt(size * size + 1.0));
}
)";
constexpr std::string_view osl_acosh = R"(float @_acosh(float a) {
    return a < 1.0 ? (a - 2.0) * 1e38 * 1e38 : log(a + sqrt(a * a - 1.0));
}
)";
constexpr std::string_view osl_atanh = R"(float @_atanh(float a) {
    return abs(a) < 1.0 ? 0.5 * log((1.0 + a) / (1.0 - a)) : a * 1e38 * 1e38;
}
)";

constexpr Spellings osl_spellings = spellings({
    function(Op::divide, "@_divide", osl_divide),
    function(Op::modulo, "@_modulo", osl_modulo),
    function(Op::square_root, "@_sqrt", osl_root),
    function(Op::power, "@_power", osl_power),
    function(Op::logarithm, "@_log", osl_log),
    function(Op::arcsine, "@_asin", osl_asin),
    function(Op::arccosine, "@_acos", osl_acos),
    function(Op::inverse_hyperbolic_sine, "@_asinh", osl_asinh),
    function(Op::inverse_hyperbolic_cosine, "@_acosh", osl_acosh),
    function(Op::inverse_hyperbolic_tangent, "@_atanh", osl_atanh),
    function(Op::is_finite, "@_is_finite", osl_is_finite),
});

std::string osl_number(double value) {
    const double rounded = static_cast<double>(static_cast<float>(value));
    return std::isfinite(rounded) ? single_decimal(value)
           : std::isnan(rounded)  ? "(1e38 * 1e38 - 1e38 * 1e38)"
           : rounded > 0.0        ? "(1e38 * 1e38)"
                                  : "(-1e38 * 1e38)";
}

std::string osl_array(std::string_view name, const std::vector<std::string>& values) {
    return fmt::format("float {}[{}] = {{{}}};", name, values.size(), wrapped(values, 8));
}

// Words and functions of OSL that cameras might use, and names that the text needs itself.
const std::set<std::string_view> osl_words{
    "and",      "break",       "closure",    "color",     "continue",
    "do",       "else",        "emit",       "float",     "for",
    "if",       "illuminance", "illuminate", "int",       "matrix",
    "normal",   "not",         "or",         "output",    "point",
    "public",   "return",      "string",     "struct",    "vector",
    "void",     "while",       "bool",       "case",      "catch",
    "char",     "class",       "const",      "default",   "double",
    "enum",     "extern",      "false",      "friend",    "inline",
    "long",     "new",         "operator",   "private",   "protected",
    "short",    "signed",      "sizeof",     "static",    "switch",
    "template", "this",        "throw",      "true",      "try",
    "typedef",  "uniform",     "union",      "unsigned",  "varying",
    "virtual",  "volatile",    "shader",     "surface",   "displacement",
    "light",    "volume",      "P",          "I",         "N",
    "Ng",       "u",           "v",          "dPdu",      "dPdv",
    "Ps",       "time",        "dtime",      "dPdtime",   "Ci",
    "M_PI",     "length",      "distance",   "rotate",    "transform",
    "radians",  "degrees",     "sin",        "cos",       "tan",
    "exp",      "log",         "pow",        "sqrt",      "abs",
    "sign",     "floor",       "mod",        "min",       "max",
    "mix",      "step",        "clamp",      "noise",     "spline",
    "x",        "y",           "t",          "width",     "height",
    "raster",   "resolution",  "position",   "direction", "throughput",
    "dPdx",     "dPdy",        "dDdx",       "dDdy",      "aperture",
    "valid"};

// Cycles' camera space: x to the right, y up, z forward. Balcony's z-up cameras look along x, with
// y to the left.
std::string in_camera_space(const Listing& listing, std::size_t first, std::string_view sign = "") {
    const auto enclosed = [](const std::string& text) { return "(" + text + ")"; };
    const std::string x = enclosed(listing.roots[first].text);
    const std::string y = enclosed(listing.roots[first + 1].text);
    const std::string z = enclosed(listing.roots[first + 2].text);
    return fmt::format("{0}(-{2}, {3}, {1})", sign, x, y, z);
}

class OslExport : TextExport {
public:
    OslExport(const ExportSource& source, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), osl_words, {}, true) {}

    std::string text() {
        const Dialect dialect{.spellings = osl_spellings,
                              .number = osl_number,
                              .number_of_condition = "((float)({0}))",
                              .condition_of_number = "(({0}) != 0.0)",
                              .single = true,
                              .words = {{"@", name_}}};
        const Listing made =
            listing(dialect, [this](std::string_view input) { return input_text(input); });
        const CLike language{"float", "int", "", "", "floor", "(int){0}", osl_number, osl_array};
        std::string text = commented(head()) + "\n";
        text += functions(language, made);
        return text + fmt::format("shader {}(\n", name_) + shader_parameters(made) + ")\n{\n" +
               inputs(made) + definitions(language, made) + results(made) + "}\n";
    }

private:
    [[nodiscard]] std::string input_text(std::string_view input) const {
        const auto i = parameters_.of_input(input);
        return i && source_.parameters[*i].is_angle ? fmt::format("radians({})", parameters_[*i])
               : input == "t"                       ? "camera_time"
                                                    : input_name(input);
    }

    [[nodiscard]] std::vector<std::string> head() const {
        std::vector<std::string> lines = opening_lines(source_);
        lines.insert(lines.end(),
                     {"",
                      "In Blender 4.5 or later: open this file in the text editor, select the "
                      "camera, set Lens > Type to",
                      "Custom, and choose the text. The camera's rays move and turn with Blender's "
                      "camera, which looks along",
                      "x of the rays' own world, with z up."});
        if (formulas_.lens) {
            lines.insert(lines.end(), {"The aperture is that of Blender's camera, and so is its "
                                       "focus distance unless own_focus is on."});
        }
        return lines;
    }

    // One parameter of the shader: a slider.
    [[nodiscard]] std::string slider(std::size_t i) const {
        const ExportParameter& parameter = source_.parameters[i];
        const double scale = parameter.is_angle ? 180.0 / 3.14159265358979323846 : 1.0;
        std::string hints = fmt::format("string help = \"{}, {} in the camera's file\"",
                                        parameter.name, quoted(parameter.written));
        if (parameter.is_angle) {
            hints += ", string units = \"degrees\"";
        }
        const ParameterRange range = range_of(formulas_, parameter.input);
        if (range.minimum) {
            hints += fmt::format(", float min = {}", osl_number(scale * *range.minimum));
        }
        if (range.maximum) {
            hints += fmt::format(", float max = {}", osl_number(scale * *range.maximum));
        }
        const double step = parameter.is_angle       ? 1.0
                            : parameter.value == 0.0 ? 0.1
                                                     : 0.01 * std::abs(parameter.value);
        return fmt::format("    float {} = {} [[ {}, float sensitivity = {} ]],\n", parameters_[i],
                           osl_number(scale * parameter.value), hints, osl_number(step));
    }

    // A text that may stand in quotation marks.
    [[nodiscard]] static std::string quoted(std::string_view text) {
        return replaced(comment_line(text), "\"", "'");
    }

    [[nodiscard]] std::string shader_parameters(const Listing& listing) const {
        std::string text;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            text += slider(i);
        }
        if (listing.uses("camera_time")) {
            text +=
                "    float camera_time = 0.0 [[ string help = \"the time t of the camera, in "
                "seconds\" ]],\n";
        }
        if (listing.uses(std::string(own_focus_input))) {
            text +=
                "    int own_focus = 0 [[ string help = \"focus as the camera's file says, "
                "instead of at the focus distance of Blender's camera\", string widget = "
                "\"boolean\" ]],\n";
        }
        return text +
               "    output point position = 0.0,\n"
               "    output vector direction = 0.0,\n"
               "    output color throughput = 1.0,\n"
               "    output vector dPdx = 0.0,\n"
               "    output vector dPdy = 0.0,\n"
               "    output vector dDdx = 0.0,\n"
               "    output vector dDdy = 0.0";
    }

    [[nodiscard]] static std::string inputs(const Listing& listing) {
        std::string text =
            "    vector resolution = 0.0;\n"
            "    getattribute(\"cam:image_resolution\", resolution);\n"
            "    point raster = camera_shader_raster_position();\n"
            "    // In pixels from the top left corner.\n"
            "    float width = resolution[0];\n"
            "    float height = resolution[1];\n"
            "    float x = raster[0] * width;\n"
            "    float y = (1.0 - raster[1]) * height;\n";
        if (listing.uses(std::string(aperture_x_input)) ||
            listing.uses(std::string(aperture_y_input))) {
            text +=
                "    vector aperture = 0.0;\n"
                "    getattribute(\"cam:aperture_position\", aperture);\n"
                "    float aperture_x = aperture[0];\n"
                "    float aperture_y = aperture[1];\n";
        }
        if (listing.uses(std::string(focal_distance_input))) {
            text +=
                "    float focal_distance = 0.0;\n"
                "    getattribute(\"cam:focal_distance\", focal_distance);\n";
        }
        return text;
    }

    // y of the raster goes up, and so do the derivatives by y.
    [[nodiscard]] static std::string results(const Listing& listing) {
        const auto root = [&listing](std::size_t first, std::string_view before) {
            return in_camera_space(listing, first, before);
        };
        std::string text =
            fmt::format("\n    position = {};\n    direction = {};\n",
                        root(RayRoots::origin, "point"), root(RayRoots::direction, "vector"));
        text += fmt::format("    throughput = ({}) ? color(1.0) : color(0.0);\n",
                            listing.roots[RayRoots::valid].text);
        text += fmt::format(
            "    dPdx = {};\n    dPdy = {};\n    dDdx = {};\n    dDdy = {};\n",
            root(RayRoots::origin_by_x, "vector"), root(RayRoots::origin_by_y, "-vector"),
            root(RayRoots::direction_by_x, "vector"), root(RayRoots::direction_by_y, "-vector"));
        return text;
    }
};

Result<std::string> write_osl(const ExportSource& source, const ExportOptions&,
                              CameraFormulas formulas) {
    return OslExport(source, std::move(formulas)).text();
}

}  // namespace

ExportTarget osl_target() {
    return {.name = "osl",
            .meaning = "a camera shader for Cycles in Blender 4.5 and later",
            .ending = ".osl",
            .write = write_osl,
            .always_single = true,
            .opens_parameters = true,
            .footprints = true,
            .axes = Axes::z_up,
            .only_axes = true,
            .adapted = with_blender_lens};
}

}  // namespace balcony::bridge
