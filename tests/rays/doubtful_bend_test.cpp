// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Bends that do not end, or not where their formula says: each is an error or a counted warning.

#include <cmath>
#include <memory>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::rays::test::doubtful_bend_test {
namespace {

std::string with(const std::string& bend) {
    return "camera a { map u = 0.8 .. -0.8, v = square  eye point  toward plane((1, 0, 0))  "
           "move translate(1, 2, 3)  " +
           bend + " }";
}

std::string messages_of(const std::string& text) {
    return to_text(
        lang::make_camera(std::make_shared<const SourceText>("test.cam", text), "").diagnostics);
}

}  // namespace

// A bend that leads nowhere, or not where its formula says, is no picture without a word.
TEST(DoubtfulBend, IsCountedInAWarning) {
    struct Case {
        std::string bend;
        std::string message;
    };
    const std::vector<Case> cases{
        // Orbits without end, in steps that are far too long.
        {"bend field(at(x, y, z) = [1/sqrt((x - 1)^2 + (y - 2)^2 + (z - 6)^2)], length = 1000000, "
         "parts = 16)",
         "of 25 rays over the picture, the path of this bend is another one by more than 1 %"},
        {"bend field(at(x, y, z) = [-4*(x - 1), -4*(y - 3), -4*(z - 3)], length = 200, parts = 16)",
         "of 25 rays over the picture, the path of this bend is another one by more than 1 %"},
        {"bend field(at(x, y, z) = [if(x > 5, 1.5, 1)], length = 10)",
         "on 25 of 25 rays over the picture, the refractive index of this bend changes by more "
         "than 5 % without bending them"},
        // A slab, in front of and behind which the index is the same, and a staircase.
        {"bend field(at(x, y, z) = [if(x > 5, if(x > 5.5, 1, 1.5), 1)], length = 10)",
         "on 25 of 25 rays over the picture, the refractive index of this bend changes by more "
         "than 5 % without bending them"},
        {"bend field(at(x, y, z) = [1 + 0.04*floor(x)], length = 10)",
         "on 25 of 25 rays over the picture, the refractive index of this bend changes by more "
         "than 5 % without bending them"},
        {"bend field(at(x, y, z) = [if(x > 5, -1, 1)], length = 10)",
         "error: the refractive index of this bend is not positive along any ray"},
        // A pole half-way along the rays of two of five columns, those to the left.
        {"bend curve(point(s, x, y, z, dx, dy, dz) = "
         "[x + 9*s*dx, y + 9*s*dy, z + if(dy > 0.01, 0.00001/(s - 0.5), 0)])",
         "on 10 of 25 rays over the picture, the numbers of this bend are not finite"},
        {"bend curve(point(s, x, y, z, dx, dy, dz) = "
         "[x + 9*s*dx, y + 9*s*dy, z + 0.00001/(s - 0.5)])",
         "no path for any ray"},
        {"bend pinholes([(-9, 2, 3), (-9, 12, 3)])",
         "no ray of the picture turns at corner 1 of this bend"},
        {"bend pinholes([(7, 2, 3), (7, 12, 3), (7, -20, 3), (-7, -20, 3)])",
         "corner 2 of this bend has no direction"},
    };
    for (const Case& one : cases) {
        const std::string text = messages_of(with(one.bend));
        EXPECT_NE(text.find(one.message), std::string::npos) << one.bend << "\n" << text;
        EXPECT_NE(text.find("test.cam:1:"), std::string::npos) << one.bend << "\n" << text;
        EXPECT_NE(text.find("help: "), std::string::npos) << one.bend << "\n" << text;
    }
    for (const std::string bend :
         {"bend field(at(x, y, z) = [1 + 0.2*exp(-((x - 9)^2 + y^2 + z^2)/9)], length = 18)",
          "bend field(at(x, y, z) = [1.3 + 0.3*tanh(2*(x - 9))], length = 18)",
          "bend field(at(x, y, z) = [1/(1 + ((x - 1)^2 + (y - 2)^2 + (z - 3)^2)/9)], length = 9)",
          "bend field(at(x, y, z) = [0, 0, -0.1], length = 9, parts = 3)",
          "bend pinholes([(7, 2, 3), (7, 12, 3), (17, 12, 3)])"}) {
        EXPECT_EQ(messages_of(with(bend)), "");
    }
}

// Twice round a square: every ray ends, after as many turns as there are corners.
TEST(DoubtfulBend, AWayThatClosesOnItselfEnds) {
    const auto program =
        compile(camera_of(with("bend pinholes([(11, 2, 3), (11, 12, 3), (1, 12, 3), (1, 2, 3), "
                               "(11, 2, 3), (11, 12, 3), (1, 12, 3), (1, 2, 3)])")),
                width, height, {.points = true, .bends = true});
    ASSERT_TRUE(program) << to_text(program.diagnostics);
    Scratch scratch;
    RayBatch batch;
    const auto run_at = [&](const V2d& point) {
        program->run(Points{{&point.x, 1}, {&point.y, 1}, 0.0}, scratch, batch);
    };
    at_pixels([&](const V2d& point) {
        run_at(point);
        ASSERT_TRUE(batch.valid(0));
        ASSERT_EQ(batch.part_count(), 8U);
        EXPECT_TRUE(std::isinf(batch.part(0, 7).length));
        EXPECT_NEAR(batch.part(0, 7).direction.length(), 1.0, rounding);
    });
    // The middle ray is on the way, so it ends as the last side leads.
    run_at({80.0, 45.0});
    EXPECT_LT((batch.part(0, 7).direction - V3d(0.0, -1.0, 0.0)).length(), 1e-9);
}

}  // namespace balcony::rays::test::doubtful_bend_test
