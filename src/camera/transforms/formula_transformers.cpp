// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Parameter transformers (PCS → PCS) and object transformers (OCS → OCS) that a user writes as
// formulas.

#include "camera/catalogue/families.hpp"

namespace balcony::camera {

namespace {

/// formula(u, v) = [u', v'].
class ParameterFormula final : public ParameterTransformer {
public:
    explicit ParameterFormula(Formula formula) : formula_(std::move(formula)) {}
    ParameterPoint transform(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> uv = formula_.emit(emit.graph(), std::array{p.u, p.v});
        return {uv[0], uv[1]};
    }

private:
    Formula formula_;
};

/// formula(x, y, z) = [x', y', z'].
class ObjectFormula final : public ObjectTransformer {
public:
    explicit ObjectFormula(Formula formula) : formula_(std::move(formula)) {}
    ObjectPoint transform(const ObjectPoint& p, Emitter& emit) const override {
        const std::vector<Expr> xyz = formula_.emit(emit.graph(), std::array{p.x, p.y, p.z});
        return {xyz[0], xyz[1], xyz[2]};
    }

private:
    Formula formula_;
};

}  // namespace

std::vector<StageEntry> formula_transformers() {
    return {
        {.kind = StageKind::parameter_transformer,
         .name = "formula",
         .meaning = "a map of parameter space: formula(u, v) = [u', v']",
         .formula = R"(
(u′, v′) = [a, b]
)",
         .make = [](const Arguments& a) { return made<ParameterFormula>(a.formula()); },
         .shape = FormulaShape{2, 2, 2},
         .example = R"(
// Looks through rippled glass.
camera rippled {
    map    u = 40deg .. -40deg, v = square
    warp   formula(u, v) = [u + 1deg*sin(20*v), v + 1deg*sin(20*u)]
    eye    point
    toward sphere(1)
}
)"},
        {.kind = StageKind::object_transformer,
         .name = "formula",
         .meaning = "a map of object space: formula(x, y, z) = [x', y', z']",
         .formula = R"(
(x′, y′, z′) = [a, b, c]
)",
         .make = [](const Arguments& a) { return made<ObjectFormula>(a.formula()); },
         .shape = FormulaShape{3, 3, 3},
         .example = R"(
// A plane bent by a wave: its normals diverge on crests and converge over troughs.
camera bent {
    map  u = 2 .. -2, v = square
    eye  plane
    look normal
    move formula(x, y, z) = [x + 0.1*cos(3*y), y, z]
}
)"},
    };
}

}  // namespace balcony::camera
