// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS, that a user writes as formulas.

#include "camera/families.hpp"

namespace balcony::camera {

namespace {

/// curve(u) = [x, y] or [x, y, z].
class FormulaCurve final : public ObjectGenerator {
public:
    explicit FormulaCurve(Formula formula) : formula_(std::move(formula)) {}
    int dimension() const override { return 1; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> xyz = formula_.emit(emit.graph(), std::array{p.u});
        return {xyz[0], xyz[1], xyz.size() > 2 ? xyz[2] : emit(0.0)};
    }

private:
    Formula formula_;
};

/// surface(u, v) = [x, y, z].
class FormulaSurface final : public ObjectGenerator {
public:
    explicit FormulaSurface(Formula formula) : formula_(std::move(formula)) {}
    int dimension() const override { return 2; }
    ObjectPoint generate(const ParameterPoint& p, Emitter& emit) const override {
        const std::vector<Expr> xyz = formula_.emit(emit.graph(), std::array{p.u, p.v});
        return {xyz[0], xyz[1], xyz[2]};
    }

private:
    Formula formula_;
};

}  // namespace

std::vector<StageEntry> formula_objects() {
    const StageKind kind = StageKind::object_generator;
    return {
        {kind,
         "curve",
         "a curve by formula: curve(u) = [x, y] or [x, y, z]",
         {},
         [](const Arguments& a) { return made<FormulaCurve>(a.formula()); },
         FormulaShape{1, 2, 3},
         1},
        {kind,
         "surface",
         "a surface by formula: surface(u, v) = [x, y, z]",
         {},
         [](const Arguments& a) { return made<FormulaSurface>(a.formula()); },
         FormulaShape{2, 3, 3},
         2},
    };
}

}  // namespace balcony::camera
