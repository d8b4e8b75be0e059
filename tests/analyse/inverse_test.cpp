// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// The inverse by its law, that forward then inverse is the place one came from, and by cameras
// whose sightings can be counted and calculated.

#include "balcony/inverse.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <map>
#include <numbers>
#include <string>
#include <thread>

#include <gtest/gtest.h>

#include "../laws/built_in_cameras.hpp"
#include "balcony/catalogue.hpp"
#include "random_points.hpp"
#include "support.hpp"

namespace balcony::analyse::inverse_test {
namespace {

using test::RandomPoints;

using std::numbers::pi;

// How far in pixels each of the random points is found from where it came from.
std::vector<double> misses(const camera::Camera& camera, double height, std::size_t count) {
    const double width = std::round(height * camera.parts().aspect);
    const RandomPoints random(camera, width, height, count);
    std::vector<double> nearest(random.points.size(), std::numeric_limits<double>::infinity());
    const auto locator = Locator::make(camera, width, height);
    EXPECT_TRUE(locator) << to_text(locator.diagnostics);
    if (!locator) {
        return nearest;
    }
    for (const Sighting& sighting : locator->locate(random.points)) {
        double& miss = nearest[sighting.point];
        miss = std::min(miss, (sighting.position - random.places[sighting.point]).length());
    }
    return nearest;
}

// How many of them are not found within a distance.
std::size_t lost(const std::vector<double>& misses, double distance = 0.01) {
    return static_cast<std::size_t>(std::count_if(misses.begin(), misses.end(),
                                                  [&](double miss) { return !(miss < distance); }));
}

std::size_t lost(const camera::Camera& camera, double height, std::size_t count) {
    return lost(misses(camera, height, count));
}

std::vector<Sighting> sightings(const std::string& text, double width, double height,
                                const V3d& point) {
    return Locator::make(test::camera_of(text), width, height)->locate(point);
}

void expect_at(const Sighting& sighting, const V2d& place) {
    EXPECT_LT((sighting.position - place).length(), 1e-6)
        << sighting.position << " is not " << place;
}

}  // namespace

TEST(Sightings, ForemostAreThoseOfTheFrontLayerAndTheNearest) {
    const auto seen = [](std::size_t point, std::size_t layer, double distance) {
        return Sighting{.point = point,
                        .layer = layer,
                        .position = {},
                        .origin = V3d(0.0),
                        .distance = distance};
    };
    const std::vector<Sighting> all{seen(0, 1, 5.0), seen(0, 2, 7.0), seen(0, 2, 6.0),
                                    seen(2, 0, 1.0), seen(2, 0, 2.0)};
    EXPECT_EQ(foremost(all, 4), (std::vector<const Sighting*>{&all[2], nullptr, &all[3], nullptr}));
}

TEST(InverseLaw, HoldsForEveryBuiltInCamera) {
    constexpr std::size_t count = 10'000;
    // At the rim of these discs, the angle changes without bound, or all that is behind it is seen.
    // The normals of a profile cross, and there two places of the picture meet.
    const std::map<std::string, double> lost_share{{"angular_map", 0.002},
                                                   {"catadioptric_spherical", 0.002},
                                                   {"fisheye_thoby", 0.002},
                                                   {"mirror_ball", 0.05},
                                                   {"rollout_profile", 0.002}};
    for (const std::string& name : laws::single_built_in_cameras()) {
        const auto exception = lost_share.find(name);
        const double allowed = exception == lost_share.end() ? 0.0 : exception->second;
        EXPECT_LE(static_cast<double>(lost(test::standard(name), 500, count)), allowed * count)
            << name;
    }
}

// Where a picture folds, as plate 15 does, two sightings of a point meet. Nearer to each other than
// a pixel, one of them may stand for both.
TEST(InverseLaw, HoldsForThePlates) {
    constexpr double one_for_both = 1.0;
    std::size_t count = 0;
    const std::filesystem::path plates = BALCONY_SOURCE_DIR "/plates";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(plates)) {
        if (entry.path().extension() != ".cam") {
            continue;
        }
        const auto camera = lang::make_camera(entry.path(), "");
        ASSERT_TRUE(camera) << to_text(camera.diagnostics);
        const std::vector<double> missed = misses(*camera, 300, 10'000);
        EXPECT_EQ(lost(missed, one_for_both), 0U) << entry.path();
        EXPECT_LE(lost(missed), 1U) << entry.path();
        ++count;
    }
    EXPECT_GE(count, 2U);
}

// Fractal terrain is left out: its normals cross at every scale, down to below a pixel.
TEST(InverseLaw, HoldsForTheExamplesOfTheCatalogue) {
    for (const camera::StageEntry& row : camera::catalogue()) {
        if (row.example.find("camera ") == std::string_view::npos ||
            row.name.starts_with("fractal")) {
            continue;
        }
        const auto text = std::make_shared<const SourceText>("example", std::string(row.example));
        const auto camera = lang::make_camera(text, "");
        if (camera) {
            EXPECT_EQ(lost(*camera, 100, 500), 0U) << row.name;
        }
    }
}

// Whatever the place of the seams: tiles, a picture of six sides, a border of the rays' own, an
// infinite derivative, a turning spiral.
TEST(InverseLaw, HoldsAcrossSeamsAndBorders) {
    for (const char* text : {
             R"(camera tiles {
                    map u = 2 .. -2, v = -1 .. 1
                    warp formula(u, v) = [mod(u, 0.37), mod(v, 0.41)]
                    eye point(0, 0, 0)
                    toward plane((1, 0, 0))
                })",
             R"(camera columns {
                    map u = 0 .. 4, v = -1 .. 1
                    eye point(0, 0, 1)
                    toward surface(u, v) = [
                        cos(floor(u)*90deg) - sin(floor(u)*90deg)*(2*(u - floor(u)) - 1),
                        sin(floor(u)*90deg) + cos(floor(u)*90deg)*(2*(u - floor(u)) - 1), v]
                })",
             R"(camera disc {
                    map u = 1.2 .. -1.2, v = square
                    eye surface(u, v) = [sqrt(1 - u^2 - v^2), u, v]
                    look normal
                })",
             R"(camera cusps {
                    aspect 3
                    map u = 180deg .. -180deg, v = -40deg .. 40deg
                    eye product(superellipse(1, 0.6, 1/4, by = trigonometric),
                                superellipse(4, 2, 1/4, by = trigonometric))
                    look normal
                })",
             R"(camera spiral {
                    map u = 1 .. -1, v = square
                    warp formula(u, v) = [log(sqrt(u^2 + v^2)), atan2(v, u)]
                    eye point(0, 0, 0)
                    toward surface(u, v) = [cos(mod(u, 0.7))*cos(v), cos(mod(u, 0.7))*sin(v),
                                            sin(mod(u, 0.7))]
                })",
         }) {
        EXPECT_EQ(lost(test::camera_of(text), 300, 3'000), 0U) << text;
    }
}

// Rays that cross each other, so that points see many places and derivatives vanish at some.
TEST(InverseLaw, HoldsWhereRaysCross) {
    for (const char* text : {
             R"(camera waves {
                    map u = 2 .. -2, v = square
                    eye surface(u, v) = [0.3*sin(5*u)*cos(4*v), u, v]
                    look normal
                })",
             R"(camera ring {
                    map u = 180deg .. -180deg, v = -180deg .. 180deg
                    eye torus(5, 2)
                    look normal(side = back)
                })",
             R"(camera swinging {
                    map u = 2 .. -2, v = -20deg .. 20deg
                    eye line(along = (0, 1, 0))
                    toward {
                        warp   zoom(at = (0, 0), radius = (1, 0.3), strength = 3)
                        object surface(u, v) = [cos(v), u, sin(v)]
                    }
                })",
         }) {
        EXPECT_EQ(lost(test::camera_of(text), 300, 3'000), 0U) << text;
    }
}

TEST(ClosedForm, IsTheTextbooksForThePinhole) {
    const camera::Camera camera = test::standard("pinhole", {{"fov", "80deg"}, {"pz", "2"}});
    const auto locator = Locator::make(camera, 640, 400);
    EXPECT_TRUE(locator->closed_form());
    EXPECT_EQ(locator->patch_count(), 0U);
    const double focal = 320.0 / std::tan(40.0 * pi / 180.0);
    for (const V3d& point : {V3d(1, 0, 2), V3d(5, -3, 1), V3d(2e9, 1e9, -7e8)}) {
        const auto found = locator->locate(point);
        ASSERT_EQ(found.size(), 1U);
        expect_at(found[0],
                  {320.0 - focal * point.y / point.x, 200.0 - focal * (point.z - 2.0) / point.x});
        EXPECT_NEAR(found[0].distance, (point - V3d(0, 0, 2)).length(), 1e-9 * point.length());
    }
}

TEST(ClosedForm, SolvesEveryCameraThatIsLinear) {
    for (const char* text : {
             "camera a { map u = 2 .. -2, v = square eye plane look normal move rotate(z, 20deg) }",
             // Two slits: rays start on an upright line and pass a level one.
             R"(camera slits {
                    map u = 1 .. -1, v = square
                    eye    surface(u, v) = [0, 0, v]
                    toward surface(u, v) = [1, u, 0]
                })",
             // A push-broom camera: perspective in height, parallel along its path.
             R"(camera broom {
                    map u = 1 .. -1, v = square
                    eye    surface(u, v) = [0, u, 0]
                    toward surface(u, v) = [1, u, v]
                })",
         }) {
        const camera::Camera camera = test::camera_of(text);
        EXPECT_TRUE(Locator::make(camera, 300, 200)->closed_form()) << text;
        EXPECT_EQ(lost(camera, 200, 1'000), 0U) << text;
    }
    EXPECT_FALSE(Locator::make(test::standard("panorama"), 300, 150)->closed_form());
    EXPECT_FALSE(Locator::make(test::standard("fisheye"), 300, 300)->closed_form());
}

TEST(Locate, FindsNothingBehindBesideOrAtTheEye) {
    const auto pinhole = Locator::make(test::standard("pinhole"), 640, 360);
    EXPECT_TRUE(pinhole->locate(V3d(-1, 0, 0)).empty());
    EXPECT_TRUE(pinhole->locate(V3d(1, 5, 0)).empty());
    EXPECT_TRUE(pinhole->locate(V3d(0, 0, 0)).empty());
    const auto fisheye = Locator::make(test::standard("fisheye"), 400, 400);
    EXPECT_TRUE(fisheye->locate(V3d(-1, 0.1, 0)).empty());
    EXPECT_TRUE(fisheye->locate(V3d(0, 0, 0)).empty());
    EXPECT_EQ(fisheye->locate(V3d(1, 0.1, 0)).size(), 1U);
}

TEST(Locate, FindsAPointInEveryTurnOfAPanorama) {
    const camera::Picture turns(test::standard("cylinder", {{"width", "720deg"}}));
    const auto twice = Locator::make(turns.with_fit(camera::Fit::stretch), 1600, 200);
    const auto found = twice->locate(V3d(4, 1, 0.3));
    ASSERT_EQ(found.size(), 2U);
    // A turn to the left is 800 pixels; the middle faces along x.
    const double left = std::atan2(1.0, 4.0) / (2.0 * pi) * 800.0;
    expect_at(found[0], {800.0 - left, found[0].position.y});
    expect_at(found[1], {1600.0 - left, found[0].position.y});
    EXPECT_NEAR(found[0].distance, std::sqrt(17.0) - 1.0, 1e-9);
}

// Height above the horizon and angle round it, as the panorama has them.
TEST(Locate, IsTheTextbooksForThePanorama) {
    const auto locator = Locator::make(test::standard("panorama"), 800, 400);
    const V3d point(-2, 3, 1.5);
    const auto found = locator->locate(point);
    ASSERT_EQ(found.size(), 1U);
    const double longitude = std::atan2(point.y, point.x);
    const double latitude = std::asin(point.z / point.length());
    expect_at(found[0], {400.0 - longitude / pi * 400.0, 200.0 - latitude / pi * 400.0});
}

TEST(Locate, FindsSomePlacesOfALineThatAllSeesAPole) {
    const auto locator = Locator::make(test::standard("panorama"), 800, 400);
    const auto found = locator->locate(V3d(0, 0, 3));
    ASSERT_FALSE(found.empty());
    for (const Sighting& sighting : found) {
        EXPECT_NEAR(sighting.position.y, 0.0, 1e-6);
        EXPECT_NEAR(sighting.distance, 3.0, 1e-9);
    }
}

// Parallel rays at y = u^3 - u: three where that has three roots, and one outside.
TEST(Locate, FindsAllThreeLayersOfAFold) {
    const std::string fold = R"(camera fold {
        map u = 1.5 .. -1.5, v = -1 .. 1
        eye    surface(u, v) = [0, u^3 - u, v]
        toward surface(u, v) = [1, u^3 - u, v]
    })";
    const auto three = sightings(fold, 300, 200, {5, 0, 0});
    ASSERT_EQ(three.size(), 3U);
    expect_at(three[0], {50, 100});
    expect_at(three[1], {150, 100});
    expect_at(three[2], {250, 100});
    EXPECT_NEAR(three[1].distance, 5.0, 1e-12);
    EXPECT_EQ(sightings(fold, 300, 200, {5, 0.5, 0}).size(), 1U);
    // The fold itself is at y = 2/(3 sqrt 3): a hair inside there are two roots near each other.
    const double edge = 2.0 / (3.0 * std::sqrt(3.0));
    EXPECT_EQ(sightings(fold, 300, 200, {5, edge - 1e-6, 0}).size(), 3U);
    EXPECT_EQ(sightings(fold, 300, 200, {5, edge + 1e-6, 0}).size(), 1U);
}

