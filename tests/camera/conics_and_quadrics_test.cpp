// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Conics as curves of their own, in every parametrisation, and quadrics made of them.

#include <numbers>
#include <random>

#include "support.hpp"

namespace balcony::camera::conics_and_quadrics_test {

namespace {

using std::numbers::pi;

Given conic(double a, double b, std::string_view by) {
    return {{"a", numbers({a})}, {"b", numbers({b})}, {"by", std::string(by)}};
}

double square(double x) { return x * x; }

}  // namespace

TEST(Ellipse, SolvesItsEquationInEveryParametrisation) {
    for (const std::string_view by : {"trigonometric", "arc_length", "polar", "focal"}) {
        const GeneratorProbe curve(object("ellipse", conic(3.0, 2.0, by)));
        for (double u = -7.0; u < 7.0; u += 0.0731) {
            const Sample s = curve(u);
            EXPECT_TRUE(s.valid);
            EXPECT_NEAR(square(s.point[0] / 3.0) + square(s.point[1] / 2.0), 1.0, 1e-13) << by;
            EXPECT_EQ(s.point[2], 0.0);
        }
        // Counter-clockwise from the x axis, once in 360 degrees.
        expect_near(curve(0.0).point, {3.0, 0.0, 0.0}, 1e-12);
        EXPECT_GT(curve(0.0).along_u[1], 0.1);
        expect_near(curve(pi).point, {-3.0, 0.0, 0.0}, 1e-7);  // the arc length is from a table
    }
}

TEST(Ellipse, IsParametrisedAsItSays) {
    const GeneratorProbe trigonometric(object("ellipse", conic(3.0, 2.0, "trigonometric")));
    const GeneratorProbe arc_length(object("ellipse", conic(3.0, 2.0, "arc_length")));
    const GeneratorProbe polar(object("ellipse", conic(3.0, 2.0, "polar")));
    const GeneratorProbe focal(object("ellipse", conic(3.0, 2.0, "focal")));
    const double c = std::sqrt(5.0);
    const double speed = length(arc_length(0.1).along_u);
    for (double u = -3.1; u < 3.1; u += 0.0731) {
        expect_near(trigonometric(u).point, {3.0 * std::cos(u), 2.0 * std::sin(u), 0.0}, 1e-14);
        EXPECT_NEAR(std::atan2(polar(u).point[1], polar(u).point[0]), u, 1e-13);
        EXPECT_NEAR(std::atan2(focal(u).point[1], focal(u).point[0] - c), u, 1e-13);
        EXPECT_NEAR(length(arc_length(u).along_u), speed, 1e-5);  // a table's slope
    }
    // Its length, by Ramanujan's second series to 1e-8.
    EXPECT_NEAR(2.0 * pi * speed, 15.8654395892906, 1e-4);
}

TEST(Ellipse, ByItsFocalAngleIsWiderThanHigh) {
    const auto made = try_stage(StageKind::object_generator, "ellipse", conic(1.0, 2.0, "focal"));
    ASSERT_FALSE(made);
    EXPECT_NE(made.diagnostics.front().remedy.find("rotate"), std::string::npos);
}

TEST(Hyperbola, SolvesItsEquationInEveryParametrisation) {
    const double asymptote = std::atan2(2.0, 3.0);
    const std::pair<std::string_view, double> ends[] = {{"hyperbolic", 2.0},
                                                        {"cartesian", 4.0},
                                                        {"trigonometric", 1.5},
                                                        {"polar", 0.99 * asymptote},
                                                        {"focal", 0.99 * (pi - asymptote)}};
    for (const auto& [by, end] : ends) {
        const GeneratorProbe curve(object("hyperbola", conic(3.0, 2.0, by)));
        for (double u = -end; u <= end; u += end / 40.0) {
            const Sample s = curve(u);
            EXPECT_TRUE(s.valid) << by << ' ' << u;
            EXPECT_GT(s.point[0], 2.9);
            // The difference of two squares is as exact as the larger one is.
            EXPECT_NEAR(square(s.point[0] / 3.0) - square(s.point[1] / 2.0), 1.0,
                        1e-13 * square(s.point[0]))
                << by << ' ' << u;
            EXPECT_GT(s.along_u[1], 0.0);
        }
    }
    const double c = std::sqrt(13.0);
    const GeneratorProbe polar(object("hyperbola", conic(3.0, 2.0, "polar")));
    const GeneratorProbe focal(object("hyperbola", conic(3.0, 2.0, "focal")));
    for (double u = -0.5; u < 0.5; u += 0.0731) {
        EXPECT_NEAR(std::atan2(polar(u).point[1], polar(u).point[0]), u, 1e-13);
        EXPECT_NEAR(std::atan2(focal(u).point[1], c - focal(u).point[0]), u, 1e-13);
    }
    for (const double beyond : {1.01, 1.2}) {
        EXPECT_FALSE(polar(beyond * asymptote).valid);
        EXPECT_FALSE(focal(beyond * (pi - asymptote)).valid);
    }
    EXPECT_FALSE(polar(pi).valid);  // the other branch
}

// A point of a parabola is as far from the focus as from the directrix.
TEST(Parabola, IsAsFarFromItsFocusAsFromItsDirectrix) {
    for (const std::string_view by : {"cartesian", "focal"}) {
        const GeneratorProbe curve(
            object("parabola", {{"focus", numbers({1.5})}, {"by", std::string(by)}}));
        for (double u = -3.0; u < 3.0; u += 0.0731) {
            const Sample s = curve(u);
            EXPECT_TRUE(s.valid);
            EXPECT_NEAR(length(s.point - Vector{1.5, 0.0, 0.0}), s.point[0] + 1.5,
                        1e-14 * (1.0 + s.point[0]))
                << by;
            const double parameter =
                by == "cartesian" ? s.point[1] : std::atan2(s.point[1], 1.5 - s.point[0]);
            EXPECT_NEAR(parameter, u, 1e-13);
        }
    }
    const GeneratorProbe focal(object("parabola", {{"by", std::string("focal")}}));
    EXPECT_FALSE(focal(3.2).valid || focal(-3.2).valid);
}

TEST(Superparabola, SolvesItsEquationAndIsTheParabolaForGammaOne) {
    for (const double gamma : {0.25, 0.5, 1.0, 1.5}) {
        for (const std::string_view by : {"cartesian", "root"}) {
            Given given = conic(3.0, 2.0, by);
            given["gamma"] = numbers({gamma});
            const GeneratorProbe curve(object("superparabola", given));
            for (double u = -2.0; u < 2.0; u += 0.0731) {
                const Vector p = curve(u).point;
                EXPECT_NEAR(p[0] / 3.0, std::pow(std::fabs(p[1] / 2.0), 2.0 / gamma),
                            1e-12 * (1.0 + p[0]))
                    << by << ' ' << gamma;
                EXPECT_EQ(p[1] > 0.0, u > 0.0);
            }
        }
    }
    // x = 3 (y/2)^2, so y^2 = 4/3 x and the focus is at 1/3.
    const GeneratorProbe super(object("superparabola", conic(3.0, 2.0, "cartesian")));
    const GeneratorProbe plain(object("parabola", {{"focus", numbers({1.0 / 3.0})}}));
    for (double u = -2.0; u < 2.0; u += 0.0731) {
        expect_near(super(u).point, plain(2.0 * u).point, 1e-13);
    }
}

namespace {

// |x/a|^e + su |y/b|^e, to the power f/e, + sv |z/c|^f: 1 on a superquadric.
double superquadric(const Vector& p, double gamma_u, double gamma_v, double sign_u, double sign_v) {
    const double e = 2.0 / gamma_u;
    const double f = 2.0 / gamma_v;
    const double round =
        std::pow(std::fabs(p[0] / 3.0), e) + sign_u * std::pow(std::fabs(p[1] / 2.0), e);
    return std::pow(round, f / e) + sign_v * std::pow(std::fabs(p[2] / 1.5), f);
}

Given with_axes(Given given) {
    given["a"] = numbers({3.0});
    given["b"] = numbers({2.0});
    given["c"] = numbers({1.5});
    return given;
}

struct Family {
    const char* quadric;
    const char* super;
    double sign_u, sign_v;
    std::vector<const char*> by_u, by_v;  // of the super form; one parameter `by` if they are equal
};

const std::vector<const char*> ellipses{"angle_centre", "trigonometric", "arc_length"};
const std::vector<const char*> hyperbolas{"cartesian", "hyperbolic", "trigonometric",
                                          "angle_centre"};

const Family families_of_quadrics[] = {
    {"ellipsoid", "superellipsoid", 1.0, 1.0, ellipses, ellipses},
    {"hyperboloid_one", "superhyperboloid_one", 1.0, -1.0, ellipses, hyperbolas},
    {"hyperboloid_two", "superhyperboloid_two", -1.0, -1.0, hyperbolas, hyperbolas},
};

std::vector<Given> choices_of(const Family& family) {
    std::vector<Given> all;
    for (const char* by_u : family.by_u) {
        for (const char* by_v : family.by_v) {
            if (family.by_u != family.by_v) {
                all.push_back({{"by_u", std::string(by_u)}, {"by_v", std::string(by_v)}});
            } else if (by_u == by_v) {
                all.push_back({{"by", std::string(by_u)}});
            }
        }
    }
    return all;
}

template <class Check>
void at_small_parameters(const Check& check) {
    std::mt19937_64 random(74);
    std::uniform_real_distribution<double> any(-0.75, 0.75);
    for (int i = 0; i < 100; ++i) {
        const double u = any(random);
        check(u, any(random));
    }
}

}  // namespace

TEST(Superquadrics, SolveTheirImplicitEquationsInEveryParametrisation) {
    for (const Family& family : families_of_quadrics) {
        for (const Given& by : choices_of(family)) {
            for (const auto& [gamma_u, gamma_v] : {std::pair(1.0, 1.0), std::pair(0.25, 0.5)}) {
                Given given = with_axes(by);
                given["gamma_u"] = numbers({gamma_u});
                given["gamma_v"] = numbers({gamma_v});
                const GeneratorProbe surface(object(family.super, given));
                at_small_parameters([&](double u, double v) {
                    const Sample s = surface(u, v);
                    ASSERT_TRUE(s.valid);
                    // The terms of a hyperboloid's difference are as large as its largest power.
                    const double largest = 1.0 +
                                           std::pow(std::fabs(s.point[2] / 1.5), 2.0 / gamma_v) +
                                           std::pow(s.point[0] / 3.0, 2.0 / gamma_u);
                    EXPECT_NEAR(
                        superquadric(s.point, gamma_u, gamma_v, family.sign_u, family.sign_v), 1.0,
                        1e-12 * largest * largest)
                        << family.super << ' ' << std::get<std::string>(by.begin()->second);
                });
            }
        }
    }
}

TEST(Superquadrics, OfGammaOneAreTheQuadrics) {
    for (const Family& family : families_of_quadrics) {
        const std::string by_v = family.sign_v > 0.0 ? "trigonometric" : "hyperbolic";
        const std::string by_u = family.sign_u > 0.0 ? "trigonometric" : "hyperbolic";
        const GeneratorProbe quadric(object(family.quadric, with_axes({{"by", by_v}})));
        const GeneratorProbe super(
            object(family.super, with_axes({{"by", by_v}, {"by_u", by_u}, {"by_v", by_v}})));
        at_small_parameters([&](double u, double v) {
            expect_near(quadric(u, v).point, super(u, v).point, 1e-14);
        });
    }
}

TEST(Superquadrics, AreTheProductsOfThePaper) {
    const auto curve = [](const char* name, double a, double b, double gamma) {
        return object(name, {{"a", numbers({a})},
                             {"b", numbers({b})},
                             {"gamma", numbers({gamma})},
                             {"by", std::string("hyperbolic")}});
    };
    // The camera of plate 7.
    const GeneratorProbe product(
        object("product", {{"g", curve("superhyperbola", 1.0, 45.0 / 81.0, 0.25)},
                           {"h", curve("superhyperbola", 40.5, 22.5, 0.25)}}));
    const GeneratorProbe ready(object("superhyperboloid_two", {{"a", numbers({40.5})},
                                                               {"b", numbers({22.5})},
                                                               {"c", numbers({22.5})},
                                                               {"gamma_u", numbers({0.25})},
                                                               {"gamma_v", numbers({0.25})},
                                                               {"by", std::string("hyperbolic")}}));
    at_small_parameters(
        [&](double u, double v) { expect_near(ready(u, v).point, product(u, v).point, 1e-12); });
}

TEST(Superquadrics, CanChangeWithTime) {
    Given given = with_axes({});
    given["a"] = std::vector<Scalar>{Scalar(formula(0, [](Graph& graph, const std::vector<Expr>&) {
        return std::vector{3.0 + graph.time()};
    }))};
    const GeneratorProbe surface(object("ellipsoid", given));
    expect_near(surface(0.0, 0.0, 2.0).point, {5.0, 0.0, 0.0}, 1e-14);
    expect_near(surface(pi / 2.0, 0.0, 2.0).point, {0.0, 2.0, 0.0}, 1e-14);
}

// The angles of the poles are doubles a little off a quarter turn; what is made of them must not
// lie beyond, where the cross product of the tangents points inwards.
TEST(Superquadrics, HaveOutwardNormalsAtTheirPolesToo) {
    for (const double gamma : {0.25, 1.0, 1.5}) {
        for (const std::string_view by : {"angle_centre", "arc_length"}) {
            const Given given{{"a", numbers({3.0})},
                              {"b", numbers({2.0})},
                              {"gamma_u", numbers({gamma})},
                              {"gamma_v", numbers({gamma})},
                              {"by", std::string(by)}};
            const GeneratorProbe surface(object("superellipsoid", given));
            for (const double v : {-0.5 * pi, 0.5 * pi}) {
                for (double u = -3.0; u < 3.0; u += 0.37) {
                    const Sample s = surface(u, v);
                    EXPECT_GT(cross(s.along_u, s.along_v)[2] * v, 0.0) << by << ' ' << gamma;
                }
            }
        }
    }
}

TEST(Toroids, SolveTheirImplicitEquations) {
    const Given measures{{"a", numbers({5.0})},
                         {"b", numbers({4.0})},
                         {"tube", numbers({2.0})},
                         {"c", numbers({1.5})}};
    const auto equation = [](const Vector& p, double gamma_u, double gamma_v) {
        // The middle line's own distance from the axis is 5 in the direction of p, after scaling.
        const double e = 2.0 / gamma_u;
        const double round = std::pow(
            std::pow(std::fabs(p[0]), e) + std::pow(std::fabs(p[1] * 5.0 / 4.0), e), 1.0 / e);
        const double f = 2.0 / gamma_v;
        return std::pow(std::fabs((round - 5.0) / 2.0), f) + std::pow(std::fabs(p[2] / 1.5), f);
    };
    const GeneratorProbe toroid(object("toroid", measures));
    for (const char* by : ellipses) {
        Given given = measures;
        given["by"] = std::string(by);
        given["gamma_u"] = numbers({0.25});
        given["gamma_v"] = numbers({0.5});
        const GeneratorProbe super(object("supertoroid", given));
        given["gamma_u"] = given["gamma_v"] = numbers({1.0});
        const GeneratorProbe plain(object("supertoroid", given));
        for (double u = -3.1; u < 3.1; u += 0.31) {
            for (double v = -3.1; v < 3.1; v += 0.31) {
                EXPECT_NEAR(equation(super(u, v).point, 0.25, 0.5), 1.0, 1e-12);
                EXPECT_NEAR(equation(toroid(u, v).point, 1.0, 1.0), 1.0, 1e-12);
                if (std::string_view(by) != "arc_length") {
                    expect_near(plain(u, v).point, toroid(u, v).point, 1e-13);
                }
            }
        }
    }
}

TEST(Toroids, OfCirclesAreTheTorus) {
    const GeneratorProbe toroid(object("toroid", {{"a", numbers({5.0})},
                                                  {"b", numbers({5.0})},
                                                  {"tube", numbers({2.0})},
                                                  {"c", numbers({2.0})}}));
    const GeneratorProbe torus(
        object("torus", {{"major", numbers({5.0})}, {"minor", numbers({2.0})}}));
    at_small_parameters([&](double u, double v) {
        expect_near(toroid(4.0 * u, 4.0 * v).point, torus(4.0 * u, 4.0 * v).point, 1e-13);
    });
}

}  // namespace balcony::camera::conics_and_quadrics_test
