// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// What a camera sees of a scene and where its rays start, in scenes where that is known.

#include "balcony/probe.hpp"

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::probe_test {
namespace {

using namespace test;

/// A cube with edges of length 2 round a point, facing outwards, or inwards as a room does.
scene::Mesh cube(const V3f& center, bool inwards = false) {
    scene::Mesh mesh;
    for (int corner = 0; corner < 8; ++corner) {
        const auto side = [&](int bit) { return (corner >> bit & 1) != 0 ? 1.0F : -1.0F; };
        mesh.positions.push_back(center + V3f(side(0), side(1), side(2)));
    }
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    if (inwards) {
        for (auto& triangle : mesh.triangles) {
            std::swap(triangle[1], triangle[2]);
        }
    }
    mesh.normals.assign(mesh.positions.size(), V3f(0.0F, 0.0F, 1.0F));
    return mesh;
}

Probe probed(const scene::Scene& scene, const camera::Camera& camera) {
    ProbeSettings settings;
    settings.width = 128;
    settings.height = 128;
    Result<Probe> made = probe(renderer_of(scene), camera, settings);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

// The attempts that meet something, and how many objects.
std::vector<std::pair<RayChange, std::size_t>> attempts_of(const scene::Scene& scene,
                                                           const camera::Camera& camera) {
    const Result<Miss> miss =
        explain_miss(renderer_of(scene), camera, {.width = 128, .height = 128});
    EXPECT_TRUE(miss) << to_text(miss.diagnostics);
    std::vector<std::pair<RayChange, std::size_t>> found;
    for (const Miss::Attempt& attempt : miss->attempts) {
        found.emplace_back(attempt.change, attempt.objects);
    }
    return found;
}

TEST(Miss, IsExplainedByTheChangeThatMeetsObjects) {
    using Attempts = std::vector<std::pair<RayChange, std::size_t>>;
    scene::Scene scene;
    add(scene, wall(-3.0F, 20.0F), white());
    add(scene, wall(-2.0F, 0.5F), white());
    View view = view_down_z(0.0, 0.0, 0.5);
    view.forward = V3d(0, 0, 1);
    EXPECT_EQ(attempts_of(scene, orthographic(view)), (Attempts{{RayChange::reversed, 2}}));
    // A camera written for z up that looks along its own -z, which is the scene's -y.
    EXPECT_EQ(attempts_of(scene, orthographic(view_down_z(0.0, 0.0, 0.5), Axes::z_up)),
              (Attempts{{RayChange::other_axes, 2}}));
    // In millimetres, a scene of metres.
    scene.instances.erase(scene.instances.begin());
    EXPECT_EQ(attempts_of(scene, pinhole(view_down_z(0.0, 2000.0, 500.0))),
              (Attempts{{RayChange::scaled, 1}}));
    // Not all that is far away is in other units.
    EXPECT_EQ(attempts_of(scene, pinhole(view_down_z(0.0, 20.0, 5.0))), Attempts{});
    view = view_down_z(300.0, 0.0, 500.0);
    view.forward = V3d(-0.1, 0, -1);
    EXPECT_EQ(attempts_of(scene, orthographic(view)), (Attempts{{RayChange::scaled, 1}}));
    const Result<Miss> miss = explain_miss(renderer_of(scene), orthographic(view), {});
    EXPECT_EQ(miss->attempts.at(0).factor, 1e-3);
    EXPECT_NEAR(miss->origins.min.x, 299.0, 0.1);
    EXPECT_EQ(miss->bounds.max.x, 0.5);
}

TEST(Miss, CountsRaysThatHit) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 0.5F), white());
    const Request asked = request(40, 40, "preview");
    // The wall covers a quarter of the picture.
    Rendered made = render(scene, orthographic(view_down_z(0.0, 0.0, 0.0)), asked);
    EXPECT_EQ(made.summary.layers.at(0).hits, 400U);
    made = render(scene, orthographic(view_down_z(7.0, 0.0, 0.0)), asked);
    EXPECT_EQ(made.summary.layers.at(0).hits, 0U);
}

TEST(Probe, SeesSmallVisibleObjects) {
    scene::Scene scene;
    add(scene, wall(-3.0F, 20.0F), white());
    add(scene, wall(-4.0F, 1.0F), white());
    // A sixteenth of the distance between the rays of the first look, but wider than a pixel.
    add(scene, parallelogram({0.3F, 0.3F, -1.0F}, {0.017F, 0.0F, 0.0F}, {0.0F, 0.017F, 0.0F}),
        white());
    add(scene, scene::Mesh{}, white());
    const Probe found = probed(scene, orthographic(view_down_z(0.0, 0.0, 0.0)));
    EXPECT_EQ(found.rays, 1024U);
    ASSERT_EQ(found.objects.size(), 4U);
    EXPECT_TRUE(found.objects[0].seen);
    EXPECT_FALSE(found.objects[1].seen);
    EXPECT_TRUE(found.objects[1].has_surface);
    EXPECT_TRUE(found.objects[2].seen);
    EXPECT_FALSE(found.objects[3].has_surface);
    EXPECT_NEAR(*found.median_distance, 3.0, 1e-6);
}

