// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "cli/report/explain_report.hpp"

#include <algorithm>
#include <map>
#include <span>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "balcony/stages.hpp"

namespace balcony::cli {

namespace {

using lang::Explanation;

// ------------------------------------------------------------------------------------------ text

std::string indented(std::size_t depth) { return std::string(4 * depth, ' '); }

std::string text_of(const std::vector<Explanation::Step>& steps, std::size_t depth) {
    std::string text;
    for (const Explanation::Step& step : steps) {
        const std::string indent = indented(step.depth + depth);
        text += fmt::format("{}{:<7} {}\n", indent, step.statement, step.written);
        for (const std::string& meaning : step.meanings) {
            text += fmt::format("{}        - {}\n", indent, meaning);
        }
    }
    return text;
}

// Its parameters and what it defines.
std::string values_text(const Explanation& explanation, std::size_t depth) {
    std::string text;
    for (const Explanation::Parameter& parameter : explanation.parameters) {
        text += fmt::format("{}{} = {}\n", indented(depth), parameter.name, parameter.value);
    }
    for (const std::string& definition : explanation.definitions) {
        text += fmt::format("{}let {}\n", indented(depth), definition);
    }
    return text;
}

// A picture with its layers, including those of nested pictures, followed by the cameras.
class PictureText {
public:
    explicit PictureText(const Explanation& whole) : whole_(whole), layers_(whole.shown.size()) {}

    std::string operator()() {
        std::string text = fmt::format("{}: {}\n", whole_.name, whole_.summary);
        text += values_text(whole_, 1);
        text += "\nLayers, from back to front:\n";
        text += layers(whole_, "", 1);
        for (std::size_t i = 0; i < whole_.shown.size(); ++i) {
            if (!whole_.shown[i].is_picture) {
                text += camera(whole_.shown[i], layers_[i]);
            }
        }
        return text;
    }

private:
    std::string layers(const Explanation& picture, const std::string& path, std::size_t depth) {
        std::string text;
        std::size_t number = 0;
        for (const Explanation::Layer& layer : picture.layers) {
            const std::string place = fmt::format("{}{}", path, ++number);
            text += fmt::format("\n{}{}  {}\n", indented(depth), place, layer.written);
            text += text_of(layer.steps, depth + 1);
            text += shown(layer.shows, place, depth + 1);
        }
        return text;
    }

    // A nested picture is described where it first occurs, a camera below with all its layers.
    std::string shown(std::size_t index, const std::string& place, std::size_t depth) {
        const Explanation& shown = whole_.shown[index];
        layers_[index].push_back(place);
        if (!shown.is_picture) {
            return "";
        }
        if (layers_[index].size() > 1) {
            return fmt::format("{}the picture of layer {} again\n", indented(depth),
                               layers_[index].front());
        }
        return fmt::format("{}{}\n{}{}", indented(depth), shown.summary,
                           values_text(shown, depth + 1), layers(shown, place + ".", depth + 1));
    }

    static std::string camera(const Explanation& camera, const std::vector<std::string>& layers) {
        return fmt::format(
            "\n{}, layer{} {}: {}\n{}\nA point of the layer becomes a ray in these "
            "steps:\n{}",
            camera.name, layers.size() > 1 ? "s" : "", fmt::join(layers, ", "), camera.summary,
            values_text(camera, 1), text_of(camera.steps, 1));
    }

    const Explanation& whole_;
    std::vector<std::vector<std::string>> layers_;  // The layers that show each camera or picture.
};

// ------------------------------------------------------------------------------------------ JSON

nlohmann::json json_of(const std::vector<Explanation::Step>& steps) {
    nlohmann::json all = nlohmann::json::array();
    for (const Explanation::Step& step : steps) {
        all.push_back({{"statement", step.statement},
                       {"written", step.written},
                       {"meanings", step.meanings},
                       {"depth", step.depth}});
    }
    return all;
}

nlohmann::json json_of(const std::vector<Explanation::Layer>& layers) {
    nlohmann::json all = nlohmann::json::array();
    for (const Explanation::Layer& layer : layers) {
        all.push_back(
            {{"written", layer.written}, {"steps", json_of(layer.steps)}, {"shows", layer.shows}});
    }
    return all;
}

// -------------------------------------------------------------------------------------- formulas

// The statement of a stage, which follows from its path and from whether it is the first one there
// with values of its kind.
std::string statement_of(std::span<const camera::StageValues> stages, std::size_t i) {
    using Owner = camera::StageValues::Owner;
    const camera::StageValues& stage = stages[i];
    if (stage.owner == Owner::look) {
        return "look";
    }
    const bool parameters = stage.values.size() == 2;
    const bool first = std::none_of(stages.begin(), stages.begin() + static_cast<std::ptrdiff_t>(i),
                                    [&](const camera::StageValues& one) {
                                        return one.owner == stage.owner &&
                                               one.values.size() == stage.values.size();
                                    });
    const bool eye = stage.owner == Owner::eye;
    if (!parameters && first) {
        return eye ? "eye" : "toward";
    }
    const std::string_view statement = parameters ? first ? "map" : "warp" : "move";
    return fmt::format("{}{}", eye ? "" : "toward_", statement);
}

/// Formulas with their names.
class FormulaList {
public:
    void add(std::string name, const expr::Expr& formula) {
        names_.push_back(std::move(name));
        roots_.push_back(formula);
    }

    template <class Vector>
    void add_xyz(const std::string& name, const Vector& v) {
        add(name + "_x", v.x);
        add(name + "_y", v.y);
        add(name + "_z", v.z);
    }

