// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The reflections at the points of a block of paths. Those of plain materials are computed
// together, the others one by one; the results are those of Bsdf, bit for bit.

#include <array>
#include <cstddef>
#include <optional>

#include "render/tracing/scene_tracer.hpp"
#include "shading/materials/bsdf.hpp"
#include "shading/materials/plain_lanes.hpp"

namespace balcony::render {

/// A point has a place in the block, its lane.
class BsdfBlock {
public:
    static constexpr std::size_t size = plain_lanes::size;

    void clear();
    /// The direction to the viewer is unit. The surface is softened to a roughness that is not 0;
    /// returns whether this changes it.
    bool add(std::size_t place, const Interaction& at, const V3f& to_viewer,
             float least_roughness = 0.0F);
    /// After all points, and before what follows.
    void set_views();

    [[nodiscard]] const BsdfMaterial& material(std::size_t place) const {
        return *materials_[place];
    }
    /// As Bsdf::lit_side().
    [[nodiscard]] V3f lit_side(std::size_t place) const;

    /// For evaluate(): a unit direction.
    void set_light(std::size_t place, const V3f& to_light) { to_light_.set(place, to_light); }
    /// What the points reflect of the light from the directions that were set.
    void evaluate(LaneBits places);
    [[nodiscard]] Bsdf::Value value(std::size_t place) const;

    /// Whether sample() may be given a direction.
    [[nodiscard]] bool is_plain(std::size_t place) const { return (plain_ & lane_bit(place)) != 0; }
    /// For sample(): the unit direction that it is to take, as one of the diffuse lobe. After
    /// evaluate().
    void set_direction(std::size_t place, const V3f& to_light) {
        given_ |= lane_bit(place);
        to_light_.set(place, to_light);
    }
    /// For sample(): three numbers in [0, 1).
    void set_numbers(std::size_t place, const V3f& random) { random_.set(place, random); }
    void sample(LaneBits places);
    /// As Bsdf::sample().
    [[nodiscard]] std::optional<BsdfSample> sampled(std::size_t place) const;

private:
    // A point whose material is not plain, or a mirror.
    struct Single {
        Bsdf bsdf;
        Bsdf::View view;
        Bsdf::Value value{};
        std::optional<BsdfSample> sample{};
    };

    LaneBits plain_ = 0;
    LaneBits given_ = 0;  // Directions for sample().
    std::array<const BsdfMaterial*, size> materials_{};
    std::array<std::optional<BsdfMaterial>, size> varying_;
    std::array<std::optional<Single>, size> singles_;
    // Of the plain ones.
    std::array<const BsdfMaterial*, size> known_{};  // Those that surfaces_ has.
    plain_lanes::Surfaces surfaces_;
    plain_lanes::Views views_;
    plain_lanes::Vectors to_viewer_, to_light_, random_;
    plain_lanes::Values values_;
    plain_lanes::Directions directions_;
    plain_lanes::Values sampled_;
};

}  // namespace balcony::render
