// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The layer `motion` against the textbook formulas of its cameras.

#include <cmath>
#include <functional>
#include <memory>
#include <numbers>
#include <optional>

#include <gtest/gtest.h>

#include "balcony/inverse.hpp"
#include "balcony/motion.hpp"
#include "support.hpp"

namespace balcony::render::test::motion_layer_test {

namespace {

using Imath::V2d;

constexpr std::size_t side = 64;
constexpr double frame = 0.25;
// Rounding of positions, by which the expected motion is computed.
constexpr double tolerance = 1e-3;

/// A pinhole camera at a place, with a field of view of 90 degrees, that looks along -z.
struct Pinhole {
    static camera::ObjectVector direction(const camera::ParameterPoint& p, camera::Emitter& emit) {
        return {p.u, p.v, emit(-1.0)};
    }
    static std::optional<V2d> place_of(const V3d& p) {
        const V2d place(0.5 * side * (1.0 - p.x / p.z), 0.5 * side * (1.0 + p.y / p.z));
        const bool inside = place.x >= 0.0 && place.x < side && place.y >= 0.0 && place.y < side;
        return p.z < 0.0 && inside ? std::optional(place) : std::nullopt;
    }
};

/// All directions by longitude and latitude; the middle looks along -z.
struct Panorama {
    static camera::ObjectVector direction(const camera::ParameterPoint& p, camera::Emitter&) {
        const auto longitude = std::numbers::pi * p.u;
        const auto latitude = 0.5 * std::numbers::pi * p.v;
        return {cos(latitude) * sin(longitude), sin(latitude), -cos(latitude) * cos(longitude)};
    }
    static std::optional<V2d> place_of(const V3d& p) {
        using std::numbers::pi;
        return V2d(0.5 * side * (1.0 + std::atan2(p.x, -p.z) / pi),
                   0.5 * side * (1.0 - 2.0 * std::asin(p.y / p.length()) / pi));
    }
};

/// The camera at a place that moves with time.
template <class Projection>
camera::Camera camera_at(const V3d& velocity) {
    return make_camera(
        {[velocity](const camera::ParameterPoint&, camera::Emitter& emit) {
             const expr::Expr t = emit.graph().time();
             return camera::ObjectPoint{t * velocity.x, t * velocity.y, t * velocity.z};
         },
         Projection::direction});
}

/// The last instance moves at an even velocity, and is where it was made at time 0.
void set_in_motion(scene::Scene& scene, const V3d& velocity) {
    auto motion = std::make_shared<scene::Motion>();
    const auto at = [&](double time) { return V3f(velocity * time); };
    constexpr double end = 4.0;
    motion->tracks = {{scene::Interpolation::linear,
                       3,
                       {-end, end},
                       {at(-end).x, at(-end).y, at(-end).z, at(end).x, at(end).y, at(end).z}}};
    scene::Node node;
    node.world_from_parent = scene.instances.back().world_from_mesh;
    node.translation_track = scene::TrackIndex(0);
    motion->nodes = {node};
    motion->instances = {{scene.instances.size() - 1, scene::NodeIndex(0)}};
    scene.motion = std::move(motion);
}

scene::Scene ball_before_a_wall() {
    scene::Scene scene;
    add(scene, wall(-6.0F, 20.0F), white());
    scene::M44d placed;
    placed.setTranslation(V3d(0.3, -0.2, -3.0));
    add(scene, coarse_sphere(1.0F, 24, 12), white(), placed);
    return scene;
}

Request motion_request() {
    Request made = request(side, side, "preview");
    made.layout.layers = {LayerId::motion};
    made.frames.duration = frame;
    return made;
}

std::shared_ptr<const rays::ImagePointFinder> inverse_at(const camera::Picture& picture,
                                                         double time) {
    const auto made = analyse::Locator::make(picture, side, side, time);
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return std::make_shared<const analyse::Locator>(*made);
}

Rendered rendered(const scene::Scene& scene, const camera::Picture& picture, Request request) {
    request.frames.previous = inverse_at(picture, request.time - frame);
    request.frames.next = inverse_at(picture, request.time + frame);
    return render(scene, picture, request);
}

/// Compares the layer with the motion of the surface that the film shows.
template <class Projection>
void expect_motion(const Film& film, const V3d& ball_velocity, const V3d& camera_velocity,
                   double pixel_tolerance = tolerance) {
    std::size_t compared = 0;
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const std::size_t i = film.index(x, y);
            const V3d velocity =
                (film.layers->object[i] == 2 ? ball_velocity : V3d(0.0)) - camera_velocity;
            const V3d now(film.layers->position[i]);
            const auto before = Projection::place_of(now - frame * velocity);
            const auto after = Projection::place_of(now + frame * velocity);
            if (film.layers->object[i] == 0 || !before || !after) {
                continue;
            }
            ++compared;
            const V2d here(static_cast<double>(x) + 0.5, static_cast<double>(y) + 0.5);
            const V4f& motion = film.layers->motion[i];
            ASSERT_NEAR(motion.x, before->x - here.x, pixel_tolerance) << x << ' ' << y;
            ASSERT_NEAR(motion.y, here.y - before->y, pixel_tolerance) << x << ' ' << y;
            ASSERT_NEAR(motion.z, here.x - after->x, pixel_tolerance) << x << ' ' << y;
            ASSERT_NEAR(motion.w, after->y - here.y, pixel_tolerance) << x << ' ' << y;
        }
    }
    EXPECT_GT(compared, side * side / 4);
}

}  // namespace

