// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Picture mappers and arrangers: from pixels to parameter space.

#include "support.hpp"

namespace balcony::camera::picture_test {

namespace {

constexpr double tolerance = 1e-14;

struct Mapped {
    double u = 0.0;
    double v = 0.0;
};

Mapped mapped(const PictureMapperPointer& mapper, double x, double y, double width, double height) {
    Graph graph;
    Emitter emit(graph);
    const ParameterPoint p =
        mapper->map({{graph.picture_x(), graph.picture_y()}, {emit(width), emit(height)}}, emit);
    const std::vector<double> r = expr::evaluate(std::array{p.u, p.v}, {x, y, 0.0, {}});
    return {r[0], r[1]};
}

struct Arranged {
    double x = 0.0;
    double y = 0.0;
    double width = 0.0;
    double height = 0.0;
};

Arranged placed(std::vector<double> from, std::vector<double> to, double x, double y) {
    const auto place = stage<PictureArranger>(
        StageKind::picture_arranger, "place",
        {{"from", numbers(std::move(from))}, {"to", numbers(std::move(to))}});
    Graph graph;
    Emitter emit(graph);
    const PicturePoint p =
        place->arrange({{graph.picture_x(), graph.picture_y()}, {emit(200.0), emit(100.0)}}, emit);
    const std::array roots{p.point.x, p.point.y, p.size.width, p.size.height};
    const std::vector<double> r = expr::evaluate(roots, {x, y, 0.0, {}});
    return {r[0], r[1], r[2], r[3]};
}

}  // namespace

TEST(RangeMapper, TakesCornersToCornersAndTheCentreToTheCentre) {
    const auto mapper = range(-2.0, 4.0, 1.0, 2.0);
    const double w = 640.0;
    const double h = 360.0;
    const Mapped top_left = mapped(mapper, 0.0, 0.0, w, h);
    EXPECT_NEAR(top_left.u, -2.0, tolerance);
    EXPECT_NEAR(top_left.v, 2.0, tolerance);
    const Mapped bottom_right = mapped(mapper, w, h, w, h);
    EXPECT_NEAR(bottom_right.u, 4.0, tolerance);
    EXPECT_NEAR(bottom_right.v, 1.0, tolerance);
    const Mapped centre = mapped(mapper, w / 2.0, h / 2.0, w, h);
    EXPECT_NEAR(centre.u, 1.0, tolerance);
    EXPECT_NEAR(centre.v, 1.5, tolerance);
}

TEST(SquareMapper, HasSquarePixelsInPicturesOfAnyProportion) {
    for (const auto& [w, h] : {std::pair(640.0, 360.0), std::pair(100.0, 900.0)}) {
        for (const auto& [first, last] : {std::pair(-1.0, 3.0), std::pair(2.0, -1.0)}) {
            for (const bool given_u : {true, false}) {
                const auto mapper = stage<PictureMapper>(
                    StageKind::picture_mapper, given_u ? "square_v" : "square_u",
                    {{given_u ? "u_first" : "v_first", numbers({first})},
                     {given_u ? "u_last" : "v_last", numbers({last})}});
                const Mapped centre = mapped(mapper, w / 2.0, h / 2.0, w, h);
                const Mapped right = mapped(mapper, w / 2.0 + 1.0, h / 2.0, w, h);
                const Mapped up = mapped(mapper, w / 2.0, h / 2.0 - 1.0, w, h);
                EXPECT_NEAR(given_u ? centre.u : centre.v, 0.5 * (first + last), tolerance);
                EXPECT_NEAR(given_u ? centre.v : centre.u, 0.0, tolerance);
                EXPECT_NEAR(std::fabs(right.u - centre.u), std::fabs(up.v - centre.v), tolerance);
                // The parameter that is not given grows to the right or upwards.
                EXPECT_GT(given_u ? up.v - centre.v : right.u - centre.u, 0.0);
                const double edge =
                    given_u ? mapped(mapper, w, 0.0, w, h).u : mapped(mapper, 0.0, 0.0, w, h).v;
                EXPECT_NEAR(edge, last, tolerance);
            }
        }
    }
}

TEST(Place, ScalesTheCamerasPictureIntoItsPart) {
    const Arranged corner = placed({0.25, 0.5}, {0.75, 1.0}, 50.0, 50.0);
    EXPECT_NEAR(corner.x, 0.0, tolerance);
    EXPECT_NEAR(corner.y, 0.0, tolerance);
    EXPECT_NEAR(corner.width, 100.0, tolerance);
    EXPECT_NEAR(corner.height, 50.0, tolerance);
    const Arranged inside = placed({0.25, 0.5}, {0.75, 1.0}, 90.5, 70.5);
    EXPECT_NEAR(inside.x, 40.5, tolerance);
    EXPECT_NEAR(inside.y, 20.5, tolerance);
}

TEST(Place, HasNoRaysOutsideItsPart) {
    Camera::Parts parts;
    parts.name = "placed";
    parts.arrangers = {
        stage<PictureArranger>(StageKind::picture_arranger, "place",
                               {{"from", numbers({0.25, 0.5})}, {"to", numbers({0.75, 0.8})}})};
    parts.eye = {range(-1.0, 1.0, -1.0, 1.0), {}, object("sphere"), {}};
    parts.look = look("normal");
    const CameraProbe ray(camera(std::move(parts)), 200.0, 100.0);
    for (double x = 0.5; x < 200.0; x += 1.0) {
        for (double y = 0.5; y < 100.0; y += 1.0) {
            const bool inside = 50.0 <= x && x <= 150.0 && 50.0 <= y && y <= 80.0;
            ASSERT_EQ(ray(x, y).valid, inside) << x << ' ' << y;
        }
    }
}

TEST(Place, NeedsAnArea) {
    EXPECT_FALSE(try_stage(StageKind::picture_arranger, "place",
                           {{"from", numbers({0.5, 0.0})}, {"to", numbers({0.5, 1.0})}}));
    EXPECT_FALSE(try_stage(StageKind::picture_arranger, "place",
                           {{"from", numbers({0.0, 0.6})}, {"to", numbers({0.5, 0.2})}}));
}

}  // namespace balcony::camera::picture_test
