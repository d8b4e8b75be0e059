// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/embree/accelerator.hpp"

#include <array>
#include <vector>

#include <gtest/gtest.h>

#include "support.hpp"

namespace balcony::render::embree {
namespace {

// Cameras whose rays leave a surface along its normals have whole regions of directions along an
// axis but for a hair.
constexpr std::array<float, 11> hairs{0.0F,    -0.0F,  1e-38F, -1e-30F, 1e-19F, -1e-18F,
                                      -1e-16F, 1e-12F, -1e-9F, 1e-7F,   -1e-5F};

TEST(Accelerator, PacketsFindWhatSingleRaysFindAlongTheAxes) {
    scene::Scene scene;
    for (int i = 0; i < 40; ++i) {
        const float x = -20.0F + static_cast<float>(i);
        test::add(scene, test::parallelogram({x, -30.0F, -3.0F}, {1.0F, 0.0F, 0.0F}, {0, 60.0F, 0}),
                  {});
    }
    const auto accelerator = Accelerator::build(scene);
    ASSERT_TRUE(accelerator) << to_text(accelerator.diagnostics);

    constexpr std::size_t side = hairs.size();
    std::vector<Ray> rays;
    for (std::size_t y = 0; y < side; ++y) {
        for (std::size_t x = 0; x < side; ++x) {
            const V3f origin(0.26F * static_cast<float>(x) - 1.25F,
                             0.26F * static_cast<float>(y) - 1.3F, 0.0F);
            rays.push_back({origin, V3f(hairs[x], hairs[y], -1.0F)});
        }
    }
    const std::vector<std::uint8_t> active(rays.size(), 1);
    std::vector<Hit> hits(rays.size());
    accelerator->intersect_grid(side, rays, active, hits);
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Hit single = accelerator->intersect(rays[i]);
        ASSERT_TRUE(single.any());
        EXPECT_EQ(hits[i].instance, single.instance) << "direction " << rays[i].direction;
    }
}

}  // namespace
}  // namespace balcony::render::embree