    void add_ray(const std::string& prefix, const camera::RayExpressions& ray) {
        add(prefix + "u", ray.parameters.u);
        add(prefix + "v", ray.parameters.v);
        add_xyz(prefix + "origin", ray.origin);
        add_xyz(prefix + "direction", ray.direction);
        add(prefix + "valid", ray.valid);
        if (ray.lens) {
            const camera::RayExpressions through = camera::through_lens(ray);
            add_xyz(prefix + "lens_origin", through.origin);
            add_xyz(prefix + "lens_direction", through.direction);
        }
        if (ray.time) {
            add(prefix + "time", *ray.time);
        }
        if (ray.bend) {
            for (std::size_t i = 0; i < ray.bend->knots.size(); ++i) {
                add_xyz(fmt::format("{}knot_{}", prefix, i + 1), ray.bend->knots[i]);
            }
            add_xyz(prefix + "last_direction", ray.bend->direction);
        }
    }

    /// Names what the formulas have in common after the stages of a camera.
    void add_stages(std::span<const camera::StageValues> stages) {
        std::map<std::string, std::size_t> counts;
        for (std::size_t i = 0; i < stages.size(); ++i) {
            const std::string statement = statement_of(stages, i);
            const std::size_t number = ++counts[statement];
            steps_.push_back({number == 1 ? statement : fmt::format("{}_{}", statement, number),
                              stages[i].values,
                              stages[i].values.size() == 2
                                  ? std::vector<std::string>{"u", "v"}
                                  : std::vector<std::string>{"x", "y", "z"}});
        }
    }

    [[nodiscard]] std::string text() {
        std::vector<expr::Expr> all = roots_;
        for (const expr::NamedStep& step : steps_) {
            all.insert(all.end(), step.values.begin(), step.values.end());
        }
        all = expr::simplify(all);
        auto value = all.begin() + static_cast<std::ptrdiff_t>(roots_.size());
        for (expr::NamedStep& step : steps_) {
            const auto end = value + static_cast<std::ptrdiff_t>(step.values.size());
            step.values.assign(value, end);
            value = end;
        }
        return expr::print(std::span(all).first(roots_.size()), names_, steps_);
    }

private:
    std::vector<expr::Expr> roots_;
    std::vector<std::string> names_;
    std::vector<expr::NamedStep> steps_;
};

using Elements = std::vector<camera::PictureExpressions::Element>;

/// The elements of a picture are in the order of its layers. Each layer contributes its leader
/// lines, its content and its frame.
void add_elements(const camera::Picture& picture, const Elements& elements, const std::string& path,
                  FormulaList& formulas) {
    auto element = elements.begin();
    std::size_t number = 0;
    for (const camera::Layer& layer : picture.parts().layers) {
        const std::string prefix = fmt::format("{}_{}", path, ++number);
        for (std::size_t leader = 1; leader <= layer.leaders.size(); ++leader) {
            formulas.add(fmt::format("{}_leader_{}_coverage", prefix, leader),
                         (element++)->coverage);
        }
        formulas.add(prefix + "_coverage", element->coverage);
        if (element->ray) {
            formulas.add_ray(prefix + "_", *element->ray);
        } else {
            add_elements(*std::get<std::shared_ptr<const camera::Picture>>(layer.content),
                         element->group, prefix, formulas);
        }
        ++element;
        if (layer.frame) {
            formulas.add(prefix + "_frame_coverage", (element++)->coverage);
        }
        if (layer.scale_bar) {
            formulas.add(prefix + "_scale_bar_coverage", (element++)->coverage);
        }
    }
}

}  // namespace

std::string explanation_text(const Explanation& explanation) {
    if (explanation.is_picture) {
        return PictureText(explanation)();
    }
    return fmt::format("{}: {}\n{}\nA point of the picture becomes a ray in these steps:\n{}",
                       explanation.name, explanation.summary, values_text(explanation, 1),
                       text_of(explanation.steps, 1));
}

std::string explanation_text(const Explanation& explanation, const std::string& formulas,
                             std::size_t width, std::size_t height) {
    return fmt::format(
        "{}\nFormulas for a picture of {} x {} pixels. x and y are the position in pixels from "
        "the\n"
        "top left corner, t is the time{}:\n\n{}",
        explanation_text(explanation), width, height,
        explanation.is_picture ? ", a coverage is the opacity at the position" : "", formulas);
}

nlohmann::json explanation_json(const Explanation& explanation) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const Explanation::Parameter& parameter : explanation.parameters) {
        parameters.push_back({{"name", parameter.name}, {"value", parameter.value}});
    }
    nlohmann::json made{{explanation.is_picture ? "picture" : "camera", explanation.name},
                        {"summary", explanation.summary},
                        {"parameters", parameters},
                        {"definitions", explanation.definitions}};
    if (explanation.is_picture) {
        made["layers"] = json_of(explanation.layers);
    } else {
        made["steps"] = json_of(explanation.steps);
    }
    for (const Explanation& shown : explanation.shown) {
        made["shown"].push_back(explanation_json(shown));
    }
    return made;
}

std::string formulas_text(const camera::Picture& picture, double width, double height) {
    expr::Graph graph;
    FormulaList formulas;
    const Elements elements = picture.emit(graph, width, height).elements;
    if (const camera::Camera* camera = picture.only_camera()) {
        camera::PicturePoint point{{graph.picture_x(), graph.picture_y()},
                                   {graph.constant(width), graph.constant(height)}};
        camera::Emitter unused(graph);
        const std::vector<camera::ShownCamera> shown = shown_cameras(picture);
        for (const auto& arranger : shown.front().uses.front().arrangers) {
            point = arranger->arrange(point, unused);
        }
        formulas.add_ray("", *elements.front().ray);
        formulas.add_stages(camera->emit_stages(point));
    } else {
        add_elements(picture, elements, "layer", formulas);
    }
    return formulas.text();
}

}  // namespace balcony::cli
