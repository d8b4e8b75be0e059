// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
//
// Rays as numbers: the same from a grid and at points, with derivatives that are those of
// neighbouring rays.

#include "analyse/measure/ray_field.hpp"

#include <gtest/gtest.h>

#include <array>

#include "support.hpp"

namespace balcony::analyse::ray_field_test {
namespace {

using Derivatives = RayField::Derivatives;

RayField field_of(const char* camera, double width, double height, Derivatives derivatives) {
    auto made = RayField::make(test::standard(camera), width, height, 0.0, derivatives);
    return std::move(*made);
}

TEST(SampleGrid, IsCentredInThePicture) {
    const SampleGrid grid = SampleGrid::over(100, 45, 10);
    EXPECT_EQ(grid.columns, 10U);
    EXPECT_EQ(grid.rows, 4U);
    EXPECT_EQ(grid.at(0), V2d(5, 7.5));
    EXPECT_EQ(grid.at(grid.size() - 1), V2d(95, 37.5));
    EXPECT_EQ(SampleGrid::over(3, 2, 10).at(0), V2d(1.5, 1));
}

TEST(RayField, GridAndPointsAreOne) {
    RayField program = field_of("superelliptic", 300, 100, Derivatives::with);
    const SampleGrid grid = SampleGrid::over(300, 100, 1);
    const std::vector<Ray> rays = program.run(grid);
    ASSERT_EQ(rays.size(), 30000U);
    for (const std::size_t index : {0U, 299U, 15070U, 29999U}) {
        const Ray one = program.at(grid.at(index));
        EXPECT_EQ(one.origin, rays[index].origin);
        EXPECT_EQ(one.direction_by_y, rays[index].direction_by_y);
        EXPECT_EQ(one.parameters, rays[index].parameters);
        EXPECT_TRUE(one.valid);
    }
    const std::array many{grid.at(120), grid.at(3059), grid.at(12345)};
    EXPECT_EQ(program.at(many)[1].direction, rays[3059].direction);
    EXPECT_EQ(program.at(many)[2].origin_by_x, rays[12345].origin_by_x);
}

TEST(RayField, DerivativesAreNeighbourDifferences) {
    RayField program = field_of("hyperbolic", 160, 90, Derivatives::with);
    RayField rays_only = field_of("hyperbolic", 160, 90, Derivatives::without);
    // The error of a central difference is some h^2; that of its rounding 1e-15/h.
    const double h = 1e-4;
    for (const V2d& p : {V2d(10, 10), V2d(81, 40), V2d(150, 88)}) {
        const Ray ray = program.at(p);
        const auto slope = [&](V3d Ray::*member, const V2d& by) {
            return (rays_only.at(p + h * by).*member - rays_only.at(p - h * by).*member) / (2 * h);
        };
        EXPECT_LT((ray.origin_by_x - slope(&Ray::origin, {1, 0})).length(), 1e-8);
        EXPECT_LT((ray.origin_by_y - slope(&Ray::origin, {0, 1})).length(), 1e-8);
        EXPECT_LT((ray.direction_by_x - slope(&Ray::direction, {1, 0})).length(), 1e-8);
        EXPECT_LT((ray.direction_by_y - slope(&Ray::direction, {0, 1})).length(), 1e-8);
    }
    EXPECT_EQ(rays_only.at({80, 45}).origin_by_x, V3d(0.0));
}

}  // namespace
}  // namespace balcony::analyse::ray_field_test
