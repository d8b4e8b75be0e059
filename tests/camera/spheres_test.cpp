// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The sphere's parametrisations: what they keep, what they cover, and where they end.

#include <functional>
#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::spheres_test {

namespace {

using std::numbers::pi;
constexpr double radius = 3.0;
constexpr double tolerance = 1e-13;  // a handful of roundings of coordinates up to 3

GeneratorProbe sphere(std::string_view by) {
    return GeneratorProbe(
        object("sphere", {{"radius", numbers({radius})}, {"by", std::string(by)}}));
}

double area(const Sample& s) { return length(cross(s.along_u, s.along_v)); }

void at_random_places(double u_max, double v_max,
                      const std::function<void(double u, double v)>& check) {
    std::mt19937_64 random(73);
    std::uniform_real_distribution<double> any(-1.0, 1.0);
    for (int i = 0; i < 400; ++i) {
        const double u = any(random);
        check(u_max * u, v_max * any(random));
    }
}

constexpr std::array parametrisations{"latitude",    "stereographic", "equal_area",
                                      "equidistant", "orthographic",  "cylindrical_equal_area",
                                      "mollweide",   "cube",          "equiangular_cube"};

}  // namespace

TEST(SphereParametrisations, LieOnTheSphereAndFaceOutwards) {
    for (const std::string_view by : parametrisations) {
        const GeneratorProbe probe = sphere(by);
        int valid = 0;
        at_random_places(3.0, 1.5, [&](double u, double v) {
            const Sample s = probe(u, v);
            valid += s.valid ? 1 : 0;
            if (s.valid) {
                EXPECT_NEAR(length(s.point), radius, tolerance) << by;
                const Vector normal = cross(s.along_u, s.along_v);
                EXPECT_NEAR(dot(normal, s.point) / (length(normal) * radius), 1.0, 1e-10) << by;
            }
        });
        EXPECT_GT(valid, 50) << by;
    }
}

TEST(SphereParametrisations, StartOnTheXAxisWithUTowardsYAndVTowardsZ) {
    for (const std::string_view by : parametrisations) {
        const Sample s = sphere(by)(0.0, 0.0);
        EXPECT_TRUE(s.valid) << by;
        expect_near(s.point, {radius, 0.0, 0.0}, tolerance);
        expect_near((1.0 / length(s.along_u)) * s.along_u, {0.0, 1.0, 0.0}, tolerance);
        expect_near((1.0 / length(s.along_v)) * s.along_v, {0.0, 0.0, 1.0}, tolerance);
    }
}

TEST(StereographicSphere, IsConformalAndTheProjectionFromTheFarPole) {
    const GeneratorProbe probe = sphere("stereographic");
    at_random_places(8.0, 8.0, [&](double u, double v) {
        const Sample s = probe(u, v);
        EXPECT_TRUE(s.valid);
        EXPECT_NEAR(dot(s.along_u, s.along_v), 0.0, tolerance);
        EXPECT_NEAR(length(s.along_u), length(s.along_v), tolerance);
        // From (-3, 0, 0) through the point to the plane x = 3.
        const double reach = 2.0 * radius / (s.point[0] + radius);
        EXPECT_NEAR(reach * s.point[1], radius * u, 1e-11);
        EXPECT_NEAR(reach * s.point[2], radius * v, 1e-11);
    });
}

TEST(EqualAreaSpheres, HaveAreasInProportionEverywhere) {
    for (const std::string_view by : {"equal_area", "cylindrical_equal_area", "mollweide"}) {
        const GeneratorProbe probe = sphere(by);
        int valid = 0;
        at_random_places(2.8, 1.4, [&](double u, double v) {
            const Sample s = probe(u, v);
            if (s.valid) {
                // Near their borders the derivatives of the maps' roots lose digits.
                EXPECT_NEAR(area(s), radius * radius, 1e-8) << by << ' ' << u << ' ' << v;
                ++valid;
            }
        });
        EXPECT_GT(valid, 150) << by;
    }
}

// Areas are kept, so each map covers the sphere once if it is valid on an area of 4 pi.
TEST(EqualAreaSpheres, CoverTheSphereOnce) {
    constexpr int cells = 400;
    for (const auto& [by, u_max, v_max] :
         {std::tuple("equal_area", 2.2, 2.2), std::tuple("mollweide", 3.0, 1.5)}) {
        const GeneratorProbe probe = sphere(by);
        int valid = 0;
        for (int i = 0; i < cells; ++i) {
            for (int j = 0; j < cells; ++j) {
                valid += probe(u_max * (2.0 * i + 1.0 - cells) / cells,
                               v_max * (2.0 * j + 1.0 - cells) / cells)
                             .valid;
            }
        }
        const double covered = 4.0 * u_max * v_max * valid / (cells * cells);
        EXPECT_NEAR(covered, 4.0 * pi, 0.02) << by;  // a boundary of 10 cuts cells of 0.01
    }
}

TEST(EqualAreaSpheres, AreTheTextbookMaps) {
    const GeneratorProbe azimuthal = sphere("equal_area");
    at_random_places(1.4, 1.4, [&](double u, double v) {
        const Vector chord = azimuthal(u, v).point - Vector{radius, 0.0, 0.0};
        EXPECT_NEAR(length(chord), radius * std::hypot(u, v), tolerance);
        EXPECT_NEAR(chord[1] * v, chord[2] * u, tolerance);
    });
    const GeneratorProbe cylindrical = sphere("cylindrical_equal_area");
    at_random_places(3.1, 0.99, [&](double u, double v) {
        const Vector p = cylindrical(u, v).point;
        EXPECT_NEAR(p[2], radius * v, tolerance);
        EXPECT_NEAR(std::atan2(p[1], p[0]), u, 1e-12);
    });
    // Mollweide's equation for the auxiliary angle t with v = sqrt(2) sin t.
    const GeneratorProbe mollweide = sphere("mollweide");
    at_random_places(1.0, 1.39, [&](double u, double v) {
        const Vector p = mollweide(u, v).point;
        const double t = std::asin(v / std::sqrt(2.0));
        if (mollweide(u, v).valid) {
            EXPECT_NEAR(2.0 * t + std::sin(2.0 * t), pi * p[2] / radius, 1e-12);
            EXPECT_NEAR(2.0 * std::sqrt(2.0) / pi * std::atan2(p[1], p[0]) * std::cos(t), u, 1e-11);
        }
    });
}

