// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The camera with a lens of glass, against what its name says: 85 mm, f/2.2, 36 mm by 24 mm.

#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "support.hpp"

namespace balcony::cameras::test::portrait_lens_test {

namespace {

/// Its rays, by the point of the picture in fractions and that of the lens.
class LensRays {
public:
    explicit LensRays(const std::vector<lang::Override>& overrides) {
        const camera::Camera camera = make("portrait_lens", overrides);
        width_ = camera::Picture(camera).aspect();
        auto made =
            rays::compile(camera, width_, 1.0,
                          {.tiles = false,
                           .points = true,
                           .inputs = {{std::string(camera::lens_input_x), program::Rate::pixel},
                                      {std::string(camera::lens_input_y), program::Rate::pixel}}});
        EXPECT_TRUE(made) << to_text(made.diagnostics);
        program_.emplace(*std::move(made.value));
    }
    rays::Ray operator()(double x, double y, const V2d& lens) {
        const double px = x * width_;
        const std::array<std::span<const double>, 2> inputs{std::span(&lens.x, 1),
                                                            std::span(&lens.y, 1)};
        program_->run(rays::Points{std::span(&px, 1), std::span(&y, 1), 0.0, inputs}, scratch_,
                      batch_);
        return batch_[0];
    }

private:
    std::optional<rays::RayProgram> program_;
    double width_ = 1.0;
    rays::Scratch scratch_;
    rays::RayBatch batch_;
};

}  // namespace

// Spherical aberration grows with the square of the aperture.
TEST(PortraitLens, IsSharpAtItsDistance) {
    LensRays rays({lang::Override{"distance", "2.5"}});
    const auto miss = [&](double a) {
        const rays::Ray ray = rays(0.5, 0.5, {0.0, a});
        return ray.origin.x - ray.origin.z / ray.direction.z * ray.direction.x - 2.5;
    };
    EXPECT_LT(std::abs(miss(0.02)), 1e-3);
    EXPECT_NEAR(miss(0.02) / miss(0.2), 0.01, 0.001);
}

// The outermost ray on the axis leaves at the focal length divided by twice the f-number, in
// metres; steps of the lens are 1 % of it, and the spherical aberration of the pupil wide open 3 %.
TEST(PortraitLens, HasItsFNumber) {
    for (const double f_number : {2.2, 4.0, 16.0}) {
        LensRays rays(
            {lang::Override{"f_number", fmt::format("{}", f_number)}, {"distance", "1e6"}});
        double rim = 0.0;
        for (double a = 0.0; a < 1.0; a += 0.01) {
            const rays::Ray ray = rays(0.5, 0.5, {0.0, a});
            rim = ray.valid ? ray.origin.z : rim;
        }
        const double wanted = 0.085 / (2.0 * f_number);
        EXPECT_NEAR(rim, wanted, 0.04 * wanted) << f_number;
    }
}

// But for the distortion of 1 %; and the mount darkens the corners.
TEST(PortraitLens, HasTheFieldAndTheVignettingOfItsLens) {
    LensRays rays({lang::Override{"distance", "1e6"}});
    const rays::Ray right = rays(1.0, 0.5, {0.0, 0.0});
    EXPECT_NEAR(-right.direction.y / right.direction.x, 18.0 / 85.0, 0.01 * 18.0 / 85.0);
    const rays::Ray top = rays(0.5, 0.0, {0.0, 0.0});
    EXPECT_NEAR(top.direction.z / top.direction.x, 12.0 / 85.0, 0.01 * 12.0 / 85.0);
    for (const V2d& at : {V2d(0.9, 0.0), V2d(0.0, 0.9), V2d(-0.9, 0.0), V2d(0.0, -0.9)}) {
        EXPECT_TRUE(rays(0.5, 0.5, at).valid) << at;
    }
    int passed = 0;
    for (double a = -0.9; a < 1.0; a += 0.2) {
        for (double b = -0.9; b < 1.0; b += 0.2) {
            passed += rays(0.01, 0.01, {a, b}).valid ? 1 : 0;
        }
    }
    EXPECT_GT(passed, 10);
    EXPECT_LT(passed, 60);
}

}  // namespace balcony::cameras::test::portrait_lens_test
