// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Object generators, PCS → OCS, defined by formulas of the user.

#include "camera/catalogue/families.hpp"

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
    return {
        {.name = "curve",
         .meaning = "a curve from a formula: curve(u) = [x, y] or [x, y, z]",
         .formula = R"(
p = (x, y, z)      z = 0 if there are two results
)",
         .make = [](const Arguments& a) { return made<FormulaCurve>(a.formula()); },
         .shape = FormulaShape{1, 2, 3},
         .dimension = 1,
         .example = R"(
// The right side of a winding path through a valley, seen at right angles to the path.
camera valley_walk {
    map    u = 3 .. -3, v = -1 .. 1
    eye    curve(u) = [u, sin(u), 0.2*u^2]
    toward surface(u, v) = [u + cos(u), sin(u) - 1, 0.2*u^2 + v]
}
)"},
        {.name = "surface",
         .meaning = "a surface from a formula: surface(u, v) = [x, y, z]",
         .formula = R"(
p = (x, y, z)
)",
         .make = [](const Arguments& a) { return made<FormulaSurface>(a.formula()); },
         .shape = FormulaShape{2, 3, 3},
         .dimension = 2,
         .example = R"(
// A curved wall: its normals face both sides of a room's corner and spread between them.
camera bulge {
    map  u = 1.2 .. -1.2, v = -1 .. 1
    eye  surface(u, v) = [-3*cosh(u), 3*sinh(u), v]
    look normal
}
)"},
    };
}

}  // namespace balcony::camera
