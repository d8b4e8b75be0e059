// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curve_sampler.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::camera {

namespace {

constexpr std::size_t batch = 64;

// Computes a node that is not a leaf for `count` points, with its arguments at the
// pointers.
void evaluate(const Graph& graph, const expr::Node& node, const double* const* arguments,
              std::size_t count, double* results) {
    if (expr::is_native(node.op)) {
        graph.native(expr::NativeId(node.detail))->evaluate(count, arguments, results);
        return;
    }
    const expr::Operation& operation = expr::operation(node.op);
    const auto arity = static_cast<std::size_t>(operation.arity);
    const expr::Table* table =
        expr::is_lookup(node.op) ? graph.table(expr::TableId(node.detail)).get() : nullptr;
    for (std::size_t i = 0; i < count; ++i) {
        std::array<double, 3> at{};
        for (std::size_t k = 0; k < arity; ++k) {
            at[k] = arguments[k][i];
        }
        results[i] =
            table != nullptr ? (*table)(std::span(at).first(arity)) : operation.scalar(at.data());
    }
}

}  // namespace

double norm(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

bool at_same_point(const CurveSample& a, const CurveSample& b) {
    const Vector3 apart{b.point[0] - a.point[0], b.point[1] - a.point[1], b.point[2] - a.point[2]};
    // Parameters such as 360deg have a rounding error, and so have values computed from them.
    return norm(apart) <= 1e-9 * (norm(a.point) + norm(a.velocity));
}

Result<CurveSampler> CurveSampler::make(const ObjectGenerator& curve, Derivatives derivatives) {
    CurveSampler made;
    Graph& graph = *made.graph_;
    Emitter emit(graph);
    const Expr parameter = graph.fresh_variable();
    const ObjectPoint p = curve.generate({parameter, emit(0.0)}, emit);
    made.roots_ = {p.x, p.y, p.z};
    for (std::size_t order = 0; order < (derivatives == Derivatives::first ? 1 : 2); ++order) {
        const std::vector<Expr> slopes =
            expr::differentiate(std::span(made.roots_).subspan(3 * order, 3), parameter);
        made.roots_.insert(made.roots_.end(), slopes.begin(), slopes.end());
    }
    made.roots_.push_back(emit.valid());
    made.roots_ = expr::simplify(made.roots_);
    made.nodes_ = expr::reachable(graph, made.roots_);
    made.places_.resize(graph.size());
    for (std::size_t i = 0; i < made.nodes_.size(); ++i) {
        made.places_[made.nodes_[i].value()] = i;
        if (graph[made.nodes_[i]].op == expr::Op::input) {
            return error("a tabulated curve cannot change with time", {},
                         "remove t from the curve; use it outside of the curve");
        }
    }
    return made;
}

// Node by node over the batch; values[place * batch + i] for point i.
void CurveSampler::run(std::span<const double> parameters, std::span<double> values) const {
    for (std::size_t place = 0; place < nodes_.size(); ++place) {
        const expr::Node& node = (*graph_)[nodes_[place]];
        double* results = values.data() + place * batch;
        if (node.op == expr::Op::constant) {
            std::fill_n(results, batch, node.value);
        } else if (node.op == expr::Op::variable) {
            std::copy(parameters.begin(), parameters.end(), results);
        } else {
            std::array<const double*, 3> arguments{};
            for (std::size_t k = 0; k < arguments.size() && node.arguments[k].valid(); ++k) {
                arguments[k] = values.data() + places_[node.arguments[k].value()] * batch;
            }
            evaluate(*graph_, node, arguments.data(), parameters.size(), results);
        }
    }
}

std::vector<CurveSample> CurveSampler::operator()(std::span<const double> parameters) const {
    std::vector<CurveSample> samples(parameters.size());
    std::vector<double> values(nodes_.size() * batch);
    for (std::size_t begin = 0; begin < parameters.size(); begin += batch) {
        const std::size_t count = std::min(batch, parameters.size() - begin);
        run(parameters.subspan(begin, count), values);
        for (std::size_t i = 0; i < count; ++i) {
            const auto root = [&](std::size_t number) {
                return values[places_[roots_[number].id().value()] * batch + i];
            };
            const bool valid = root(roots_.size() - 1) != 0.0;
            const auto vector = [&](std::size_t number) {
                constexpr double none = std::numeric_limits<double>::quiet_NaN();
                return valid ? Vector3{root(number), root(number + 1), root(number + 2)}
                             : Vector3{none, none, none};
            };
            CurveSample& sample = samples[begin + i];
            sample.point = vector(0);
            sample.velocity = vector(3);
            sample.acceleration = roots_.size() > 7 ? vector(6) : Vector3{};
        }
    }
    return samples;
}

}  // namespace balcony::camera
