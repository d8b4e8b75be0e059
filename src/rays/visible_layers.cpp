// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/rays.hpp"

#include <algorithm>

#include "base/precondition.hpp"
#include "rays/results.hpp"

namespace balcony::rays {

// Visits elements from front to back and collects what hides those behind.
class LayerFinder {
public:
    using Element = camera::PictureExpressions::Element;

    explicit LayerFinder(const CompileOptions& options) : options_(options) {}

    Result<VisibleLayers> run(const std::vector<Element>& elements, expr::Graph& graph) {
        find(elements, graph.constant(0.0), graph.constant(1.0));
        std::reverse(made_.layers_.begin(), made_.layers_.end());
        std::reverse(hidden_.begin(), hidden_.end());
        if (std::any_of(hidden_.begin(), hidden_.end(),
                        [](const expr::Expr& hidden) { return !hidden.is_constant(0.0); })) {
            made_.hidden_ =
                take(program::Program::make(hidden_, {program::Sampling::points, options_.inputs}),
                     found_);
        }
        if (has_errors(found_)) {
            return found_;
        }
        return {std::move(made_), std::move(found_)};
    }

private:
    // `hidden` is where elements in front hide these, `shown` where the enclosing groups cover
    // something. Returns where these elements and those in front hide what is behind.
    expr::Expr find(const std::vector<Element>& elements, expr::Expr hidden, expr::Expr shown) {
        for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
            const expr::Expr present = contents(*element, hidden, shown && 0.0 < element->coverage);
            if (element->blend == camera::BlendMode::normal) {
                hidden = hidden || (present && 1.0 <= element->coverage);
            }
        }
        return hidden;
    }

    // Where there is something that can hide others: a ray, paint, or a group without a gap.
    expr::Expr contents(const Element& element, expr::Expr hidden, expr::Expr shown) {
        if (element.compositing == camera::Compositing::depth) {
            return find_by_depth(element.group, hidden, shown);
        }
        if (!element.group.empty()) {
            return find(element.group, hidden, shown);
        }
        if (!element.ray) {
            return hidden.graph().constant(1.0);
        }
        camera::RayExpressions ray = *element.ray;
        ray.valid = ray.valid && shown;
        hidden_.push_back(hidden);
        if (auto rays = take(RayProgram::make(ray, element.axes, options_), found_)) {
            made_.layers_.push_back({element.name, options_.axes.value_or(element.axes),
                                     std::move(*rays), element.objects});
        }
        return element.objects.empty() ? element.ray->valid : hidden.graph().constant(0.0);
    }

    // The master hides what is behind all of them.
    expr::Expr find_by_depth(const std::vector<Element>& elements, expr::Expr hidden,
                             expr::Expr shown) {
        expr::Expr present = hidden.graph().constant(0.0);
        for (auto element = elements.rbegin(); element != elements.rend(); ++element) {
            present = contents(*element, hidden, shown && 0.0 < element->coverage) &&
                      1.0 <= element->coverage;
        }
        return present;
    }

    const CompileOptions& options_;
    VisibleLayers made_;
    std::vector<expr::Expr> hidden_;  // By layer.
    Diagnostics found_;
};

void VisibleLayers::run_hidden(const Points& points, Scratch& scratch,
                               std::span<double* const> hidden) const {
    precondition(hidden_.has_value(), "something hides a layer");
    program::run(*hidden_, points, scratch, hidden);
}

Result<VisibleLayers> compile_layers(const camera::Picture& picture, double width, double height,
                                     const CompileOptions& options, const std::stop_token& stop) {
    return within_limits<VisibleLayers>(
        "picture", picture.name(), {width, height}, stop, [&](auto& graph) {
            return LayerFinder(options).run(picture.emit(graph, width, height).elements, graph);
        });
}

}  // namespace balcony::rays
