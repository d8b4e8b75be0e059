// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// The reflection of plain materials at sixteen points together, against Bsdf at each.

#include "shading/materials/plain_lanes.hpp"

#include <gtest/gtest.h>

#include "bsdf_support.hpp"

namespace balcony::render::plain_lanes_test {

namespace {

using namespace test;
constexpr std::size_t size = plain_lanes::size;

// Sixteen points of rough materials without further layers.
struct Points {
    explicit Points(Directions& random) {
        while (materials.size() < size) {
            Appearance appearance = random.material().appearance;
            appearance.transmission = 0.0F;
            appearance.clearcoat = 0.0F;
            appearance.sheen_color = Color3f(0.0F);
            BsdfMaterial material(appearance);
            if (material.is_mirror()) {
                continue;
            }
            // Some have a row of energies of their own, as materials without textures.
            if (random.uniform() < 0.5F) {
                rows.push_back(material.energies.keep_row());
            }
            materials.push_back(material);
        }
        for (std::size_t lane = 0; lane < size; ++lane) {
            normals.push_back(random.on_sphere());
            geometric.push_back(random.above(normals.back(), 0.6F));
            to_viewer.set(lane, random.above(normals.back(), -0.1F));
            surfaces.set(lane, {materials[lane], normals[lane], geometric[lane]});
            // The surface of the line above is gone.
            surfaces.set_material(lane, materials[lane]);
        }
        set_views(all, surfaces, to_viewer, views);
    }

    [[nodiscard]] Bsdf bsdf(std::size_t lane) const {
        return {materials[lane], normals[lane], geometric[lane]};
    }

    static constexpr LaneBits all = lane_bit(size) - 1;
    std::vector<BsdfMaterial> materials;
    std::vector<std::shared_ptr<const void>> rows;
    std::vector<V3f> normals, geometric;
    plain_lanes::Vectors to_viewer;
    plain_lanes::Surfaces surfaces;
    plain_lanes::Views views;
};

TEST(PlainLanes, ReflectAsEachBsdf) {
    Directions random(31);
    std::size_t lit = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Points points(random);
        plain_lanes::Vectors to_light;
        for (std::size_t lane = 0; lane < size; ++lane) {
            to_light.set(lane, random.above(points.normals[lane], -0.3F));
        }
        constexpr LaneBits asked = 0xf3d7;
        plain_lanes::Values found;
        evaluate(asked, points.surfaces, points.views, to_light, found);
        for (std::size_t lane = 0; lane < size; ++lane) {
            const Bsdf::Value expected =
                (asked & lane_bit(lane)) != 0
                    ? points.bsdf(lane).evaluate(points.to_viewer.of(lane), to_light.of(lane))
                    : Bsdf::Value{};
            ASSERT_EQ(Color3f(found.reflected.of(lane)), expected.reflected) << lane;
            ASSERT_EQ(found.pdf[lane], expected.pdf) << lane;
            lit += expected.pdf > 0.0F ? 1 : 0;
        }
    }
    EXPECT_GT(lit, 1000U);
}

TEST(PlainLanes, SampleTheDirectionsOfEachBsdf) {
    Directions random(32);
    std::size_t by_facet = 0;
    std::size_t diffuse = 0;
    for (int trial = 0; trial < 200; ++trial) {
        const Points points(random);
        plain_lanes::Vectors numbers;
        for (std::size_t lane = 0; lane < size; ++lane) {
            numbers.set(lane, random.numbers());
        }
        plain_lanes::Directions found;
        sample(points.surfaces, points.views, numbers, found);
        for (std::size_t lane = 0; lane < size; ++lane) {
            const std::optional<BsdfSample> expected =
                points.bsdf(lane).sample(points.to_viewer.of(lane), numbers.of(lane));
            if (!expected) {
                continue;
            }
            const bool facet = (found.by_facet & lane_bit(lane)) != 0;
            ASSERT_EQ(facet, expected->lobe == BsdfLobe::glossy);
            ASSERT_EQ(found.to_light.of(lane), expected->to_light) << lane << facet;
            ASSERT_EQ(found.facet_normal.of(lane), expected->facet_normal) << lane << facet;
            ++(facet ? by_facet : diffuse);
        }
    }
    EXPECT_GT(by_facet, 300U);
    EXPECT_GT(diffuse, 300U);
}

}  // namespace

}  // namespace balcony::render::plain_lanes_test