// Rays that run from a cylinder inwards pass a point from its near side and from its far side.
TEST(Locate, FindsBothSidesOfARoundRoom) {
    const std::string inwards = R"(camera inwards {
        aspect 3.6
        map  u = -180deg .. 180deg, v = -1 .. 1
        eye  cylinder(3)
        look normal(side = back)
    })";
    const double angle = 40.0 * pi / 180.0;
    const auto found = sightings(inwards, 720, 200, {std::cos(angle), std::sin(angle), 0.5});
    ASSERT_EQ(found.size(), 2U);
    expect_at(found[0], {360.0 + 2.0 * (40.0 - 180.0), 50.0});
    expect_at(found[1], {360.0 + 2.0 * 40.0, 50.0});
    EXPECT_NEAR(found[0].distance, 4.0, 1e-9);
    EXPECT_NEAR(found[1].distance, 2.0, 1e-9);
}

TEST(Locate, FindsThePointsWhereRaysStart) {
    const camera::Camera camera = test::standard("hyperbolic");
    const PointRays rays(*rays::compile(camera, 480, 270, {.footprints = true, .points = true}),
                         0.0);
    PointRays::Batch batch(rays);
    batch.place(0, {123.4, 56.7});
    batch.run(1);
    const auto found = Locator::make(camera, 480, 270)->locate(batch.ray(0).origin);
    ASSERT_EQ(found.size(), 1U);
    expect_at(found[0], {123.4, 56.7});
    EXPECT_NEAR(found[0].distance, 0.0, 1e-9);
}

