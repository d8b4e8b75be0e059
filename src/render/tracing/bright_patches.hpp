// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// The brightest parts of surfaces, such as a patch of sun on a floor. What they light is noisy, as
// few of the rays that a surface scatters find them. So some paths are sent there instead: a
// direction is that to an even point of a box around a part of a patch, with a probability that
// depends on the place, or one that the surface chooses. Its density is that of both (the balance
// heuristic of multiple importance sampling, Veach 1997), so the mean is the same.

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include <Imath/ImathVec.h>

#include "shading/geometry/place_tree.hpp"
#include "shading/lanes/lane_arrays.hpp"

namespace balcony::render {

/// A box along the axes, of a volume that is not 0.
struct BrightBox {
    Imath::V3f low;
    Imath::V3f high;
    /// The mean irradiance of the probes' surfaces by what is in it.
    float irradiance = 0.0F;
};

/// A point of a surface.
struct PatchProbe {
    Imath::V3f position;
    /// An estimate of its irradiance by other light than that of lamps and boxes.
    float other = 0.0F;
    /// If it looks at the boxes: a number for each that is proportional to the irradiance by an
    /// equally bright surface in it.
    std::optional<LaneFloats> seen{};
};

/// Immutable.
class BrightPatches {
public:
    static constexpr std::size_t most = lane_count;  ///< The largest number of boxes.

    /// A part of space.
    struct Place {
        float share = 0.0F;       ///< The probability of a direction to a box.
        LaneFloats cumulative{};  ///< The probabilities of the boxes.
        LaneFloats factors{};     ///< The same by box, over three times its volume.
    };

    /// At least one box and one probe that looks.
    BrightPatches(std::span<const BrightBox> boxes, std::vector<PatchProbe> probes);

    /// Null where no direction leads to a box.
    [[nodiscard]] const Place* at(const Imath::V3f& position) const {
        const Place& place = places_.at(position);
        return place.share > 0.0F ? &place : nullptr;
    }

    /// A unit direction to a box, from three numbers in [0, 1).
    [[nodiscard]] Imath::V3f sample(const Place& place, const Imath::V3f& from,
                                    const Imath::V3f& random) const;
    /// Its density, by solid angle.
    [[nodiscard]] float pdf(const Place& place, const Imath::V3f& from,
                            const Imath::V3f& direction) const;
    /// The density if a surface chooses the other directions with this one.
    [[nodiscard]] float mixed_pdf(const Place& place, const Imath::V3f& from,
                                  const Imath::V3f& direction, float of_surface) const {
        return (1.0F - place.share) * of_surface + place.share * pdf(place, from, direction);
    }

private:
    struct Boxes {
        explicit Boxes(std::span<const BrightBox> boxes);
        std::size_t count;
        LaneVectors low, high;  // The last one is repeated.
    };
    [[nodiscard]] static Place place_of(std::span<const PatchProbe> probes, const Boxes& boxes,
                                        const LaneFloats& irradiance_of_seen);

    Boxes boxes_;
    PlaceTree<Place> places_;
};

}  // namespace balcony::render