// The fisheye lenses by their textbook radii as functions of the angle to the axis.
TEST(FisheyeSpheres, HaveTheirRadiusAtEachAngle) {
    const std::array lenses{
        std::pair(
            "equidistant", +[](double angle) { return angle; }),
        std::pair(
            "equal_area", +[](double angle) { return 2.0 * std::sin(0.5 * angle); }),
        std::pair(
            "stereographic", +[](double angle) { return 2.0 * std::tan(0.5 * angle); }),
        std::pair(
            "orthographic", +[](double angle) { return std::sin(angle); })};
    for (const auto& [by, radius_at] : lenses) {
        const GeneratorProbe probe = sphere(by);
        at_random_places(0.45 * pi, pi, [&, f = radius_at](double angle, double turn) {
            const double r = f(std::abs(angle));
            const Sample s = probe(r * std::cos(turn), r * std::sin(turn));
            EXPECT_TRUE(s.valid);
            const double sine = radius * std::sin(std::abs(angle));
            expect_near(s.point,
                        {radius * std::cos(angle), sine * std::cos(turn), sine * std::sin(turn)},
                        1e-12);
        });
    }
    EXPECT_FALSE(sphere("equidistant")(pi + 1e-9, 0.0).valid);
    EXPECT_FALSE(sphere("orthographic")(0.8, 0.7).valid);
}

TEST(CubeSphere, ShowsSixFacesWhereTheyAre) {
    for (const std::string_view by : {"cube", "equiangular_cube"}) {
        const GeneratorProbe probe = sphere(by);
        expect_near(probe(0.0, 0.0).point, {radius, 0.0, 0.0}, tolerance);
        expect_near(probe(2.0, 0.0).point, {0.0, radius, 0.0}, tolerance);
        expect_near(probe(4.0, 0.0).point, {-radius, 0.0, 0.0}, tolerance);
        expect_near(probe(-2.0, 0.0).point, {0.0, -radius, 0.0}, tolerance);
        expect_near(probe(0.0, 2.0).point, {0.0, 0.0, radius}, tolerance);
        expect_near(probe(0.0, -2.0).point, {0.0, 0.0, -radius}, tolerance);
        // No ray beside the cross.
        for (const auto& [u, v] :
             {std::pair(2.0, 2.0), std::pair(-2.0, -2.0), std::pair(4.0, 2.0), std::pair(5.5, 0.0),
              std::pair(-3.5, 0.0), std::pair(0.0, 3.5), std::pair(0.0, -3.5)}) {
            EXPECT_FALSE(probe(u, v).valid) << u << ' ' << v;
        }
    }
}

// From one face to the next across a joint of the cross, and across the edges of the cube that the
// cross cuts: each cut edge is seen twice, at the places that the paper cube would be glued.
TEST(CubeSphere, FacesJoinWithoutAGap) {
    constexpr double e = 1e-12;
    for (const std::string_view by : {"cube", "equiangular_cube"}) {
        const GeneratorProbe probe = sphere(by);
        const auto meet = [&](double u, double v, double other_u, double other_v) {
            EXPECT_TRUE(probe(u, v).valid && probe(other_u, other_v).valid);
            expect_near(probe(u, v).point, probe(other_u, other_v).point, 1e-11);
        };
        for (double s = -0.99; s < 1.0; s += 0.11) {
            for (const double joint : {-1.0, 1.0, 3.0}) {
                meet(joint - e, s, joint + e, s);
            }
            meet(s, 1.0 - e, s, 1.0 + e);
            meet(s, -1.0 - e, s, -1.0 + e);
            meet(-3.0 + e, s, 5.0 - e, s);                 // right and back
            meet(1.0 - e, 2.0 + s, 2.0 + s, 1.0 - e);      // top and left
            meet(-1.0 + e, 2.0 + s, -2.0 - s, 1.0 - e);    // top and right
            meet(s, 3.0 - e, 4.0 - s, 1.0 - e);            // top and back
            meet(1.0 - e, -2.0 - s, 2.0 + s, -1.0 + e);    // bottom and left
            meet(-1.0 + e, -2.0 - s, -2.0 - s, -1.0 + e);  // bottom and right
            meet(s, -3.0 + e, 4.0 - s, -1.0 + e);          // bottom and back
        }
    }
}

TEST(CubeSphere, FacesAreFlatPicturesOrOfEqualAngles) {
    const GeneratorProbe flat = sphere("cube");
    const GeneratorProbe equiangular = sphere("equiangular_cube");
    at_random_places(0.999, 0.999, [&](double u, double v) {
        const Vector p = flat(u, v).point;
        EXPECT_NEAR(p[1] / p[0], u, tolerance);
        EXPECT_NEAR(p[2] / p[0], v, tolerance);
        const Vector q = equiangular(u, v).point;
        EXPECT_NEAR(std::atan2(q[1], q[0]), 0.25 * pi * u, tolerance);
        EXPECT_NEAR(std::atan2(q[2], q[0]), 0.25 * pi * v, tolerance);
    });
}

}  // namespace balcony::camera::spheres_test
