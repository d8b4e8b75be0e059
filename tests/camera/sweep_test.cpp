// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Sweeps, by the frame that carries their profile.

#include <functional>
#include <numbers>

#include "support.hpp"

namespace balcony::camera::sweep_test {

namespace {

using std::numbers::pi;

using Build = std::function<std::vector<Expr>(Graph&, Expr)>;

ObjectGeneratorPointer curve(const Build& build) {
    Arguments arguments;
    arguments.set_formula(
        formula(1, [&](Graph& graph, const std::vector<Expr>& u) { return build(graph, u[0]); }));
    const StageEntry* row = catalogue().find(StageKind::object_generator, "curve");
    return std::static_pointer_cast<const ObjectGenerator>(*row->make(arguments).value);
}

/// The profile whose points for v = 0, 1 and 2 are the origin, (1, 0) and (0, 1).
ObjectGeneratorPointer corner() {
    return curve([](Graph& graph, Expr v) {
        const Expr two = graph.constant(2.0);
        return std::vector{v * (two - v), 0.5 * v * (v - 1.0)};
    });
}

ObjectGeneratorPointer helix() {
    return curve([](Graph&, Expr u) { return std::vector{2.0 * cos(u), 2.0 * sin(u), 0.3 * u}; });
}

// Bends to one side and then to the other, in a plane that is none of the axes'.
ObjectGeneratorPointer wave() {
    return curve([](Graph&, Expr u) { return std::vector{u, 0.8 * sin(u), 0.6 * sin(u)}; });
}

ObjectGeneratorPointer knot() {
    return curve([](Graph&, Expr u) {
        const Expr r = 2.0 + cos(3.0 * u);
        return std::vector{r * cos(2.0 * u), r * sin(2.0 * u), sin(3.0 * u)};
    });
}

Given along(const ObjectGeneratorPointer& path, double from, double to) {
    return {
        {"profile", corner()}, {"path", path}, {"from", numbers({from})}, {"to", numbers({to})}};
}

struct Frame {
    Vector tangent, right, up;
    Vector right_along;  ///< How the right changes with u.
};

Frame frame_of(const GeneratorProbe& sweep, double u) {
    const Sample origin = sweep(u, 0.0);
    const Sample right = sweep(u, 1.0);
    const Sample up = sweep(u, 2.0);
    return {(1.0 / length(origin.along_u)) * origin.along_u, right.point - origin.point,
            up.point - origin.point, right.along_u - origin.along_u};
}

Vector reflected(const Vector& a, const Vector& mirror_normal) {
    return a - (2.0 * dot(mirror_normal, a) / dot(mirror_normal, mirror_normal)) * mirror_normal;
}

/// A frame's up carried from one place on a path to the next by two reflections (Wang, Jüttler,
/// Zheng and Liu 2008).
Vector carried(const Vector& up, const Sample& here, const Sample& next) {
    const auto tangent = [](const Sample& at) { return (1.0 / length(at.along_u)) * at.along_u; };
    const Vector way = next.point - here.point;
    return reflected(reflected(up, way), tangent(next) - reflected(tangent(here), way));
}

double spin(const Frame& frame) { return dot(frame.right_along, frame.up); }

}  // namespace

TEST(Sweep, HasAnOrthonormalFrameThatDoesNotTurn) {
    for (const auto& [path, from, to] :
         {std::tuple(helix(), 0.0, 12.0), std::tuple(wave(), -4.0, 4.0),
          std::tuple(object("line"), 0.0, 1.0)}) {
        const GeneratorProbe sweep(object("sweep", along(path, from, to)));
        for (double s = 0.001; s < 1.0; s += 0.0137) {
            const Frame frame = frame_of(sweep, std::lerp(from, to, s));
            expect_near(cross(frame.tangent, frame.up), frame.right, 1e-13);
            EXPECT_NEAR(dot(frame.tangent, frame.up), 0.0, 1e-13);
            EXPECT_NEAR(length(frame.up), 1.0, 1e-13);
            // By the path's parameter; a cubic in cells of 0.05 is off by a third power of that.
            EXPECT_NEAR(spin(frame), 0.0, 1e-5);
        }
    }
}

// The frame of Frenet jumps by half a turn where the wave changes sides.
TEST(Sweep, KeepsItsFrameAtInflectionsAndStraightParts) {
    const GeneratorProbe sweep(object("sweep", along(wave(), -pi / 2.0, 2.5 * pi)));
    // The wave is plane, so what is across its plane stays; up begins as z, of which the part
    // across the plane is 0.8^2.
    const Vector across{0.0, -0.6, 0.8};
    const double kept = dot(frame_of(sweep, -pi / 2.0).up, across);
    for (double u = -pi / 2.0; u < 2.5 * pi; u += 0.05) {
        // Of fourth order in cells of 0.04.
        EXPECT_NEAR(dot(frame_of(sweep, u).up, across), kept, 1e-7);
    }
}

// Steps of a 6000th of the way that end at the knots are off by (256/6000)^4 of what the same steps
// are off by in 256 cells, where that is some 1e-6: by less than 1e-11. The frame states 1e-6 for
// what grows along the way and as much for a cell.
TEST(Sweep, FollowsTheFrameWhereThePathsSecondDerivativeJumps) {
    constexpr int pieces = 6;
    constexpr int steps = 1000 * pieces;
    const ObjectGeneratorPointer path =
        object("catmull_rom", {{"points", PointList{3, {-4, -3, 0, -2, 2, 1, 0,  0, -1, 2, -2,
                                                        1,  3,  0, 2,  1, 3, -1, 4, 4,  0}}},
                               {"spacing", std::string("uniform")}});
    const GeneratorProbe exact(path);
    const GeneratorProbe sweep(object("sweep", along(path, 0.0, 1.0)));
    Vector up = frame_of(sweep, 0.0).up;
    Sample here = exact(0.0);
    double largest = 0.0;
    for (int step = 1; step <= steps; ++step) {
        const double u = static_cast<double>(step) / steps;
        const Sample next = exact(u);
        up = carried(up, here, next);
        here = next;
        largest = std::max(largest, length(frame_of(sweep, u).up - up));
    }
    EXPECT_LT(largest, 2e-6);
}

TEST(Sweep, OfACircleRoundACircleIsATorus) {
    const GeneratorProbe sweep(
        object("sweep", {{"profile", object("circle", {{"radius", numbers({0.5})}})},
                         {"path", object("circle", {{"radius", numbers({3.0})}})},
                         {"to", numbers({2.0 * pi})}}));
    const GeneratorProbe torus(
        object("torus", {{"major", numbers({3.0})}, {"minor", numbers({0.5})}}));
    for (double u = -4.0; u < 9.0; u += 0.37) {
        for (double v = -3.0; v < 3.0; v += 0.41) {
            expect_near(sweep(u, v).point, torus(u, v).point, 1e-10);
            expect_near(sweep(u, v).along_u, torus(u, v).along_u, 1e-7);
            expect_near(sweep(u, v).along_v, torus(u, v).along_v, 1e-10);
        }
    }
}

TEST(Sweep, AlongAPathThatComesBackJoins) {
    const GeneratorProbe sweep(object("sweep", along(knot(), 0.0, 2.0 * pi)));
    const Frame first = frame_of(sweep, 0.0);
    const Frame last = frame_of(sweep, 2.0 * pi - 1e-9);
    expect_near(last.up, first.up, 1e-7);
    expect_near(last.right, first.right, 1e-7);
    // The closing angle is spread evenly, and is at most half a turn.
    const double even = spin(first);
    EXPECT_LE(std::fabs(even), 0.5 + 1e-4);
    for (double u = 0.01; u < 6.28; u += 0.11) {
        EXPECT_NEAR(spin(frame_of(sweep, u)), even, 2e-4);
        EXPECT_TRUE(sweep(u + 2.0 * pi).valid);
    }
}

TEST(Sweep, TwistsAndScalesOnTheWay) {
    Given given = along(object("line", {{"along", numbers({4.0, 0.0, 0.0})}}), 0.0, 1.0);
    given["twist"] = numbers({pi});
    given["scale"] = formula(1, [](Graph&, const std::vector<Expr>& s) {
        return std::vector{1.0 + s[0], 3.0 - s[0]};
    });
    const GeneratorProbe sweep(object("sweep", given));
    // Seen along x with z up, the right is -y; counter-clockwise from there is z.
    expect_near(sweep(0.0, 1.0).point, {0.0, -1.0, 0.0}, 1e-14);
    expect_near(sweep(0.0, 2.0).point, {0.0, 0.0, 3.0}, 1e-14);
    expect_near(sweep(0.5, 1.0).point, {2.0, 0.0, 1.5}, 1e-13);
    expect_near(sweep(0.5, 2.0).point, {2.0, 2.5, 0.0}, 1e-13);
    expect_near(sweep(1.0, 1.0).point, {4.0, 2.0, 0.0}, 1e-13);
    EXPECT_FALSE(sweep(1.01, 1.0).valid);
}

TEST(Sweep, UprightKeepsItsYAsNearToUpAsCanBe) {
    Given given = along(helix(), 0.0, 12.0);
    given["frame"] = std::string("upright");
    const GeneratorProbe sweep(object("sweep", given));
    for (double u = 0.0; u < 12.0; u += 0.31) {
        const Frame frame = frame_of(sweep, u);
        EXPECT_NEAR(frame.right[2], 0.0, 1e-14);
        EXPECT_GT(frame.up[2], 0.0);
        expect_near(cross(frame.tangent, frame.up), frame.right, 1e-14);
    }
}

TEST(Sweep, TangentsAreNeighbourDifferences) {
    Given given = along(knot(), 0.0, 2.0 * pi);
    given["twist"] = numbers({2.0 * pi});
    const GeneratorProbe sweep(object("sweep", given));
    for (double u = 0.05; u < 6.2; u += 0.17) {
        constexpr double h = 1e-5;
        const Sample s = sweep(u, 0.7);
        // Third derivatives of some hundred, times h^2; roundings of 10 over h.
        expect_near(s.along_u, (0.5 / h) * (sweep(u + h, 0.7).point - sweep(u - h, 0.7).point),
                    1e-7);
        expect_near(s.along_v, (0.5 / h) * (sweep(u, 0.7 + h).point - sweep(u, 0.7 - h).point),
                    1e-7);
    }
}

TEST(Sweep, SaysWhatItCannotSweepAlong) {
    const auto said = [](const Given& given) {
        const auto made = try_stage(StageKind::object_generator, "sweep", given);
        return made ? std::string() : to_text(made.diagnostics);
    };
    EXPECT_NE(said(along(helix(), 1.0, 1.0)).find("the path is empty"), std::string::npos);
    EXPECT_NE(said(along(curve([](Graph& graph, Expr u) {
                             return std::vector{u * graph.time(), u};
                         }),
                         0.0, 1.0))
                  .find("cannot change with time"),
              std::string::npos);
    EXPECT_NE(said(along(curve([](Graph&, Expr u) {
                             return std::vector{u * u, u * u * u};
                         }),
                         0.0, 1.0))
                  .find("no direction"),
              std::string::npos);
    EXPECT_NE(said(along(helix(), 0.0, 6000.0)).find("turns too much"), std::string::npos);
    const PointList corners{3, {0, 0, 0, 1, 0, 0, 1, 1, 0, 1, 1, 1}};
    EXPECT_EQ(said(along(object("polyline", {{"points", corners}}), 0.0, 1.0)), "")
        << "corners are borne";
}

}  // namespace balcony::camera::sweep_test
