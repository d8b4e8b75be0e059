// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// CAVE walls against off-axis frusta by matrices.

#include <random>

#include <ImathMatrix.h>
#include <fmt/format.h>

#include "support.hpp"

namespace balcony::cameras::test::walls_test {

namespace {

using Imath::M44d;

struct Corners {
    V3d lower_left, lower_right, upper_left;
};

/// Kooima's matrices, as OpenGL multiplies them: a frustum, the turn of the wall, the eye's place.
/// Imath multiplies row vectors, so each is transposed and the order is reversed.
M44d frustum_of(const Corners& wall, const V3d& eye) {
    const V3d right = (wall.lower_right - wall.lower_left).normalized();
    const V3d up = (wall.upper_left - wall.lower_left).normalized();
    const V3d out = right.cross(up);
    const V3d a = wall.lower_left - eye, b = wall.lower_right - eye, c = wall.upper_left - eye;
    const double d = -a.dot(out), near = 0.1, far = 100.0;
    const double l = right.dot(a) * near / d, r = right.dot(b) * near / d;
    const double bottom = up.dot(a) * near / d, top = up.dot(c) * near / d;
    const M44d projection(2.0 * near / (r - l), 0.0, 0.0, 0.0,                 //
                          0.0, 2.0 * near / (top - bottom), 0.0, 0.0,          //
                          (r + l) / (r - l), (top + bottom) / (top - bottom),  //
                          -(far + near) / (far - near), -1.0,                  //
                          0.0, 0.0, -2.0 * far * near / (far - near), 0.0);
    const M44d turn(right.x, up.x, out.x, 0.0, right.y, up.y, out.y, 0.0, right.z, up.z, out.z, 0.0,
                    0.0, 0.0, 0.0, 1.0);
    return M44d().translate(-eye) * turn * projection;
}

std::string text(const V3d& a) { return fmt::format("({}, {}, {})", a.x, a.y, a.z); }

std::vector<lang::Override> corners(const Corners& wall) {
    return {{"lower_left", text(wall.lower_left)},
            {"lower_right", text(wall.lower_right)},
            {"upper_left", text(wall.upper_left)}};
}

// Where a point behind a wall is seen on it, as fractions from the top left corner.
V2d seen_at(const M44d& frustum, const V3d& point) {
    V3d ndc;
    frustum.multVecMatrix(point, ndc);  // Divides by w.
    return {0.5 + 0.5 * ndc.x, 0.5 - 0.5 * ndc.y};
}

/// Points behind the wall, from the eye, are where the matrices say.
void expect_frustum(const Rays& camera, const Corners& wall, const V3d& eye) {
    const M44d frustum = frustum_of(wall, eye);
    std::mt19937_64 random(6);
    std::uniform_real_distribution<double> part(0.02, 0.98);
    for (int i = 0; i < 200; ++i) {
        const V3d on_wall = wall.lower_left + part(random) * (wall.lower_right - wall.lower_left) +
                            part(random) * (wall.upper_left - wall.lower_left);
        const V3d point = eye + (1.0 + 5.0 * part(random)) * (on_wall - eye);
        const V2d at = seen_at(frustum, point);
        const Ray ray = camera.at(at.x, at.y);
        ASSERT_TRUE(ray.valid);
        expect_near(ray.origin, eye, 1e-12);
        expect_near(ray.direction, (point - eye).normalized(), 1e-9);
    }
}

// The default walls of `cave`.
const std::vector<Corners> cube{{{-1.5, 1.5, 0.0}, {1.5, 1.5, 0.0}, {-1.5, 1.5, 3.0}},
                                {{1.5, 1.5, 0.0}, {1.5, -1.5, 0.0}, {1.5, 1.5, 3.0}},
                                {{1.5, -1.5, 0.0}, {-1.5, -1.5, 0.0}, {1.5, -1.5, 3.0}},
                                {{-1.5, 1.5, 0.0}, {-1.5, -1.5, 0.0}, {1.5, 1.5, 0.0}}};

}  // namespace

TEST(CaveWall, IsTheOffAxisFrustumOfTheHead) {
    for (const V3d& head : {V3d(0.0, 0.0, 1.6), V3d(0.7, -1.1, 1.2)}) {
        for (const Corners& wall : cube) {
            auto set = corners(wall);
            set.push_back({"head", text(head)});
            expect_frustum(Rays("cave_wall", set), wall, head);
        }
        // A leaning wall that is wider than high.
        const Corners leaning{{2.0, 2.0, 0.5}, {2.0, -2.0, 0.5}, {2.6, 2.0, 1.3}};
        auto set = corners(leaning);
        set.push_back({"head", text(head)});
        const Rays camera("cave_wall", set);
        EXPECT_NEAR(camera.width() / camera.height(), 4.0, 1e-9);
        expect_frustum(camera, leaning, head);
    }
}

TEST(CaveWall, MovesTheEyesAsideOfWhereTheHeadFaces) {
    for (const double side : {-1.0, 1.0}) {
        for (const double facing : {0.0, 90.0, -30.0}) {
            const V3d right(std::sin(facing * degree), -std::cos(facing * degree), 0.0);
            auto set = corners(cube[1]);
            set.insert(set.end(), {{"head", "(0.2, 0.1, 1.7)"},
                                   {"separation", "0.07"},
                                   {"side", std::to_string(side)},
                                   {"facing", std::to_string(facing) + "deg"}});
            expect_frustum(Rays("cave_wall", set), cube[1],
                           V3d(0.2, 0.1, 1.7) + side * 0.035 * right);
        }
    }
}

TEST(CaveWall, StandsInTheSceneByItsOriginScaleAndTurn) {
    const Rays own("cave_wall", {{"head", "(0.3, 0.2, 1.5)"}});
    const Rays placed("cave_wall", {{"head", "(0.3, 0.2, 1.5)"},
                                    {"scale", "2"},
                                    {"yaw", "90deg"},
                                    {"px", "5"},
                                    {"py", "6"},
                                    {"pz", "7"}});
    for (const double x : {0.2, 0.5, 0.9}) {
        const Ray a = own.at(x, 0.3), b = placed.at(x, 0.3);
        expect_near(b.origin,
                    V3d(5.0 - 2.0 * a.origin.y, 6.0 + 2.0 * a.origin.x, 7.0 + 2.0 * a.origin.z),
                    1e-12);
        expect_near(b.direction, {-a.direction.y, a.direction.x, a.direction.z}, 1e-12);
    }
}

TEST(Cave, ShowsEveryWallInItsPlace) {
    const V3d head(0.4, -0.2, 1.5);
    for (const int columns : {4, 2}) {
        const camera::Picture cave =
            make_picture("cave", {{"head", text(head)}, {"columns", std::to_string(columns)}});
        const int rows = 4 / columns;
        EXPECT_NEAR(cave.aspect(), static_cast<double>(columns) / rows, 1e-12);
        const double side = 200.0;
        const Result<rays::CompiledPicture> picture =
            rays::compile(cave, side * columns, side * rows, {.tiles = false, .points = true});
        ASSERT_TRUE(picture);
        ASSERT_EQ(picture->layers().size(), cube.size());
        for (std::size_t i = 0; i < cube.size(); ++i) {
            const double left = side * static_cast<double>(i % static_cast<std::size_t>(columns));
            const double top = side * static_cast<double>(i / static_cast<std::size_t>(columns));
            const V3d point = head + 3.0 * (cube[i].lower_left +
                                            0.3 * (cube[i].lower_right - cube[i].lower_left) +
                                            0.6 * (cube[i].upper_left - cube[i].lower_left) - head);
            const V2d at = seen_at(frustum_of(cube[i], head), point);
            const std::vector<double> x{left + side * at.x}, y{top + side * at.y};
            rays::Points points;
            points.x = x;
            points.y = y;
            rays::Scratch scratch;
            rays::RayBatch batch;
            picture->layers()[i].rays.run(points, scratch, batch);
            ASSERT_TRUE(batch.valid(0));
            expect_near(batch[0].direction, (point - head).normalized(), 1e-9);
        }
    }
}

TEST(Cave, ReportsCornersOfNoPlaneOrNoRectangle) {
    const auto message = [](const std::string& corner, const std::string& place) {
        const auto made = lang::make_camera("cave_wall", "", {lang::Override{corner, place}});
        EXPECT_FALSE(made);
        return to_text(made.diagnostics);
    };
    EXPECT_NE(message("upper_left", "(1.5, 0.5, 0)").find("in one line and span no plane"),
              std::string::npos);
    EXPECT_NE(message("upper_left", "(1.5, 1.2, 3)").find("not those of a rectangle"),
              std::string::npos);
    EXPECT_NE(message("upper_right", "(1.9, -1.5, 3)").find("are not in a plane"),
              std::string::npos);
}

}  // namespace balcony::cameras::test::walls_test
