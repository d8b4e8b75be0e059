// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

// Sends some of the paths of a block to bright patches.

#include <algorithm>
#include <array>
#include <cstddef>

#include "render/integrators/path_block.hpp"
#include "render/tracing/bright_patches.hpp"

namespace balcony::render {

class PatchGuide {
public:
    /// Null: there are no patches.
    explicit PatchGuide(const BrightPatches* patches) : patches_(patches) {}

    /// Before what follows: the surface of a lane. Diffuse plain ones look for patches.
    void find_place(PathBlock& block, std::size_t lane) {
        const bool looks = patches_ != nullptr && block.bsdfs().is_plain(lane) &&
                           !is_black(block.bsdfs().material(lane).diffuse);
        const Surface& surface = block.at(lane).surface;
        places_[lane] = looks ? patches_->at(surface.position) : nullptr;
        starts_[lane] = looks ? surface.start_to_light() : surface.position;
    }
    [[nodiscard]] const BrightPatches::Place* place(std::size_t lane) const {
        return places_[lane];
    }

    /// Sets what BsdfBlock::sample() makes a direction of: three numbers in [0, 1), or a direction
    /// to a patch.
    void choose(PathBlock& block, std::size_t lane, V3f random) const {
        if (const BrightPatches::Place* const place = places_[lane]; place != nullptr) {
            constexpr float below_1 = 0x1.fffffep-1F;
            const bool to_patch = random.x < place->share;
            random.x = to_patch ? random.x / place->share
                                : (random.x - place->share) / (1.0F - place->share);
            random.x = std::min(random.x, below_1);
            if (to_patch) {
                block.bsdfs().set_direction(lane, patches_->sample(*place, starts_[lane], random));
            }
        }
        block.bsdfs().set_numbers(lane, random);
    }

    /// Gives a sample of the surface its density here. Returns what its throughput is to be
    /// multiplied with for Russian roulette, which judges a path to a patch like one that has found
    /// it by chance: the throughput is small because patches are bright.
    [[nodiscard]] float weigh(std::size_t lane, BsdfSample& sample) const {
        if (places_[lane] == nullptr) {
            return 1.0F;
        }
        const float of_surface = sample.pdf;
        sample.pdf = pdf(lane, sample.to_light, of_surface);
        sample.weight *= of_surface / sample.pdf;
        return sample.pdf / of_surface;
    }

    /// The density of a direction that the surface alone chooses with another.
    [[nodiscard]] float pdf(std::size_t lane, const V3f& direction, float of_surface) const {
        return places_[lane] == nullptr
                   ? of_surface
                   : patches_->mixed_pdf(*places_[lane], starts_[lane], direction, of_surface);
    }

private:
    const BrightPatches* patches_;
    std::array<const BrightPatches::Place*, PathBlock::size> places_{};
    std::array<V3f, PathBlock::size> starts_{};
};

}  // namespace balcony::render
