// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "balcony/blend.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <sstream>

#include "balcony/inverse.hpp"
#include "balcony/lang.hpp"

namespace balcony::bridge::blend_test {
namespace {

using Overrides = std::vector<lang::Override>;

SourceCamera source_of(const std::string& camera, std::size_t width, std::size_t height,
                       const Overrides& set = {}) {
    const auto picture = lang::make_picture(camera, "", set)->with_fit(camera::Fit::stretch);
    auto grid = RayGrid::make(
        picture, {.width = width, .height = height, .axes = Axes::z_up, .footprints = true});
    auto locator = analyse::Locator::make(picture, static_cast<double>(width),
                                          static_cast<double>(height), 0.0, Axes::z_up);
    EXPECT_TRUE(grid && locator);
    return {std::move(*grid), std::make_shared<const analyse::Locator>(std::move(*locator))};
}

SourceCamera projector(const std::string& yaw, std::size_t width = 96, std::size_t height = 64) {
    return source_of("pinhole", width, height, {{"fov", "70deg"}, {"yaw", yaw}});
}

std::vector<V2d> centres(const RayGrid& rays) {
    std::vector<V2d> made;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        made.emplace_back(static_cast<double>(i % rays.width()) + 0.5,
                          static_cast<double>(i / rays.width()) + 0.5);
    }
    return made;
}

}  // namespace

TEST(Blend, SharesOfADirectionHaveTheSum1) {
    // Of different sizes, and one that has no rays around a circle.
    const std::vector<SourceCamera> projectors{
        projector("-30deg"), projector("5deg", 120, 50), projector("35deg"),
        source_of("fulldome", 80, 80, {{"tilt", "60deg"}, {"fov", "120deg"}})};
    const auto blend = Blend::make(projectors);
    ASSERT_TRUE(blend) << to_text(blend.diagnostics);
    ASSERT_EQ(blend->size(), 4U);
    std::size_t shared = 0;
    for (std::size_t i = 0; i < projectors.size(); ++i) {
        const RayGrid& rays = projectors[i].rays;
        std::vector<double> sums;
        blend->run(i, 0, rays.height(), sums);
        const std::vector<double> own = sums;
        std::vector<double> row;
        blend->run(i, 7, 1, row);
        for (std::size_t x = 0; x < rays.width(); ++x) {
            // Places are found from other ones, each exact to 1e-8 pixel; see below.
            ASSERT_NEAR(row[x], own[7 * rays.width() + x], 1e-6) << i << ' ' << x;
        }
        for (std::size_t j = 0; j < projectors.size(); ++j) {
            if (i == j) {
                continue;
            }
            const auto map = StMap::make(rays, projectors[j]);
            std::vector<SourcePlace> places;
            map->run(0, rays.height(), places);
            const V2d size(static_cast<double>(projectors[j].rays.width()),
                           static_cast<double>(projectors[j].rays.height()));
            std::vector<V2d> there;
            std::vector<std::size_t> of;
            for (std::size_t k = 0; k < places.size(); ++k) {
                if (places[k].valid) {
                    there.push_back(V2d(places[k].st.x, 1.0 - places[k].st.y) * size);
                    of.push_back(k);
                }
            }
            std::vector<double> shares;
            blend->at(j, there, shares);
            for (std::size_t k = 0; k < of.size(); ++k) {
                sums[of[k]] += shares[k];
            }
        }
        for (std::size_t k = 0; k < sums.size(); ++k) {
            if (own[k] == 0.0) {
                continue;  // It has no ray there.
            }
            shared += own[k] < 1.0 ? 1 : 0;
            // Places are exact to 1e-8 pixel, and a share changes by at most 1 in half a pixel, the
            // least distance of a pixel's centre from a border.
            ASSERT_NEAR(sums[k], 1.0, 1e-6) << i << ' ' << k;
        }
    }
    EXPECT_GT(shared, 5000U);
}

