// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/picture_shader.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "bridge/glsl/glsl_words.hpp"
#include "bridge/text/c_like.hpp"
#include "bridge/text/single_precision.hpp"

namespace balcony::bridge {

namespace {

using Element = camera::PictureExpressions::Element;

constexpr std::string_view target = "page";
constexpr std::size_t most_layers = 32;

// The renderer's formula for layers in normal blend mode (render/job/blend.cpp).
constexpr std::string_view compositing = R"(
PictureColor picture_over(PictureColor below, PictureColor source, float coverage) {
    float share = coverage * source.presence;
    return PictureColor((1.0 - share) * below.light + coverage * source.light,
                        (1.0 - share) * below.display + coverage * source.display,
                        below.presence + share - below.presence * share);
}

PictureColor picture_channels(PictureColor own, mat3 weights) {
    return PictureColor(vec4(weights * own.light.rgb, own.light.a),
                        vec4(weights * own.display.rgb, own.display.a), own.presence);
}

// A coverage, which counts as 0 where it is not a number.
float picture_part(float value) { return value > 0.0 ? min(value, 1.0) : 0.0; }
)";

// What the elements of a picture need of the renderer that a shader does not have.
Diagnostics missing_in(const std::vector<Element>& elements, const camera::Picture& picture) {
    Diagnostics found;
    const auto refuse = [&](const Element& element, std::string_view what) {
        found.push_back(error(
            fmt::format("'{}' of the picture '{}' cannot be exported to a {}: {}",
                        element.name.empty() ? "a layer" : element.name, picture.name(), target,
                        what),
            {},
            "take this layer out, or show one of its cameras alone: FILE:NAME; 'balcony render' "
            "makes the whole picture"));
    };
    for (const Element& element : elements) {
        if (element.blend != camera::BlendMode::normal) {
            refuse(element, "it has a blend mode");
        }
        if (element.compositing == camera::Compositing::depth) {
            refuse(element.group.back(), "it is blended by depth");
        }
        if (!element.objects.empty()) {
            refuse(element, "it shows some objects of the scene only");
        }
        Diagnostics inside = missing_in(element.group, picture);
        std::move(inside.begin(), inside.end(), std::back_inserter(found));
    }
    return found;
}

/// Writes the text of a picture at one size.
class PictureWriter {
public:
    PictureWriter(const std::vector<ExportParameter>& parameters, Axes axes)
        : parameters_(parameters), axes_(axes) {
        formulas_.graph = std::make_unique<expr::Graph>();
        formulas_.condition.reset();
    }

    Result<PictureShader> run(const camera::Picture& picture,
                              const std::array<std::size_t, 2>& size) {
        const std::vector<Element> elements =
            picture
                .emit(*formulas_.graph, static_cast<double>(size[0]), static_cast<double>(size[1]))
                .elements;
        Diagnostics missing = missing_in(elements, picture);
        if (!missing.empty()) {
            return missing;
        }
        const std::string color = composited(elements, "c", "    ");
        const std::string shares = shares_of(elements);
        if (made_.layers > most_layers) {
            return error(fmt::format("the picture '{}' has {} camera layers; a {} shows {}",
                                     picture.name(), made_.layers, target, most_layers),
                         {}, "take layers out");
        }
        return written(color, shares);
    }

private:
    // The lines that composite elements into a variable; gives numbers to layers and values.
    std::string composited(const std::vector<Element>& elements, const std::string& into,
                           const std::string& margin) {
        std::string text = fmt::format(
            "{}PictureColor {} = PictureColor(vec4(0.0), vec4(0.0), 0.0);\n", margin, into);
        for (const Element& element : elements) {
            const std::string coverage = value(element.coverage);
            std::string source;
            if (element.ray) {
                source = fmt::format("picture_seen[{}]", add_layer(element));
            } else if (element.paint) {
                std::vector<std::string> channels;
                for (const Expr& channel : *element.paint) {
                    channels.push_back(value(channel));
                }
                source = fmt::format("PictureColor(vec4(0.0), vec4({}, 1.0), 1.0)",
                                     fmt::join(channels, ", "));
            } else {
                source = fmt::format("{}{}", into, ++groups_);
                text += composited(element.group, source, margin);
            }
            if (element.channels) {
                source = fmt::format("picture_channels({}, {})", source, matrix(*element.channels));
            }
            text += fmt::format("{0}{1} = picture_over({1}, {2}, picture_part({3}));\n", margin,
                                into, source, coverage);
        }
        return text;
    }

