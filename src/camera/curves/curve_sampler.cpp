// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "camera/curves/curve_sampler.hpp"

#include <algorithm>
#include <cmath>

namespace balcony::camera {

namespace {

constexpr std::size_t batch = 64;

}  // namespace

double norm(const Vector3& v) { return std::hypot(v[0], v[1], v[2]); }

bool at_same_point(const CurveSample& a, const CurveSample& b) {
    const Vector3 apart{b.point[0] - a.point[0], b.point[1] - a.point[1], b.point[2] - a.point[2]};
    // Parameters such as 360deg have a rounding error, and so have values computed from them.
    return norm(apart) <= 1e-9 * (norm(a.point) + norm(a.velocity));
}

CurveSampler::CurveSampler(std::shared_ptr<const Graph> graph, std::span<const Expr> expressions)
    : graph_(std::move(graph)), last_(expressions.size() - 1), evaluate_(expressions) {}

Result<CurveSampler> CurveSampler::make(const ObjectGenerator& curve, Derivatives derivatives) {
    const auto graph = std::make_shared<Graph>();
    Emitter emit(*graph);
    const Expr parameter = graph->fresh_variable();
    const ObjectPoint p = curve.generate({parameter, emit(0.0)}, emit);
    std::vector<Expr> roots{p.x, p.y, p.z};
    for (std::size_t order = 0; order < (derivatives == Derivatives::first ? 1 : 2); ++order) {
        const std::vector<Expr> slopes =
            expr::differentiate(std::span(roots).subspan(3 * order, 3), parameter);
        roots.insert(roots.end(), slopes.begin(), slopes.end());
    }
    roots.push_back(emit.valid());
    CurveSampler made(graph, expr::simplify(roots));
    for (const expr::NodeId id : made.evaluate_.leaves()) {
        const expr::Node& leaf = (*graph)[id];
        if (leaf.op == expr::Op::input) {
            const std::string& name = graph->input_names()[leaf.detail];
            const std::string what = name == "t" ? "time" : "the input '" + name + "'";
            return error("a tabulated curve cannot change with " + what, {},
                         "remove " + name + " from the curve; use it outside of the curve");
        }
    }
    return made;
}

std::vector<CurveSample> CurveSampler::operator()(std::span<const double> parameters) const {
    std::vector<CurveSample> samples(parameters.size());
    for (std::size_t begin = 0; begin < parameters.size(); begin += batch) {
        const std::size_t count = std::min(batch, parameters.size() - begin);
        const auto fill = [&](const expr::Node&, std::span<double> values) {
            std::copy_n(parameters.begin() + static_cast<std::ptrdiff_t>(begin), count,
                        values.begin());
        };
        const std::vector<double> values = evaluate_(count, fill);
        for (std::size_t i = 0; i < count; ++i) {
            const auto value = [&](std::size_t number) { return values[number * count + i]; };
            const bool valid = value(last_) != 0.0;
            const auto vector = [&](std::size_t number) {
                constexpr double none = std::numeric_limits<double>::quiet_NaN();
                return valid ? Vector3{value(number), value(number + 1), value(number + 2)}
                             : Vector3{none, none, none};
            };
            CurveSample& sample = samples[begin + i];
            sample.point = vector(0);
            sample.velocity = vector(3);
            sample.acceleration = last_ > 6 ? vector(6) : Vector3{};
        }
    }
    return samples;
}

}  // namespace balcony::camera
