// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// A tree over the patches of a picture: which of them can see a point?

#include <cstdint>
#include <vector>

#include "analyse/inverse/ray_patches.hpp"

namespace balcony::analyse {

/// Patches are grouped by their rays and not by their position in the picture, so that a seam
/// of the picture has no effect. Each node bounds the origins of its rays by a ball and their
/// directions by a cone. Immutable.
class RayTree {
public:
    /// Copies the patches. `extent` is the radius of the bounds of all origins. Throws if the work
    /// is to stop.
    RayTree(std::vector<RayPatch> patches, double extent, const Work& work);

    [[nodiscard]] const std::vector<RayPatch>& patches() const { return patches_; }

    /// Appends the numbers of the patches whose bounds see the point.
    void find(const V3d& point, std::vector<std::uint32_t>& found) const;

private:
    struct Bounds {
        V3d center{0.0};
        double radius = 0.0;
        V3d axis{0.0};
        double cosine = 1.0;  ///< Of the half angle of the cone.
        double sine = 0.0;

        [[nodiscard]] bool sees(const V3d& point) const;
    };
    struct Node {
        Bounds bounds;
        std::uint32_t skip = 0;   ///< The next node after this subtree.
        std::uint32_t patch = 0;  ///< Of a leaf; else no_patch.
    };
    static constexpr std::uint32_t no_patch = ~std::uint32_t{0};

    class Builder;

    std::vector<RayPatch> patches_;
    std::vector<Node> nodes_;  ///< Depth first.
};

}  // namespace balcony::analyse
