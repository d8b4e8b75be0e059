// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <vector>

#include "render/job/blend.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// The weights of the camera layers at the points of a tile, as in blend mode normal: the coverage
/// of a layer times the part that nothing in front covers.
class LayerWeights {
public:
    /// The layers are what was drawn, by camera layer, or empty if one is invisible.
    LayerWeights(const TileCoverages& coverages, const std::vector<std::vector<Drawn>>& layers)
        : coverages_(coverages), layers_(layers) {}

    /// Calls visit(layer, weight) for the camera layers that contribute to point i, from front to
    /// back.
    template <class Visit>
    void at(const std::vector<rays::CompiledPicture::Element>& elements, std::size_t i,
            const Visit& visit) const {
        uncovered(elements, i, 1.0F, visit);
    }

private:
    // Returns the part that the elements leave uncovered.
    template <class Visit>
    float uncovered(const std::vector<rays::CompiledPicture::Element>& elements, std::size_t i,
                    float scale, const Visit& visit) const {
        float rest = 1.0F;
        for (auto element = elements.rbegin(); element != elements.rend() && rest > 0.0F;
             ++element) {
            const float part = coverages_.coverage(*element, i);
            if (part <= 0.0F) {
                continue;
            }
            float presence = 1.0F;  // Of a paint.
            if (!element->group.empty()) {
                presence = 1.0F - uncovered(element->group, i, scale * rest * part, visit);
            } else if (element->layer) {
                const std::vector<Drawn>& drawn = layers_[*element->layer];
                presence = drawn.empty() ? 0.0F : drawn[i].presence;
                if (presence > 0.0F) {
                    visit(*element->layer, scale * rest * part);
                }
            }
            rest *= 1.0F - part * presence;
        }
        return rest;
    }

    const TileCoverages& coverages_;
    const std::vector<std::vector<Drawn>>& layers_;
};

}  // namespace balcony::render
