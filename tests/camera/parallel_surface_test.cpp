// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The object transformer `offset`: surfaces parallel to others.

#include <functional>

#include "support.hpp"

namespace balcony::camera::parallel_surface_test {

namespace {

constexpr double width = 80.0;
constexpr double height = 45.0;
constexpr double tolerance = 1e-12;  // points of size 10 after some dozen roundings

Camera::Parts moved(const ObjectGeneratorPointer& surface,
                    std::vector<ObjectTransformerPointer> moves) {
    Camera::Parts parts;
    parts.name = "test";
    parts.eye = {range(2.0, -2.0, 0.1, 0.9), {}, surface, std::move(moves)};
    parts.look = look("normal");
    return parts;
}

ObjectTransformerPointer offset(double distance) {
    return move("offset", {{"distance", numbers({distance})}});
}

void at_pixels(const std::function<void(double x, double y)>& check) {
    for (double x = 0.5; x < width; x += 7.0) {
        for (double y = 0.5; y < height; y += 5.0) {
            check(x, y);
        }
    }
}

}  // namespace

TEST(Offset, MovesEveryPointByItsDistanceAlongTheNormalAndKeepsThat) {
    for (const ObjectGeneratorPointer& surface :
         {object("sphere"), object("torus", {{"major", numbers({4.0})}}), object("plane"),
          object("paraboloid"), object("superellipsoid", {{"gamma_v", numbers({0.5})}}),
          object("mobius_band"), object("mesh")}) {
        const CameraProbe still(camera(moved(surface, {})), width, height);
        for (const double distance : {0.4, -0.3}) {
            const CameraProbe rays(camera(moved(surface, {offset(distance)})), width, height);
            at_pixels([&](double x, double y) {
                const Ray before = still(x, y);
                const Ray after = rays(x, y);
                ASSERT_EQ(after.valid, before.valid);
                if (before.valid) {
                    expect_near(after.origin - before.origin, distance * before.direction,
                                tolerance);
                    expect_near(after.direction, before.direction, tolerance);
                }
            });
        }
    }
}

// The tangents of the parallel surface are perpendicular to the normal that it keeps.
TEST(Offset, MakesTheSurfaceThatItsNormalsSay) {
    const auto surface = object("paraboloid");
    for (const char* along : {"u", "v"}) {
        Camera::Parts parts = moved(surface, {offset(0.2)});
        const CameraProbe normals(camera(parts), width, height);
        parts.look = look("tangent", {{"along", std::string(along)}});
        const CameraProbe tangents(camera(parts), width, height);
        at_pixels([&](double x, double y) {
            EXPECT_NEAR(dot(normals(x, y).direction, tangents(x, y).direction), 0.0, tolerance);
        });
    }
}

TEST(Offset, OfASphereIsALargerSphere) {
    const CameraProbe offset_one(camera(moved(object("sphere"), {offset(0.5)})), width, height);
    const CameraProbe larger(camera(moved(object("sphere", {{"radius", numbers({1.5})}}), {})),
                             width, height);
    at_pixels([&](double x, double y) {
        expect_near(offset_one(x, y).origin, larger(x, y).origin, tolerance);
    });
}

// Moves before it shape the surface; those after it move the parallel surface.
TEST(Offset, TakesTheNormalsThatItsPlaceInTheSequenceGives) {
    const auto egg = move("stretch", {{"z", numbers({2.0})}});
    const auto turn =
        move("rotate", {{"axis", numbers({1.0, 2.0, -1.0})}, {"angle", numbers({0.7})}});
    for (const char* name : {"sphere", "mesh"}) {
        const CameraProbe plain(camera(moved(object(name), {egg})), width, height);
        const CameraProbe rays(camera(moved(object(name), {egg, offset(0.5), turn})), width,
                               height);
        at_pixels([&](double x, double y) {
            const Ray before = plain(x, y);
            const Ray after = rays(x, y);
            ASSERT_EQ(after.valid, before.valid);
            if (before.valid) {
                const Vector point = before.origin - (-0.5) * before.direction;
                expect_near(after.origin, transformed(turn, point), tolerance);
                expect_near(after.direction, transformed(turn, before.direction), tolerance);
            }
        });
    }
}

TEST(Offset, AddsUpWhenRepeated) {
    const auto twice = move(
        "repeat",
        {{"times", numbers({2.0})}, {"stages", std::vector<Arguments::StagePointer>{offset(0.2)}}});
    const CameraProbe repeated(camera(moved(object("paraboloid"), {twice})), width, height);
    const CameraProbe once(camera(moved(object("paraboloid"), {offset(0.4)})), width, height);
    at_pixels([&](double x, double y) {
        expect_near(repeated(x, y).origin, once(x, y).origin, tolerance);
    });
}

TEST(Offset, NeedsASurface) {
    for (const char* name : {"circle", "point"}) {
        Camera::Parts parts = moved(object("sphere"), {});
        parts.toward = Path{parts.eye.mapper, {}, object(name), {offset(1.0)}};
        parts.look = look("relative");
        const Result<Camera> made = Camera::make(std::move(parts));
        ASSERT_FALSE(made);
        EXPECT_NE(made.diagnostics.front().message.find("needs a surface, but the 'toward' object"),
                  std::string::npos);
        EXPECT_FALSE(made.diagnostics.front().remedy.empty());
    }
}

}  // namespace balcony::camera::parallel_surface_test