TEST(Blend, IsHalfInTheMiddleAndWholeAlone) {
    const auto two = Blend::make({projector("20deg"), projector("-20deg")});
    ASSERT_TRUE(two) << to_text(two.diagnostics);
    constexpr double degree = std::numbers::pi / 180.0;
    // The direction between both, in each picture.
    const double aside = 48.0 * std::tan(20.0 * degree) / std::tan(35.0 * degree);
    std::vector<double> shares;
    two->at(0, std::vector{V2d(48.0 + aside, 32.0), V2d(95.9, 32.0), V2d(0.1, 32.0)}, shares);
    EXPECT_NEAR(shares[0], 0.5, 1e-9);
    EXPECT_LT(shares[1], 0.02);
    EXPECT_EQ(shares[2], 1.0);
    const auto one = Blend::make({projector("0deg")});
    one->run(0, 0, 64, shares);
    EXPECT_EQ(shares, std::vector<double>(96 * 64, 1.0));
}

// What a picture shows of the other one with rays everywhere is shared by the distances from the
// rim of a circle and from the sides, each as a part of its own picture.
TEST(Blend, SharesGoWithTheDistanceFromTheBorder) {
    constexpr std::size_t size = 80;
    const SourceCamera dome = source_of("fulldome", size, size);
    const SourceCamera around = source_of("panorama", 200, 100);
    const auto blend = Blend::make({dome, around});
    ASSERT_TRUE(blend) << to_text(blend.diagnostics);
    std::vector<double> shares;
    blend->run(0, 0, size, shares);
    std::vector<SourcePlace> places;
    StMap::make(dome.rays, around)->run(0, size, places);
    const std::vector<V2d> pixels = centres(dome.rays);
    const auto from_sides = [](const V2d& place, double width, double height) {
        return std::min({place.x, place.y, width - place.x, height - place.y});
    };
    std::vector<V2d> outside;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!places[i].valid) {
            outside.push_back(pixels[i]);
        }
    }
    std::size_t rim = 0;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (!places[i].valid) {
            ASSERT_EQ(shares[i], 0.0) << i;
            continue;
        }
        double from_outside = size;
        for (const V2d& place : outside) {
            from_outside = std::min(from_outside, (place - pixels[i]).length() - 0.5);
        }
        const double sides = from_sides(pixels[i], size, size);
        rim += from_outside < sides ? 1 : 0;
        const double own = std::min(from_outside, sides) / size;
        const V2d there = V2d(places[i].st.x, 1.0 - places[i].st.y) * V2d(200.0, 100.0);
        const double other = std::max(0.0, from_sides(there, 200.0, 100.0)) / 100.0;
        ASSERT_NEAR(shares[i], own / (own + other), 1e-6) << pixels[i];  // As above.
    }
    EXPECT_GT(rim, 1000U);
}

TEST(Blend, RefusesSeveralViewpoints) {
    const std::vector<SourceCamera> apart{projector("20deg"),
                                          source_of("pinhole", 96, 64, {{"px", "1"}})};
    const auto refused = Blend::make(apart);
    ASSERT_FALSE(refused);
    EXPECT_NE(to_text(refused.diagnostics).find("see from different places"), std::string::npos);
    EXPECT_TRUE(Blend::make(apart, Parallax::ignore));
}

TEST(StMap, IsTheSameAtPlacesAsAtPixels) {
    const SourceCamera frame = source_of("omnimax", 64, 50);
    const auto map = StMap::make(frame.rays, source_of("fulldome", 200, 200, {{"tilt", "30deg"}}));
    ASSERT_TRUE(map) << to_text(map.diagnostics);
    std::vector<SourcePlace> rows;
    map->run(0, 50, rows);
    std::vector<SourcePlace> places;
    map->at(centres(frame.rays), places);
    ASSERT_EQ(places.size(), rows.size());
    for (std::size_t i = 0; i < rows.size(); ++i) {
        ASSERT_EQ(places[i].valid, rows[i].valid) << i;
        if (rows[i].valid) {
            EXPECT_NEAR((places[i].st - rows[i].st).length(), 0.0, 1e-9) << i;
        }
    }
}