TEST(MotionLayer, MovingObjects) {
    scene::Scene scene = ball_before_a_wall();
    const V3d velocity(0.8, 0.5, 0.3);
    set_in_motion(scene, velocity);
    const Film seen = rendered(scene, camera_at<Pinhole>(V3d(0.0)), motion_request()).film;
    expect_motion<Pinhole>(seen, velocity, V3d(0.0));
    const Film around = rendered(scene, camera_at<Panorama>(V3d(0.0)), motion_request()).film;
    expect_motion<Panorama>(around, velocity, V3d(0.0));
}

TEST(MotionLayer, MovingCameras) {
    const scene::Scene scene = ball_before_a_wall();
    const V3d velocity(-0.6, 0.4, -0.5);
    const Film seen = rendered(scene, camera_at<Pinhole>(velocity), motion_request()).film;
    expect_motion<Pinhole>(seen, V3d(0.0), velocity);
    const Film around = rendered(scene, camera_at<Panorama>(velocity), motion_request()).film;
    expect_motion<Panorama>(around, V3d(0.0), velocity);
}

// A shutter that is open does not change the data, which are those of its middle.
TEST(MotionLayer, OpenShutter) {
    scene::Scene scene = ball_before_a_wall();
    const V3d velocity(0.8, 0.5, 0.3);
    set_in_motion(scene, velocity);
    Request open = motion_request();
    open.shutter.duration = 0.5 * frame;
    open.samples = 4;
    const camera::Picture picture = camera_at<Pinhole>(V3d(0.0));
    open.frames.previous = inverse_at(picture, -frame);
    open.frames.next = inverse_at(picture, frame);
    const Result<Renderer> renderer =
        Renderer::make(std::make_shared<scene::Scene>(scene),
                       RendererSettings{.interval = open.shutter.exposure(open.time)});
    Result<Film> film = make_film(open.layout);
    ASSERT_TRUE(render::render(*renderer, picture, open, *film));
    expect_motion<Pinhole>(*film, velocity, V3d(0.0));
}

// A mesh that turns: the matrices between two times are not those of any step.
TEST(MotionLayer, TurningObjectsKeepToTheirCircles) {
    scene::Scene scene;
    add(scene, wall(0.0F, 2.0F), white());
    auto motion = std::make_shared<scene::Motion>();
    constexpr double turn = 1.0;  // Radians per frame.
    scene::Track track{scene::Interpolation::linear, 4, {-frame, 0.0, frame}, {}};
    for (const double angle : {-turn, 0.0, turn}) {
        const auto half = static_cast<float>(0.5 * angle);
        track.values.insert(track.values.end(), {0.0F, 0.0F, std::sin(half), std::cos(half)});
    }
    motion->tracks = {track};
    scene::Node node;
    node.rotation_track = scene::TrackIndex(0);
    motion->nodes = {node};
    motion->instances = {{0, scene::NodeIndex(0)}};
    scene.motion = std::move(motion);
    const Film film = rendered(scene, orthographic(view_down_z(0, 0, 2)), motion_request()).film;
    for (const auto& [x, y] : {std::pair<std::size_t, std::size_t>{40, 30}, {20, 36}, {32, 32}}) {
        const double px = static_cast<double>(x) + 0.5 - 0.5 * side;
        const double py = 0.5 * side - static_cast<double>(y) - 0.5;  // Up.
        const V4f& found = film.layers->motion[film.index(x, y)];
        EXPECT_NEAR(found.x, px * std::cos(turn) + py * std::sin(turn) - px, tolerance);
        EXPECT_NEAR(found.y, py * std::cos(turn) - px * std::sin(turn) - py, tolerance);
        EXPECT_NEAR(found.z, px - (px * std::cos(turn) - py * std::sin(turn)), tolerance);
        EXPECT_NEAR(found.w, py - (py * std::cos(turn) + px * std::sin(turn)), tolerance);
    }
}

