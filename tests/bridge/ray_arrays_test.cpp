// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/ray_arrays.hpp"

#include <gtest/gtest.h>

#include <array>

#include "balcony/lang.hpp"

namespace balcony::bridge::ray_arrays_test {
namespace {

// More than one part, and sides that are no multiples of a part's.
constexpr std::size_t width = 165;
constexpr std::size_t height = 131;

// All arrays, with a value in them that no ray has.
struct Arrays {
    explicit Arrays(std::size_t rays)
        : origins(3 * rays, 7.0),
          directions(3 * rays, 7.0),
          parameters(2 * rays, 7.0),
          footprints(12 * rays, 7.0),
          valid(rays, 7) {}

    [[nodiscard]] RayArrays all() {
        return {origins.data(), directions.data(), valid.data(), parameters.data(),
                footprints.data()};
    }

    std::vector<double> origins, directions, parameters, footprints;
    std::vector<std::uint8_t> valid;
};

RayGrid grid_of(const std::string& camera) {
    const auto picture = lang::make_picture(camera, "");
    EXPECT_TRUE(picture) << to_text(picture.diagnostics);
    auto grid = RayGrid::make(*picture, {.width = width, .height = height, .footprints = true});
    EXPECT_TRUE(grid) << to_text(grid.diagnostics);
    return std::move(*grid);
}

rays::V3d vector_of(const std::vector<double>& numbers, std::size_t first) {
    return {numbers[first], numbers[first + 1], numbers[first + 2]};
}

// Ray `to` of the arrays is the only one of a batch.
void expect_ray(const Arrays& arrays, std::size_t to, const rays::RayBatch& batch,
                double tolerance) {
    const rays::Ray ray = batch.valid(0) ? batch[0] : rays::Ray{};
    ASSERT_EQ(arrays.valid[to], batch.valid(0) ? 1 : 0);
    const auto expect_near = [&](const std::vector<double>& numbers, std::size_t first,
                                 const rays::V3d& wanted) {
        const rays::V3d miss = vector_of(numbers, first) - wanted;
        ASSERT_LE(miss.length(), tolerance * (1.0 + wanted.length())) << to;
    };
    expect_near(arrays.origins, 3 * to, ray.origin);
    expect_near(arrays.directions, 3 * to, ray.direction);
    expect_near(arrays.footprints, 12 * to, ray.origin_by_x);
    expect_near(arrays.footprints, 12 * to + 3, ray.origin_by_y);
    expect_near(arrays.footprints, 12 * to + 6, ray.direction_by_x);
    expect_near(arrays.footprints, 12 * to + 9, ray.direction_by_y);
    ASSERT_NEAR(arrays.parameters[2 * to], ray.parameters.x, tolerance);
    ASSERT_NEAR(arrays.parameters[2 * to + 1], ray.parameters.y, tolerance);
}

class RayArraysOf : public testing::TestWithParam<const char*> {};

TEST_P(RayArraysOf, AreThoseOfTheGrid) {
    const RayGrid grid = grid_of(GetParam());
    Arrays of_pixels(grid.size());
    ASSERT_TRUE(fill(grid, of_pixels.all()));
    std::vector<Imath::V2d> points;
    for (std::size_t i = 0; i < grid.size(); ++i) {
        points.emplace_back(static_cast<double>(i % width) + 0.5,
                            static_cast<double>(i / width) + 0.5);
    }
    Arrays of_points(grid.size());
    ASSERT_TRUE(fill(grid, points, of_points.all()));
    rays::Scratch scratch;
    rays::RayBatch batch;
    for (std::size_t i = 0; i < grid.size(); i += 7) {
        grid.run_at(std::span(&points[i].x, 1), std::span(&points[i].y, 1), scratch, batch);
        expect_ray(of_points, i, batch, 0.0);
        // Over pixels, what depends on a column alone is computed once for it: other roundings.
        expect_ray(of_pixels, i, batch, 1e-11);
    }
}

// One in whose corners there is no ray, and one whose rays start in many places.
INSTANTIATE_TEST_SUITE_P(Cameras, RayArraysOf,
                         testing::Values("fisheye_orthographic", "superelliptic"));

TEST(RayArrays, LeaveOutWhatIsNotWanted) {
    const RayGrid grid = grid_of("fisheye_orthographic");
    std::vector<std::uint8_t> valid(grid.size(), 7);
    ASSERT_TRUE(fill(grid, {.valid = valid.data()}));
    EXPECT_EQ(valid.front(), 0);
    EXPECT_EQ(valid[(height / 2) * width + width / 2], 1);
    EXPECT_TRUE(fill(grid, std::span<const Imath::V2d>(), {}));
}

TEST(RayArrays, AreNotCompleteAfterAStop) {
    std::stop_source stop;
    stop.request_stop();
    const RayGrid grid = grid_of("fisheye_orthographic");
    EXPECT_FALSE(fill(grid, {}, stop.get_token()));
}

}  // namespace
}  // namespace balcony::bridge::ray_arrays_test
