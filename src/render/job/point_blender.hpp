// Balcony: rendering through extended cameras.
// SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

#include "render/job/blend.hpp"
#include "render/job/picture_rays.hpp"

namespace balcony::render {

/// Composites all elements of a picture at a point of a tile, from back to front.
class PointBlender {
public:
    /// The layers are what was drawn, by camera layer, or empty if one is invisible.
    PointBlender(const TileCoverages& coverages, const std::vector<std::vector<Drawn>>& layers)
        : coverages_(coverages), layers_(layers) {}

    [[nodiscard]] Drawn operator()(const std::vector<rays::CompiledPicture::Element>& elements,
                                   std::size_t i) const {
        Drawn all;
        bool over_nothing = true;
        for (const rays::CompiledPicture::Element& element : elements) {
            const float part = coverages_.coverage(element, i);
            if (part <= 0.0F) {
                continue;
            }
            const bool hides = part >= 1.0F && element.blend == camera::BlendMode::normal;
            all = over_nothing && hides ? source(element, i)
                                        : composed(all, source(element, i), part, element.blend);
            over_nothing = false;
        }
        return all;
    }

private:
    [[nodiscard]] Drawn source(const rays::CompiledPicture::Element& element, std::size_t i) const {
        const Drawn own = contents(element, i);
        return element.channels ? with_channels(own, *element.channels) : own;
    }

    [[nodiscard]] Drawn contents(const rays::CompiledPicture::Element& element,
                                 std::size_t i) const {
        if (!element.group.empty()) {
            return (*this)(element.group, i);
        }
        if (element.paint) {
            return {Color4f(0.0F), coverages_.paint(*element.paint, i), Color4f(0.0F), 1.0F};
        }
        const std::vector<Drawn>& layer = layers_[*element.layer];
        return layer.empty() ? Drawn{} : layer[i];
    }

    const TileCoverages& coverages_;
    const std::vector<std::vector<Drawn>>& layers_;
};

/// Whether there are any paints among the elements, such as frames and leader lines.
[[nodiscard]] inline bool paints(const std::vector<rays::CompiledPicture::Element>& elements) {
    return std::any_of(elements.begin(), elements.end(),
                       [](const auto& element) { return element.paint || paints(element.group); });
}

}  // namespace balcony::render