    static std::string matrix(const camera::ColorMatrix& weights) {
        std::vector<std::string> numbers;
        for (std::size_t column = 0; column < 3; ++column) {
            for (const std::array<double, 3>& row : weights) {
                numbers.push_back(glsl_number(row[column]));
            }
        }
        return fmt::format("mat3({})", fmt::join(numbers, ", "));
    }

    // A number that the rays' function computes.
    std::string value(const Expr& formula) {
        values_.push_back(formula);
        return fmt::format("picture_value[{}]", values_.size() - 1);
    }

    std::size_t add_layer(const Element& element) {
        const bool has_lens = element.ray->lens.has_value();
        made_.has_lens = made_.has_lens || has_lens;
        std::vector<Expr> roots =
            rays::ray_roots(*element.ray, has_lens, false, element.axes, axes_);
        std::move(roots.begin(), roots.end(), std::back_inserter(rays_));
        return made_.layers++;
    }

    // From front to back: what is in front of a layer and covers it hides it. Numbers are given as
    // in composited().
    std::string shares_of(const std::vector<Element>& elements) {
        std::vector<std::string> lines;
        std::size_t layer = 0;
        std::size_t number = 0;
        const auto visit = [&](const auto& self, const std::vector<Element>& all,
                               const std::string& around) -> void {
            for (const Element& element : all) {
                const std::string part = fmt::format("picture_part(picture_value[{}])", number++);
                const std::string share = around + " * " + part;
                if (element.ray) {
                    lines.push_back(fmt::format(
                        "    picture_layer[{0}].share = {1};\n    open = picture_layer[{0}].ray != "
                        "0.0 && {2} >= 1.0 ? 0.0 : open;\n",
                        layer++, share, around == "open" ? part : "0.0"));
                } else if (element.paint) {
                    number += 3;
                    lines.push_back(fmt::format("    open = {} >= 1.0 ? 0.0 : open;\n",
                                                around == "open" ? part : "0.0"));
                } else {
                    self(self, element.group, share);
                }
            }
        };
        visit(visit, elements, "open");
        std::string text = "\n    float open = 1.0;\n";
        for (auto line = lines.rbegin(); line != lines.rend(); ++line) {
            text += *line;
        }
        return text;
    }

    [[nodiscard]] std::string input_text(std::string_view input) const {
        for (std::size_t i = 0; i < parameters_.size(); ++i) {
            if (parameters_[i].input == input) {
                return fmt::format("picture_parameters[{}]", i);
            }
        }
        return std::string(input);
    }

    Result<PictureShader> written(const std::string& color, const std::string& shares) {
        std::vector<Expr> all = rays_;
        all.insert(all.end(), values_.begin(), values_.end());
        formulas_.roots = expr::simplify(all);
        const expr::Graph& graph = *formulas_.graph;
        for (const expr::NodeId id : expr::reachable(graph, formulas_.roots)) {
            if (graph[id].op == Op::call && graph.call_of(id).native) {
                return error(fmt::format("a clip or an arrangement of the picture cannot be "
                                         "exported to a {}: '{}' has no formula",
                                         target, graph.call_of(id).native->name()),
                             {}, "clip its layers by a shape");
            }
        }
        Names names({"x", "y", "t", "lens_x", "lens_y", "open"});
        const Listing listing =
            listing_of(formulas_, glsl_dialect("picture"), names, "picture_",
                       [this](std::string_view input) { return input_text(input); });
        // Tables are no arrays, which take drivers seconds to compile.
        const CLike language{"float", "bool",          "", "", "floor", "int({0})", glsl_number,
                             nullptr, "picture_number"};
        for (const ListedTable& listed : listing.tables) {
            for (const double number : listed.table->coefficients) {
                made_.table_numbers.push_back(static_cast<float>(number));
            }
        }
        made_.has_time = listing.uses("t");
        made_.text = declarations() + glsl_infinity("picture") + functions(language, listing) +
                     std::string(compositing) +
                     "\nvoid picture_rays(float x, float y, float t, float lens_x, float lens_y) "
                     "{\n" +
                     definitions(language, listing) + "\n" + results(listing) + shares +
                     "}\n\nPictureColor picture_color() {\n" + color + "    return c;\n}\n";
        return std::move(made_);
    }