TEST(Locate, HearsTheTime) {
    const camera::Camera camera = test::camera_of(
        "camera a { map u = 45deg .. -45deg, v = square eye point(0, 0, 0) toward sphere(1) "
        "move rotate(z, t*10deg) }");
    const auto at = [&](double time) {
        return Locator::make(camera, 900, 500, time)->locate(V3d(5, 0, 0)).at(0).position.x;
    };
    EXPECT_NEAR(at(0.0), 450.0, 1e-6);
    EXPECT_NEAR(at(2.0), 650.0, 1e-6);
}

TEST(Locate, ManyPointsAgreeWithSinglePointsAndThreads) {
    const camera::Camera camera = test::standard("superelliptic");
    const auto locator = Locator::make(camera, 750, 150);
    const RandomPoints random(camera, 750, 150, 300);
    const auto together = locator->locate(random.points);
    std::vector<Sighting> single;
    {
        const std::jthread other([&] {
            for (const V3d& point : random.points) {
                const auto found = locator->locate(point);
                single.insert(single.end(), found.begin(), found.end());
            }
        });
        EXPECT_EQ(locator->locate(random.points).size(), together.size());
    }
    ASSERT_EQ(single.size(), together.size());
    for (std::size_t i = 0; i < single.size(); ++i) {
        EXPECT_EQ(single[i].position, together[i].position);
        EXPECT_EQ(single[i].distance, together[i].distance);
    }
}

