// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set, and the compiler
// vectorises its loops.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "render/sampling/sample_block.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include "render/sampling/sample_block.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::HWY_NAMESPACE {

// One pair of dimensions of each sampler, by the place of its pixel.
void set_numbers(const std::array<PassNumbers::Pair, SampleBlock::size>& pairs,
                 const SampleBlock::Pixels& pixels, SampleBlock::Floats& x,
                 SampleBlock::Floats& y) {
    for (std::size_t i = 0; i < SampleBlock::size; ++i) {
        x[i] = first_number(pairs[i], pixels[i]);
        y[i] = second_number(pairs[i], pixels[i]);
    }
}

}  // namespace balcony::render::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render {

HWY_EXPORT(set_numbers);

void SampleBlock::fill(std::span<const Sampler* const> samplers) {
    std::array<PassNumbers::Pair, size> pairs{};
    Pixels pixels{};
    for (std::size_t i = 0; i < samplers.size(); ++i) {
        pixels[i] = samplers[i]->pixel_;
    }
    for (std::uint32_t ahead = 0; ahead < depth; ++ahead) {
        for (std::size_t i = 0; i < samplers.size(); ++i) {
            pairs[i] = samplers[i]->pass_->pair(samplers[i]->next_ + ahead);
        }
        HWY_DYNAMIC_DISPATCH(set_numbers)(pairs, pixels, x_[ahead], y_[ahead]);
    }
}

}  // namespace balcony::render

#endif
