// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Transformers that add an offset from a field to a point: vector<Expr> field(point, emit),
// one per coordinate.

#include <array>
#include <span>
#include <utility>
#include <vector>

#include "balcony/emitter.hpp"
#include "camera/catalogue/stage_parameters.hpp"

namespace balcony::camera {

template <class Field>
class ParameterOffset final : public ParameterTransformer {
public:
    ParameterOffset(Field field, Scalar amount)
        : field_(std::move(field)), amount_(std::move(amount)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> offset = field_(std::array{p.u, p.v}, emit);
        const Expr amount = emit(amount_);
        return {p.u + amount * offset[0], p.v + amount * offset[1]};
    }

private:
    Field field_;
    Scalar amount_;
};

template <class Field>
class ObjectOffset final : public ObjectTransformer {
public:
    ObjectOffset(Field field, Scalar amount)
        : field_(std::move(field)), amount_(std::move(amount)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const std::vector<Expr> offset = field_(std::array{p.x, p.y, p.z}, emit);
        return p + emit(amount_) * ObjectVector{offset[0], offset[1], offset[2]};
    }

private:
    Field field_;
    Scalar amount_;
};

inline StageParameter amount_parameter() {
    return number_parameter("amount", 1.0, "strength of the distortion; 0 is none");
}

}  // namespace balcony::camera
