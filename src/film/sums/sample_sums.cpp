// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

// Highway compiles the first part of this file once for each instruction set.

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "film/sums/sample_sums.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#include <hwy/cache_control.h>

#include <cassert>
#include <cstdint>

#include "film/sums/sample_sums.hpp"

HWY_BEFORE_NAMESPACE();

namespace balcony::render::HWY_NAMESPACE {

namespace lanes = hwy::HWY_NAMESPACE;

constexpr std::size_t channels = 4;

void add_samples(const float* from, std::size_t count, double* to) {
    const lanes::CappedTag<double, channels> tag;
    const lanes::Rebind<float, decltype(tag)> floats;
    for (std::size_t k = 0; k < channels * count; k += lanes::Lanes(tag)) {
        const auto sample = lanes::PromoteTo(tag, lanes::LoadU(floats, from + k));
        lanes::StoreU(lanes::Add(lanes::LoadU(tag, to + k), sample), tag, to + k);
    }
}

// The places for half a sum are aligned to its size, those of larger registers need not be.
void set_first_samples(const float* from, std::size_t count, double* to) {
    const lanes::CappedTag<double, channels / 2> tag;
    const lanes::Rebind<float, decltype(tag)> floats;
    for (std::size_t k = 0; k < channels * count; k += lanes::Lanes(tag)) {
        const auto sample = lanes::PromoteTo(tag, lanes::LoadU(floats, from + k));
        // As in a sum, no 0 is negative.
        lanes::Stream(lanes::Add(lanes::Zero(tag), sample), tag, to + k);
    }
}

}  // namespace balcony::render::HWY_NAMESPACE

HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace balcony::render {

HWY_EXPORT(add_samples);
HWY_EXPORT(set_first_samples);

void add_samples(const Color4f* samples, std::size_t count, Color4d* sums) {
    HWY_DYNAMIC_DISPATCH(add_samples)(&samples->r, count, &sums->r);
}

void set_first_samples(const Color4f* samples, std::size_t count, Color4d* sums) {
    assert(reinterpret_cast<std::uintptr_t>(sums) % (sizeof(Color4d) / 2) == 0);
    HWY_DYNAMIC_DISPATCH(set_first_samples)(&samples->r, count, &sums->r);
}

void finish_first_samples() { hwy::FlushStream(); }

}  // namespace balcony::render

#endif
