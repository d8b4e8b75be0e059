// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "balcony/solve.hpp"
#include "rays/results.hpp"
#include "solve/input_rays.hpp"
#include "solve/minimum.hpp"
#include "solve/outlines.hpp"
#include "solve/problem_check.hpp"

namespace balcony::solve {

namespace {

using Element = camera::PictureExpressions::Element;

// The layer of a number, from the back; null if there are fewer. The number becomes that of the
// layers behind these elements.
const Element* find_layer(const std::vector<Element>& elements, std::size_t& number) {
    for (const Element& element : elements) {
        if (element.ray && number-- == 0) {
            return &element;
        }
        if (const Element* const found = find_layer(element.group, number)) {
            return found;
        }
    }
    return nullptr;
}

}  // namespace

Solver::Solver(std::shared_ptr<const InputRays> rays, Axes axes, double width, double height,
               std::vector<std::string> inputs)
    : rays_(std::move(rays)),
      axes_(axes),
      width_(width),
      height_(height),
      inputs_(std::move(inputs)) {}

Result<Solver> Solver::make(const camera::Picture& picture, std::size_t layer, double width,
                            double height, std::vector<std::string> inputs, double time,
                            const std::stop_token& stop) {
    const auto layer_in = [&](const std::vector<Element>& elements) {
        std::size_t number = layer;
        return find_layer(elements, number);
    };
    const auto axes = rays::within_limits<Axes>(
        "picture", picture.parts().name, {width, height}, stop,
        [&](expr::Graph& graph) -> Result<Axes> {
            const auto whole = picture.emit(graph, width, height);
            const Element* const found = layer_in(whole.elements);
            return found != nullptr
                       ? Result<Axes>(found->axes)
                       : error(Kind::usage, fmt::format("the picture has no layer {}", layer + 1));
        });
    if (!axes) {
        return axes.diagnostics;
    }
    const RaySource source{[&](expr::Graph& graph) {
                               return *layer_in(picture.emit(graph, width, height).elements)->ray;
                           },
                           *axes,
                           picture.parts().name,
                           {width, height},
                           time};
    Result<InputRays> rays = InputRays::make(source, inputs, {}, stop);
    if (!rays) {
        return std::move(rays.diagnostics);
    }
    return Solver(std::make_shared<const InputRays>(std::move(*rays)), *axes, width, height,
                  std::move(inputs));
}

Result<Solution> Solver::solve(const Problem& given, const Options& options,
                               const std::stop_token& stop) const {
    Diagnostics found = problems_of(given);
    const bool has_inputs = std::equal(
        inputs_.begin(), inputs_.end(), given.unknowns.begin(), given.unknowns.end(),
        [](const std::string& input, const Unknown& unknown) { return input == unknown.input; });
    if (!has_inputs) {
        found.push_back(error(Kind::internal, "the unknowns are not those of the solver"));
    }
    for (const Constraint& constraint : given.constraints) {
        if (constraint.marks.empty() && !constraint.outline) {
            found.push_back(error(Kind::internal, "a solver knows no shapes"));
        }
    }
    if (!found.empty()) {
        return found;
    }
    const V2d size(width_, height_);
    const Problem problem = with_solving(given);
    return solution_of({rays_, size, problem}, given, problem, size, options, stop);
}

}  // namespace balcony::solve
