// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// No bridge takes the first straight part of a bent ray for the whole: each says that it cannot.

#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "balcony/export.hpp"
#include "balcony/lang.hpp"
#include "balcony/picture_samples.hpp"
#include "balcony/ray_maps.hpp"

namespace balcony::bridge::bend_test {
namespace {

camera::Camera bent_camera() {
    const auto made = lang::make_camera(
        std::make_shared<const SourceText>(
            "test.cam",
            "camera bent { map u = 0.5 .. -0.5, v = square  eye point  toward plane((1, 0, 0))  "
            "bend pinholes([(10, 0, 0), (10, 20, 0)]) }"),
        "");
    EXPECT_TRUE(made) << to_text(made.diagnostics);
    return *made;
}

bool refuses(const Diagnostics& diagnostics) {
    return to_text(diagnostics).find("are bent, but only straight rays") != std::string::npos;
}

}  // namespace

TEST(BentExport, EveryLanguageRefuses) {
    for (const ExportTarget& target : export_targets()) {
        const auto made = export_camera(target, {bent_camera()});
        EXPECT_FALSE(made) << target.name;
        const std::string text = to_text(made.diagnostics);
        EXPECT_NE(
            text.find(fmt::format("the camera 'bent' cannot be exported to '{}': its rays are "
                                  "bent",
                                  target.name)),
            std::string::npos)
            << text;
        EXPECT_NE(text.find("test.cam:1:"), std::string::npos) << text;
    }
}

TEST(BentExport, RayMapsRefuse) {
    const auto grid = RayGrid::make(bent_camera(), {.width = 8, .height = 4});
    EXPECT_FALSE(grid);
    EXPECT_TRUE(refuses(grid.diagnostics)) << to_text(grid.diagnostics);
}

TEST(BentExport, SamplesForOtherRenderersRefuse) {
    render::SampleSettings settings;
    settings.width = 8;
    settings.height = 4;
    const auto samples = render::PictureSamples::make(bent_camera(), settings);
    EXPECT_FALSE(samples);
    EXPECT_TRUE(refuses(samples.diagnostics)) << to_text(samples.diagnostics);
}

}  // namespace balcony::bridge::bend_test
