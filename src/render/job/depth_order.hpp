// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Layers that are composited by depth.

#include <algorithm>
#include <cstddef>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "balcony/rays.hpp"
#include "render/job/camera_rays.hpp"
#include "shading/geometry/ray.hpp"

namespace balcony::render {

/// How far a place is along a ray of the master: its foot, in scene units from the ray's origin.
/// Without a place it is infinite; without a ray, all depths are the same.
[[nodiscard]] inline double depth_along(const rays::RayBatch& master, std::size_t i,
                                        const std::optional<embree::V3f>& place) {
    if (!traceable(master, i)) {
        return 0.0;
    }
    return place ? (V3d(*place) - master.origin(i)).dot(master.direction(i))
                 : std::numeric_limits<double>::infinity();
}

/// Sorts the layers of a group at points of a tile.
class DepthOrder {
public:
    using Element = rays::CompiledPicture::Element;

    /// Depths by camera layer and point; a layer that shows nothing in the tile has none.
    explicit DepthOrder(const std::vector<std::vector<double>>& depths) : depths_(depths) {}

    /// From back to front, until the next call. Of equal depths, the foremost layer is in front.
    [[nodiscard]] std::span<const Element* const> at(const std::vector<Element>& group,
                                                     std::size_t i) {
        order_.clear();
        for (const Element& element : group) {
            if (!depths_[*element.layer].empty()) {
                order_.push_back(&element);
            }
        }
        std::sort(order_.begin(), order_.end(), [&](const Element* a, const Element* b) {
            const double depth_a = depths_[*a->layer][i];
            const double depth_b = depths_[*b->layer][i];
            return depth_a > depth_b || (depth_a == depth_b && a < b);
        });
        return order_;
    }

private:
    const std::vector<std::vector<double>>& depths_;
    std::vector<const Element*> order_;
};

}  // namespace balcony::render
