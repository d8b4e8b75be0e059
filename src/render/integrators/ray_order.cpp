// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/integrators/ray_order.hpp"

#include <algorithm>
#include <array>

#include <Imath/ImathBox.h>

namespace balcony::render {

namespace {

constexpr unsigned bits_per_axis = 3;
constexpr std::size_t octants = 8;
constexpr std::size_t bucket_count = octants << (3 * bits_per_axis);

// The bits of a number with two zeros between each.
constexpr auto spread_bits = [] {
    std::array<std::uint16_t, 1U << bits_per_axis> spread{};
    for (unsigned value = 0; value < spread.size(); ++value) {
        for (unsigned bit = 0; bit < bits_per_axis; ++bit) {
            spread[value] |= static_cast<std::uint16_t>(((value >> bit) & 1U) << (3 * bit));
        }
    }
    return spread;
}();

// Maps the points of a box to cells of a grid.
class Grid {
public:
    explicit Grid(const Imath::Box3f& box) : origin_(box.min) {
        const Imath::V3f size = box.size();
        const auto cells_per_length = [](float length) {
            return length > 0.0F ? static_cast<float>(spread_bits.size()) / length : 0.0F;
        };
        scale_ = {cells_per_length(size.x), cells_per_length(size.y), cells_per_length(size.z)};
    }

    [[nodiscard]] unsigned morton_index(const Imath::V3f& point) const {
        const Imath::V3f at = (point - origin_) * scale_;
        return spread_bits[cell(at.x)] | static_cast<unsigned>(spread_bits[cell(at.y)]) << 1U |
               static_cast<unsigned>(spread_bits[cell(at.z)]) << 2U;
    }

private:
    static std::size_t cell(float at) {
        constexpr auto last = static_cast<float>(spread_bits.size() - 1);
        return static_cast<std::uint32_t>(at > 0.0F ? std::min(at, last) : 0.0F);  // NaN is 0.
    }

    Imath::V3f origin_;
    Imath::V3f scale_;
};

unsigned octant(const Imath::V3f& direction) {
    return (direction.x < 0.0F ? 1U : 0U) | (direction.y < 0.0F ? 2U : 0U) |
           (direction.z < 0.0F ? 4U : 0U);
}

}  // namespace

std::span<const std::uint32_t> RayOrder::sort(std::span<const Key> rays) {
    Imath::Box3f box;
    for (const Key& ray : rays) {
        box.extendBy(ray.origin);
    }
    const Grid grid(box);
    buckets_.clear();
    order_.clear();
    for (const Key& ray : rays) {
        order_.push_back(static_cast<std::uint32_t>(order_.size()));
        buckets_.push_back(static_cast<std::uint16_t>(octant(ray.direction) << (3 * bits_per_axis) |
                                                      grid.morton_index(ray.origin)));
    }
    counting_sort<bucket_count>(order_, buffer_, [this](std::uint32_t i) { return buckets_[i]; });
    return order_;
}

}  // namespace balcony::render
