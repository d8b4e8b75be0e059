// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/ray_order.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include <gtest/gtest.h>

namespace balcony::render::ray_order_test {
namespace {

using Imath::V3f;

// Rays from the points of a grid into all octants, scattered.
std::vector<RayOrder::Key> rays() {
    std::vector<RayOrder::Key> made;
    for (unsigned i = 0; i < 512; ++i) {
        const unsigned k = i * 197 % 512;
        const auto sign = [k](unsigned bit) { return (k >> bit) % 2 == 0 ? 1.0F : -1.0F; };
        made.push_back({V3f(static_cast<float>(k % 8), static_cast<float>(k / 8 % 8),
                            static_cast<float>(k / 64)),
                        V3f(sign(0), 0.5F * sign(3), 0.1F * sign(6))});
    }
    return made;
}

TEST(RayOrder, CountingSortIsStable) {
    const auto bucket = [](std::uint32_t i) { return i * 7 % 32; };
    std::vector<std::uint32_t> indices;
    for (std::uint32_t i = 0; i < 200; ++i) {
        indices.push_back(i * 89 % 200);
    }
    std::vector<std::uint32_t> expected = indices;
    std::stable_sort(expected.begin(), expected.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return bucket(a) < bucket(b); });
    std::vector<std::uint32_t> buffer;
    counting_sort<32>(indices, buffer, bucket);
    EXPECT_EQ(indices, expected);
}

TEST(RayOrder, ContainsEachRayOnce) {
    const auto all = rays();
    RayOrder order;
    const auto sorted = order.sort(all);
    EXPECT_EQ(sorted.size(), all.size());
    EXPECT_EQ(std::set<std::uint32_t>(sorted.begin(), sorted.end()).size(), all.size());
}

TEST(RayOrder, VisitsEachOctantOnce) {
    const auto all = rays();
    RayOrder order;
    const auto sorted = order.sort(all);
    int changes = 0;
    for (std::size_t i = 1; i < sorted.size(); ++i) {
        const V3f& before = all[sorted[i - 1]].direction;
        const V3f& now = all[sorted[i]].direction;
        changes += before.x * now.x < 0.0F || before.y * now.y < 0.0F || before.z * now.z < 0.0F;
    }
    EXPECT_EQ(changes, 7);
}

TEST(RayOrder, NeighboursAreNear) {
    const auto all = rays();
    RayOrder order;
    const auto path_length = [&](const auto& indices) {
        double sum = 0.0;
        for (std::size_t i = 1; i < indices.size(); ++i) {
            sum +=
                static_cast<double>((all[indices[i]].origin - all[indices[i - 1]].origin).length());
        }
        return sum;
    };
    std::vector<std::uint32_t> as_given(all.size());
    for (std::uint32_t i = 0; i < as_given.size(); ++i) {
        as_given[i] = i;
    }
    EXPECT_LT(path_length(order.sort(all)), 0.5 * path_length(as_given));
}

TEST(RayOrder, EqualRaysStayInOrder) {
    const std::vector<RayOrder::Key> equal(5, {V3f(1.0F), V3f(0.0F, 0.0F, 1.0F)});
    RayOrder order;
    const auto sorted = order.sort(equal);
    EXPECT_TRUE(std::is_sorted(sorted.begin(), sorted.end()));
}

TEST(RayOrder, TakesNumbersThatAreNotFinite) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    const std::vector<RayOrder::Key> odd{{V3f(infinity), V3f(1.0F)},
                                         {V3f(std::nanf("")), V3f(std::nanf(""))},
                                         {V3f(0.0F), V3f(-infinity)}};
    RayOrder order;
    EXPECT_EQ(order.sort(odd).size(), odd.size());
}

}  // namespace
}  // namespace balcony::render::ray_order_test