TEST(Probe, SeesThroughTransparentSurfaces) {
    scene::Scene scene;
    scene::Material glass = white();
    glass.alpha_mode = scene::AlphaMode::blend;
    add(scene, wall(-1.0F, 20.0F), glass);
    add(scene, wall(-2.0F, 20.0F), glass);
    add(scene, wall(-3.0F, 20.0F), white());
    add(scene, wall(-4.0F, 20.0F), white());
    const Probe found = probed(scene, orthographic(view_down_z(0.0, 0.0, 0.0)));
    EXPECT_TRUE(found.objects[0].seen && found.objects[1].seen && found.objects[2].seen);
    EXPECT_FALSE(found.objects[3].seen);
}

TEST(Probe, CountsRaysThatStartInside) {
    // Origins from -1 to 1 in x and y; the cube holds those with x > 0.5.
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 0.0));
    scene::Scene scene;
    add(scene, cube({1.5F, 0.0F, 0.0F}), white());
    Probe found = probed(scene, camera);
    EXPECT_EQ(found.objects[0].rays_from_inside, 1024U / 4);
    EXPECT_GT(found.objects[0].inside_at.x, 96.0);
    // A small one in it does not hide the large one's inside.
    add(scene, cube({1.5F, 0.0F, -2.5F}), white());
    EXPECT_EQ(probed(scene, camera).objects[0].rays_from_inside, 1024U / 4);
}

TEST(Probe, OnlyClosedOutwardFacingObjectsHaveAnInside) {
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 0.0));
    scene::Mesh open = cube({0.0F, 0.0F, 0.0F});
    open.triangles.pop_back();
    scene::M44d mirror;
    mirror[0][0] = -1.0;
    scene::Scene scene;
    add(scene, cube({0.0F, 0.0F, 0.0F}, true), white());
    EXPECT_EQ(probed(scene, camera).objects[0].rays_from_inside, 0U);
    scene = {};
    add(scene, open, white());
    EXPECT_EQ(probed(scene, camera).objects[0].rays_from_inside, 0U);
    // A mirror image is turned round again; and a wall seen from behind is no inside.
    scene = {};
    add(scene, cube({1.5F, 0.0F, 0.0F}), white(), mirror);
    add(scene, parallelogram({-5.0F, -5.0F, -9.0F}, {0.0F, 10.0F, 0.0F}, {10.0F, 0.0F, 0.0F}),
        white());
    const Probe found = probed(scene, camera);
    EXPECT_EQ(found.objects[0].rays_from_inside, 1024U / 4);
    EXPECT_EQ(found.objects[1].rays_from_inside, 0U);
    EXPECT_TRUE(found.objects[1].seen);
}

TEST(Probe, RaysStartInNoObjectThatIsHidden) {
    scene::Scene scene;
    add(scene, cube(V3f(0.0F)), white());
    scene.objects[0].name = "shell";
    const Renderer renderer = renderer_of(scene);
    ProbeSettings settings{.width = 16, .height = 16};
    const auto inside = [&] {
        return probe(renderer, pinhole(view_down_z(0.0, 0.0, 0.0)), settings)
            ->objects[0]
            .rays_from_inside;
    };
    EXPECT_GT(inside(), 0U);
    settings.objects = {{.shows = false, .patterns = {{"shell"}}}};
    EXPECT_EQ(inside(), 0U);
}

// A slope that rises by 3 in 4 to the right, from -1 to 1, and a smaller plate across the rays
// before it. Floats at a distance of 3 are exact to 2.4e-7, and neighbours are 0.125 apart.
TEST(ScaleErrors, AreThoseOfTheSurfaceAlsoBesideItsEdges) {
    scene::Scene scene;
    add(scene, parallelogram({-1.0F, -1.0F, -4.0F}, {2.0F, 0.0F, 1.5F}, {0.0F, 1.8F, 0.0F}),
        white());
    add(scene, wall(-2.0F, 0.4F), white());
    const rays::Tile grid{4.0, 4.0, 8.0, 16, 16};
    const auto errors = scale_errors(renderer_of(scene), orthographic(view_down_z(0.0, 0.0, 0.0)),
                                     {.width = 128, .height = 128}, grid, 2.0 / 128.0);
    ASSERT_TRUE(errors) << to_text(errors.diagnostics);
    ASSERT_EQ(errors->size(), 256U);
    for (std::size_t i = 0; i < errors->size(); ++i) {
        const double x = (grid.column(i % 16) - 64.0) / 64.0;
        const double y = (64.0 - grid.row(i / 16)) / 64.0;
        const std::optional<double>& error = (*errors)[i];
        ASSERT_EQ(error.has_value(), y < 0.8) << x << " " << y;
        if (error) {
            const bool on_plate = std::max(std::abs(x), std::abs(y)) < 0.4;
            EXPECT_NEAR(*error, on_plate ? 0.0 : 0.25, 1e-5) << x << " " << y;
        }
    }
    // The direction with the largest error counts: half of what a pixel should be is the larger
    // one.
    const auto larger = scale_errors(renderer_of(scene), orthographic(view_down_z(0.0, 0.0, 0.0)),
                                     {.width = 128, .height = 128}, grid, 4.0 / 128.0);
    ASSERT_TRUE(larger) << to_text(larger.diagnostics);
    EXPECT_NEAR(*larger->back(), -0.5, 1e-5);
}

}  // namespace
}  // namespace balcony::render::probe_test
