// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

namespace balcony::render {

/// Places that divide space by planes across the axes, each with what some probes have found in it.
/// Immutable.
template <class Place>
class PlaceTree {
public:
    /// `make` makes a place of each group of `fewest` probes to twice as many, or of all if there
    /// are fewer; at least one. A probe has a `position`. The result does not depend on their order
    /// as long as no two have the same position.
    template <class Probe, class Make>
    PlaceTree(std::span<Probe> probes, std::size_t fewest, const Make& make) {
        nodes_.emplace_back();
        divide(0, probes, fewest, make);
    }

    [[nodiscard]] const Place& at(const Imath::V3f& position) const {
        const Node* node = &nodes_.front();
        while (node->axis >= 0) {
            node = &nodes_[node->first + (position[node->axis] < node->border ? 0 : 1)];
        }
        return places_[node->first];
    }

private:
    struct Node {
        float border = 0.0F;
        int axis = -1;            // Of a place: none.
        std::uint32_t first = 0;  // The node below the border, before that above; or the place.
    };

    template <class Probe, class Make>
    void divide(std::size_t node, std::span<Probe> probes, std::size_t fewest, const Make& make) {
        if (probes.size() < 2 * fewest) {
            nodes_[node].first = static_cast<std::uint32_t>(places_.size());
            places_.push_back(make(probes));
            return;
        }
        const int axis = longest_side(probes);
        const auto order = [axis](const Probe& probe) {
            const Imath::V3f& p = probe.position;
            return std::array{p[axis], p[(axis + 1) % 3], p[(axis + 2) % 3]};
        };
        const std::size_t middle = probes.size() / 2;
        std::nth_element(probes.begin(), probes.begin() + static_cast<std::ptrdiff_t>(middle),
                         probes.end(),
                         [&](const Probe& a, const Probe& b) { return order(a) < order(b); });
        const auto below = static_cast<std::uint32_t>(nodes_.size());
        nodes_[node] = {probes[middle].position[axis], axis, below};
        nodes_.resize(nodes_.size() + 2);
        divide(below, probes.first(middle), fewest, make);
        divide(below + 1, probes.subspan(middle), fewest, make);
    }

    // Of the box around some probes.
    template <class Probe>
    [[nodiscard]] static int longest_side(std::span<Probe> probes) {
        Imath::V3f low = probes.front().position;
        Imath::V3f high = low;
        for (const Probe& probe : probes) {
            for (int axis = 0; axis < 3; ++axis) {
                low[axis] = std::min(low[axis], probe.position[axis]);
                high[axis] = std::max(high[axis], probe.position[axis]);
            }
        }
        const Imath::V3f sides = high - low;
        return static_cast<int>(std::max_element(&sides.x, &sides.x + 3) - &sides.x);
    }

    std::vector<Node> nodes_;
    std::vector<Place> places_;
};

}  // namespace balcony::render
