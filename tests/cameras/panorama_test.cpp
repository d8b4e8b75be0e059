// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Panoramas against published formulas: from the direction of a ray back to its place in the
// picture.

#include <cmath>
#include <functional>
#include <random>

#include "support.hpp"

namespace balcony::cameras::test::panorama_test {

namespace {

constexpr double pi = std::numbers::pi;
// Directions of unit length after some ten rounded operations.
constexpr double tolerance = 1e-12;

struct Places {
    std::mt19937_64 random{11};
    double operator()() { return std::uniform_real_distribution<double>(0.001, 0.999)(random); }
};

double longitude(const V3d& d) { return std::atan2(d.y, d.x); }
double tangent_of_latitude(const V3d& d) { return d.z / std::hypot(d.x, d.y); }

// ---------------------------------------------------------------------------------- cube maps

/// A place in a cube map.
struct OnFace {
    int face;  // As OpenGL counts: right, left, up, down, front (its +z), back.
    V2d at;    // From the top left corner of the face, 0 to 1.
};

// Selection of a cube map's face and the place in it: OpenGL 4.6, section 8.13 and table 8.19.
OnFace opengl_cube_map(const V3d& direction) {
    const double x = -direction.y;
    const double y = direction.z;
    const double z = direction.x;
    const double major = std::max({std::abs(x), std::abs(y), std::abs(z)});
    const auto at = [major](int face, double s, double t) {
        return OnFace{face, V2d(s / major + 1.0, t / major + 1.0) / 2.0};
    };
    if (major == std::abs(x)) {
        return x > 0.0 ? at(0, -z, -y) : at(1, z, -y);
    }
    if (major == std::abs(y)) {
        return y > 0.0 ? at(2, x, z) : at(3, x, -z);
    }
    return z > 0.0 ? at(4, x, -y) : at(5, -x, -y);
}

enum class Turn { none, half, quarter };

/// A cell of a picture that shows a face, turned clockwise.
struct Cell {
    int column, row, face;
    Turn turn = Turn::none;
};

struct Layout {
    std::string camera;
    V2d cells;
    std::vector<Cell> shown;
};

// The place in a cell of a place on a face that is turned clockwise.
V2d turned(const V2d& at, Turn turn) {
    switch (turn) {
        case Turn::half: return {1.0 - at.x, 1.0 - at.y};
        case Turn::quarter: return {1.0 - at.y, at.x};
        default: return at;
    }
}

V2d equal(const V2d& at) { return at; }

// Equi-angular: C. Brown, "Bringing pixels front and center in VR video", 2017.
V2d equiangular(const V2d& at) {
    const auto one = [](double x) { return 2.0 / pi * std::atan(2.0 * x - 1.0) + 0.5; };
    return {one(at.x), one(at.y)};
}

void expect_layout(const Layout& layout, V2d (*spaced)(const V2d&) = equal) {
    const Rays rays(layout.camera);
    EXPECT_NEAR(rays.width() / rays.height(), layout.cells.x / layout.cells.y, tolerance);
    Places place;
    for (const Cell& cell : layout.shown) {
        for (int i = 0; i < 50; ++i) {
            const V2d within(place(), place());
            const Ray ray = rays.at((cell.column + within.x) / layout.cells.x,
                                    (cell.row + within.y) / layout.cells.y);
            ASSERT_TRUE(ray.valid) << layout.camera;
            const OnFace found = opengl_cube_map(ray.direction);
            ASSERT_EQ(found.face, cell.face) << layout.camera << ' ' << cell.column << cell.row;
            const V2d expected = turned(spaced(found.at), cell.turn);
            EXPECT_LE((expected - within).length(), 1e-11)
                << layout.camera << " face " << cell.face;
        }
    }
}

}  // namespace

TEST(CubeMap, StripHasTheOrderAndOrientationOfOpenGl) {
    expect_layout({"cubemap_strip",
                   {6, 1},
                   {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {3, 0, 3}, {4, 0, 4}, {5, 0, 5}}});
}

TEST(CubeMap, TwoRowsHaveTheSameOrder) {
    expect_layout({"cubemap_3x2",
                   {3, 2},
                   {{0, 0, 0}, {1, 0, 1}, {2, 0, 2}, {0, 1, 3}, {1, 1, 4}, {2, 1, 5}}});
}

TEST(CubeMap, CrossesAreUnfoldedCubes) {
    expect_layout({"cubemap_cross",
                   {4, 3},
                   {{1, 0, 2}, {0, 1, 1}, {1, 1, 4}, {2, 1, 0}, {3, 1, 5}, {1, 2, 3}}});
    expect_layout({"cubemap_vertical_cross",
                   {3, 4},
                   {{1, 0, 2}, {0, 1, 1}, {1, 1, 4}, {2, 1, 0}, {1, 2, 3}, {1, 3, 5, Turn::half}}});
    EXPECT_FALSE(Rays("cubemap_cross").at(0.1, 0.1).valid);
    EXPECT_FALSE(Rays("cubemap_cross").at(0.9, 0.9).valid);
    EXPECT_FALSE(Rays("cubemap_vertical_cross").at(0.1, 0.9).valid);
    EXPECT_FALSE(Rays("cubemap_vertical_cross").at(0.9, 0.1).valid);
}

// The upper row of YouTube's layout is left, front, right. The lower one shows down, back and up as
// one who looks back sees them, which turns up and down by half, and all by a further quarter.
TEST(CubeMap, EquiangularFacesHaveEqualAnglesInTheLayoutOfYouTube) {
    expect_layout({"equiangular_cubemap", {3, 2}, {{0, 0, 1}, {1, 0, 4}, {2, 0, 0}}}, equiangular);
    expect_layout({"equiangular_cubemap", {3, 2}, {{1, 1, 5, Turn::quarter}}}, equiangular);
    const auto opposite = [](const V2d& at) { return V2d(1.0, 1.0) - equiangular(at); };
    expect_layout(
        {"equiangular_cubemap", {3, 2}, {{0, 1, 3, Turn::quarter}, {2, 1, 2, Turn::quarter}}},
        opposite);
}

// --------------------------------------------------------------------------- other projections

TEST(Panorama, IsEquirectangular) {
    const Rays rays("panorama");
    Places place;
    for (int i = 0; i < 100; ++i) {
        const V2d at(place(), place());
        const V3d d = rays.at(at.x, at.y).direction;
        EXPECT_NEAR(longitude(d), (1.0 - 2.0 * at.x) * pi, tolerance);
        EXPECT_NEAR(std::asin(d.z), (0.5 - at.y) * pi, 1e-9);  // Steep at the poles.
    }
}

// x = f longitude, y = f tan latitude, with f = width/fov.
TEST(Cylindrical, IsTheCentralCylindricalProjection) {
    for (const char* fov : {"360deg", "120deg"}) {
        const Rays rays(make("cylindrical", {{"fov", fov}}));
        const double f = rays.width() / (std::stod(fov) * degree);
        Places place;
        for (int i = 0; i < 100; ++i) {
            const V2d at(place() * rays.width(), place() * rays.height());
            const V3d d = rays.at_pixel(at.x, at.y).direction;
            EXPECT_NEAR(f * longitude(d), rays.width() / 2.0 - at.x, 1e-9);
            EXPECT_NEAR(f * tangent_of_latitude(d), rays.height() / 2.0 - at.y, 1e-9);
        }
    }
}

// Sharpless, Postle and German 2010: the sphere is projected to a cylinder from its centre, and the
// cylinder to a plane from a point at the distance d behind its axis.
TEST(Panini, IsTheDoubleProjection) {
    for (const double d : {0.0, 0.5, 1.0}) {
        const Rays rays(make("panini", {{"d", std::to_string(d)}}));
        Places place;
        double scale = 0.0;
        for (int i = 0; i < 100; ++i) {
            const V2d at(place() * rays.width(), place() * rays.height());
            const V3d ray = rays.at_pixel(at.x, at.y).direction;
            const double across = std::hypot(ray.x, ray.y);
            const V3d on_cylinder = ray / across;
            // From (-d, 0, 0) through the point of the cylinder to the plane x = 1.
            const double depth = (d + 1.0) / (d + on_cylinder.x);
            const V2d on_plane(depth * on_cylinder.y, depth * on_cylinder.z);
            const V2d from_middle(rays.width() / 2.0 - at.x, rays.height() / 2.0 - at.y);
            scale = scale > 0.0 ? scale : from_middle.x / on_plane.x;
            EXPECT_NEAR(scale * on_plane.x, from_middle.x, 1e-8);
            EXPECT_NEAR(scale * on_plane.y, from_middle.y, 1e-8);
        }
        EXPECT_NEAR(2.0 * longitude(rays.at(0.0, 0.5).direction), 150.0 * degree, tolerance);
    }
}

// Equal angles between circles: the distance from the middle is 2 tan(angle/2).
TEST(LittlePlanet, IsStereographicLookingDown) {
    for (const auto& [name, axis] : {std::pair("little_planet", -1.0), std::pair("tunnel", 1.0)}) {
        const Rays rays(name);
        Places place;
        for (int i = 0; i < 100; ++i) {
            const V2d at(place(), place());
            const V3d d = rays.at(at.x, at.y).direction;
            const double radius = std::hypot(at.x - 0.5, at.y - 0.5) / 0.5;
            const double angle = std::acos(axis * d.z);
            EXPECT_NEAR(std::tan(angle / 2.0), radius * std::tan(65.0 * degree), 1e-9) << name;
        }
        // Ahead is on top of the planet and at the bottom of the tunnel, left is on the left.
        const double ahead = axis < 0.0 ? 0.3 : 0.7;
        EXPECT_GT(rays.at(0.5, ahead).direction.x, 0.5) << name;
        EXPECT_GT(rays.at(0.3, 0.5).direction.y, 0.5) << name;
    }
}

// Debevec's light probes fill a disc in which u and v run from -1 to 1, right and up. They look
// along -z and have y up.
void at_light_probe(const char* camera,
                    const std::function<void(double u, double v, const V3d& direction)>& check) {
    const Rays rays(camera);
    Places place;
    for (int i = 0; i < 100; ++i) {
        const V2d at(place(), place());
        const double u = 2.0 * at.x - 1.0;
        const double v = 1.0 - 2.0 * at.y;
        const Ray ray = rays.at(at.x, at.y);
        ASSERT_EQ(ray.valid, u * u + v * v < 1.0);
        if (ray.valid) {
            check(u, v, {-ray.direction.y, ray.direction.z, -ray.direction.x});
        }
    }
}

// The reflection of parallel rays in a ball, which he photographed from the front: the normal at
// (u, v) halves the angle between the directions to the camera and to the light. Turned to the
// front by half.
TEST(MirrorBall, IsTheReflectionInABall) {
    at_light_probe("mirror_ball", [](double u, double v, const V3d& d) {
        const V3d normal(u, v, std::sqrt(1.0 - u * u - v * v));
        const V3d to_camera(0.0, 0.0, 1.0);
        const V3d reflected = 2.0 * (normal ^ to_camera) * normal - to_camera;
        expect_near(d, {reflected.x, reflected.y, -reflected.z}, tolerance);
    });
}

// debevec.org/probes: (u, v) = r (Dx, Dy) with r = acos(Dz)/(π √(Dx² + Dy²)), where Dz is ahead.
TEST(AngularMap, IsDebevecsFormula) {
    at_light_probe("angular_map", [](double u, double v, const V3d& d) {
        const double r = std::acos(-d.z) / (pi * std::hypot(d.x, d.y));
        EXPECT_NEAR(r * d.x, u, 1e-9);
        EXPECT_NEAR(r * d.y, v, 1e-9);
    });
}

// Rays start on the axis and go horizontally outwards; angles and heights are to scale at the
// walls.
TEST(Cylinder, LooksHorizontallyOutwardsToScale) {
    const Rays rays(make("cylinder", {{"radius", "3"}, {"start", "0"}, {"height", "4"}}));
    EXPECT_NEAR(rays.width() / rays.height(), 2.0 * pi * 3.0 / 4.0, tolerance);
    for (const double x : {0.1, 0.25, 0.6}) {
        const Ray ray = rays.at(x, 0.25);
        expect_near(ray.origin, {0.0, 0.0, 1.0}, tolerance);
        const double longitude = (1.0 - 2.0 * x) * pi;
        expect_near(ray.direction, {std::cos(longitude), std::sin(longitude), 0.0}, tolerance);
    }
    expect_near(Rays(make("cylinder", {{"radius", "3"}})).at(0.25, 0.5).origin, {0.0, 3.0, 0.0},
                tolerance);
}

}  // namespace balcony::cameras::test::panorama_test
