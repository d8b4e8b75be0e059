// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Picture arrangers: where a point of the picture lies in the camera's own one.

#include <numbers>

#include "camera/machine/arrange.hpp"
#include "support.hpp"

namespace balcony::camera::arrangers_test {

namespace {

// Of a picture of 200 x 100 pixels; positions differ from what is meant by rounding alone.
constexpr double tolerance = 1e-12;
constexpr double width = 200.0;
constexpr double height = 100.0;

struct Arranged {
    double x, y, width, height;
};

class ArrangerProbe {
public:
    ArrangerProbe(std::string_view name, const Given& given = {}) {
        const auto arranger = stage<PictureArranger>(StageKind::picture_arranger, name, given);
        Emitter emit(graph_);
        const PicturePoint p = arranger->arrange(
            {{graph_.picture_x(), graph_.picture_y()}, {emit(width), emit(height)}}, emit);
        roots_ = {p.point.x, p.point.y, p.size.width, p.size.height};
    }
    Arranged operator()(double x, double y) const {
        const std::vector<double> r = expr::evaluate(roots_, {x, y, 0.0, {}});
        return {r[0], r[1], r[2], r[3]};
    }

private:
    Graph graph_;
    std::vector<Expr> roots_;
};

/// An arranger that is a formula: build({x, y}) gives {x', y'}.
class FormulaProbe {
public:
    template <class Build>
    explicit FormulaProbe(const Build& build) {
        Arguments arguments;
        arguments.set_formula(
            formula(2, [&build](Graph&, const std::vector<Expr>& p) { return build(p); }));
        const auto made = catalogue().find(StageKind::picture_arranger, "formula")->make(arguments);
        const auto arranger = std::dynamic_pointer_cast<const PictureArranger>(*made);
        Emitter emit(graph_);
        const PicturePoint p = arranger->arrange(
            {{graph_.picture_x(), graph_.picture_y()}, {emit(width), emit(height)}}, emit);
        roots_ = {p.point.x, p.point.y, emit.valid()};
    }
    std::vector<double> operator()(double x, double y) const {
        return expr::evaluate(roots_, {x, y, 0.0, {}});
    }
    [[nodiscard]] bool valid(double x, double y) const { return (*this)(x, y)[2] != 0.0; }

private:
    Graph graph_;
    std::vector<Expr> roots_;
};

void expect_point(const Arranged& found, double x, double y, double within = tolerance) {
    EXPECT_NEAR(found.x, x, within);
    EXPECT_NEAR(found.y, y, within);
}

Arguments::Value angle(double degrees) { return numbers({degrees * std::numbers::pi / 180.0}); }

}  // namespace

TEST(RotatePicture, TurnsCounterClockwiseAsItIsSeen) {
    // What was to the right of the middle is above it after a quarter turn.
    const ArrangerProbe turned("rotate", {{"angle", angle(90.0)}, {"at", numbers({0.5, 0.5})}});
    expect_point(turned(100.0, 50.0 - 30.0), 130.0, 50.0);
    expect_point(turned(100.0, 50.0), 100.0, 50.0);
    const ArrangerProbe round_corner("rotate",
                                     {{"angle", angle(33.0)}, {"at", numbers({0.0, 1.0})}});
    expect_point(round_corner(0.0, 100.0), 0.0, 100.0);
}

TEST(RotatePicture, KeepsDistances) {
    const ArrangerProbe turned("rotate", {{"angle", angle(17.0)}, {"at", numbers({0.2, 0.7})}});
    const Arranged a = turned(13.0, 70.0);
    const Arranged b = turned(150.0, 4.0);
    EXPECT_NEAR(std::hypot(a.x - b.x, a.y - b.y), std::hypot(137.0, 66.0), tolerance);
}

TEST(ScalePicture, KeepsItsPointAndTheWholePicture) {
    const ArrangerProbe scaled("scale",
                               {{"by", numbers({0.5, 0.25})}, {"at", numbers({1.0, 0.5})}});
    const Arranged corner = scaled(100.0, 37.5);
    expect_point(corner, 0.0, 0.0);
    EXPECT_NEAR(corner.width, 100.0, tolerance);
    EXPECT_NEAR(corner.height, 25.0, tolerance);
    expect_point(scaled(200.0, 50.0), 100.0, 12.5);
}

TEST(Mirror, IsItsOwnInverse) {
    const ArrangerProbe sides("mirror", {{"axis", std::string("x")}});
    expect_point(sides(10.0, 20.0), 190.0, 20.0);
    const ArrangerProbe upside_down("mirror", {{"axis", std::string("y")}});
    expect_point(upside_down(10.0, 20.0), 10.0, 80.0);
    for (const ArrangerProbe* probe : {&sides, &upside_down}) {
        const Arranged once = (*probe)(31.0, 77.0);
        expect_point((*probe)(once.x, once.y), 31.0, 77.0);
    }
}

TEST(Shift, MovesToTheRightAndDown) {
    const ArrangerProbe shifted("shift", {{"by", numbers({0.1, 0.2})}});
    expect_point(shifted(20.0, 20.0), 0.0, 0.0);
}

TEST(ZoomPicture, MagnifiesInTheMiddleAndLeavesTheRest) {
    const ArrangerProbe zoomed(
        "zoom",
        {{"at", numbers({0.25, 0.5})}, {"radius", numbers({0.4})}, {"strength", numbers({4.0})}});
    expect_point(zoomed(50.0, 50.0), 50.0, 50.0);
    // A hundredth of a pixel in a circle of 40: the law of the middle holds to its square.
    expect_point(zoomed(50.01, 50.0), 50.0025, 50.0, 1e-8);
    expect_point(zoomed(50.0, 91.0), 50.0, 91.0);
    expect_point(zoomed(180.0, 5.0), 180.0, 5.0);
}

TEST(Ripple, MovesAlongTheRayFromItsMiddle) {
    const ArrangerProbe rippled("ripple", {{"amplitude", numbers({0.02})},
                                           {"wavelength", numbers({0.2})},
                                           {"at", numbers({0.5, 0.5})},
                                           {"phase", numbers({0.0})}});
    expect_point(rippled(105.0, 50.0), 107.0, 50.0);  // A quarter of a wavelength out: a crest.
    expect_point(rippled(100.0, 65.0), 100.0, 63.0);  // Three quarters: a trough.
    expect_point(rippled(120.0, 50.0), 120.0, 50.0);
    const Arranged oblique = rippled(107.0, 57.0);
    EXPECT_NEAR(oblique.x - 100.0, oblique.y - 50.0, tolerance);
    EXPECT_TRUE(std::isfinite(rippled(100.0, 50.0).x));
}

TEST(Ripple, RunsOutwardsWithItsPhase) {
    const ArrangerProbe rippled("ripple", {{"amplitude", numbers({0.02})},
                                           {"wavelength", numbers({0.2})},
                                           {"at", numbers({0.5, 0.5})},
                                           {"phase", angle(90.0)}});
    // The crest that stood a quarter of a wavelength out has gone on by as much.
    expect_point(rippled(110.0, 50.0), 112.0, 50.0);
    expect_point(rippled(105.0, 50.0), 105.0, 50.0);
}

TEST(PictureFormula, RunsFromMinusOneToOneToTheRightAndUp) {
    const FormulaProbe at([](const std::vector<Expr>& p) {
        return std::vector{0.5 * p[0], p[1] + 0.5};
    });
    // The middle shows what is half way to the top; the left edge what is half way to it.
    EXPECT_NEAR(at(100.0, 50.0)[1], 25.0, tolerance);
    EXPECT_NEAR(at(0.0, 50.0)[0], 50.0, tolerance);
    EXPECT_NEAR(at(100.0, 90.0)[1], 65.0, tolerance);
}

TEST(PictureFormula, HasNoPlaceWhereItHasNoValue) {
    const FormulaProbe across([](const std::vector<Expr>& p) {
        return std::vector{sqrt(p[0]), p[1]};
    });
    EXPECT_TRUE(across.valid(150.0, 50.0));
    EXPECT_FALSE(across.valid(50.0, 50.0));
    const FormulaProbe upwards([](const std::vector<Expr>& p) {
        return std::vector{p[0], sqrt(p[1])};
    });
    EXPECT_TRUE(upwards.valid(100.0, 25.0));
    EXPECT_FALSE(upwards.valid(100.0, 75.0));
}

// Leader lines begin where this finds the corners of an inset.
TEST(FindArranged, InvertsAffineAndBentArrangers) {
    const std::vector<PictureArrangerPointer> affine{
        stage<PictureArranger>(StageKind::picture_arranger, "place",
                               {{"from", numbers({0.5, 0.1})}, {"to", numbers({0.9, 0.6})}}),
        stage<PictureArranger>(StageKind::picture_arranger, "rotate",
                               {{"angle", angle(25.0)}, {"at", numbers({0.5, 0.5})}})};
    std::vector<PictureArrangerPointer> bent = affine;
    bent.push_back(stage<PictureArranger>(
        StageKind::picture_arranger, "zoom",
        {{"at", numbers({0.5, 0.5})}, {"radius", numbers({2.0})}, {"strength", numbers({1.3})}}));
    for (const auto& arrangers : {affine, bent}) {
        for (const auto& [across, down] : {std::pair(0.0, 0.0), std::pair(1.0, 0.25)}) {
            Graph graph;
            Emitter emit(graph);
            const PicturePoint whole = whole_picture(graph, width, height);
            const DevicePoint found =
                find_arranged(whole.size, arrangers, {emit(across), emit(down)}, emit);
            const PicturePoint back = arranged({found, whole.size}, arrangers, emit);
            const std::array roots{back.point.x - across * back.size.width,
                                   back.point.y - down * back.size.height};
            const std::vector<double> miss = expr::evaluate(roots, {0.0, 0.0, 0.0, {}});
            // Six steps of Newton's method from the middle of the whole: far below a pixel.
            EXPECT_NEAR(miss[0], 0.0, 1e-6);
            EXPECT_NEAR(miss[1], 0.0, 1e-6);
        }
    }
}

}  // namespace balcony::camera::arrangers_test