TEST(WarpMesh, BringsThePictureWhereTheStMapDoes) {
    const std::size_t width = 64;
    const std::size_t height = 50;
    const SourceCamera frame = source_of("omnimax", width, height);
    const auto map = StMap::make(frame.rays, source_of("fulldome", 200, 200, {{"tilt", "30deg"}}));
    const auto blend = Blend::make({frame});
    // With nodes at the corners of the pixels, the centre of a pixel is that of a cell.
    const WarpMesh mesh = warp_mesh(*blend, 0, *map, width + 1, height + 1, 2.2);
    std::vector<SourcePlace> places;
    map->run(0, height, places);
    std::size_t compared = 0;
    for (std::size_t y = 1; y + 1 < height; ++y) {
        for (std::size_t x = 1; x + 1 < width; ++x) {
            const auto place = [&](std::size_t column, std::size_t row) -> const SourcePlace& {
                return places[row * width + column];
            };
            const auto node = [&](std::size_t column, std::size_t row) -> const WarpMesh::Node& {
                return mesh.nodes[(height - row) * (width + 1) + column];
            };
            const std::array around{node(x, y), node(x + 1, y), node(x, y + 1), node(x + 1, y + 1)};
            const std::array beside{place(x - 1, y), place(x + 1, y), place(x, y - 1),
                                    place(x, y + 1), place(x, y)};
            if (std::any_of(around.begin(), around.end(),
                            [](const auto& n) { return n.intensity < 0.0; }) ||
                !std::all_of(beside.begin(), beside.end(), [](const auto& p) { return p.valid; })) {
                continue;
            }
            const V2d& st = place(x, y).st;
            const V2d mean = 0.25 * (around[0].texture + around[1].texture + around[2].texture +
                                     around[3].texture);
            // Interpolation over a cell is off by an eighth of the second differences along both
            // sides; these change little from pixel to pixel.
            const double bound = (beside[0].st + beside[1].st - 2.0 * st).length() +
                                 (beside[2].st + beside[3].st - 2.0 * st).length();
            ASSERT_LE((mean - st).length(), bound / 8.0 * 1.5 + 1e-8) << x << ' ' << y;
            ++compared;
        }
    }
    EXPECT_GT(compared, 1500U);
}

TEST(WarpMesh, IsReadBackFromItsText) {
    const auto blend = Blend::make({projector("20deg"), projector("-20deg")});
    const auto map = StMap::make(blend->rays(0), source_of("fulldome", 200, 200));
    const WarpMesh mesh = warp_mesh(*blend, 0, *map, 9, 7, 2.0);
    std::istringstream text(to_text(mesh));
    int type = 0;
    std::size_t columns = 0;
    std::size_t rows = 0;
    text >> type >> columns >> rows;
    EXPECT_EQ(type, 2);
    ASSERT_EQ(columns, 9U);
    ASSERT_EQ(rows, 7U);
    bool drawn = false;
    bool blank = false;
    for (const WarpMesh::Node& node : mesh.nodes) {
        WarpMesh::Node read;
        text >> read.position.x >> read.position.y >> read.texture.x >> read.texture.y >>
            read.intensity;
        ASSERT_TRUE(text);
        // Nine digits.
        EXPECT_NEAR((read.position - node.position).length(), 0.0, 1e-8);
        EXPECT_NEAR((read.texture - node.texture).length(), 0.0, 1e-8);
        EXPECT_NEAR(read.intensity, node.intensity, 1e-8);
        drawn = drawn || node.intensity > 0.0;
        blank = blank || node.intensity < 0.0;
    }
    // The lower half is below the rim of the dome.
    EXPECT_TRUE(drawn && blank);
    EXPECT_EQ(mesh.nodes.front().position, V2d(-1.5, -1.0));
    EXPECT_EQ(mesh.nodes.back().position, V2d(1.5, 1.0));
    std::string rest;
    EXPECT_FALSE(text >> rest);
    // An intensity is the share as a projector of this gamma takes it.
    const WarpMesh linear = warp_mesh(*blend, 0, *map, 9, 7, 1.0);
    bool partial = false;
    for (std::size_t i = 0; i < mesh.nodes.size(); ++i) {
        const double intensity = mesh.nodes[i].intensity;
        partial = partial || (intensity > 0.0 && intensity < 1.0);
        if (intensity >= 0.0) {
            EXPECT_NEAR(intensity * intensity, linear.nodes[i].intensity, 1e-12);
        }
    }
    EXPECT_TRUE(partial);
    // Masks blend instead.
    for (const WarpMesh::Node& node : warp_mesh(*blend, 0, *map, 9, 7, {}).nodes) {
        EXPECT_TRUE(node.intensity == 1.0 || node.intensity == -1.0);
    }
}

}  // namespace balcony::bridge::blend_test
