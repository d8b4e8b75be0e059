// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Layers of some objects through lenses, in stereo and in motion: in parts with the camera of the
// master, each picture is that of a single layer. And what probes say of such layers.

#include <algorithm>
#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/inverse.hpp"
#include "balcony/make_stage.hpp"
#include "balcony/motion.hpp"
#include "balcony/probe.hpp"
#include "still_life.hpp"
#include "support.hpp"

namespace balcony::render::test::object_layers_test {
namespace {

using namespace still_life;

void expect_the_same(const Film& plain, const Film& parts) {
    EXPECT_TRUE(are_same(plain.sum, parts.sum));
    EXPECT_TRUE(are_same(plain.layers->object, parts.layers->object));
    EXPECT_TRUE(are_same(plain.layers->position, parts.layers->position));
    EXPECT_TRUE(are_same(plain.means.objects, parts.means.objects));
}

ProbeSettings of_objects(camera::ObjectFilter objects) {
    ProbeSettings made{.width = 96, .height = 72, .step = 2};
    made.objects = std::move(objects);
    return made;
}

}  // namespace

TEST(ObjectLayers, ThroughALensTheyAreThePlainPicture) {
    camera::Camera::Parts parts = eye().parts();
    const auto flat = *camera::make_stage<camera::FocusSurface>("flat", {{"distance", 3.0}});
    parts.lens = *camera::make_stage<camera::Lens>(
        "lens", {{"radius", 0.2}, {"focus", std::shared_ptr<const camera::Stage>(flat)}});
    const camera::Camera lens = *camera::Camera::make(parts);
    for (const std::string integrator : {"preview", "direct"}) {
        SCOPED_TRACE(integrator);
        const Film plain = render(scene_of_parts(), lens, asked(integrator, 4)).film;
        expect_the_same(plain,
                        render(scene_of_parts(), in_parts(lens, lens), asked(integrator, 4)).film);
        EXPECT_FALSE(
            are_same(plain.sum, render(scene_of_parts(), eye(), asked(integrator, 4)).film.sum));
    }
    // The lens focuses on an object that its layer does not show.
    const auto on = *camera::make_stage<camera::FocusSurface>("on", {{"object", "ball 2"}});
    parts.lens = *camera::make_stage<camera::Lens>(
        "lens", {{"radius", 0.2}, {"focus", std::shared_ptr<const camera::Stage>(on)}});
    const camera::Camera focused = *camera::Camera::make(parts);
    const Film film =
        render(scene_of_parts(), picture_of({layer("board", focused, only({"board"}))}),
               asked("preview", 4))
            .film;
    EXPECT_TRUE(std::all_of(film.sum.begin(), film.sum.end(),
                            [](const Color4d& one) { return std::isfinite(one.r); }));
}

TEST(ObjectLayers, InStereoTheyAreThePlainPicture) {
    for (const double side : {-1.0, 1.0}) {
        const auto view = *camera::make_stage<camera::StereoView>(
            "stereo", {{"separation", 0.3}, {"convergence", 3.0}, {"side", side}});
        const auto plain = camera::Picture(eye()).with_stereo(view);
        const auto parts = in_parts(eye(), eye()).with_stereo(view);
        ASSERT_TRUE(plain && parts) << to_text(plain.diagnostics) << to_text(parts.diagnostics);
        expect_the_same(render(scene_of_parts(), *plain, asked("direct")).film,
                        render(scene_of_parts(), *parts, asked("direct")).film);
    }
}

// The camera moves, and each layer has the motion of what it shows.
TEST(ObjectLayers, TheirMotionIsThatOfThePlainPicture) {
    constexpr double frame = 0.25;
    const camera::Camera moving =
        make_camera({[](const camera::ParameterPoint&, camera::Emitter& emit) {
                         const expr::Expr t = emit.graph().time();
                         return camera::ObjectPoint{0.4 * t, -0.3 * t, 2.0 + 0.5 * t};
                     },
                     [](const camera::ParameterPoint& p, camera::Emitter& emit) {
                         return camera::ObjectVector{p.u, p.v, emit(-1.0)};
                     }});
    const auto motion_of = [&](const camera::Picture& picture) {
        Request wanted = asked("preview", 1);
        wanted.layout.layers = {LayerId::motion};
        wanted.frames.duration = frame;
        const auto at = [&](double time) {
            const auto made = analyse::Locator::make(picture, 96, 72, time);
            EXPECT_TRUE(made) << to_text(made.diagnostics);
            return std::make_shared<const analyse::Locator>(*made);
        };
        wanted.frames.previous = at(-frame);
        wanted.frames.next = at(frame);
        return render(scene_of_parts(), picture, wanted).film;
    };
    const Film plain = motion_of(moving);
    const Film parts = motion_of(in_parts(moving, moving));
    ASSERT_EQ(plain.layers->motion.size(), parts.layers->motion.size());
    std::size_t moved = 0;
    for (std::size_t i = 0; i < plain.layers->motion.size(); ++i) {
        const auto& a = plain.layers->motion[i];
        const auto& b = parts.layers->motion[i];
        // Both searches end where a step is below 1e-6 pixels or so.
        for (const auto& [one, other] :
             {std::pair(a.x, b.x), std::pair(a.y, b.y), std::pair(a.z, b.z), std::pair(a.w, b.w)}) {
            ASSERT_NEAR(one, other, 1e-4F) << i;
        }
        moved += std::abs(a.x) > 0.1F ? 1 : 0;
    }
    EXPECT_GT(moved, 3000U);
}

// -------------------------------------------------------------------------------------- probes

TEST(ObjectLayers, AProbeMeetsOnlyWhatTheLayerShows) {
    const scene::Scene scene = scene_of_parts();
    const Renderer renderer = renderer_of(scene);
    const auto seen = [&](camera::ObjectFilter objects) {
        const auto found = probe(renderer, eye(), of_objects(std::move(objects)));
        EXPECT_TRUE(found) << to_text(found.diagnostics);
        std::vector<std::string> names;
        for (std::size_t i = 0; i < found->objects.size(); ++i) {
            EXPECT_EQ(found->objects[i].seen, found->objects[i].has_surface) << i;
            if (found->objects[i].seen) {
                names.push_back(scene.objects[i].name);
            }
        }
        return std::pair(names, *found->median_distance);
    };
    EXPECT_EQ(seen({}).first.size(), 4U);
    const auto [wall_alone, far] = seen(only({"wall"}));
    EXPECT_EQ(wall_alone, (std::vector<std::string>{"wall"}));
    EXPECT_GT(far, 5.0) << "the distance of the wall";
    const auto [ball_alone, near] = seen(only({"wall", "board", "ball 2"}, false));
    EXPECT_EQ(ball_alone, (std::vector<std::string>{"ball 1"}));
    EXPECT_LT(near, 3.2) << "the ball has its middle at 3";
}

TEST(ObjectLayers, TheScaleIsThatOfWhatTheLayerShows) {
    scene::Scene scene;
    add(scene, parallelogram({-1.0F, -1.0F, -4.0F}, {2.0F, 0.0F, 1.5F}, {0.0F, 2.0F, 0.0F}),
        white());
    add(scene, wall(-2.0F, 3.0F), white());
    scene.objects[0].name = "slope";
    scene.objects[1].name = "plate";
    const Renderer renderer = renderer_of(scene);
    const camera::Camera camera = orthographic(view_down_z(0.0, 0.0, 0.0));
    const rays::Tile grid{4.0, 4.0, 8.0, 12, 9};
    const auto errors_of = [&](camera::ObjectFilter objects) {
        ProbeSettings settings = of_objects(std::move(objects));
        settings.height = 96;
        const auto errors = scale_errors(renderer, camera, settings, grid, 2.0 / 96.0);
        EXPECT_TRUE(errors) << to_text(errors.diagnostics);
        const auto measured = measure_scale(renderer, camera, settings);
        EXPECT_TRUE(measured && *measured);
        // A pixel of the slope, which rises by 3 in 4, is a quarter longer.
        EXPECT_NEAR((*measured)->across.median / (2.0 / 96.0) - 1.0, *(*errors)[50], 1e-4);
        return *(*errors)[50];
    };
    EXPECT_NEAR(errors_of({}), 0.0, 1e-4) << "the plate hides the slope";
    EXPECT_NEAR(errors_of(only({"slope"})), 0.25, 1e-4);
    EXPECT_NEAR(errors_of(only({"plate"}, false)), 0.25, 1e-4);
}

}  // namespace balcony::render::test::object_layers_test
