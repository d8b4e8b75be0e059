// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/sampling/sampler.hpp"

namespace balcony::render {

PassNumbers::PassNumbers(std::size_t pass, std::uint32_t seed)
    : pass_(static_cast<std::uint32_t>(pass)), seed_(mixed(seed + 0x9e3779b9U)) {
    for (std::uint32_t index = 0; index < first_pairs_.size(); ++index) {
        first_pairs_[index] = make_pair(index);
    }
}

// The golden ratio's multiples are far from each other before they are mixed.
PassNumbers::Pair PassNumbers::make_pair(std::uint32_t index) const {
    const std::uint32_t seed = mixed(seed_ ^ (index + 1) * 0x9e3779b9U);
    return {reversed(scrambled(reversed(pass_), mixed(seed + 1))), mixed(seed + 2), mixed(seed + 3),
            mixed(seed + 4)};
}

}  // namespace balcony::render
