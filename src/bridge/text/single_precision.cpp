// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// What single precision changes: the formulas are computed with every number rounded to a float.

#include "bridge/text/single_precision.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "balcony/ray_difference.hpp"
#include "bridge/text/blender_lens.hpp"
#include "bridge/text/coarse_table.hpp"

namespace balcony::bridge {

namespace {

using expr::Node;
using expr::NodeId;
using rays::Ray;
using rays::V3d;

double to_single(double value) { return static_cast<double>(static_cast<float>(value)); }
double unchanged(double value) { return value; }

/// Computes formulas point by point, with a rounding after every operation.
class Evaluator {
public:
    using Round = double (*)(double);
    Evaluator(const CameraFormulas& formulas, Round round)
        : formulas_(formulas),
          round_(round),
          nodes_(expr::reachable(*formulas.graph, formulas.roots)),
          values_(formulas.graph->size()) {
        for (const NodeId id : nodes_) {
            if ((*formulas.graph)[id].op == Op::call) {
                tables_.try_emplace(id, kept(formulas.graph->call_of(id).table));
            }
        }
    }

    /// The values of the roots, given those of the inputs by name; others are 0.
    std::vector<double> operator()(const std::map<std::string, double>& inputs) {
        const expr::Graph& graph = *formulas_.graph;
        for (const NodeId id : nodes_) {
            const Node& node = graph[id];
            arguments_.clear();
            for (const NodeId argument : graph.arguments(id)) {
                arguments_.push_back(values_[argument.value()]);
            }
            double& value = values_[id.value()];
            if (node.op == Op::constant) {
                value = round_(node.value);
            } else if (node.op == Op::input) {
                const auto found = inputs.find(graph.input_names()[node.detail]);
                value = found == inputs.end() ? 0.0 : round_(found->second);
            } else if (node.op == Op::call) {
                value = round_(tables_.at(id)(arguments_));
            } else if (node.op == Op::result) {
                value = arguments_.front();
            } else {
                value = round_(expr::operation(node.op).scalar(arguments_.data()));
            }
        }
        std::vector<double> roots;
        for (const Expr root : formulas_.roots) {
            roots.push_back(values_[root.id().value()]);
        }
        return roots;
    }

private:
    // The table as a text in this precision has it.
    [[nodiscard]] expr::Table kept(const std::shared_ptr<const expr::Table>& given) const {
        expr::Table table = round_ == to_single ? *coarse_table(given) : *given;
        for (double& coefficient : table.coefficients) {
            coefficient = round_(coefficient);
        }
        return table;
    }

    const CameraFormulas& formulas_;
    const Round round_;
    const std::vector<NodeId> nodes_;
    std::vector<double> values_;
    std::vector<double> arguments_;
    std::map<NodeId, expr::Table> tables_;
};

V3d vector_at(const std::vector<double>& roots, std::size_t first) {
    return {roots[first], roots[first + 1], roots[first + 2]};
}

Ray ray_of(const std::vector<double>& roots) {
    Ray ray;
    ray.origin = vector_at(roots, RayRoots::origin);
    ray.direction = vector_at(roots, RayRoots::direction);
    ray.valid = roots[RayRoots::valid] != 0.0;
    ray.origin_by_x = vector_at(roots, RayRoots::origin_by_x);
    ray.origin_by_y = vector_at(roots, RayRoots::origin_by_y);
    ray.direction_by_x = vector_at(roots, RayRoots::direction_by_x);
    ray.direction_by_y = vector_at(roots, RayRoots::direction_by_y);
    return ray;
}

struct Pair {
    double x, y;
    Ray exact, single;
};

// Rays at pixel centres all over the picture.
std::vector<Pair> pairs(const CameraFormulas& formulas,
                        const std::vector<ExportParameter>& parameters,
                        const std::array<std::size_t, 2>& size) {
    constexpr std::size_t most = 64;
    const auto [width, height] = size;
    std::map<std::string, double> inputs{{std::string(width_input), static_cast<double>(width)},
                                         {std::string(height_input), static_cast<double>(height)},
                                         {std::string(own_focus_input), 1.0}};
    for (const ExportParameter& parameter : parameters) {
        inputs[parameter.input] = parameter.value;
    }
    Evaluator exact(formulas, unchanged);
    Evaluator single(formulas, to_single);
    std::vector<Pair> made;
    const std::size_t step = std::max<std::size_t>(1, std::max(width, height) / most);
    for (std::size_t y = step / 2; y < height; y += step) {
        for (std::size_t x = step / 2; x < width; x += step) {
            inputs["x"] = static_cast<double>(x) + 0.5;
            inputs["y"] = static_cast<double>(y) + 0.5;
            made.push_back(
                {inputs["x"], inputs["y"], ray_of(exact(inputs)), ray_of(single(inputs))});
        }
    }
    return made;
}

// The diagonal of the box of all origins.
double size_of(const std::vector<Pair>& all) {
    V3d low(std::numeric_limits<double>::infinity());
    V3d high(-std::numeric_limits<double>::infinity());
    for (const Pair& pair : all) {
        for (int axis = 0; axis < 3 && pair.exact.valid; ++axis) {
            low[axis] = std::min(low[axis], pair.exact.origin[axis]);
            high[axis] = std::max(high[axis], pair.exact.origin[axis]);
        }
    }
    return low.x <= high.x ? (high - low).length() : 0.0;
}

}  // namespace

SinglePrecision measure_single_precision(const CameraFormulas& formulas,
                                         const std::vector<ExportParameter>& parameters,
                                         const std::array<std::size_t, 2>& size) {
    const std::vector<Pair> all = pairs(formulas, parameters, size);
    const double extent = size_of(all);
    const double distance = extent > 0.0 ? extent : std::numeric_limits<double>::infinity();
    SinglePrecision made{.rays = all.size()};
    std::vector<double> differences;
    for (const Pair& pair : all) {
        if (pair.exact.valid != pair.single.valid) {
            ++made.lost;
        }
        if (!pair.exact.valid || !pair.single.valid) {
            continue;
        }
        const double pixels = rays::pixels_between(pair.exact, pair.single, distance);
        differences.push_back(pixels);
        if (pixels > made.largest) {
            made.largest = pixels;
            made.x = pair.x;
            made.y = pair.y;
        }
    }
    if (!differences.empty()) {
        const auto rank =
            differences.begin() +
            static_cast<std::ptrdiff_t>(0.99 * static_cast<double>(differences.size() - 1));
        std::nth_element(differences.begin(), rank, differences.end());
        made.usual = *rank;
    }
    return made;
}

}  // namespace balcony::bridge
