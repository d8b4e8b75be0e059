// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The inverse of cameras with a lens of glass: a point is where the ray through the middle of the
// pupil shows it, and if it is in focus, all rays of the lens show it there.

#include <array>
#include <cmath>
#include <span>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "balcony/inverse.hpp"
#include "balcony/rays.hpp"
#include "random_points.hpp"
#include "support.hpp"

namespace balcony::analyse::lens_inverse_test {
namespace {

constexpr double size = 400.0;

/// A camera that looks along x; a unit of its scene is 1 mm.
std::string looking_through(const std::string& lens, const std::string& map = "u = 0.36 .. -0.36") {
    return "camera a { aspect 1  map " + map +
           ", v = square  eye point  toward plane((1, 0, 0))  lens table(" + lens + ", unit = 1) }";
}

}  // namespace

// Of a picture beside the axis, of a sensor wider than the light of its lens, and of a focus that
// changes over the picture, too.
TEST(InverseThroughALens, FindsTheCentralRay) {
    for (const std::string& text :
         {looking_through("\"dgauss.dat\", focus = 1000, f_number = 4"),
          looking_through("\"petzval.dat\", focus = 3000, blades = 5", "u = 0.1 .. -0.3"),
          looking_through("\"triplet.dat\", focus = 500, sensor = 80"),
          looking_through("\"dgauss.dat\", focus = 700, group = (1, 5)")}) {
        const camera::Camera camera = test::camera_of(text);
        const test::RandomPoints random(camera, size, size, 2000);
        ASSERT_EQ(random.points.size(), 2000U);
        std::vector<double> missed(random.points.size(), 1.0);
        for (const Sighting& seen : Locator::make(camera, size, size)->locate(random.points)) {
            missed[seen.point] =
                std::min(missed[seen.point], (seen.position - random.places[seen.point]).length());
        }
        EXPECT_LT(*std::max_element(missed.begin(), missed.end()), 1e-4) << text;
    }
}

// The spots of this lens at f/8 are 30 micrometres, a third of a pixel of 36 mm/400.
TEST(InverseThroughALens, FindsWhatIsInFocusWhereAllRaysShowIt) {
    constexpr double focus = 2000.0;
    const camera::Camera camera =
        test::camera_of(looking_through("\"dgauss.dat\", focus = 2000, f_number = 8"));
    const rays::RayProgram program =
        *rays::compile(camera, size, size,
                       {.points = true,
                        .inputs = {{std::string(camera::lens_input_x), program::Rate::pixel},
                                   {std::string(camera::lens_input_y), program::Rate::pixel}}});
    const auto locator = Locator::make(camera, size, size);
    int compared = 0;
    for (const V2d& aim : {V2d(0.0, 0.0), V2d(0.2, -0.1), V2d(-0.3, 0.25)}) {
        const V3d point(focus, focus * aim.x, focus * aim.y);
        const std::vector<Sighting> seen = locator->locate(point);
        ASSERT_EQ(seen.size(), 1U) << aim;
        const double pixel = 0.72 * focus / size;
        for (const V2d& at : {V2d(0.9, 0.0), V2d(-0.6, 0.6), V2d(0.0, -0.8), V2d(0.2, 0.1)}) {
            const std::array<std::span<const double>, 2> inputs{std::span(&at.x, 1),
                                                                std::span(&at.y, 1)};
            rays::Scratch scratch;
            rays::RayBatch batch;
            const V2d& place = seen.front().position;
            program.run(rays::Points{std::span(&place.x, 1), std::span(&place.y, 1), 0.0, inputs},
                        scratch, batch);
            if (batch.valid(0)) {
                const V3d off = point - batch.origin(0);
                EXPECT_LT(off.cross(batch.direction(0)).length(), 0.5 * pixel) << aim << at;
                ++compared;
            }
        }
    }
    EXPECT_GE(compared, 9);
}

// Beyond the circle of light the sensor is dark, and the map shows a pinhole what it would see.
TEST(InverseThroughALens, DoesNotFindWhatTheLensKeepsInTheDark) {
    const V3d aside(1000.0, 700.0, 0.0);
    const std::string map = "u = 0.9 .. -0.9";
    const auto found = [&](const std::string& text) {
        return Locator::make(test::camera_of(text), size, size)->locate(aside).size();
    };
    EXPECT_EQ(found(looking_through("\"petzval.dat\", focus = 1000", map)), 0U);
    EXPECT_EQ(found("camera a { aspect 1  map u = 0.9 .. -0.9, v = square  eye point  toward "
                    "plane((1, 0, 0)) }"),
              1U);
}

}  // namespace balcony::analyse::lens_inverse_test
