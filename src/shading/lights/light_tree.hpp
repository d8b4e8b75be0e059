// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A tree of lights: Conty Estevez and Kulla, "Importance Sampling of Many Lights with Adaptive Tree
// Splitting" (2018).

#include <array>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <stop_token>
#include <vector>

#include <Imath/ImathVec.h>

#include "shading/lanes/four_floats.hpp"
#include "shading/lights/light_bounds.hpp"

namespace balcony::render {

/// Chooses one of many lights at finite distances, about in proportion to the light that arrives
/// from it, without regard to shadows.
class LightTree {
public:
    struct Chosen {
        std::size_t light = 0;
        float probability = 0.0F;
    };

    /// Lights without power are never chosen. After a stop, the tree is of no use.
    explicit LightTree(std::span<const LightBounds> lights, const std::stop_token& stop = {});

    /// Chooses by a number in [0, 1). Nothing if no light reaches the point. A normal of 0 stands
    /// for light from all sides.
    [[nodiscard]] std::optional<Chosen> choose(const Imath::V3f& position, const Imath::V3f& normal,
                                               float random) const;

    /// The probability that choose() gives this light.
    [[nodiscard]] float probability(const Imath::V3f& position, const Imath::V3f& normal,
                                    std::size_t light) const;

    /// An estimate of the light that arrives at a point from all lights.
    [[nodiscard]] float illuminance(const Imath::V3f& position, const Imath::V3f& normal) const;

    [[nodiscard]] bool empty() const { return nodes_.empty(); }

private:
    friend class LightTreeBuilder;

    static constexpr std::uint32_t width = 4;  // Lanes.
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    // Bounds of the lights below each child. A child that does not exist has no power.
    struct Node {
        Float4 x{}, y{}, z{};  // Centres.
        Float4 half_x{}, half_y{}, half_z{};
        Float4 axis_x{}, axis_y{}, axis_z{};
        Float4 cosine_spread{}, sine_spread{};
        Float4 cosine_falloff{};
        Float4 back{};  // -1 if two-sided, otherwise 1.
        Float4 power{};
        std::array<std::uint32_t, width> child{none, none, none, none};  // A node, or a light.
        std::uint32_t leaves = 0;  // Bit i is set if child i is a light.
        std::uint32_t parent = none;
        std::uint32_t place = 0;  // The number of this child of the parent.
    };

    [[nodiscard]] static Float4 importance(const Node& node, const Imath::V3f& position,
                                           const Imath::V3f& normal);

    std::vector<Node> nodes_;            // The root is first.
    std::vector<std::uint32_t> places_;  // Of each light: width * node + child; or none.
    float power_ = 0.0F;                 // Of all lights; those of nodes are parts of it.
};

}  // namespace balcony::render
