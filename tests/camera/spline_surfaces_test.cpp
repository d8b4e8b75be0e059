// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Free-form surfaces from nets of points.

#include <random>

#include "support.hpp"

namespace balcony::camera::spline_surfaces_test {

namespace {

Arguments::Value points(std::size_t coordinates, std::vector<double> values) {
    return PointList{coordinates, std::move(values)};
}

Arguments::Value word(std::string_view choice) { return std::string(choice); }

/// A net of rows at random near a plane grid.
PointList random_net(std::size_t columns, std::size_t rows, std::size_t coordinates = 3) {
    std::mt19937_64 random(columns * 100 + rows);
    std::uniform_real_distribution<double> shift(-0.3, 0.3);
    PointList net{coordinates, {}};
    for (std::size_t j = 0; j < rows; ++j) {
        for (std::size_t i = 0; i < columns; ++i) {
            net.values.insert(net.values.end(),
                              {static_cast<double>(i) + shift(random),
                               static_cast<double>(j) + shift(random), 2.0 * shift(random)});
            if (coordinates == 4) {
                net.values.push_back(1.0 + shift(random));
            }
        }
    }
    return net;
}

/// A surface and the curves that its rows and its columns are: parameters of theirs, for a row's or
/// column's points to be added.
struct Case {
    std::string_view name;
    std::size_t columns, rows, coordinates;
    Given given;
    std::string_view curve;
    Given along_u, along_v;
    bool closed_u = false;
    bool closed_v = false;
};

std::vector<Case> cases() {
    const Arguments::Value yes = word("yes");
    const Arguments::Value uniform = word("uniform");
    const Arguments::Value knots = points(1, {0, 0, 0, 1, 1.5, 4, 4, 4});
    return {
        {"bezier_patch", 4, 3, 3, {}, "bezier", {}, {}},
        {"bezier_patch",
         7,
         6,
         3,
         {{"degree_u", numbers({2})}, {"degree_v", numbers({3})}, {"closed_v", yes}},
         "bezier",
         {{"degree", numbers({2})}},
         {{"degree", numbers({3})}, {"closed", yes}},
         false,
         true},
        {"bspline_patch", 6, 5, 3, {}, "bspline", {}, {}},
        {"bspline_patch",
         6,
         5,
         3,
         {{"degree_u", numbers({2})}, {"ends_u", word("closed")}, {"ends_v", word("open")}},
         "bspline",
         {{"degree", numbers({2})}, {"ends", word("closed")}},
         {{"ends", word("open")}},
         true,
         false},
        {"nurbs_patch",
         5,
         6,
         4,
         {{"degree_u", numbers({2})}, {"knots_u", knots}, {"ends_v", word("closed")}},
         "nurbs",
         {{"degree", numbers({2})}, {"knots", knots}},
         {{"ends", word("closed")}},
         false,
         true},
        {"interpolating_patch",
         5,
         4,
         3,
         {},
         "catmull_rom",
         {{"spacing", uniform}},
         {{"spacing", uniform}}},
        {"interpolating_patch",
         5,
         4,
         3,
         {{"by", word("natural")}, {"closed_u", yes}},
         "natural_spline",
         {{"spacing", uniform}, {"closed", yes}},
         {{"spacing", uniform}},
         true,
         false},
    };
}

Given given_of(const Case& made) {
    Given given = made.given;
    given["points"] = random_net(made.columns, made.rows, made.coordinates);
    given["columns"] = numbers({static_cast<double>(made.columns)});
    return given;
}

GeneratorProbe curve_through(std::string_view name, Given given, PointList through) {
    given["points"] = std::move(through);
    return GeneratorProbe(object(name, given));
}

}  // namespace

// The points of all rows at one u, taken as the points of a curve, make the curve of that u. (Of
// rational ones this holds for points times their weights, so their weights are 1 here.)
TEST(SplineSurfaces, AreCurvesOfCurves) {
    for (Case made : cases()) {
        Given given = given_of(made);
        PointList net = std::get<PointList>(given["points"]);
        for (std::size_t i = 3; made.coordinates == 4 && i < net.values.size(); i += 4) {
            net.values[i] = 1.0;
        }
        given["points"] = net;
        const GeneratorProbe surface(object(made.name, given));
        for (const double u : {0.0, 0.13, 0.5, 0.77, 1.0}) {
            PointList across{3, {}};
            for (std::size_t j = 0; j < made.rows; ++j) {
                PointList row{made.coordinates, {}};
                const auto begin = static_cast<std::ptrdiff_t>(j * made.columns * made.coordinates);
                row.values.assign(net.values.begin() + begin,
                                  net.values.begin() + begin +
                                      static_cast<std::ptrdiff_t>(made.columns * made.coordinates));
                const Vector p = curve_through(made.curve, made.along_u, row)(u).point;
                across.values.insert(across.values.end(), p.begin(), p.end());
            }
            const GeneratorProbe column = curve_through(made.curve, made.along_v, across);
            for (const double v : {0.0, 0.21, 0.6, 1.0}) {
                expect_near(surface(u, v).point, column(v).point, 1e-12);
            }
        }
    }
}

TEST(SplineSurfaces, RunFromNoughtToOneAndGoRoundIfClosed) {
    for (const Case& made : cases()) {
        const GeneratorProbe surface(object(made.name, given_of(made)));
        EXPECT_TRUE(surface(0.0, 0.0).valid && surface(1.0, 1.0).valid);
        EXPECT_EQ(surface(1.01, 0.5).valid, made.closed_u) << made.name;
        EXPECT_EQ(surface(0.5, -0.01).valid, made.closed_v) << made.name;
        if (made.closed_u) {
            expect_near(surface(2.3, 0.4).point, surface(0.3, 0.4).point, 1e-12);
        }
        if (made.closed_v) {
            expect_near(surface(0.3, -0.6).point, surface(0.3, 0.4).point, 1e-12);
        }
    }
}

TEST(SplineSurfaces, TangentsAreNeighbourDifferences) {
    for (const Case& made : cases()) {
        const GeneratorProbe surface(object(made.name, given_of(made)));
        for (double u = 0.013; u < 0.98; u += 0.0971) {
            for (double v = 0.011; v < 0.98; v += 0.0831) {
                constexpr double h = 1e-5;
                const Sample s = surface(u, v);
                // Third derivatives of some thousand, times h^2 / 6; where a second derivative
                // jumps within the step, which is by some hundred, times h / 2.
                expect_near(s.along_u,
                            (0.5 / h) * (surface(u + h, v).point - surface(u - h, v).point), 1e-3);
                expect_near(s.along_v,
                            (0.5 / h) * (surface(u, v + h).point - surface(u, v - h).point), 1e-3);
            }
        }
    }
}

TEST(SplineSurfaces, OfFourPointsAreBilinear) {
    const std::vector<double> net{0, 0, 0, 1, 0, 2, 0, 1, 3, 2, 2, -1};
    for (const std::string_view name :
         {"bezier_patch", "bspline_patch", "nurbs_patch", "interpolating_patch"}) {
        const GeneratorProbe surface(
            object(name, {{"points", points(3, net)}, {"columns", numbers({2})}}));
        for (const double u : {0.0, 0.3, 0.9}) {
            for (const double v : {0.1, 0.5, 1.0}) {
                Vector wanted{};
                for (std::size_t k = 0; k < 3; ++k) {
                    wanted[k] = (1 - v) * ((1 - u) * net[k] + u * net[3 + k]) +
                                v * ((1 - u) * net[6 + k] + u * net[9 + k]);
                }
                expect_near(surface(u, v).point, wanted, 1e-14);
            }
        }
    }
}

TEST(SplineSurfaces, AnInterpolatingPatchPassesItsNet) {
    const PointList net = random_net(5, 4);
    for (const std::string_view by : {"catmull_rom", "natural"}) {
        for (const std::string_view closed : {"no", "yes"}) {
            const GeneratorProbe surface(
                object("interpolating_patch", {{"points", net},
                                               {"columns", numbers({5})},
                                               {"by", word(by)},
                                               {"closed_u", word(closed)},
                                               {"closed_v", word(closed)}}));
            const double steps = closed == "yes" ? 0.0 : 1.0;
            for (std::size_t j = 0; j < 4; ++j) {
                for (std::size_t i = 0; i < 5; ++i) {
                    const auto p = net[j * 5 + i];
                    expect_near(surface(static_cast<double>(i) / (5.0 - steps),
                                        static_cast<double>(j) / (4.0 - steps))
                                    .point,
                                {p[0], p[1], p[2]}, 1e-13);
                }
            }
        }
    }
}

// An octant of the unit sphere (Piegl and Tiller, The NURBS Book, 8.4).
TEST(SplineSurfaces, ARationalPatchCanBeASphere) {
    const double w = std::sqrt(0.5);
    const GeneratorProbe sphere(
        object("nurbs_patch", {{"points", points(4, {1, 0, 0, 1, 1, 1, 0, w,   0, 1, 0, 1,  //
                                                     1, 0, 1, w, 1, 1, 1, 0.5, 0, 1, 1, w,  //
                                                     0, 0, 1, 1, 0, 0, 1, w,   0, 0, 1, 1})},
                               {"columns", numbers({3})}}));
    for (double u = 0.0; u <= 1.0; u += 0.0625) {
        for (double v = 0.0; v < 1.0; v += 0.0625) {
            const Sample s = sphere(u, v);
            EXPECT_NEAR(length(s.point), 1.0, 1e-15);
            // The normal of a sphere is its radius.
            const Vector normal = cross(s.along_u, s.along_v);
            expect_near((1.0 / length(normal)) * normal, s.point, 1e-12);
        }
    }
}

TEST(SplineSurfaces, ReportErrors) {
    const auto said = [](std::string_view name, const Given& given) {
        const auto made = try_stage(StageKind::object_generator, name, given);
        return made ? std::string() : to_text(made.diagnostics);
    };
    const Arguments::Value net = random_net(5, 4);
    EXPECT_NE(said("bspline_patch", {{"points", net}, {"columns", numbers({6})}})
                  .find("20 points do not form rows of 6 columns"),
              std::string::npos);
    EXPECT_NE(said("bspline_patch", {{"points", net}, {"columns", numbers({20})}})
                  .find("do not form rows"),
              std::string::npos);
    EXPECT_NE(said("bspline_patch",
                   {{"points", net}, {"columns", numbers({5})}, {"degree_v", numbers({4})}})
                  .find("degree 4 needs at least 5 points"),
              std::string::npos);
    EXPECT_NE(said("nurbs_patch",
                   {{"points", net}, {"columns", numbers({5})}, {"weights", points(1, {1, 1})}})
                  .find("cannot have 2 weights"),
              std::string::npos);
}

}  // namespace balcony::camera::spline_surfaces_test