// The points of still surfaces are exact, as they are on their rays.
TEST(MotionLayer, NothingMoves) {
    for (const bool pinhole : {true, false}) {
        const camera::Camera camera =
            pinhole ? camera_at<Pinhole>(V3d(0.0)) : camera_at<Panorama>(V3d(0.0));
        const Rendered still = rendered(ball_before_a_wall(), camera, motion_request());
        EXPECT_EQ(still.summary.unknown_motion, 0U);
        for (const V4f& motion : still.film.layers->motion) {
            // The accuracy of the inverse.
            ASSERT_LT(motion.length(), 1e-6F);
        }
    }
}

// Of what enters or leaves the picture, the motion in the other frame continues.
TEST(MotionLayer, MotionContinuesBeyondThePicture) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 9.0F), white());
    const V3d velocity(0.5, 0.0, 0.0);
    set_in_motion(scene, velocity);
    const Rendered seen = rendered(scene, camera_at<Pinhole>(V3d(0.0)), motion_request());
    EXPECT_EQ(seen.summary.unknown_motion, 0U);
    const auto pixels = static_cast<float>(0.5 * side * frame * velocity.x);
    for (const V4f& motion : seen.film.layers->motion) {
        ASSERT_NEAR(motion.x, -pixels, tolerance);
        ASSERT_NEAR(motion.z, -pixels, tolerance);
    }
}

// A wall that is in the picture at this moment only.
TEST(MotionLayer, UnknownMotionIsCounted) {
    scene::Scene scene;
    add(scene, wall(-1.0F, 9.0F), white());
    set_in_motion(scene, {30.0, 0.0, 0.0});
    const Rendered seen = rendered(scene, camera_at<Pinhole>(V3d(0.0)), motion_request());
    EXPECT_EQ(seen.summary.unknown_motion, side * side);
    for (const V4f& motion : seen.film.layers->motion) {
        ASSERT_EQ(motion, V4f(0.0F));
    }
}

// A picture of directions twice around shows each point at two places.
TEST(MotionLayer, TheNearestPlaceCounts) {
    const scene::Scene scene = ball_before_a_wall();
    const camera::Camera twice =
        make_camera({[](const camera::ParameterPoint&, camera::Emitter& emit) {
                         return camera::ObjectPoint{emit(0.0), emit(0.0), emit(0.0)};
                     },
                     [](const camera::ParameterPoint& p, camera::Emitter& emit) {
                         return Panorama::direction({2.0 * p.u, p.v}, emit);
                     }});
    const Rendered seen = rendered(scene, twice, motion_request());
    EXPECT_GT(seen.summary.ambiguous_motion, side);
    for (const V4f& motion : seen.film.layers->motion) {
        ASSERT_LT(motion.length(), 1e-6F);
    }
}

TEST(MotionLayer, FramesHaveADuration) {
    const scene::Scene scene = ball_before_a_wall();
    const Result<Renderer> renderer = Renderer::make(std::make_shared<scene::Scene>(scene));
    Request wrong = motion_request();
    const auto film = std::make_shared<Film>(*make_film(wrong.layout));
    for (const double duration : {0.0, -1.0, std::nan("")}) {
        wrong.frames.duration = duration;
        EXPECT_FALSE(Job::make(*renderer, camera_at<Pinhole>(V3d(0.0)), wrong, film)) << duration;
    }
}

}  // namespace balcony::render::test::motion_layer_test
