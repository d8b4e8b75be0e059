// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include <Imath/ImathVec.h>

#include "render/sampling/sampler.hpp"

namespace balcony::render {

/// The next pairs of dimensions of several samplers, computed together in the widest registers of
/// the machine. They are the same numbers, bit for bit, that the samplers give one by one.
class SampleBlock {
public:
    static constexpr std::size_t size = 16;
    static constexpr std::size_t depth = 4;  ///< Pairs of each sampler.

    /// Takes at most `size` samplers, and leaves them where they are.
    void fill(std::span<const Sampler* const> samplers);

    /// The pair that a sampler of the last fill() gives after `ahead` others.
    [[nodiscard]] Imath::V2f pair(std::size_t sampler, std::size_t ahead) const {
        return {x_[ahead][sampler], y_[ahead][sampler]};
    }

    using Floats = std::array<float, size>;
    using Pixels = std::array<std::uint32_t, size>;

private:
    alignas(64) std::array<Floats, depth> x_{};
    alignas(64) std::array<Floats, depth> y_{};
};

/// Gives the numbers of a sampler, and takes those that a block has ready from there.
class SampleReader {
public:
    /// Number `place` of the last SampleBlock::fill().
    SampleReader(const SampleBlock& block, std::size_t place, Sampler& sampler)
        : block_(&block), place_(place), sampler_(&sampler) {}

    /// As Sampler::next().
    [[nodiscard]] float next() { return is_ready() ? take().x : sampler_->next(); }
    /// As Sampler::next_pair().
    [[nodiscard]] Imath::V2f next_pair() { return is_ready() ? take() : sampler_->next_pair(); }

private:
    [[nodiscard]] bool is_ready() const { return taken_ < SampleBlock::depth; }
    [[nodiscard]] Imath::V2f take() {
        ++sampler_->next_;
        return block_->pair(place_, taken_++);
    }

    const SampleBlock* block_;
    std::size_t place_;
    Sampler* sampler_;
    std::size_t taken_ = 0;
};

}  // namespace balcony::render