TEST(Locate, AllProcessorsFindWhatOneDoes) {
    const camera::Camera camera = test::standard("superelliptic");
    const auto locator = Locator::make(camera, 750, 150);
    const RandomPoints random(camera, 750, 150, 10000);
    const std::vector<Sighting> one = locator->locate(random.points);
    std::vector<std::size_t> in_part;
    const auto all = locator->locate(random.points, in_part);
    ASSERT_TRUE(all) << to_text(all.diagnostics);
    ASSERT_EQ(all->size(), one.size());
    for (std::size_t i = 0; i < one.size(); ++i) {
        EXPECT_EQ((*all)[i].point, one[i].point);
        EXPECT_EQ((*all)[i].position, one[i].position);
        EXPECT_EQ((*all)[i].distance, one[i].distance);
    }
}

TEST(Locate, FindsExtremelyDistantPoints) {
    for (const char* name : {"pinhole", "panorama", "fisheye"}) {
        const auto locator = Locator::make(test::standard(name), 800, 400);
        const V3d direction(4, 1, -0.5);
        const Sighting near = locator->locate(direction).at(0);
        for (const double far : {1e50, 1e80, 1e149, 1e200, 1e306}) {
            // One far point among others does not change these.
            const auto found = locator->locate(std::vector{direction, far * direction});
            ASSERT_EQ(found.size(), 2U) << name << ' ' << far;
            EXPECT_EQ(found[0].position, near.position);
            EXPECT_LT((found[1].position - near.position).length(), 1e-6) << name << ' ' << far;
            EXPECT_NEAR(found[1].distance / far, near.distance, 1e-9);
        }
        const double none = std::nan("");
        const double infinite = std::numeric_limits<double>::infinity();
        EXPECT_TRUE(locator->locate(V3d(none, 0, 0)).empty());
        EXPECT_TRUE(locator->locate(V3d(1, none, infinite)).empty());
        EXPECT_TRUE(locator->locate(V3d(infinite, 0, 0)).empty());
    }
}

TEST(Locate, RefusesAPictureWithoutPlaces) {
    const auto none = Locator::make(test::standard("pinhole"), 0, 100);
    ASSERT_FALSE(none);
    EXPECT_TRUE(has_errors(none.diagnostics));
}

}  // namespace balcony::analyse::inverse_test
