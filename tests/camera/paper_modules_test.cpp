// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Every module of the paper's section 3 is a stage of the catalogue, by name.

#include <algorithm>

#include <gtest/gtest.h>

#include "balcony/catalogue.hpp"

namespace balcony::camera::paper_modules_test {

namespace {

struct Module {
    const char* what;  // As the paper's section 3 has it.
    StageKind kind;
    std::vector<std::string_view> stages;
};

constexpr StageKind pcs = StageKind::parameter_transformer;
constexpr StageKind ocs = StageKind::object_transformer;
constexpr StageKind object = StageKind::object_generator;
constexpr StageKind rule = StageKind::direction_rule;

const std::vector<Module> modules = {
    {"affine 2D", pcs, {"translate", "scale", "rotate", "shear", "affine"}},
    {"affine 3D", ocs, {"translate", "scale", "rotate", "stretch", "mirror", "affine"}},
    {"local zoom", pcs, {"zoom"}},
    {"grid distortion 2D", pcs, {"grid"}},
    {"grid distortion 3D", ocs, {"grid"}},
    {"warping by seed points", pcs, {"thin_plate", "inverse_distance"}},
    {"warping by line pairs", pcs, {"line_pairs"}},
    {"centres of interest", ocs, {"coin", "coins"}},
    {"user formulas", pcs, {"formula"}},
    {"user formulas", ocs, {"formula"}},
    {"iteration", pcs, {"repeat"}},
    {"iteration", ocs, {"repeat"}},
    {"analytic primitives",
     object,
     {"point", "line", "circle", "plane", "disc", "sphere", "cylinder", "cone", "torus", "ellipse",
      "helix", "ring", "paraboloid", "mobius_band"}},
    {"quadrics and superquadrics",
     object,
     {"ellipsoid", "hyperboloid_one", "hyperboloid_two", "toroid", "superellipsoid",
      "superhyperboloid_one", "superhyperboloid_two", "supertoroid", "product"}},
    {"conics and superconics",
     object,
     {"ellipse", "hyperbola", "parabola", "superellipse", "superhyperbola", "superparabola"}},
    {"general curves",
     object,
     {"catmull_rom", "natural_spline", "bezier", "bspline", "nurbs", "arc_length"}},
    {"free-form surfaces",
     object,
     {"bezier_patch", "bspline_patch", "nurbs_patch", "interpolating_patch"}},
    {"sweeps", object, {"sweep"}},
    {"fractal objects", object, {"fractal_plane", "fractal_sphere"}},
    {"direction rules", rule, {"normal", "absolute", "relative", "tangent", "along", "blend"}},
};

}  // namespace

TEST(PaperModules, AreAllInTheCatalogue) {
    for (const Module& module : modules) {
        for (const std::string_view stage : module.stages) {
            EXPECT_NE(catalogue().find(module.kind, stage), nullptr)
                << module.what << ": " << stage;
        }
    }
}

TEST(PaperModules, HaveTheParametrisationsOfTheSphere) {
    const StageEntry* sphere = catalogue().find(object, "sphere");
    ASSERT_NE(sphere, nullptr);
    for (const StageParameter& parameter : sphere->parameters) {
        if (const auto* by = parameter.as<ChoiceParameter>()) {
            for (const char* choice : {"latitude", "stereographic", "equal_area", "cube"}) {
                EXPECT_NE(std::find(by->choices.begin(), by->choices.end(), choice),
                          by->choices.end())
                    << choice;
            }
            return;
        }
    }
    FAIL() << "the sphere has one parametrisation only";
}

}  // namespace balcony::camera::paper_modules_test
