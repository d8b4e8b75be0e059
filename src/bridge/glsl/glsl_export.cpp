// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// A camera as a function of GLSL ES 3.00 (WebGL 2) and of desktop GLSL from 3.30 on.

#include <fmt/format.h>

#include "bridge/glsl/glsl_words.hpp"
#include "bridge/text/targets.hpp"
#include "bridge/text/text_export.hpp"

namespace balcony::bridge {

namespace {

std::string glsl_array(std::string_view name, const std::vector<std::string>& values) {
    return fmt::format("const float {}[{}] = float[{}]({});", name, values.size(), values.size(),
                       wrapped(values, 8));
}

// Words of GLSL that cameras might use, its functions, and names that the text needs itself.
const std::set<std::string_view> glsl_words{
    "active",    "attribute", "buffer", "centroid", "coherent",   "common",    "const",
    "discard",   "double",    "filter", "fixed",    "flat",       "float",     "goto",
    "half",      "highp",     "image",  "in",       "inout",      "input",     "int",
    "invariant", "layout",    "long",   "lowp",     "main",       "mat2",      "mat3",
    "mat4",      "mediump",   "noise",  "out",      "output",     "partition", "patch",
    "precise",   "precision", "public", "resource", "sample",     "sampler2D", "shared",
    "short",     "smooth",    "static", "struct",   "subroutine", "switch",    "template",
    "texture",   "this",      "uint",   "uniform",  "union",      "unsigned",  "using",
    "varying",   "vec2",      "vec3",   "vec4",     "void",       "volatile",  "bool",
    "radians",   "degrees",   "length", "distance", "dot",        "cross",     "normalize",
    "reflect",   "refract",   "step",   "mix",      "clamp",      "sin",       "cos",
    "tan",       "exp",       "log",    "pow",      "sqrt",       "abs",       "sign",
    "floor",     "ceil",      "fract",  "mod",      "min",        "max",       "x",
    "y",         "t",         "width",  "height",   "lens_x",     "lens_y",    "origin",
    "direction"};

class GlslExport : TextExport {
public:
    GlslExport(const ExportSource& source, CameraFormulas formulas)
        : TextExport(source, std::move(formulas), glsl_words, "gl_") {}

    std::string text() {
        const Listing made = listing(glsl_dialect(name_));
        const CLike language{"float", "bool", "", "", "floor", "int({0})", glsl_number, glsl_array};
        std::string text =
            comment({"x to the right and y down from the top left corner, so that x is "
                     "gl_FragCoord.x and y is height -",
                     "gl_FragCoord.y. It returns whether there is a ray, with its origin and its "
                     "direction of unit length."}) +
            "\n#ifdef GL_ES\nprecision highp float;\n#endif\n\n";
        text += glsl_infinity(name_);
        text += functions(language, made);
        return text + defaults() + signature() + " {\n" + definitions(language, made) +
               results(made) + "}\n";
    }

private:
    // The values of the parameters as constants; angles are in radians.
    [[nodiscard]] std::string defaults() const {
        std::string text;
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            text += fmt::format("const float {}_default_{} = {};  // {}\n", name_, parameters_[i],
                                glsl_number(source_.parameters[i].value),
                                comment_line(source_.parameters[i].written));
        }
        return text.empty() ? text : text + "\n";
    }

    [[nodiscard]] std::string signature() const {
        std::string given = "float x, float y, float width, float height, float t";
        given += formulas_.lens ? ", float lens_x, float lens_y" : "";
        for (const std::string& parameter : parameters_) {
            given += ", float " + parameter;
        }
        return fmt::format("bool {}_ray({},\n        out vec3 origin, out vec3 direction)", name_,
                           given);
    }

    [[nodiscard]] static std::string results(const Listing& listing) {
        const auto vector = [&listing](std::size_t first) {
            return fmt::format("vec3({}, {}, {})", listing.roots[first].text,
                               listing.roots[first + 1].text, listing.roots[first + 2].text);
        };
        return fmt::format("\n    origin = {};\n    direction = {};\n    return {};\n",
                           vector(RayRoots::origin), vector(RayRoots::direction),
                           listing.roots[RayRoots::valid].text);
    }
};

Result<std::string> write_glsl(const ExportSource& source, const ExportOptions&,
                               CameraFormulas formulas) {
    return GlslExport(source, std::move(formulas)).text();
}

}  // namespace

ExportTarget glsl_target() {
    return {.name = "glsl",
            .meaning = "a function for WebGL 2 and desktop shaders",
            .ending = ".glsl",
            .write = write_glsl,
            .always_single = true};
}

}  // namespace balcony::bridge
