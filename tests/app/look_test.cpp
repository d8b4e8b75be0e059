// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The exposure that a picture is given follows from the scene and the camera alone.

#include <gtest/gtest.h>

#include "balcony/app.hpp"
#include "support.hpp"

namespace balcony::app::look_test {
namespace {

class LookTest : public test::FolderTest {
protected:
    // A closed room, seen from its middle, with a small lamp in a corner: with one sample, few
    // pixels have light at all.
    Request room() const {
        file("lamp.mtl", "newmtl lamp\nKe 9e5 9e5 9e5\nnewmtl wall\nKd 0.5 0.5 0.5\n");
        return {.scene = file("room.obj",
                              "mtllib lamp.mtl\nusemtl wall\n"
                              "v -2 -2 -2\nv 2 -2 -2\nv 2 2 -2\nv -2 2 -2\n"
                              "v -2 -2 2\nv 2 -2 2\nv 2 2 2\nv -2 2 2\n"
                              "f 1 2 3 4\nf 5 6 7 8\nf 1 2 6 5\nf 4 3 7 8\n"
                              "f 1 4 8 5\nf 2 3 7 6\nusemtl lamp\n"
                              "v 1.7 1.8 1.7\nv 1.75 1.8 1.7\nv 1.75 1.85 1.7\n"
                              "f 9 10 11\n"),
                .camera = "panorama"};
    }

    Request field() const {
        Request request{.scene = file("field.obj",
                                      "v -9 0 -9\nv 9 0 -9\nv 9 0 9\nv -9 0 9\n"
                                      "f 1 2 3 4\nv 1 0 0\nv 1 1 0\nv 0 2 1\n"
                                      "f 5 6 7\n")};
        request.light.environment = render::Sky{};
        return request;
    }

    double exposure_of(Request request, std::size_t width, std::size_t height, std::size_t samples,
                       std::uint32_t seed) const {
        request.size = {.width = width, .height = height, .fit = camera::Fit::stretch};
        request.samples = samples;
        request.settings.sampling.seed = seed;
        request.output = file("p.png");
        const Report report = Session().render(request);
        EXPECT_FALSE(has_errors(report.diagnostics)) << to_text(report.diagnostics);
        EXPECT_TRUE(report.is_exposure_chosen);
        return report.exposure;
    }

    void expect_one_exposure(const Request& request) const {
        const double exposure = exposure_of(request, 32, 18, 1, 0);
        EXPECT_NE(exposure, 0.0);
        for (const std::size_t samples : {std::size_t{4}, std::size_t{16}}) {
            EXPECT_EQ(exposure_of(request, 32, 18, samples, 0), exposure) << samples;
        }
        for (const std::uint32_t seed : {1U, 2U}) {
            EXPECT_EQ(exposure_of(request, 32, 18, 1, seed), exposure) << seed;
        }
        EXPECT_EQ(exposure_of(request, 64, 36, 1, 0), exposure);
        // Of almost the same aspect.
        EXPECT_NEAR(exposure_of(request, 99, 55, 1, 0), exposure, 0.25);
    }
};

TEST_F(LookTest, OfARoomWithASmallLamp) { expect_one_exposure(room()); }
TEST_F(LookTest, OfAFieldUnderASky) { expect_one_exposure(field()); }

TEST_F(LookTest, IsThatOfTheWholePicture) {
    const double exposure = exposure_of(room(), 32, 18, 1, 0);
    Request part = room();
    part.crop.corners = {0.0, 0.9, 0.1, 1.0};
    EXPECT_EQ(exposure_of(part, 32, 18, 1, 0), exposure);
}

}  // namespace
}  // namespace balcony::app::look_test
