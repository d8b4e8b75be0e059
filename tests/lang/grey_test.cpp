// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// grey("mix.png", x, y): images in expressions, and cameras that an image chooses at each place.

#include <gtest/gtest.h>

#include <array>
#include <string>

#include "../files/temporary_folder.hpp"
#include "small_image.hpp"
#include "support.hpp"

namespace balcony::lang::grey_test {

namespace {

class Grey : public ::testing::Test {
protected:
    [[nodiscard]] Result<camera::Camera> make(const std::string& text) const {
        folder_.write("four.tga", test::four_greys());
        return make_camera(CameraSource(folder_.write("test.cam", text)), "");
    }

    [[nodiscard]] double value_of(const std::string& expression,
                                  const std::string& lets = "") const {
        const auto camera =
            make(test::joined({lets, "\ncamera c { map u = 1 .. -1, v = square eye point(",
                               expression, ", 0, 0) toward plane((1, 0, 0)) }"}));
        EXPECT_TRUE(camera) << to_text(camera.diagnostics);
        return camera ? test::ray(*camera, 50.0, 50.0, 100.0, 100.0).origin[0] : -1.0;
    }

    [[nodiscard]] std::string message_of(const std::string& expression) const {
        const auto camera = make(test::joined({"camera c { map u = 1 .. -1, v = square eye point(",
                                               expression, ", 0, 0) toward plane((1, 0, 0)) }"}));
        return camera.diagnostics.empty() ? "" : camera.diagnostics.front().message;
    }

    files::TemporaryFolder folder_;
};

constexpr double rounding = 1e-7;  // Of values that are floats.

}  // namespace

TEST_F(Grey, IsBilinearBetweenThePixels) {
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.25, 0.25))"), 0.0, rounding);
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.75, 0.25))"), 1.0, rounding);
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.25, 0.75))"), 0.2, rounding);
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.75, 0.75))"), 0.6, rounding);
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.5, 0.25))"), 0.5, rounding);
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.5, 0.5))"), 0.45, rounding);
    // It is constant beyond the outermost pixel centres, and beyond the image.
    EXPECT_NEAR(value_of(R"(grey("four.tga", 0.9, 0))"), 1.0, rounding);
    EXPECT_NEAR(value_of(R"(1 + 2*grey("four.tga", -7, 7))"), 1.4, rounding);
}

TEST_F(Grey, AFunctionOfTheFileHidesIt) {
    EXPECT_EQ(value_of("grey(3)", "let grey(a) = 2*a"), 6.0);
}

TEST_F(Grey, EachMistakeIsSaid) {
    EXPECT_EQ(message_of(R"(grey("four.tga", 1))"),
              "'grey' takes an image file and two numbers, but 2 arguments are given");
    EXPECT_EQ(message_of(R"(grey("four.tga", x = 1, 2))"),
              "the function 'grey' takes no named arguments");
    EXPECT_EQ(message_of("grey(1, 2, 3)"),
              "the first argument of 'grey' is the name of an image file in quotation marks");
    EXPECT_EQ(message_of(R"(grey("four.tga", 1deg, 2))"),
              "the place in an image is a number, but this is an angle");
    EXPECT_NE(message_of(R"(grey("five.tga", 1, 2))").find("five.tga"), std::string::npos);
}

// A camera texture: where the image is black, the first camera, where it is white, the second, and
// between them what a formula of the same numbers gives.
TEST_F(Grey, AnImageChoosesTheCameraAtEachPlace) {
    const auto morph = [&](const std::string& amount) {
        const auto camera = make(
            "camera c { morph panorama .. pinhole(fov = 70deg, px = 2), aspect = fill, "
            "amount = " +
            amount + " }");
        EXPECT_TRUE(camera) << to_text(camera.diagnostics);
        return *camera;
    };
    const camera::Camera texture = morph(R"(grey("four.tga", x, 0.25))");
    const camera::Camera formula = morph("max(0, min(1, 2*x - 0.5))");
    const camera::Camera first = morph("0");
    const camera::Camera second = morph("1");
    constexpr double width = 160.0;
    constexpr double height = 90.0;
    for (const double x : {0.05, 0.2, 0.3, 0.45, 0.6, 0.74, 0.8, 0.97}) {
        for (const double y : {0.3, 0.5, 0.64}) {
            const auto at = [&](const camera::Camera& camera) {
                return test::ray(camera, x * width, y * height, width, height);
            };
            const test::Ray ray = at(texture);
            for (const camera::Camera* other : {&formula, x < 0.25   ? &first
                                                          : x > 0.75 ? &second
                                                                     : &formula}) {
                const test::Ray expected = at(*other);
                ASSERT_EQ(ray.valid, expected.valid) << x << ' ' << y;
                for (std::size_t i = 0; ray.valid && i < 3; ++i) {
                    EXPECT_NEAR(ray.origin[i], expected.origin[i], 1e-9) << x << ' ' << y;
                    EXPECT_NEAR(ray.direction[i], expected.direction[i], 1e-9) << x << ' ' << y;
                }
            }
        }
    }
}

}  // namespace balcony::lang::grey_test
