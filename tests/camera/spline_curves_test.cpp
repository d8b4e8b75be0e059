// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Curves from points, as stages.

#include <random>

#include "support.hpp"

namespace balcony::camera::spline_curves_test {

namespace {

Arguments::Value points(std::size_t coordinates, std::vector<double> values) {
    return PointList{coordinates, std::move(values)};
}

Arguments::Value word(std::string_view choice) { return std::string(choice); }

// Seven points of the plane, unevenly spaced.
const Arguments::Value& seven() {
    static const Arguments::Value made =
        points(2, {0.0, 0.0, 1.0, 0.2, 1.5, 1.0, 3.0, 1.2, 3.2, 2.5, 2.0, 3.0, 0.5, 2.0});
    return made;
}

struct Case {
    std::string_view name;
    Given given;
    bool closed;
};

std::vector<Case> cases() {
    std::vector<Case> all;
    for (const std::string_view name : {"polyline", "catmull_rom", "natural_spline"}) {
        for (const std::string_view spacing : {"uniform", "centripetal", "chordal"}) {
            for (const bool closed : {false, true}) {
                all.push_back({name,
                               {{"points", seven()},
                                {"spacing", word(spacing)},
                                {"closed", word(closed ? "yes" : "no")}},
                               closed});
            }
        }
    }
    const Arguments::Value tangents =
        points(2, {1.0, 0.0, 0.5, 0.5, 1.0, 1.0, 1.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.3, -1.0});
    for (const bool closed : {false, true}) {
        const Arguments::Value yes = word(closed ? "yes" : "no");
        all.push_back(
            {"hermite", {{"points", seven()}, {"tangents", tangents}, {"closed", yes}}, closed});
        all.push_back({"bezier", {{"points", seven()}, {"closed", yes}}, closed});
        for (const double degree : {2.0, 3.0, 5.0}) {
            const Arguments::Value ends = word(closed ? "closed" : "open");
            all.push_back({"bspline",
                           {{"points", seven()}, {"degree", numbers({degree})}, {"ends", ends}},
                           closed});
            all.push_back({"nurbs",
                           {{"points", seven()},
                            {"weights", points(1, {1.0, 2.0, 0.5, 1.0, 3.0, 1.0, 0.7})},
                            {"degree", numbers({degree})},
                            {"ends", ends}},
                           closed});
        }
    }
    all.push_back({"nurbs",
                   {{"points", seven()},
                    {"weights", points(1, {1.0, 2.0, 0.5, 1.0, 3.0, 1.0, 0.7})},
                    {"knots", points(1, {0, 0, 0, 0, 0.3, 1.1, 2, 4, 4, 4, 4})}},
                   false});
    return all;
}

}  // namespace

TEST(SplineCurves, RunFromNoughtToOneAndGoRoundIfClosed) {
    for (const Case& made : cases()) {
        const GeneratorProbe curve(object(made.name, made.given));
        for (const double u : {0.0, 0.01, 0.5, 0.99, 1.0}) {
            EXPECT_TRUE(curve(u).valid) << made.name;
        }
        for (const double u : {-0.01, 1.01, 7.3}) {
            EXPECT_EQ(curve(u).valid, made.closed) << made.name;
        }
        if (made.closed) {
            for (const double u : {0.1, 0.35, 0.77}) {
                expect_near(curve(u + 2.0).point, curve(u).point, 1e-12);
                expect_near(curve(u - 3.0).along_u, curve(u).along_u, 1e-10);
            }
            expect_near(curve(1.0 - 1e-9).point, curve(0.0).point, 1e-6);
        }
    }
}

TEST(SplineCurves, LieInThePlaneOfTheirPoints) {
    for (const Case& made : cases()) {
        const auto curve = object(made.name, made.given);
        EXPECT_TRUE(try_stage(StageKind::object_generator, "product",
                              {{"g", curve}, {"h", object("circle")}}))
            << made.name;
    }
}

TEST(SplineCurves, TangentsAreNeighbourDifferences) {
    for (const Case& made : cases()) {
        if (made.name == "polyline") {
            continue;  // Has corners; its tangents are those of its lines.
        }
        const GeneratorProbe curve(object(made.name, made.given));
        for (double u = 0.013; u < 0.98; u += 0.0371) {
            constexpr double h = 1e-5;
            const Vector difference = (0.5 / h) * (curve(u + h).point - curve(u - h).point);
            // Third derivatives of some thousand, times h^2 / 6; where a second derivative jumps
            // within the step, which is by some hundred, times h / 2.
            expect_near(curve(u).along_u, difference, 2e-3);
        }
    }
}

// A curve of moved points is the moved curve. Chordal spacing survives what keeps proportions of
// distances.
TEST(SplineCurves, MoveWithTheirPoints) {
    const auto turned = [](const Vector& p) {
        return Vector{2.0 - 1.2 * p[1], 1.2 * p[0] - 3.0, 0.0};
    };
    for (const Case& made : cases()) {
        Given moved = made.given;
        for (const std::string_view name : {"points", "tangents"}) {
            const auto list = moved.find(name);
            if (list == moved.end()) {
                continue;
            }
            PointList points = std::get<PointList>(list->second);
            for (std::size_t i = 0; i < points.size(); ++i) {
                const Vector p = turned({points.values[2 * i], points.values[2 * i + 1], 0.0});
                const bool vectors = name == "tangents";
                points.values[2 * i] = p[0] - (vectors ? 2.0 : 0.0);
                points.values[2 * i + 1] = p[1] + (vectors ? 3.0 : 0.0);
            }
            list->second = points;
        }
        const GeneratorProbe before(object(made.name, made.given));
        const GeneratorProbe after(object(made.name, moved));
        for (double u = 0.0; u <= 1.0; u += 0.0625) {
            expect_near(after(u).point, turned(before(u).point), 1e-13);
        }
    }
}

TEST(SplineCurves, InterpolateTheirPointsByTheSpacing) {
    const PointList& list = std::get<PointList>(seven());
    for (const std::string_view name : {"polyline", "catmull_rom", "natural_spline"}) {
        for (const auto& [spacing, power] :
             {std::pair("uniform", 0.0), std::pair("centripetal", 0.5),
              std::pair("chordal", 1.0)}) {
            const GeneratorProbe curve(
                object(name, {{"points", seven()}, {"spacing", word(spacing)}}));
            std::vector<double> places{0.0};
            for (std::size_t i = 0; i + 1 < list.size(); ++i) {
                const double chord =
                    std::hypot(list[i + 1][0] - list[i][0], list[i + 1][1] - list[i][1]);
                places.push_back(places.back() + std::pow(chord, power));
            }
            for (std::size_t i = 0; i < list.size(); ++i) {
                expect_near(curve(places[i] / places.back()).point, {list[i][0], list[i][1], 0.0},
                            1e-13);
            }
        }
    }
}

TEST(SplineCurves, TakeTheTangentsThatTheyAreGiven) {
    for (const std::string_view name : {"catmull_rom", "natural_spline"}) {
        const GeneratorProbe curve(object(name, {{"points", seven()},
                                                 {"spacing", word("uniform")},
                                                 {"start_tangent", numbers({0.5, -2.0, 0.0})},
                                                 {"end_tangent", numbers({1.0, 3.0, 0.0})}}));
        // Of six segments, each takes a sixth of u.
        expect_near(curve(0.0).along_u, {3.0, -12.0, 0.0}, 1e-12);
        expect_near(curve(1.0).along_u, {6.0, 18.0, 0.0}, 1e-12);
    }
    const GeneratorProbe hermite(object("hermite", {{"points", points(3, {0, 0, 0, 1, 1, 1})},
                                                    {"tangents", points(3, {1, 2, 3, 4, 5, 6})}}));
    expect_near(hermite(0.0).point, {0.0, 0.0, 0.0}, 1e-15);
    expect_near(hermite(0.0).along_u, {1.0, 2.0, 3.0}, 1e-14);
    expect_near(hermite(1.0).point, {1.0, 1.0, 1.0}, 1e-14);
    expect_near(hermite(1.0).along_u, {4.0, 5.0, 6.0}, 1e-14);
}

TEST(SplineCurves, ABezierCurveLeavesAndArrivesAlongItsPolygon) {
    const GeneratorProbe curve(
        object("bezier", {{"points", points(3, {0, 0, 0, 1, 2, 3, 2, 1, 1, 4, 4, 0})}}));
    expect_near(curve(0.0).point, {0.0, 0.0, 0.0}, 1e-15);
    expect_near(curve(0.0).along_u, {3.0, 6.0, 9.0}, 1e-14);
    expect_near(curve(1.0).point, {4.0, 4.0, 0.0}, 1e-14);
    expect_near(curve(1.0).along_u, {6.0, 9.0, -3.0}, 1e-13);
}

// A full circle as four rational parabolas (Piegl and Tiller, The NURBS Book, 7.5).
TEST(SplineCurves, ARationalCurveCanBeACircle) {
    const double w = std::sqrt(0.5);
    const GeneratorProbe circle(
        object("nurbs",
               {{"points", points(4, {1, 0, 2,  1,  1, 1, 2, w,  0, 1, 2, 1,  -1, 1, 2, w, -1, 0,
                                      2, 1, -1, -1, 2, w, 0, -1, 2, 1, 1, -1, 2,  w, 1, 0, 2,  1})},
                {"degree", numbers({2.0})},
                {"knots", points(1, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4})}}));
    for (double u = 0.0; u <= 1.0; u += 0.01) {
        const Vector p = circle(u).point;
        EXPECT_NEAR(std::hypot(p[0], p[1]), 1.0, 1e-15);
        EXPECT_NEAR(p[2], 2.0, 1e-14);
    }
    expect_near(circle(0.125).point, {w, w, 2.0}, 1e-14);
}