    [[nodiscard]] std::string declarations() const {
        std::string text = fmt::format("const int picture_layers = {};\n", made_.layers);
        text +=
            "struct PictureLayer { vec3 origin; vec3 direction; float ray; float share; };\n"
            "struct PictureColor { vec4 light; vec4 display; float presence; };\n"
            "PictureLayer picture_layer[picture_layers];\n"
            "PictureColor picture_seen[picture_layers];\n";
        text += fmt::format("float picture_value[{}];\n", values_.size());
        if (!parameters_.empty()) {
            text += fmt::format("uniform float picture_parameters[{}];\n", parameters_.size());
        }
        return text + "\n";
    }

    [[nodiscard]] std::string results(const Listing& listing) const {
        const auto root = [&listing](std::size_t i) { return listing.roots[i].text; };
        std::string text;
        for (std::size_t layer = 0; layer < made_.layers; ++layer) {
            const std::size_t at = layer * RayRoots::end_of_ray;
            const auto vector = [&](std::size_t first) {
                return fmt::format("vec3({}, {}, {})", root(first), root(first + 1),
                                   root(first + 2));
            };
            text += fmt::format("    picture_layer[{}] = PictureLayer({},\n        {}, {}, 0.0);\n",
                                layer, vector(at + RayRoots::origin),
                                vector(at + RayRoots::direction), root(at + RayRoots::valid));
        }
        for (std::size_t i = 0; i < values_.size(); ++i) {
            text += fmt::format("    picture_value[{}] = {};\n", i, root(rays_.size() + i));
        }
        return text;
    }

    const std::vector<ExportParameter>& parameters_;
    const Axes axes_;
    CameraFormulas formulas_;
    PictureShader made_;
    std::vector<Expr> rays_;    // Those of RayRoots of each layer.
    std::vector<Expr> values_;  // Coverages, and the colours of paints.
    std::size_t groups_ = 0;
};

// Whether all cameras have formulas, and what single precision changes in them.
Diagnostics check_cameras(const camera::Picture& picture,
                          const std::vector<ExportParameter>& parameters,
                          const std::array<std::size_t, 2>& size) {
    Diagnostics found;
    for (const camera::ShownCamera& shown : camera::shown_cameras(picture)) {
        const Result<CameraFormulas> formulas =
            formulas_of(shown.camera, {.target = target, .measured = true});
        if (!formulas) {
            found.insert(found.end(), formulas.diagnostics.begin(), formulas.diagnostics.end());
            continue;
        }
        const Diagnostics moved =
            single_precision_warnings(measure_single_precision(*formulas, parameters, size));
        found.insert(found.end(), moved.begin(), moved.end());
    }
    return found;
}

}  // namespace

Diagnostics single_precision_warnings(const SinglePrecision& found, std::string_view remedy) {
    constexpr double visible = 0.1;  // Pixels.
    Diagnostics all;
    if (found.largest > visible) {
        all.push_back(warning(
            fmt::format("in single precision, rays move by up to {:.2g} pixels (at x = {}, y = {}; "
                        "99 % move by less than {:.2g})",
                        found.largest, found.x, found.y, found.usual),
            {},
            remedy.empty()
                ? "move the camera's world closer to the origin"
                : fmt::format("move the camera's world closer to the origin, or {}", remedy)));
    }
    if (found.lost > 0) {
        all.push_back(warning(fmt::format(
            "in single precision, {} of {} rays are there that are not in double precision, or the "
            "other way round",
            found.lost, found.rays)));
    }
    return all;
}

Result<PictureShader> export_picture_shader(const camera::Picture& picture,
                                            const std::vector<ExportParameter>& parameters,
                                            Axes axes, const std::array<std::size_t, 2>& size) {
    Diagnostics found = check_cameras(picture, parameters, size);
    if (has_errors(found)) {
        return found;
    }
    try {
        Result<PictureShader> made = PictureWriter(parameters, axes).run(picture, size);
        std::move(found.begin(), found.end(), std::back_inserter(made.diagnostics));
        return made;
    } catch (const expr::GraphTooLarge&) {
        return error(fmt::format("picture '{}' is too large to be exported", picture.name()), {},
                     "repeat fewer stages, or show fewer layers");
    }
}

}  // namespace balcony::bridge
