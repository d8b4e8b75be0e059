// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "transform_probe.hpp"

namespace balcony::camera {

WarpProbe::WarpProbe(const ParameterTransformerPointer& transformer) {
    Emitter emit(*graph_);
    const Expr u = graph_->picture_x();
    const Expr v = graph_->picture_y();
    const ParameterPoint p = transformer->transform({u, v}, emit);
    roots_ = {p.u, p.v};
    for (const Expr leaf : {u, v}) {
        for (const Expr slope : expr::differentiate(std::array{p.u, p.v}, leaf)) {
            roots_.push_back(slope);
        }
    }
    roots_.push_back(emit.valid());
}

WarpSample WarpProbe::operator()(double u, double v) const {
    const std::vector<double> r = expr::evaluate(roots_, {u, v, 0.0, {}});
    return {{r[0], r[1]}, {r[2], r[3]}, {r[4], r[5]}, r[6] != 0.0};
}

MoveProbe::MoveProbe(const ObjectTransformerPointer& transformer) {
    Emitter emit(*graph_);
    const std::array leaves{graph_->fresh_variable(), graph_->fresh_variable(),
                            graph_->fresh_variable()};
    const ObjectPoint p = transformer->transform({leaves[0], leaves[1], leaves[2]}, emit);
    roots_ = {p.x, p.y, p.z};
    for (const Expr leaf : leaves) {
        for (const Expr slope : expr::differentiate(std::array{p.x, p.y, p.z}, leaf)) {
            roots_.push_back(slope);
        }
    }
    roots_.push_back(emit.valid());
}

MoveSample MoveProbe::operator()(const Vector& p, double time) const {
    const std::vector<double> r = expr::evaluate(roots_, {0.0, 0.0, time, p});
    return {{r[0], r[1], r[2]},
            {{{r[3], r[4], r[5]}, {r[6], r[7], r[8]}, {r[9], r[10], r[11]}}},
            r[12] != 0.0};
}

PointList points(std::size_t coordinates, std::vector<double> values) {
    return {coordinates, std::move(values)};
}

}  // namespace balcony::camera