TEST(SplineCurves, ReportErrors) {
    const auto said = [](std::string_view name, const Given& given) {
        const auto made = try_stage(StageKind::object_generator, name, given);
        return made ? std::string() : to_text(made.diagnostics);
    };
    const Arguments::Value twice = points(2, {0, 0, 1, 1, 1, 1, 2, 0});
    EXPECT_NE(said("catmull_rom", {{"points", twice}}).find("points 2 and 3 are the same"),
              std::string::npos);
    EXPECT_EQ(said("catmull_rom", {{"points", twice}, {"spacing", word("uniform")}}), "");
    EXPECT_NE(said("natural_spline", {{"points", points(2, {0, 0, 1, 0, 1.00001, 0, 2, 0})},
                                      {"spacing", word("chordal")}})
                  .find("less than 1/16384"),
              std::string::npos);
    EXPECT_NE(said("catmull_rom", {{"points", seven()}, {"end_tangent", numbers({0, 0, 1})}})
                  .find("is not in the plane"),
              std::string::npos);
    EXPECT_NE(
        said("catmull_rom",
             {{"points", seven()}, {"closed", word("yes")}, {"start_tangent", numbers({0, 1, 0})}})
            .find("no ends"),
        std::string::npos);
    EXPECT_NE(said("hermite", {{"points", seven()}, {"tangents", twice}}).find("do not match"),
              std::string::npos);
    EXPECT_NE(said("bezier", {{"points", points(2, std::vector<double>(18, 0.5))}})
                  .find("too many for one piece"),
              std::string::npos);
    EXPECT_NE(said("nurbs", {{"points", seven()}, {"weights", points(1, {1, 2, 3})}})
                  .find("cannot have 3 weights"),
              std::string::npos);
    EXPECT_NE(
        said("nurbs", {{"points", points(4, {0, 0, 0, 1, 1, 1, 1, -1})}}).find("must be above 0"),
        std::string::npos);
}

}  // namespace balcony::camera::spline_curves_test
