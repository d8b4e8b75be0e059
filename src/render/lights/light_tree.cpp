// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0

#include "render/lights/light_tree.hpp"

#include <algorithm>

namespace balcony::render {

std::optional<LightTree::Chosen> LightTree::choose(const Imath::V3f&, const Imath::V3f&,
                                                   float random) const {
    if (count_ == 0) {
        return std::nullopt;
    }
    const auto chosen = static_cast<std::size_t>(random * static_cast<float>(count_));
    return Chosen{std::min(chosen, count_ - 1), 1.0F / static_cast<float>(count_)};
}

float LightTree::probability(const Imath::V3f&, const Imath::V3f&, std::size_t) const {
    return 1.0F / static_cast<float>(count_);
}

}  // namespace balcony::render
