// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/job/point_boxes.hpp"

#include <algorithm>
#include <array>
#include <utility>

namespace balcony::render {

namespace {

using Imath::V3f;

// Points divide by their positions and, so that surfaces of different sides part, their normals.
constexpr std::size_t axes = 6;
float coordinate(const BrightPoint& point, std::size_t axis) {
    const auto direction = static_cast<int>(axis % 3);
    return axis < 3 ? point.position[direction] : point.normal[direction];
}

// A box that may be divided.
class Group {
public:
    explicit Group(std::vector<BrightPoint> points) : made_{std::move(points), V3f(0), V3f(0)} {
        std::array<float, axes> low{};
        std::array<float, axes> sides{};
        for (std::size_t axis = 0; axis < axes; ++axis) {
            const auto [least, largest] =
                std::minmax_element(made_.points.begin(), made_.points.end(),
                                    [axis](const BrightPoint& a, const BrightPoint& b) {
                                        return coordinate(a, axis) < coordinate(b, axis);
                                    });
            low[axis] = coordinate(*least, axis);
            sides[axis] = coordinate(*largest, axis) - low[axis];
        }
        made_.low = {low[0], low[1], low[2]};
        const V3f extent(sides[0], sides[1], sides[2]);
        made_.high = made_.low + extent;
        for (std::size_t axis = 3; axis < axes; ++axis) {
            sides[axis] *= 0.5F * extent.length();
        }
        const auto longest = std::max_element(sides.begin(), sides.end());
        axis_ = static_cast<std::size_t>(longest - sides.begin());
        side_ = *longest;
    }

    [[nodiscard]] const PointBox& box() const { return made_; }

    // How urgent it is to divide the group; 0 if it is not to be.
    [[nodiscard]] float urgency() const {
        constexpr std::size_t fewest = 8;
        return made_.points.size() < 2 * fewest ? 0.0F
                                                : side_ * static_cast<float>(made_.points.size());
    }

    // By the middle point along the longest side.
    [[nodiscard]] std::pair<Group, Group> halves() const {
        std::vector<BrightPoint> points = made_.points;
        const auto order = [this](const BrightPoint& point) {
            const V3f& p = point.position;
            return std::array{coordinate(point, axis_), p.x, p.y, p.z};
        };
        std::sort(points.begin(), points.end(),
                  [&](const BrightPoint& a, const BrightPoint& b) { return order(a) < order(b); });
        const auto middle = points.begin() + static_cast<std::ptrdiff_t>(points.size() / 2);
        return {Group({points.begin(), middle}), Group({middle, points.end()})};
    }

private:
    PointBox made_;
    std::size_t axis_ = 0;
    float side_ = 0.0F;
};

}  // namespace

std::vector<PointBox> point_boxes(std::vector<BrightPoint> points, std::size_t most) {
    std::vector<Group> groups{Group(std::move(points))};
    while (groups.size() < most) {
        const auto next = std::max_element(
            groups.begin(), groups.end(),
            [](const Group& a, const Group& b) { return a.urgency() < b.urgency(); });
        if (!(next->urgency() > 0.0F)) {
            break;
        }
        auto [below, above] = next->halves();
        *next = std::move(below);
        groups.push_back(std::move(above));
    }
    std::vector<PointBox> boxes;
    for (const Group& group : groups) {
        boxes.push_back(group.box());
    }
    return boxes;
}

}  // namespace balcony::render
